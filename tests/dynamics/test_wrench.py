"""Tables of manipulators' wrenches as expressions of time."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.wrench import wrench_expression
from berthing.scenario.wrench import Wrench

ARM = Wrench(
    "arm", np.array([1.0, 0.5, -0.2]), np.array([0.0, 4.0, 9.0]),
    np.array([[0.0, 0.1, 0.0], [0.3, -0.1, 0.2], [0.1, 0.0, 0.1]]),
    np.array([[0.1, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.3]]),
)  # fmt: skip
TETHER = Wrench(
    "tether", np.zeros(3), np.array([2.0]), np.array([[0.0, 0.0, 0.5]]), np.ones((1, 3))
)
TIMES = [-5.0, 0.0, 1.3, 4.0, 6.2, 9.0, 30.0]


def evaluated(wrenches: tuple[Wrench, ...], t: float) -> np.ndarray:
    time = ca.SX.sym("t")
    table = ca.Function("table", [time], [wrench_expression(wrenches, time)])
    return np.asarray(table(t)).ravel()


@pytest.mark.parametrize("t", TIMES)
def test_is_the_table_between_and_outside_its_times(t) -> None:
    force, torque = ARM.total(np.array([t]))
    np.testing.assert_allclose(evaluated((ARM,), t), [*force[0], *torque[0]], atol=1e-15)


def test_several_add_up_and_none_is_zero() -> None:
    both = evaluated((ARM,), 1.3) + evaluated((TETHER,), 1.3)
    np.testing.assert_allclose(evaluated((ARM, TETHER), 1.3), both, atol=1e-15)
    assert not evaluated((), 1.3).any()


def test_the_point_of_the_force_matters() -> None:
    centred = Wrench("arm", np.zeros(3), ARM.times_s, ARM.force_n, ARM.torque_nm)
    gap = evaluated((ARM,), 4.0) - evaluated((centred,), 4.0)
    np.testing.assert_allclose(gap[:3], 0.0, atol=1e-15)
    np.testing.assert_allclose(gap[3:], np.cross(ARM.point_m, ARM.force_n[1]), atol=1e-15)
    assert np.max(np.abs(gap)) > 0.1
