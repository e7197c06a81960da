"""Ends in moving frames."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import FixedAttitude, FreeAttitude
from berthing.scenario.goal import End
from berthing.scenario.motion import ConstantSpin, Motion
from berthing.scenario.structure import Structure
from berthing.scenario.tabulated import Tabulated


class Place:
    """Finds one structure under any name."""

    def __init__(self, motion: Motion) -> None:
        sizes = np.ones(motion.dim)
        body = Body((Part("core", Box(sizes), Pose.identity(motion.dim)),))
        self.only = Structure("hub", body, motion)

    def structure(self, name: str) -> Structure:
        return self.only


SPIN = ConstantSpin(
    Pose.from_quaternion(np.array([1.0, 2, 3]), quaternion.from_axis_angle(np.ones(3), 0.5)),
    np.array([0.0, 0.6, 0.8]),
    0.05,
    np.array([0.01, 0.0, -0.02]),
)
TABLE = Tabulated(
    np.array([0.0, 20, 40]),
    np.array([[0.0, 0, 0], [1, 2, 0], [1, 1, 1]]),
    quaternion.from_rotation_vector(np.array([[0.0, 0, 0], [0.3, 0.1, 0], [0, 0.4, 0.2]])),
)


def test_an_inertial_end_is_itself() -> None:
    end = End(np.array([1.0, 2, 3]), velocity_m_s=np.ones(3), rate_rad_s=np.array([0, 0, 0.1]))
    inertial = end.resolve(12.0, Place(SPIN))
    np.testing.assert_array_equal(inertial.position_m, end.position_m)
    np.testing.assert_array_equal(inertial.velocity_m_s, np.ones(3))
    np.testing.assert_array_equal(inertial.rate_rad_s(np.array([1.0, 0, 0, 0])), [0, 0, 0.1])


@pytest.mark.parametrize("motion", [SPIN, TABLE], ids=["spin", "table"])
def test_a_body_at_rest_in_a_moving_frame_moves_with_it(motion: Motion) -> None:
    """Position, velocity, attitude and rate agree with the frame's own motion, differenced."""
    q_FB = quaternion.from_axis_angle(np.array([0.0, 1, 1]), 0.9)
    end = End(
        np.array([3.0, -1, 0.5]),
        attitude=FixedAttitude(q_FB),
        velocity_m_s=np.zeros(3),
        rate_rad_s=np.zeros(3),
        frame="hub",
    )
    place, t, h = Place(motion), 13.0, 1e-4
    now, before, after = (end.resolve(s, place) for s in (t, t - h, t + h))
    np.testing.assert_allclose(
        (after.position_m - before.position_m) / (2 * h), now.velocity_m_s, atol=1e-8
    )
    q = now.attitude.nominal()
    step = quaternion.multiply(
        quaternion.conjugate(before.attitude.nominal()), after.attitude.nominal()
    )
    rate = quaternion.rotation_vector(step) / (2 * h)
    np.testing.assert_allclose(rate, now.rate_rad_s(q), atol=1e-8)
    frame = motion.pose(np.array([t]))[0]
    expected = frame.rotation @ quaternion.rotation_matrix(q_FB)
    np.testing.assert_allclose(now.pose.rotation, expected, atol=1e-12)


def test_relative_velocity_and_rate_are_added_in_their_axes() -> None:
    rest = End(np.ones(3), velocity_m_s=np.zeros(3), rate_rad_s=np.zeros(3), frame="hub")
    moving = End(
        np.ones(3),
        velocity_m_s=np.array([0.1, 0, 0]),
        rate_rad_s=np.array([0, 0.2, 0]),
        frame="hub",
    )
    a, b = (end.resolve(30.0, Place(SPIN)) for end in (rest, moving))
    first_axis = SPIN.pose(np.array([30.0]))[0].rotation[:, 0]
    np.testing.assert_allclose(b.velocity_m_s - a.velocity_m_s, 0.1 * first_axis, atol=1e-15)
    q = quaternion.from_axis_angle(np.array([1.0, 0, 2]), 0.3)
    np.testing.assert_allclose(b.rate_rad_s(q) - a.rate_rad_s(q), [0, 0.2, 0], atol=1e-15)


def test_free_components_stay_free() -> None:
    end = End(np.ones(3), attitude=FreeAttitude(), frame="hub").resolve(1.0, Place(SPIN))
    assert end.velocity_m_s is None
    assert end.rate_rad_s(np.array([1.0, 0, 0, 0])) is None
    np.testing.assert_array_equal(end.pose.rotation, np.eye(3))


def test_planar_ends_ride_on_planar_frames() -> None:
    motion = ConstantSpin(
        Pose.planar(np.array([1.0, 1]), 0.2), np.array([0.0, 0, 1]), 0.1, np.array([0.3, 0])
    )
    end = End(np.array([2.0, 0]), attitude=FreeAttitude(), velocity_m_s=np.zeros(2), frame="hub")
    now = end.resolve(5.0, Place(motion))
    angle = 0.2 + 0.1 * 5
    expected = np.array([2.5, 1]) + 2 * np.array([np.cos(angle), np.sin(angle)])
    np.testing.assert_allclose(now.position_m, expected)
    swept = 0.2 * np.array([-np.sin(angle), np.cos(angle)])
    np.testing.assert_allclose(now.velocity_m_s, np.array([0.3, 0]) + swept)
    assert now.pose.dim == 2


@pytest.mark.parametrize(
    "make",
    [
        lambda: End(np.ones(4)),
        lambda: End(np.array([1.0, np.nan, 0])),
        lambda: End(np.ones(3), position_tolerance_m=-1.0),
        lambda: End(np.ones(3), velocity_m_s=np.ones(2)),
        lambda: End(np.ones(2), rate_rad_s=np.ones(2)),
    ],
)
def test_bad_ends_are_refused(make: Callable[[], object]) -> None:
    with pytest.raises(InputError):
        make()


def test_in_the_plane_an_end_is_turned_as_it_says() -> None:
    attitude = FixedAttitude(np.array([np.cos(0.6), 0.0, 0.0, np.sin(0.6)]))
    end = End(np.array([1.0, 2.0]), attitude=attitude).resolve(0.0, Place(TABLE))
    turned = end.pose.apply(np.array([1.0, 0.0]))
    np.testing.assert_allclose(turned, [1.0 + np.cos(1.2), 2.0 + np.sin(1.2)], atol=1e-15)
