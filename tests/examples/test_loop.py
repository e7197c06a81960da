"""The loop that is closed keeps its margin; the same flight without new plans does not arrive."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "14_plan_again_while_flying.py"
ARRIVED_M = 0.05
"""A part of what flying blind misses the goal by; after the last plan noise leaves far less."""


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 5])
def test_the_margin_is_kept(seed: int) -> None:
    example = runpy.run_path(str(EXAMPLE))
    least_m, off_m, fresh = example["fly"](seed)
    assert least_m >= example["KEEP_M"]
    assert off_m <= ARRIVED_M
    assert fresh >= 5
    _, off_m, fresh = example["fly"](seed, again=False)
    assert off_m > ARRIVED_M
    assert fresh == 1
