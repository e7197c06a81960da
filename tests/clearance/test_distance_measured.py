"""The measured claims on distances, on some of the poses of the committed table."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
POSES = 5_000
# Metres and relative errors, as the project asks for them.
USUAL_BRACKET, WIDEST_BRACKET, DEPTH, ANSWER = 1e-8, 1e-7, 1e-5, 1e-7


@pytest.mark.slow
def test_distances_are_as_claimed(tmp_path: Path) -> None:
    parts = ["brackets", "contacts", "touching", "conic", "nlp", "hulls", "gradients"]
    command = [sys.executable, "-m", "benchmarks", "distance", "--only", *parts]
    command += ["--poses", str(POSES), "--json", str(tmp_path / "found.json")]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    found = json.loads((tmp_path / "found.json").read_text())
    brackets = found["brackets"]
    assert brackets["poses"] >= POSES
    assert brackets["apart"] > 0.3 * POSES
    assert brackets["overlapping"] > 0.2 * POSES
    assert brackets["not_finite_or_crossed"] == 0
    assert brackets["apart_99.9_percent_m"] <= USUAL_BRACKET
    assert brackets["apart_widest_m"] <= WIDEST_BRACKET
    assert brackets["overlapping_widest_m"] <= DEPTH
    assert brackets["asked_again_in_another_order"] > 0.8 * POSES
    assert brackets["brackets_of_both_that_exclude_each_other"] == 0
    assert brackets["apart_they_differ_by_m"] <= WIDEST_BRACKET
    assert brackets["overlapping_they_differ_by_m"] <= DEPTH
    assert brackets["upper_bounds_checked"] > 0.2 * POSES
    assert brackets["upper_bounds_wrong"] == 0
    for part in ("contacts known by hand", "touching, and about one centre"):
        assert found[part]["apart_widest_m"] <= WIDEST_BRACKET
        assert found[part]["touching_or_overlapping_widest_m"] <= DEPTH
    assert found["contacts known by hand"]["largest_error_m"] <= ANSWER
    assert found["touching, and about one centre"]["not_finite"] == 0
    for solver in ("a conic solver (Clarabel)", "an NLP solver (SLSQP)"):
        assert found[f"against {solver}"]["poses"] > 50
        assert found[f"against {solver}"]["largest_difference_m"] <= ANSWER
    assert found["depths against hulls (Qhull)"]["largest_difference_m"] <= ANSWER
    gradients = found["gradients against differences"]
    assert gradients["above_1e-5"] == 0
    assert gradients["at_kinks"] < 0.01 * gradients["poses"]
