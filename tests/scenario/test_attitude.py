"""Sets of attitudes."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.scenario.attitude import AxisAttitude, FixedAttitude, FreeAttitude, unit

X, Y, Z = np.eye(3)
QUARTER = quaternion.from_axis_angle(Z, np.pi / 2)


def test_rounding_is_normalised_and_more_is_refused() -> None:
    q = np.array([0.7071068, 0, 0, 0.7071068])  # off by 3e-8
    assert np.linalg.norm(FixedAttitude(q).q) == pytest.approx(1.0, abs=1e-15)
    for scale in (1 + 2e-6, 1 - 2e-6, 0.0):
        with pytest.raises(InputError, match="norm"):
            FixedAttitude(QUARTER * scale)
    with pytest.raises(InputError, match="NaN"):
        unit(np.array([np.nan, 0, 0, 1]), 4, "q")


def test_error_of_a_fixed_attitude_knows_the_double_cover() -> None:
    attitude = FixedAttitude(QUARTER)
    turned = quaternion.multiply(QUARTER, quaternion.from_axis_angle(X, 0.3))
    errors = attitude.error_rad(np.stack([QUARTER, -QUARTER, turned, -turned]))
    np.testing.assert_allclose(errors, [0, 0, 0.3, 0.3], atol=1e-7)


@pytest.mark.parametrize("world", [X, Y, Z, -X, np.array([-1, 1e-9, 0]), np.array([1, 2, -3.0])])
def test_nominal_of_an_axis_attitude_is_a_member(world: np.ndarray) -> None:
    attitude = AxisAttitude(2 * X, world)
    q = attitude.nominal()
    assert float(attitude.error_rad(q)) == pytest.approx(0.0, abs=1e-8)
    rolled = quaternion.multiply(q, quaternion.from_axis_angle(X, 1.1))
    assert float(attitude.error_rad(rolled)) == pytest.approx(0.0, abs=1e-8)
    tilted = quaternion.multiply(q, quaternion.from_axis_angle(Y, 0.2))
    assert float(attitude.error_rad(tilted)) == pytest.approx(0.2, abs=1e-8)


def test_frames_turn_the_sets() -> None:
    frame = quaternion.from_axis_angle(np.array([1.0, 2, 3]), 0.8)
    fixed = FixedAttitude(QUARTER, 0.1).in_frame(frame)
    assert float(fixed.error_rad(quaternion.multiply(frame, QUARTER))) == pytest.approx(0, abs=1e-7)
    assert fixed.tolerance_rad == 0.1
    axis = AxisAttitude(X, Y, 0.2).in_frame(frame)
    assert float(axis.error_rad(quaternion.multiply(frame, QUARTER))) == pytest.approx(0, abs=1e-7)
    assert axis.tolerance_rad == 0.2
    free = FreeAttitude().in_frame(frame)
    assert not free.error_rad(np.stack([QUARTER, frame])).any()


@pytest.mark.parametrize("tolerance", [-0.1, np.nan, 4.0])
def test_bad_tolerances_are_refused(tolerance: float) -> None:
    with pytest.raises(InputError, match="tolerance_rad"):
        FixedAttitude(QUARTER, tolerance)
    with pytest.raises(InputError, match="tolerance_rad"):
        AxisAttitude(X, Y, tolerance)
