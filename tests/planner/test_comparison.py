"""Formulations side by side: what each is worth on a gap that only true shapes fit through."""

from __future__ import annotations

from dataclasses import replace

import pytest

from berthing.comparison import Comparison, compare
from berthing.errors import InputError
from berthing.geometry.body import Body, Part
from berthing.geometry.capsule import Capsule
from berthing.geometry.pose import Pose
from support import documents

GAP_M = 1.0


def gap(shape=None):
    """A long plate 0.4 m wide and a gap of 1 m in a wall of 41 m, straight ahead."""
    plate = {"name": "plate", "shape": shape or documents.box(3.0, 0.4)}
    wall = documents.box(1.0, 20.0)
    offset = 10.0 + 0.5 * GAP_M
    return documents.scenario(
        documents.puck(parts=[plate], start={"position_m": [0, 0.1]}, goal={"position_m": [8, 0]}),
        structures=[
            documents.structure("upper", (4, offset), wall),
            documents.structure("lower", (4, -offset), wall),
        ],
    )


@pytest.fixture(scope="module")
def found() -> Comparison:
    names = ("plane", "dual", "bounding-sphere", "bounding-ellipsoid", "signed-distance-sequential")
    return compare(gap(), names, guesses=1)


@pytest.mark.slow
def test_the_exact_forms_find_the_way_and_agree(found):
    exact = {s.formulation: s for s in found.summaries()[:2]}
    assert [s.solved for s in exact.values()] == [1, 1]
    # One optimum: 12 m² d²/T³ with d² = 64.01, the gap being straight ahead.
    expected = 12.0 * 4.0 * 64.01 / documents.DURATION_S**3
    for summary in exact.values():
        assert summary.cost == pytest.approx(expected, rel=1e-4)
        assert summary.spare_nodes_m >= -1e-6
        assert summary.spare_between_m <= summary.spare_nodes_m


@pytest.mark.slow
def test_steps_with_the_distance_linearised_find_it_too(found):
    (trial,) = [t for t in found.trials if t.formulation == "signed-distance-sequential"]
    assert trial.status == "solved"
    assert trial.spare_nodes_m >= -1e-4
    assert trial.cost == pytest.approx(12.0 * 4.0 * 64.01 / documents.DURATION_S**3, rel=1e-2)


@pytest.mark.slow
def test_balls_and_ellipsoids_find_none(found):
    for summary in found.summaries()[2:4]:
        assert (summary.solved, summary.trials, summary.cost) == (0, 1, None)


def test_a_form_that_cannot_take_a_shape_says_so_and_the_rest_go_on():
    scenario = documents.scenario(
        structures=[documents.structure("post", (5, 5, 0), documents.box(1, 1, 1))]
    )
    (phase,) = scenario.phases
    mast = Body((Part("mast", Capsule(0.1, 0.5), Pose.identity(3)),))
    craft = replace(phase.vehicles[0], body=mast)
    scenario = replace(scenario, phases=(replace(phase, vehicles=(craft,)),))
    found = compare(scenario, ("dual", "bounding-sphere"), guesses=1)
    assert list(found.refused) == ["dual"]
    assert [t.formulation for t in found.trials] == ["bounding-sphere"]


def test_names_that_are_none_are_told_which_there_are():
    with pytest.raises(InputError, match=r"there is no 'planes'.*plane.*bounding-sphere"):
        compare(gap(), ("planes",))


def test_a_start_in_collision_is_refused():
    with pytest.raises(InputError, match=r"puck\.start: puck\.plate overlaps"):
        compare(gap(documents.box(8.0, 3.0)), ("plane",), guesses=1)
