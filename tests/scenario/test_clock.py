"""A scenario from a later time on: all is where it would be, and what cannot shift says so."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.pose import Pose
from berthing.scenario.clock import begun_at
from berthing.scenario.files import load
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure

LATER_S = 30.0
X = np.array([1.0, 2, 3, 0.1, 0.2, 0.3, 2.0, 0, 0, 0, 0.01, 0.02, 0.03])


def moving(motion: dict) -> dict:
    return structure("truss", [5, 5, 5], box(1, 1, 1), motion=motion)


SPIN = {"type": "spin", "axis": [0, 0, 1], "rate_rad_s": 0.01, "velocity_m_s": [0, 0.1, 0]}


@pytest.mark.parametrize("motion", [SPIN, {"type": "fixed"}])
def test_laws_go_on(motion: dict) -> None:
    given = scenario(spacecraft(), structures=[moving(motion)])
    later = begun_at(given, X, LATER_S, {})
    t = np.linspace(0.0, 40.0, 5)
    old = given.structures[0].motion.pose(t + LATER_S)
    new = later.structures[0].motion.pose(t)
    assert new.position == pytest.approx(old.position)
    assert new.rotation == pytest.approx(old.rotation)
    assert later.phases[0].horizon.min_s == DURATION_S - LATER_S


def test_a_measured_pose_replaces_the_law_s() -> None:
    given = scenario(spacecraft(), structures=[moving(SPIN)])
    pose = Pose(np.array([5.0, 9.0, 5.0]), np.eye(3))
    (truss,) = begun_at(given, X, LATER_S, {"truss": pose}).structures
    assert truss.motion.pose(np.zeros(1)).position[0] == pytest.approx(pose.position)
    assert truss.motion.velocity(np.zeros(1))[0][0] == pytest.approx([0, 0.1, 0])


def test_vehicles_start_as_they_are() -> None:
    start = begun_at(scenario(spacecraft()), X, 0.0, {}).phases[0].vehicles[0].start
    assert start.position_m == pytest.approx(X[:3])
    assert start.velocity_m_s == pytest.approx(X[3:6])
    assert start.attitude.q == pytest.approx([1, 0, 0, 0])
    assert start.rate_rad_s == pytest.approx(X[10:])


def test_windows_move_with_the_clock() -> None:
    override = {"between": ["puck", "post"], "contact": "allowed"}
    post = structure("post", [3, 3], {"type": "sphere", "radius_m": 0.5})
    given = scenario(
        puck(), structures=[post],
        margins={"default_m": 0.1, "overrides": [
            override | {"window_s": [40, 60]}, override | {"window_s": [0, 20]},
        ]},
    )  # fmt: skip
    margins = begun_at(given, np.zeros(4), LATER_S, {}).margins
    at = [margins.margin("puck.rim", "post.core", t) for t in (0.0, 9.9, 10.1, 29.9, 30.1)]
    assert at == [0.1, 0.1, None, None, 0.1]
    assert len(margins.overrides) == 1


def test_a_free_horizon_keeps_what_is_left() -> None:
    given = scenario(puck(), horizon={"min_s": 20, "max_s": 90})
    horizon = begun_at(given, np.zeros(4), LATER_S, {}).phases[0].horizon
    assert (horizon.is_free, horizon.max_s) == (True, 60.0)


def test_what_depends_on_the_clock_is_refused() -> None:
    loaded = load("offset-mass-wrench")
    with pytest.raises(InputError, match="over time"):
        begun_at(loaded, X, LATER_S, {})
    law = {"type": "tabulated", "times_s": [0, 100], "positions_m": [[5, 5, 5], [6, 5, 5]],
           "attitudes": [[1, 0, 0, 0], [1, 0, 0, 0]]}  # fmt: skip
    given = scenario(
        spacecraft(),
        structures=[{"name": "truss", "parts": [{"name": "core", "shape": box(1, 1, 1)}],
                     "motion": law}],
    )  # fmt: skip
    with pytest.raises(InputError, match="tabulated"):
        begun_at(given, X, LATER_S, {})
