"""Laws of motion: velocity is the derivative of pose, and the bounds bound it."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.pose import Pose
from berthing.scenario.motion import ANALYTIC, ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.tabulated import Tabulated

TURNED = Pose.from_quaternion(
    np.array([1.0, 2, 3]), quaternion.from_axis_angle(np.array([1.0, 1, 0]), 0.7)
)
PLANAR = Pose.planar(np.array([1.0, 2]), 0.4)


def _table(dim: int) -> Tabulated:
    rng = np.random.default_rng(3)
    times = np.array([0.0, 7, 11, 20, 32, 40])
    if dim == 2:
        q = quaternion.from_axis_angle(np.array([0.0, 0, 1]), rng.uniform(-0.6, 0.6, 6))
    else:
        q = quaternion.from_rotation_vector(rng.uniform(-0.6, 0.6, (6, 3)))
    q *= np.array([1.0, -1, 1, 1, -1, 1])[:, None]  # signs are for the table to settle
    return Tabulated(times, rng.normal(size=(6, dim)), q)


LAWS: dict[str, Motion] = {
    "fixed": Fixed(TURNED),
    "drift": ConstantVelocity(TURNED, np.array([0.1, -0.2, 0.3])),
    "spin": ConstantSpin(TURNED, np.array([0.0, 1, 2]), -0.3, np.array([0.1, 0, 0])),
    "table": _table(3),
    "planar fixed": Fixed(PLANAR),
    "planar drift": ConstantVelocity(PLANAR, np.array([0.1, -0.2])),
    "planar spin": ConstantSpin(PLANAR, np.array([0.0, 0, -2]), 0.3, np.array([0.1, 0])),
    "planar table": _table(2),
}


@pytest.mark.parametrize("motion", LAWS.values(), ids=LAWS.keys())
def test_velocity_is_the_derivative_of_pose(motion: Motion) -> None:
    t, h = np.linspace(0.5, 39.5, 301), 1e-4
    velocity, rate = motion.velocity(t)
    before, after, here = motion.pose(t - h), motion.pose(t + h), motion.pose(t)
    assert here.dim == motion.dim
    assert velocity.shape == (301, motion.dim)
    assert rate.shape == (301, 3)
    np.testing.assert_allclose((after.position - before.position) / (2 * h), velocity, atol=1e-6)
    # Ṙ = ω^× R, so that a point of the body moves with ω × (R p).
    point = np.array([0.3, -0.8, 0.5])[: motion.dim]
    swept = (after.rotate(point) - before.rotate(point)) / (2 * h)
    arm = np.pad(here.rotate(point), ((0, 0), (0, 3 - motion.dim)))
    np.testing.assert_allclose(swept, np.cross(rate, arm)[:, : motion.dim], atol=1e-6)


@pytest.mark.parametrize("motion", LAWS.values(), ids=LAWS.keys())
@pytest.mark.parametrize("span", [(0.0, 40.0), (3.0, 3.5), (9.0, 25.0), (11.0, 20.0), (5.0, 5.0)])
def test_speed_bounds_hold_and_are_tight(motion: Motion, span: tuple[float, float]) -> None:
    velocity, rate = motion.velocity(np.linspace(*span, 2001))
    fastest = np.linalg.norm(velocity, axis=1).max(), np.linalg.norm(rate, axis=1).max()
    bound = motion.speed_bound(*span)
    assert bound[0] >= fastest[0] - 1e-12
    assert bound[1] >= fastest[1] - 1e-12
    # Over a short span, bounds from Bernstein coefficients are near the truth.
    if span[1] - span[0] <= 0.5:
        assert bound[0] <= fastest[0] * 1.1 + 1e-12
        assert bound[1] <= fastest[1] * 1.3 + 1e-12


def test_continuity_is_declared() -> None:
    assert LAWS["spin"].continuity == ANALYTIC
    table = LAWS["table"]
    assert table.continuity == 2
    # Second differences across a row agree from both sides.
    h = 1e-3
    knot = 11.0
    left, right = (table.velocity(np.array([knot, knot + s * h])) for s in (-1, 1))
    for value in (0, 1):
        before = (left[value][0] - left[value][1]) / h
        after = (right[value][1] - right[value][0]) / h
        np.testing.assert_allclose(before, after, atol=2e-3)


def test_table_goes_through_its_rows_and_holds_outside() -> None:
    table = _table(3)
    poses = table.pose(np.array([-5.0, *table.times_s, 99.0]))
    np.testing.assert_allclose(poses.position[1:-1], table.positions_m, atol=1e-12)
    expected = quaternion.rotation_matrix(table.quaternions)
    np.testing.assert_allclose(poses.rotation[1:-1], expected, atol=1e-12)
    np.testing.assert_allclose(poses.position[0], table.positions_m[0])
    np.testing.assert_allclose(poses.position[-1], table.positions_m[-1])
    assert table.span_s == (0.0, 40.0)


def test_coefficients_are_the_whole_law() -> None:
    """What a symbolic form is built from gives the same poses."""
    table = _table(3)
    i, t = 2, 13.0
    s = t - table.times_s[i]
    value = sum(table.coefficients[k, i] * s ** (3 - k) for k in range(4))
    pose = table.pose(np.array([t]))[0]
    np.testing.assert_allclose(value[:3], pose.position)
    np.testing.assert_allclose(quaternion.rotation_matrix(value[3:]), pose.rotation, atol=1e-14)


@pytest.mark.parametrize(
    ("times", "angles", "says"),
    [
        ([0.0, 5.0, 5.0], [0.0, 0.1, 0.2], "do not increase"),
        ([0.0], [0.0], "do not increase"),
        ([0.0, 5.0, 9.0], [0.0, 1.5, 3.1], "turn by 1.6 rad between 5 and 9 s"),
        ([0.0, 1.0, 50.0], [0.0, 1.5, 0.0], "overshoot between 1 and 50 s"),
    ],
)
def test_bad_tables_are_refused(times: list[float], angles: list[float], says: str) -> None:
    q = quaternion.from_axis_angle(np.array([0.0, 0, 1]), np.array(angles))
    with pytest.raises(InputError, match=says):
        Tabulated(np.array(times), np.zeros((len(times), 3)), q)


def test_table_refuses_quaternions_that_are_not_unit_or_leave_the_plane() -> None:
    times, rows = np.array([0.0, 1.0]), np.array([[1.0, 0, 0, 0], [1.0, 0.01, 0, 0]])
    with pytest.raises(InputError, match=r"quaternions\[1\]"):
        Tabulated(times, np.zeros((2, 3)), rows)
    rows = quaternion.normalise(rows)
    Tabulated(times, np.zeros((2, 3)), rows)
    with pytest.raises(InputError, match="out of the plane"):
        Tabulated(times, np.zeros((2, 2)), rows)


def test_bad_laws_are_refused() -> None:
    with pytest.raises(InputError, match="leaves the plane"):
        ConstantSpin(PLANAR, np.array([0.0, 1, 1]), 0.3, np.zeros(2))
    with pytest.raises(InputError, match="zero"):
        ConstantSpin(TURNED, np.zeros(3), 0.3, np.zeros(3))
    with pytest.raises(InputError, match="velocity_m_s"):
        ConstantVelocity(TURNED, np.zeros(2))
    with pytest.raises(InputError, match="rate_rad_s"):
        ConstantSpin(TURNED, np.array([0.0, 0, 1]), np.nan, np.zeros(3))
