import json
from dataclasses import replace

import numpy as np
import pytest

from berthing._version import __version__
from berthing.commands.doctoring import closed_form
from berthing.scenario.files import load
from support import synthetic

EXPECTED = 12 * 9 * 109 / 150**3


def costing(cost):
    def answer(scenario):
        result = synthetic.certified(scenario)
        return replace(result, plan=replace(result.plan, cost=cost))

    return answer


def test_the_closed_form_is_that_of_the_best_force():
    # The force that is linear in time, integrated by hand.
    t = (np.arange(200_000) + 0.5) / 200_000
    force = 6 * 3 * np.sqrt(109) / 150**2 * (1 - 2 * t)
    assert closed_form(load("free-space")) == pytest.approx(np.mean(force**2) * 150, rel=1e-9)
    assert closed_form(load("free-space")) == pytest.approx(EXPECTED)


def test_what_agrees_exits_0_and_says_by_how_much(run, answer):
    answer.answer = costing(EXPECTED * (1 + 2e-9))
    done = run("doctor")
    assert done.exit_code == 0, done.output
    assert "2.0e-09" in done.stdout
    assert "0.003488" in done.stdout
    for name in ("casadi", "numpy", "scipy", "coal", "spiceypy"):
        assert name in done.stdout
    said = json.loads(run("doctor", "--json").stdout)
    assert said["versions"]["berthing"] == __version__
    assert said["closed_form"]["relative_error"] == pytest.approx(2e-9, rel=1e-3)
    assert said["closed_form"]["good"] is True


@pytest.mark.parametrize(
    "wrong", [costing(EXPECTED * 1.001), synthetic.not_certified, synthetic.failed]
)
def test_what_does_not_exits_4(run, answer, wrong):
    answer.answer = wrong
    done = run("doctor")
    assert done.exit_code == 4
    assert json.loads(run("doctor", "--json").stdout)["closed_form"]["good"] is False


@pytest.mark.slow
def test_the_solver_here_agrees(run):
    done = run("doctor", "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["closed_form"]["relative_error"] < 1e-7
