"""Rates that a mesh does not resolve, and the limits that keep answers within them."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from berthing.transcription.turning import RESOLVED_RAD, ROOM, resolved, too_fast
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure

MESH = Mesh.uniform("lgr", 5, 4)
RESOLVED_RAD_S = RESOLVED_RAD * MESH.control_count / DURATION_S
W = slice(10, 13)


def turning(rate_rad_s: float, at: int | None = None) -> Motion:
    """A spacecraft that turns at a steady rate, or at one point of the mesh alone."""
    states = np.zeros((13, MESH.point_count))
    states[11, slice(None) if at is None else at] = rate_rad_s
    return Motion(DURATION_S, {"spacecraft": states}, {"spacecraft": np.zeros((6, 20))})


def test_what_turns_faster_than_nodes_can_show_is_too_fast() -> None:
    phase = scenario().phases[0]
    assert too_fast(phase, MESH, [turning(0.0), turning(-1.01 * RESOLVED_RAD_S)])
    assert not too_fast(phase, MESH, [turning(-0.99 * RESOLVED_RAD_S)])
    assert not too_fast(phase, MESH, [])


def test_it_is_seen_between_the_nodes_too() -> None:
    # One node's polynomial overshoots between it and the next.
    phase = scenario().phases[0]
    assert too_fast(phase, MESH, [turning(0.95 * RESOLVED_RAD_S, at=3)])
    assert not too_fast(phase, MESH, [turning(0.5 * RESOLVED_RAD_S, at=3)])


def test_what_has_no_rates_is_never_too_fast() -> None:
    given = scenario(puck())
    motion = Motion(1.0, {"puck": np.full((4, MESH.point_count), 1e3)}, {})
    assert not too_fast(given.phases[0], MESH, [motion])
    same = resolved(given, given.phases[0], MESH).vehicles[0].limits
    assert np.all(np.isinf(same.state_upper))


def test_rates_are_limited_to_what_the_mesh_resolves() -> None:
    limits = {"max_rate_rad_s": [1e-3, 9.0, 9.0]}
    given = scenario(spacecraft(limits=limits))
    limited = resolved(given, given.phases[0], MESH).vehicles[0].limits
    np.testing.assert_allclose(limited.state_upper[W], [1e-3, RESOLVED_RAD_S, RESOLVED_RAD_S])
    np.testing.assert_allclose(limited.state_lower[W], -limited.state_upper[W])
    assert np.all(np.isinf(limited.state_upper[:10]))
    finer = resolved(given, given.phases[0], Mesh.uniform("lgr", 10, 4)).vehicles[0].limits
    assert finer.state_upper[11] == pytest.approx(2.0 * RESOLVED_RAD_S)


def test_but_never_below_what_the_scenario_asks_for() -> None:
    spin = {"type": "spin", "axis": [0, 0, 1], "rate_rad_s": 0.4}
    wheel = structure("wheel", [5, 9, 0], box(1, 1, 1), motion=spin)
    start = {"position_m": [0, 0, 0], "rate_rad_s": [0, 0.3, 0]}
    given = scenario(spacecraft(start=start), structures=[wheel])
    limited = resolved(given, given.phases[0], MESH).vehicles[0].limits
    assert limited.state_upper[11] == pytest.approx(ROOM * 0.7)
