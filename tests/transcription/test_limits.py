"""Limits hold at every instant, not only at the nodes."""

from __future__ import annotations

import numpy as np
import pytest

from support.documents import DURATION_S, puck, scenario, spacecraft
from support.solving import Solved, posed, solved

FINE = np.linspace(0.0, DURATION_S, 3001)
SLACK = 1e-9
"""The solver ends this near outside a limit at most."""


def found(limits: dict[str, object], **changes: object) -> Solved:
    got = solved(scenario(spacecraft(limits=limits, **changes)), 5, 4)
    assert got.outcome.solved
    return got


def states(got: Solved) -> np.ndarray:
    return got.trajectory.vehicles[0].state(FINE)


def controls(got: Solved) -> np.ndarray:
    return got.trajectory.vehicles[0].control(FINE)


def test_speed_stays_below_its_limit_between_the_nodes() -> None:
    # Unbound it would reach 3 d / 2 T.
    assert np.max(states(found({}))[:, 3]) == pytest.approx(0.15, rel=1e-6)
    bound = np.max(states(found({"max_speed_m_s": 0.12}))[:, 3])
    assert 0.119 < bound <= 0.12 + SLACK


def test_force_stays_below_its_limit_between_the_nodes() -> None:
    # Unbound it would begin with 6 m d / T².
    assert np.max(controls(found({}))) == pytest.approx(0.018, rel=1e-6)
    force = controls(found({"max_force_n": 0.014}))[:, 0]
    assert np.max(np.abs(force)) <= 0.014 + SLACK
    assert np.max(force) > 0.0135
    assert np.min(force) < -0.0135


def test_rate_and_torque_stay_below_theirs() -> None:
    turn = {"position_m": [0, 0, 0], "attitude": [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]}
    free = found({}, goal=turn)
    rate, torque = np.max(states(free)[:, 12]), np.max(controls(free)[:, 5])
    slow = found({"max_rate_rad_s": 0.9 * rate}, goal=turn)
    assert 0.89 * rate < np.max(np.abs(states(slow)[:, 10:])) <= 0.9 * rate + SLACK
    weak = found({"max_torque_nm": 0.9 * torque}, goal=turn)
    assert 0.88 * torque < np.max(np.abs(controls(weak)[:, 3:])) <= 0.9 * torque + SLACK


def test_a_wall_for_the_reference_point_holds_at_every_instant() -> None:
    fast = {"position_m": [0, 0, 0], "velocity_m_s": [0, -0.1, 0]}
    limits = {"position_m": {"lower": [None, -0.5, None]}}
    assert np.min(states(found({}, start=fast))[:, 1]) < -1.0
    assert -0.5 - SLACK <= np.min(states(found(limits, start=fast))[:, 1]) < -0.45


def test_a_limit_of_zero_is_an_equality() -> None:
    got = found({"max_force_n": [1.0, 0.0, 0.0]}, goal={"position_m": [10, 0, 0]})
    assert np.max(np.abs(controls(got)[:, 1:3])) < 1e-12
    assert np.max(np.abs(controls(got)[:, 0])) > 0.01


def test_only_finite_limits_make_rows_and_they_are_named() -> None:
    bare = posed(scenario(puck()), 2, 3)
    limited = posed(scenario(puck(limits={"max_force_n": [0.1, 0.2]})), 2, 3)
    # Two axes, two segments, three coefficients.
    assert limited.layout.rows.size == bare.layout.rows.size + 12
    names = {block.label(0) for block in limited.layout.rows.blocks}
    assert "limit[puck, fy_n, from t = 50.0 s]" in names
    assert not any(block.label(0).startswith("limit") for block in bare.layout.rows.blocks)
