"""The table of models, and what a state says of the pose."""

from __future__ import annotations

from typing import ClassVar

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.models import symbolic
from berthing.errors import CapabilityError
from berthing.geometry import quaternion
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody

MODELS = [RigidBody(3.0, 5.0 * np.eye(3)), PointMass(2.0, 3), PointMass(2.0, 2)]


@pytest.mark.parametrize("model", MODELS, ids=["rigid-body", "point-mass", "point-mass-2d"])
def test_kinematics_are_the_numeric_pose_and_velocity(model, rng, number) -> None:
    x = rng.normal(size=len(model.state_names))
    body = symbolic(model).kinematics(model, ca.DM(x))
    pose, (velocity, rate) = model.pose(x), model.velocity(x)
    np.testing.assert_allclose(number(body.position), pose.position, atol=1e-14)
    np.testing.assert_allclose(number(body.rotation), pose.rotation, atol=1e-14)
    np.testing.assert_allclose(number(body.velocity), velocity, atol=1e-14)
    if body.rate_body is not None:
        np.testing.assert_allclose(pose.rotate(number(body.rate_body)), rate, atol=1e-14)


def test_only_what_turns_has_an_attitude(number) -> None:
    rigid, point = (symbolic(m).kinematics(m, ca.DM.ones(len(m.state_names))) for m in MODELS[:2])
    assert point.attitude_error is None
    assert point.rate_body is None
    target = quaternion.normalise(np.ones(4))
    np.testing.assert_allclose(number(rigid.attitude_error(ca.DM(target))), 0.0, atol=1e-15)
    off = number(rigid.attitude_error(ca.DM([1.0, 0.0, 0.0, 0.0])))
    assert np.linalg.norm(off) > 0.5


def test_an_unknown_model_is_told_which_there_are() -> None:
    class Bicycle(PointMass):
        kind: ClassVar[str] = "bicycle"

    with pytest.raises(CapabilityError, match="Bicycle; there are PointMass, RigidBody"):
        symbolic(Bicycle(1.0))
