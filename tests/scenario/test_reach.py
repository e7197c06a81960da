"""Goals provably out of reach: refused just beyond the bound, let pass just within it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from berthing.scenario.authority import authority
from berthing.scenario.files import from_document

Document = dict[str, Any]
Refused = Callable[[Document], str]

# 2 √(√109 · 3 / (√3 · 0.02)): 60.1 s for Scenario A.
LEAST_A_S = 60.139
QUARTER_TURN = [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]


def vehicle(document: Document) -> Document:
    return document["vehicles"][0]


def within(document: Document, duration_s: float) -> Document:
    document["horizon"] = {"duration_s": duration_s}
    return document


def test_scenario_a_needs_a_minute(document: Document, refused: Refused) -> None:
    from_document(within(document, LEAST_A_S + 0.01))
    message = refused(within(document, LEAST_A_S - 0.01))
    assert message.startswith("test.yaml: vehicles[0].goal: is out of reach within 60.129 s")
    assert "10.4403 m are needed" in message
    assert "a horizon of at least 60.14 s" in message


def test_a_free_horizon_is_judged_by_its_longest(document: Document, refused: Refused) -> None:
    document["horizon"] = {"min_s": 1, "max_s": 61}
    from_document(document)
    document["horizon"] = {"min_s": 1, "max_s": 60}
    assert "out of reach within 60 s" in refused(document)


def test_tolerance_is_granted(document: Document, refused: Refused) -> None:
    within(document, 60.0)
    vehicle(document)["goal"]["position_tolerance_m"] = 0.04
    refused(document)
    vehicle(document)["goal"]["position_tolerance_m"] = 0.05
    from_document(document)


def test_a_free_velocity_doubles_the_way(document: Document, refused: Refused) -> None:
    vehicle(document)["goal"]["velocity_m_s"] = "free"
    from_document(within(document, LEAST_A_S / np.sqrt(2) + 0.01))
    refused(within(document, LEAST_A_S / np.sqrt(2) - 0.01))
    vehicle(document)["start"]["velocity_m_s"] = "free"
    from_document(within(document, 1.0))


def test_given_velocities_carry_the_vehicle(document: Document, refused: Refused) -> None:
    """Flying 10.44 m in 20 s at the mean speed asks nothing of the thrust."""
    velocity = [10 / 20, 3 / 20, 0]
    vehicle(document)["start"]["velocity_m_s"] = velocity
    vehicle(document)["goal"]["velocity_m_s"] = velocity
    from_document(within(document, 20.0))
    refused(within(document, 10.0))
    vehicle(document)["goal"]["velocity_m_s"] = [-v for v in velocity]
    vehicle(document)["goal"]["position_m"] = [0, 0, 0]
    # |Δv| = 1.044 m/s at 0.011547 m/s² takes 90.4 s.
    from_document(within(document, 90.5))
    message = refused(within(document, 90.3))
    assert "1.04403 m/s are needed" in message


def test_a_turn_from_rest_to_rest_needs_torque(document: Document, refused: Refused) -> None:
    vehicle(document)["goal"]["position_m"] = [0, 0, 0]
    vehicle(document)["goal"]["attitude"] = QUARTER_TURN
    least = 2 * np.sqrt(np.pi / 2 * 5 / (np.sqrt(3) * 0.01))
    from_document(within(document, least + 0.01))
    message = refused(within(document, least - 0.01))
    assert "1.5708 rad are needed" in message
    vehicle(document)["goal"]["attitude_tolerance_rad"] = 0.01
    from_document(within(document, least - 0.01))
    refused(within(document, least - 0.2))
    del vehicle(document)["goal"]["attitude_tolerance_rad"]
    vehicle(document)["goal"]["attitude"] = [-q for q in QUARTER_TURN]
    refused(within(document, least - 0.01))
    vehicle(document)["goal"]["attitude"] = "free"
    from_document(within(document, least - 0.01))
    vehicle(document)["goal"]["attitude"] = {"body_axis": [1, 0, 0], "points_along": [0, 1, 0]}
    refused(within(document, least - 0.01))
    vehicle(document)["goal"]["rate_rad_s"] = "free"
    from_document(within(document, least - 0.01))


def test_authority_counts_moments_about_the_centre_of_mass(document: Document) -> None:
    dynamics = vehicle(document)["dynamics"]
    dynamics["first_moment_kg_m"] = [0.6, 0, 0]  # 0.2 m ahead
    strength = authority(from_document(document).phases[0].vehicles[0])
    force, torque = np.sqrt(3) * 0.02, np.sqrt(3) * 0.01
    # About the centre of mass the moments are (5, 5 − 3 · 0.04, 5 − 3 · 0.04).
    assert strength.acceleration_m_s2 == pytest.approx(force / 3)
    assert strength.angular_rad_s2 == pytest.approx((torque + 0.2 * force) / 4.88)
    arm = {
        "name": "arm",
        "point_m": [0.2, 1, 0],
        "times_s": [0, 10],
        "force_n": [[0, 0, 0], [0.3, 0, 0]],
        "torque_nm": [[0, 0, 0], [0, 0, 0.1]],
    }
    dynamics["wrenches"] = [arm]
    pushed = authority(from_document(document).phases[0].vehicles[0])
    assert pushed.acceleration_m_s2 == pytest.approx((force + 0.3) / 3)
    # (0, 1, 0) × (0.3, 0, 0) = (0, 0, −0.3), and 0.1 of its own.
    assert pushed.angular_rad_s2 == pytest.approx((torque + 0.2 * force + 0.2) / 4.88)


def test_the_centre_of_mass_is_what_moves(document: Document, refused: Refused) -> None:
    """Turning about a far centre of mass moves the reference point for nothing."""
    body = vehicle(document)
    body["dynamics"] = {
        "model": "rigid-body",
        "mass_kg": 3,
        "inertia_kg_m2": [5, 5, 5],
        "first_moment_kg_m": [1.5, 0, 0],
    }
    # Turned by 180° about z with the centre of mass, 0.5 m ahead, staying where it is.
    body["goal"] = {"position_m": [1, 0, 0], "attitude": [0, 0, 0, 1]}
    del body["limits"]["max_torque_nm"]
    from_document(within(document, 3.0))
    body["goal"]["attitude"] = [1, 0, 0, 0]
    assert "1 m are needed" in refused(within(document, 3.0))
    body["goal"]["attitude"] = "free"
    from_document(within(document, 3.0))


def test_a_point_mass_is_judged_axis_by_axis(planar: Document, refused: Refused) -> None:
    # 6 m along x at 0.1 N on 2 kg: 2 √(6/0.05) s.
    least = 2 * np.sqrt(6 / 0.05)
    from_document(within(planar, least + 0.01))
    assert " m along x in that time" in refused(within(planar, least - 0.01))


def test_limits_on_speed_position_and_rate(document: Document, refused: Refused) -> None:
    limits = vehicle(document)["limits"]
    limits["max_speed_m_s"] = 0.066
    assert "10 m along x at no more than 0.066 m/s" in refused(document)
    limits["max_speed_m_s"] = 0.067
    from_document(document)
    limits["position_m"] = {"upper": [9.9, None, None]}
    assert "the goal has x_m = 10, outside the vehicle's limits" in refused(document)
    limits["position_m"] = {"upper": [10, None, None]}
    from_document(document)
    vehicle(document)["start"]["velocity_m_s"] = [0, 0.1, 0]
    assert "the start has vy_m_s = 0.1" in refused(document)
    del vehicle(document)["start"]["velocity_m_s"]
    limits["max_rate_rad_s"] = 0.01
    vehicle(document)["goal"]["rate_rad_s"] = [0, 0, 0.02]
    assert "the goal has wz_rad_s = 0.02" in refused(document)
    del vehicle(document)["goal"]["rate_rad_s"]
    vehicle(document)["goal"]["attitude"] = [0, 0, 0, 1]
    assert "a turn of 3.14159 rad" in refused({**document, "horizon": {"duration_s": 180}})


def test_goals_on_moving_structures(document: Document, refused: Refused) -> None:
    document["structures"][0]["motion"] = {
        "type": "constant-velocity",
        "velocity_m_s": [0.05, 0, 0],
    }
    vehicle(document)["goal"] = {"position_m": [5, 3, 0], "frame": "block"}
    # At 150 s the goal is at (17.5, 3, 0), moving at 0.05 m/s along x.
    need = np.hypot(17.5 - 0.5 * 0.05 * 150, 3)
    vehicle(document)["limits"]["max_force_n"] = 4 * need / 150**2 * 3 / np.sqrt(3) * 1.0001
    from_document(document)
    vehicle(document)["limits"]["max_force_n"] *= 0.9998
    assert f"{need:.6g} m are needed" in refused(document)
    # With a free horizon the clock at the goal is unknown: nothing is claimed.
    document["horizon"] = {"min_s": 1, "max_s": 150}
    from_document(document)


def test_no_limits_no_claims(document: Document) -> None:
    del vehicle(document)["limits"]
    vehicle(document)["goal"]["attitude"] = [0, 0, 0, 1]
    from_document(within(document, 1e-3))


def test_later_phases_are_judged_too(document: Document, refused: Refused) -> None:
    first = {key: document.pop(key) for key in ("horizon", "vehicles")}
    goal = {"position_m": [20, 3, 0]}
    second = {
        "name": "two",
        "horizon": {"duration_s": 50},
        "vehicles": [{**first["vehicles"][0], "goal": goal}],
    }
    del second["vehicles"][0]["start"]
    document["phases"] = [{"name": "one", **first}, second]
    assert "phases[1].vehicles[0].goal: is out of reach within 50 s" in refused(document)
