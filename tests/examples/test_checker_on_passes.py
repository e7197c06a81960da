"""The small checker and ``berthing verify`` on random passes of turning bodies, forged and not."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks._passes import random_pass
from benchmarks.certificate import NEAREST_M
from benchmarks.checker import FORGERIES, Files, compared, main, table


def test_both_say_the_same() -> None:
    rows = {row["what"]: (row["checker"], row["verify"]) for row in compared(0)}
    assert rows["as it is"] == (True, True)
    assert rows["a margin violated"] == (False, False)
    assert len(set(rows[FORGERIES[0]])) == 1


def test_a_disagreement_is_told(monkeypatch, capsys) -> None:
    """A checker that takes everything differs, and the benchmark says so."""
    monkeypatch.setattr("benchmarks.checker.CHECK", lambda folder: None)
    assert main(["--count", "1"]) == 1
    said = capsys.readouterr().out
    assert "| a margin violated | 1 | 0 | 0 | 1 |" in said
    row = {"seed": 0, "what": "as it is", "checker": True, "verify": True}
    assert "| as it is | 1 | 1 | 0 | 0 |" in table([row])


@pytest.mark.parametrize("how", FORGERIES)
def test_forgeries_change_the_file(how: str, tmp_path) -> None:
    rng = np.random.default_rng([1, 21])
    case = random_pass(rng, NEAREST_M)
    files = Files.write(case, tmp_path, case.least_m - 1e-2)
    before = (tmp_path / "certificate.json").read_text(encoding="utf-8")
    files.forge(how, rng)
    assert (tmp_path / "certificate.json").read_text(encoding="utf-8") != before
