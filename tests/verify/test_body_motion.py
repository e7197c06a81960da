"""Jets are the derivatives of poses, and ceilings hold between them."""

import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.native_state import Model
from berthing.scenario.point_mass import PointMass
from berthing.scenario.tabulated import Tabulated
from berthing.verify.body_motion import BodyMotion
from berthing.verify.frames import structure_motion, vehicle_motion
from berthing.verify.pair_motion import BodyPair
from berthing.verify.polynomial_motion import UnboundedAttitudeError

STEP = 1e-4
SPAN = (0.0, 10.0)


def tumbling(rng: np.random.Generator):
    amplitude, pace = rng.normal(size=(3, 3)), rng.uniform(0.1, 0.8, (3, 1))
    axis, tilt = rng.normal(size=3), quaternion.normalise(rng.normal(size=4))

    def position(t: np.ndarray) -> np.ndarray:
        return np.sin(pace * t).T @ amplitude

    def attitude(t: np.ndarray) -> np.ndarray:
        turned = quaternion.from_axis_angle(axis, 2.0 * np.sin(0.4 * t))
        return (1.0 + 0.05 * np.sin(t))[:, None] * quaternion.multiply(turned, tilt)

    return position, attitude


def table() -> Tabulated:
    position, attitude = tumbling(np.random.default_rng(3))
    t = np.linspace(1.0, 9.0, 12)
    return Tabulated(t, position(t), quaternion.normalise(attitude(t)))


POSE = Pose.from_quaternion(np.array([1.0, 2.0, 3.0]), np.array([0.6, 0.0, 0.8, 0.0]))
LAWS: dict[str, Motion] = {
    "fixed": Fixed(POSE),
    "velocity": ConstantVelocity(POSE, np.array([0.1, -0.2, 0.3])),
    "spin": ConstantSpin(POSE, np.array([1.0, 2.0, -1.0]), 0.7, np.array([0.1, 0.0, 0.0])),
    "table": table(),
    "flat spin": ConstantSpin(
        Pose.planar(np.array([1.0, 2.0]), 0.3), np.array([0.0, 0.0, 1.0]), 0.5, np.array([0.1, 0.2])
    ),
}


def cells(motion: BodyMotion, t: np.ndarray) -> np.ndarray:
    index = np.searchsorted(motion.edges_s, t, side="right") - 1
    return np.clip(index, 0, len(motion.edges_s) - 2)


def check_jets(motion: BodyMotion) -> None:
    t = np.linspace(0.1, 9.9, 37)
    here = cells(motion, t)
    jet, before, after = (motion.jet(t + dt, here) for dt in (0.0, -STEP, STEP))

    def difference(name: str) -> np.ndarray:
        return (getattr(after, name) - getattr(before, name)) / (2.0 * STEP)

    np.testing.assert_allclose(difference("position"), jet.velocity, atol=1e-6)
    np.testing.assert_allclose(difference("velocity"), jet.acceleration, atol=1e-6)
    np.testing.assert_allclose(difference("rate"), jet.rate_dot, atol=1e-6)
    spin = difference("rotation") @ np.swapaxes(jet.rotation, 1, 2)
    found = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    np.testing.assert_allclose(found, jet.rate, atol=1e-6)
    np.testing.assert_allclose(
        jet.rotation @ np.swapaxes(jet.rotation, 1, 2), np.broadcast_to(np.eye(3), (37, 3, 3)),
        atol=1e-14,
    )  # fmt: skip


def check_ceilings(motion: BodyMotion) -> None:
    t = np.linspace(0.0, 10.0, 4001)[1:-1]
    here = cells(motion, t)
    jet, ceilings = motion.jet(t, here), motion.ceilings.at(here)
    slope = {
        name: (
            getattr(motion.jet(t + STEP, here), name) - getattr(motion.jet(t - STEP, here), name)
        )
        / (2.0 * STEP)
        for name in ("acceleration", "rate_dot")
    }
    for values, ceiling in (
        (jet.acceleration, ceilings.acceleration),
        (slope["acceleration"], ceilings.jerk),
        (jet.rate, ceilings.rate),
        (jet.rate_dot, ceilings.rate_dot),
        (slope["rate_dot"], ceilings.rate_ddot),
        (jet.position, ceilings.length),
    ):
        assert np.all(np.linalg.norm(values, axis=1) <= ceiling * (1 + 1e-6) + 1e-5)


@pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
def test_a_structure_moves_as_its_law_says(law: Motion) -> None:
    motion = structure_motion(law, SPAN)
    t = np.linspace(0.0, 10.0, 101)
    jet, pose = motion.jet(t, cells(motion, t)), law.pose(t)
    d = law.dim
    np.testing.assert_allclose(jet.position[:, :d], pose.position, atol=1e-13)
    np.testing.assert_allclose(jet.rotation[:, :d, :d], pose.rotation, atol=1e-13)
    check_jets(motion)
    check_ceilings(motion)


@pytest.mark.parametrize("degree", [3, 5, 12])
def test_a_vehicle_moves_as_its_interpolant_says(make, degree: int) -> None:
    own = make.vehicle(Box(np.ones(3)))
    flown = make.path(own, *tumbling(np.random.default_rng(degree)), degree=degree)
    motion = vehicle_motion(own.model, flown)
    t = np.linspace(0.0, 10.0, 101)
    jet, pose = motion.jet(t, cells(motion, t)), own.model.pose(flown.state(t))
    np.testing.assert_allclose(jet.position, pose.position, atol=1e-12)
    np.testing.assert_allclose(jet.rotation, pose.rotation, atol=1e-12)
    check_jets(motion)
    check_ceilings(motion)


def test_relative_motion_is_that_of_the_placed_point(make) -> None:
    rng = np.random.default_rng(11)
    own = make.vehicle(Box(np.ones(3)))
    a = vehicle_motion(own.model, make.path(own, *tumbling(rng)))
    b = structure_motion(LAWS["table"], SPAN)
    pair, offset = BodyPair(a, b), np.array([[0.5, -1.0, 2.0]])
    middle = 0.5 * (pair.edges_s[1:] + pair.edges_s[:-1])
    half = 0.5 * np.diff(pair.edges_s)
    index = pair.cells(middle)
    motion = pair.motion(middle, half, index, np.repeat(offset, len(middle), axis=0))

    def centre(t: np.ndarray) -> np.ndarray:
        pose = pair.pose(t, index)
        return pose.position + pose.rotation @ offset[0]

    h = 1e-3
    low, mid, high = centre(middle - h), centre(middle), centre(middle + h)
    np.testing.assert_allclose((high - low) / (2 * h), motion.velocity, atol=1e-5)
    np.testing.assert_allclose((high - 2 * mid + low) / h**2, motion.acceleration, atol=1e-4)

    # The ceilings hold over the whole interval: compare with motions of points inside it.
    def rotation(t: np.ndarray) -> np.ndarray:
        return pair.pose(t, index).rotation

    for s in np.linspace(-0.95, 0.95, 9):
        inner = pair.motion(
            middle + s * half, 0.0 * half, index, np.repeat(offset, len(middle), axis=0)
        )
        stray = np.linalg.norm(inner.acceleration - motion.acceleration, axis=1)
        assert np.all(stray <= motion.jerk * np.abs(s) * half + 1e-12)
        t = middle + s * half
        slope = (rotation(t + h) - rotation(t - h)) / (2 * h)
        bend = (rotation(t + h) - 2 * rotation(t) + rotation(t - h)) / h**2
        for found, ceiling in ((slope, motion.turn_rate), (bend, motion.turn_bend)):
            assert np.all(np.linalg.norm(found, ord=2, axis=(1, 2)) <= ceiling * (1 + 1e-6) + 1e-6)
        # Nor are they far above: at the middle of a short interval they are what is there.
        assert np.all(inner.turn_rate <= np.linalg.norm(slope, ord=2, axis=(1, 2)) + 1e-5)


def test_a_quaternion_through_zero_has_no_bound(make) -> None:
    own = make.vehicle(Box(np.ones(3)))

    def shrinking(t: np.ndarray) -> np.ndarray:
        return (t - 5.03)[:, None] * np.array([[1.0, 0.0, 0.0, 0.0]])

    flown = make.path(own, lambda t: np.zeros((len(t), 3)), shrinking)
    with pytest.raises(UnboundedAttitudeError, match="near zero about t = 4"):
        vehicle_motion(own.model, flown)


def test_a_model_or_law_that_is_not_known_is_refused(make) -> None:
    class Other(PointMass):
        kind = "other"

    class Drift(Fixed):
        kind = "drift"

    own = make.vehicle(Box(np.ones(3)))
    other: Model = Other(1.0)
    with pytest.raises(CapabilityError, match="'other'"):
        vehicle_motion(other, make.path(own, lambda t: np.zeros((len(t), 3))))
    with pytest.raises(CapabilityError, match="'drift'"):
        structure_motion(Drift(Pose.identity()), SPAN)
