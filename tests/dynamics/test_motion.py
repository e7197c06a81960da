"""Motion laws as expressions against the numeric ones and against finite differences."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.motion import symbolic_motion
from berthing.errors import CapabilityError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.tabulated import Tabulated

TURN = quaternion.from_axis_angle(np.array([1.0, 2.0, -0.5]), 0.7)
SPACE = Pose.from_quaternion(np.array([1.0, -2.0, 0.5]), TURN)
PLANE = Pose.planar(np.array([1.0, -2.0]), 0.4)
KNOTS = np.array([0.0, 10.0, 25.0, 30.0, 60.0])


def table(dim: int) -> Tabulated:
    along = np.sin(np.outer(0.05 * KNOTS, np.arange(1, dim + 1)))
    axis = np.array([0.0, 0.0, 1.0]) if dim == 2 else np.array([1.0, 2.0, -0.5])
    turns = quaternion.from_axis_angle(np.tile(axis, (len(KNOTS), 1)), 0.03 * KNOTS)
    return Tabulated(KNOTS, along, turns)


LAWS: dict[str, Motion] = {
    "fixed": Fixed(SPACE),
    "fixed-2d": Fixed(PLANE),
    "velocity": ConstantVelocity(SPACE, np.array([0.1, 0.0, -0.2])),
    "velocity-2d": ConstantVelocity(PLANE, np.array([0.1, -0.2])),
    "spin": ConstantSpin(SPACE, np.array([1.0, 1.0, 0.0]), 0.2, np.array([0.0, 0.1, 0.0])),
    "spin-2d": ConstantSpin(PLANE, np.array([0.0, 0.0, -1.0]), 0.2, np.array([0.0, 0.1])),
    "table": table(3),
    "table-2d": table(2),
}
TIMES = [0.0, 3.7, 10.0, 26.1, 59.0]

At = Callable[[float], tuple[Array, Array, Array, Array]]


def frame_at(law: Motion, base: Pose | None = None) -> At:
    """t → position, rotation, velocity, rate, from the expressions."""
    form, t = symbolic_motion(law), ca.SX.sym("t")
    base = form.base(law) if base is None else base
    frame = form.frame(law, ca.DM(base.position), ca.DM(base.rotation), t)
    out = [frame.position, frame.rotation, frame.velocity, frame.rate]
    f = ca.Function("frame", [t], [ca.SX(v) for v in out])

    def at(time: float) -> tuple[Array, Array, Array, Array]:
        r, R, v, w = (np.array(value) for value in f(time))
        return r[:, 0], R, v[:, 0], w[:, 0]

    return at


@pytest.fixture(params=LAWS.values(), ids=LAWS.keys())
def law(request) -> Motion:
    return request.param


@pytest.mark.parametrize("t", TIMES)
def test_is_the_numeric_law(law, t) -> None:
    r, R, v, w = frame_at(law)(t)
    pose = law.pose(np.array([t]))[0]
    velocity, rate = law.velocity(np.array([t]))
    np.testing.assert_allclose(r, pose.position, atol=1e-13)
    np.testing.assert_allclose(R, pose.rotation, atol=1e-13)
    np.testing.assert_allclose(v, velocity[0], atol=1e-13)
    np.testing.assert_allclose(w, rate[0], atol=1e-13)


def test_velocity_and_rate_are_those_of_the_pose(law) -> None:
    at, step = frame_at(law), 1e-5
    for t in (3.7, 26.1, 44.0):
        (r1, R1, _, _), (r0, R0, _, _) = at(t + step), at(t - step)
        _, R, v, w = at(t)
        np.testing.assert_allclose((r1 - r0) / (2 * step), v, atol=1e-8)
        # Ṙ = ω^× R, with ω in inertial axes.
        skew = (R1 - R0) / (2 * step) @ R.T
        if law.dim == 3:
            np.testing.assert_allclose([skew[2, 1], skew[0, 2]], w[:2], atol=1e-8)
        np.testing.assert_allclose(skew[1, 0], w[2], atol=1e-8)


@pytest.mark.parametrize("name", ["velocity", "spin", "spin-2d"])
def test_moves_as_well_from_another_pose(name) -> None:
    law = LAWS[name]
    base = (
        Pose.planar(np.array([3.0, 1.0]), -1.1)
        if law.dim == 2
        else Pose.from_quaternion(np.array([3.0, 1.0, 0.2]), np.array([0.5, 0.1, -0.7, 0.2]))
    )
    moved = type(law)(**{**vars(law), "pose0": base})
    r, R, v, w = frame_at(law, base)(26.1)
    pose, (velocity, rate) = moved.pose(np.array([26.1]))[0], moved.velocity(np.array([26.1]))
    np.testing.assert_allclose(r, pose.position, atol=1e-13)
    np.testing.assert_allclose(R, pose.rotation, atol=1e-13)
    np.testing.assert_allclose(v, velocity[0], atol=1e-13)
    np.testing.assert_allclose(w, rate[0], atol=1e-13)
    assert np.max(np.abs(r - frame_at(law)(26.1)[0])) > 0.1


def test_a_table_holds_outside_its_times() -> None:
    at = frame_at(LAWS["table"])
    np.testing.assert_allclose(at(-3.0)[0], at(0.0)[0], atol=1e-15)
    np.testing.assert_allclose(at(99.0)[1], at(60.0)[1], atol=1e-15)
    assert np.max(np.abs(at(58.0)[0] - at(60.0)[0])) > 1e-3


def test_an_unknown_law_is_told_which_there_are() -> None:
    class Wobble(Fixed):
        kind: ClassVar[str] = "wobble"

    with pytest.raises(CapabilityError, match=r"Wobble; there are ConstantSpin, .*Tabulated"):
        symbolic_motion(Wobble(SPACE))
