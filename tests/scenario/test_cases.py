"""The geometry that the shipped cases promise."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.clearance.bodies import clearance
from berthing.geometry.pose import Pose
from berthing.scenario.files import load
from berthing.scenario.library import library
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.verify.endpoints import check_endpoints

PAPER = ["free-space", "scenario-a", "scenario-b", "scenario-b-tight"]
MARGIN = 0.1
GAP = 0.15


def distances(scenario: Scenario, pose: Pose) -> dict[str, float]:
    """Distance of the spacecraft, posed so, to each structure."""
    (vehicle,) = scenario.phases[0].vehicles
    found = {}
    for structure in scenario.structures:
        at = structure.motion.pose(np.zeros(1))[0]
        found[structure.name] = clearance(vehicle.body, pose, structure.body, at)[0].distance
    return found


def end_distances(name: str, end: str) -> dict[str, float]:
    scenario = load(name)
    (vehicle,) = scenario.phases[0].vehicles
    return distances(scenario, getattr(vehicle, end).resolve(0.0, scenario).pose)


@pytest.mark.parametrize("name", library())
def test_no_case_begins_or_ends_too_close(name: str) -> None:
    check_endpoints(load(name))


@pytest.mark.parametrize("name", PAPER)
def test_starts_and_goals_keep_the_margin(name: str) -> None:
    assert load(name).margins.default_m == MARGIN
    for end in ("start", "goal"):
        assert all(d > MARGIN for d in end_distances(name, end).values())


@pytest.mark.parametrize("name", PAPER)
def test_the_spacecraft_is_the_papers(name: str) -> None:
    (phase,) = load(name).phases
    (vehicle,) = phase.vehicles
    assert phase.horizon.nominal_s == 150.0
    assert not phase.horizon.is_free
    assert isinstance(vehicle.model, RigidBody)
    assert vehicle.model.mass_kg == 3.0
    np.testing.assert_array_equal(vehicle.model.inertia_kg_m2, 5 * np.eye(3))
    np.testing.assert_array_equal(vehicle.limits.control_upper, [0.02] * 3 + [0.01] * 3)
    (hull,) = vehicle.body.parts
    value, _ = hull.shape.support(np.eye(3))
    np.testing.assert_array_equal(value, [2, 1, 1])
    assert hull.name == "hull"


def test_a_has_its_goal_1_m_from_the_cylinder_and_2_m_from_the_plate() -> None:
    """Erratum 6: not at the boundary of the allowed distance."""
    found = end_distances("scenario-a", "goal")
    assert found["T1"] == pytest.approx(2.0, abs=1e-6)
    assert found["T2"] == pytest.approx(1.0, abs=1e-6)


def test_a_has_a_plate_2_m_thick_across_the_straight_way() -> None:
    """Erratum 1: the text's 2 m, not the printed 3 m."""
    scenario = load("scenario-a")
    start = distances(scenario, Pose.identity(3))
    assert start["T1"] == pytest.approx(5 - 1 - 2, abs=1e-6)
    on_the_way = Pose(np.array([5.0, 1.5, 0]), np.eye(3))
    assert distances(scenario, on_the_way)["T1"] < 0


def test_b_is_met_by_a_straight_line_with_half_a_metre() -> None:
    """Erratum 5: its separation never acts."""
    scenario = load("scenario-b")
    least = min(
        min(distances(scenario, Pose(np.array([x, 0, 0]), np.eye(3))).values())
        for x in np.linspace(0, 9.5, 20)
    )
    assert least == pytest.approx(0.5, abs=1e-6)


def test_the_tight_mouth_leaves_15_cm_beyond_the_margin_on_each_side() -> None:
    scenario = load("scenario-b-tight")
    inside = distances(scenario, Pose(np.array([9.0, 0, 0]), np.eye(3)))
    assert inside["T1"] == pytest.approx(MARGIN + GAP, abs=1e-6)
    assert inside["T3"] == pytest.approx(MARGIN + GAP, abs=1e-6)
    assert inside["lid"] == pytest.approx(MARGIN + GAP, abs=1e-6)
    for axis in (1, 2):
        for side in (-1, 1):
            position = np.array([9.0, 0, 0])
            position[axis] = side * (GAP + 0.001)
            assert min(distances(scenario, Pose(position, np.eye(3))).values()) < MARGIN


def test_the_tight_way_in_needs_a_turn() -> None:
    """Straight on, as the spacecraft starts, it meets the mouth's sides."""
    scenario = load("scenario-b-tight")
    (vehicle,) = scenario.phases[0].vehicles
    start = vehicle.start.resolve(0.0, scenario).pose
    np.testing.assert_allclose(start.rotation @ [1, 0, 0], [0, 1, 0], atol=1e-15)
    at_the_mouth = Pose(np.array([8.0, 0, 0]), start.rotation)
    found = distances(scenario, at_the_mouth)
    assert found["T1"] < 0
    assert found["T3"] < 0


@pytest.mark.parametrize("way", [[0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [1, 0, 0]])
def test_the_tight_bay_is_closed_but_for_its_mouth(way: list[int]) -> None:
    """Out of the goal in any direction but back, the spacecraft is stopped, turned or not."""
    scenario = load("scenario-b-tight")
    turns = [Pose.identity(3), Pose.from_quaternion(np.zeros(3), np.array([1.0, 0, 0, 1]))]
    for turn in turns:
        steps = [
            min(
                distances(
                    scenario, Pose(np.array([9.5, 0, 0]) + s * np.array(way), turn.rotation)
                ).values()
            )
            for s in np.linspace(0, 3, 13)
        ]
        assert min(steps) < 0
