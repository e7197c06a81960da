"""Running cases: rows, misses with their cause, and going on where a run was cut short."""

import json
import time

import benchmarks.tight3d as tight3d
import pytest
from benchmarks.tight3d import _run
from benchmarks.tight3d._families import made
from benchmarks.tight3d._table import best_known, table

from berthing.result import Attempt, Result
from support import synthetic


def _row(family, seed, cost, effort="normal", **more):
    return {
        "family": family, "seed": seed, "effort": effort, "outcome": "certified", "seconds": 1.0,
        "cpu_s": 2.0, "cost": cost, **more,
    }  # fmt: skip


def _missed(seed):
    return {
        "family": "dock", "seed": seed, "effort": "normal", "outcome": "time_limit",
        "seconds": 30.0, "cause": "refinement ended: pair a|b",
    }  # fmt: skip


def _late():
    return Result("time_limit", None, None, (Attempt("straight", "solved", cost=1.0),))


def test_table_compares_with_the_best_of_every_effort_and_the_witness():
    rows = [
        _row("dock", 0, 1.04),
        _row("dock", 0, 1.0, "thorough"),
        _row("dock", 1, 3.0),
        _missed(2),
    ]
    witnesses = [{"family": "dock", "seed": 1, "certified": True, "cost": 2.0}]
    assert best_known(rows, witnesses) == {("dock", 0): 1.0, ("dock", 1): 2.0}
    lines = table(rows, "normal", witnesses).splitlines()
    assert lines[2] == "| dock | 2 of 3 | 1.00 | 27.10 | 30.00 | 2.00 | 1.270 | 1 of 2 |"
    assert lines[-1] == "| dock 2 | 30.0 | time_limit | refinement ended: pair a/b |"


def test_a_row_that_is_there_is_not_planned_again(tmp_path, monkeypatch, capsys):
    file, asked = tmp_path / "rows.json", []

    def planned(case, effort, limit_s):
        asked.append(case.name)
        return _row(case.family, case.seed, 5.0)

    monkeypatch.setattr(tight3d, "planned", planned)
    file.write_text(json.dumps([_row("dock", 0, 1.0), _missed(1)]))
    arguments = ["--json", str(file), "--family", "dock", "--seeds", "3"]
    assert tight3d.main(arguments) == 0
    assert asked == ["dock-002"]
    assert "| dock 1 | 30.0 | time_limit |" in capsys.readouterr().out
    assert tight3d.main([*arguments, "--again"]) == 0
    assert asked == ["dock-002", "dock-001"]
    assert len(json.loads(file.read_text())) == 4
    assert tight3d.main([*arguments, "--effort", "thorough", "--seconds", "0"]) == 0
    assert len(asked) == 2


@pytest.mark.parametrize(
    ("plan", "outcome", "cause"),
    [
        (lambda s, options: time.sleep(60.0), "killed", "did not stop"),
        (lambda s, options: 1 / 0, "died", "the process died"),
        (
            lambda s, options: synthetic.failed(synthetic.scenario()),
            "locally_infeasible",
            "no guess led to an answer: 1 locally_infeasible, 1 iteration_limit",
        ),
        (
            lambda s, options: _late(),
            "time_limit",
            "no answer of a guess was refined: 1 solved",
        ),
        (
            lambda s, options: synthetic.not_certified(synthetic.scenario()),
            "not_certified",
            "plan not certified: clearance[a, b, t = 52 s] is short of 0.1 m by 0.08 m",
        ),
    ],
    ids=["hangs", "raises", "fails", "is late", "is short"],
)
def test_a_miss_has_its_cause(monkeypatch, plan, outcome, cause):
    monkeypatch.setattr(_run, "plan", plan)
    monkeypatch.setattr(_run, "GRACE_S", 0.2 if outcome == "killed" else 20.0)
    row = _run.planned(made("dock", 0), "fast", 0.1)
    assert (row["outcome"], row["cause"]) == (outcome, cause)
    assert (row["family"], row["seed"], row["effort"]) == ("dock", 0, "fast")


def test_a_plan_has_its_cost_and_time(monkeypatch):
    monkeypatch.setattr(_run, "plan", lambda s, options: synthetic.certified(synthetic.scenario()))
    row = _run.planned(made("dock", 0), "fast", 10.0)
    assert (row["outcome"], row["cost"]) == ("certified", 0.0089)
    assert "cause" not in row
    assert row["cpu_s"] >= 0.0
