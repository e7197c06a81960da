"""Polishing a plan until the lower Hamiltonian stands still."""

from __future__ import annotations

import numpy as np
import pytest

from berthing import planner
from berthing.refine.facing import least_turn
from berthing.refine.polish import jump, restless
from berthing.refine.touches import Touch
from berthing.scenario.files import load
from berthing.scenario.options import SolverOptions
from berthing.transcription.mesh import Mesh
from support.documents import box, puck, scenario, structure
from support.solving import guessed, posed


class Found:
    """What a verification says of H."""

    def __init__(self, times, values) -> None:
        self.hamiltonian = (("phase", np.asarray(times), np.asarray(values)),)


MESH = Mesh.uniform("lgr", 4, 4)
TIMES = 100.0 * MESH.point_fractions()[:-1]


def test_segments_in_which_h_moves_are_found() -> None:
    values = np.where(TIMES < 50.0, 2.0, 2.01)
    assert restless(Found(TIMES, values), (0.0, 100.0), MESH, [], 1e-3) == []
    values = values + np.where((TIMES >= 25.0) & (TIMES < 50.0), 1e-3 * np.sin(TIMES), 0.0)
    assert restless(Found(TIMES, values), (0.0, 100.0), MESH, [], 1e-3) == [0.375]
    assert restless(Found(TIMES, values), (0.0, 100.0), MESH, [], 1.0) == []
    # A row inside accounts for it; a row at the segment's end does not.
    assert restless(Found(TIMES, values), (0.0, 100.0), MESH, [0.3], 1e-3) == []
    assert restless(Found(TIMES, values), (0.0, 100.0), MESH, [0.25], 1e-3) == [0.375]


def test_the_jump_at_a_touch_is_that_of_h_about_it() -> None:
    found = Found(TIMES, np.where(TIMES < 50.0, 2.0, 2.01))
    assert jump(found, (0.0, 100.0), Touch(0, 0.49, 0.51), 0.05) == pytest.approx(0.005, rel=0.01)
    assert jump(found, (0.0, 100.0), Touch(0, 0.2, 0.21), 0.05) == 0.0


def test_a_face_keeps_its_normal_and_corners_do_not() -> None:
    """A puck that slides along x past a square below: over its top the normal stands still; around
    the corner it turns in both frames."""
    own = puck(parts=[{"name": "hull", "shape": box(0.4, 0.4)}])
    given = scenario(own, structures=[structure("block", (3.0, -1.5), box(2, 2))])
    problem = posed(given, 4, 4)
    turn = least_turn(given, problem, guessed(problem))
    assert turn(0, 0.45, 0.55) < 1e-9
    assert turn(0, 0.05, 0.2) > 0.05


def settled(name: str, tolerance: float):
    result = planner.plan(load(name), options=SolverOptions(tolerance=tolerance))
    assert result.verification is not None
    assert result.verification.certified
    assert result.verification.hamiltonian_relative_drift <= tolerance
    assert result.second_order is not None
    assert result.second_order.minimum
    return result


@pytest.mark.slow
@pytest.mark.parametrize("name", ["scenario-b", "scenario-b-tight"])
def test_the_hamiltonian_settles_to_a_thousandth(name: str, monkeypatch) -> None:
    # The order of the cost, which takes as long again, is looked at on the next one.
    monkeypatch.setattr(planner, "order_check", lambda *_: None)
    assert settled(name, 1e-3).extremality.digits > 3.0


@pytest.mark.slow
def test_on_scenario_a_the_cost_settles_with_the_order_of_its_method() -> None:
    result = settled("scenario-a", 1e-3)
    assert result.extremality.digits > 3.0
    assert result.order is not None
    assert max(result.order.own.moves) < 1e-8
    assert result.order.shown.degree >= 2
    assert result.order.order == pytest.approx(result.order.shown.expected, abs=0.7)


@pytest.mark.slow
def test_without_obstacles_it_settles_to_rounding() -> None:
    result = settled("free-space", 1e-8)
    assert result.order is not None
    # Degree 4 has the optimum exactly: order 2, as a way that is its own mirror image has.
    assert max(result.order.own.moves) < 1e-12
    assert result.order.order == pytest.approx(2.0, abs=0.1)
