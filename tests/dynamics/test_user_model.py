"""The user's own equations, with expressions and with numbers."""

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.casadi_xp import CASADI
from berthing.dynamics.models import symbolic
from berthing.errors import InputError
from berthing.scenario.rigid_body import RigidBody
from berthing.verify.equations import derivative
from berthing.xp import NUMPY
from support import users


@pytest.fixture(params=["rover", "twin", "sliding"])
def model(request):
    made = {
        "rover": users.rover,
        "twin": lambda: users.twin(RigidBody(3.0, np.diag([2.0, 5.0, 6.0]))),
        "sliding": users.sliding,
    }
    return made[request.param]()


def columns(model):
    return ca.SX.sym("x", len(model.state_names)), ca.SX.sym("u", len(model.control_names))


def test_expressions_and_numbers_agree(model):
    x, u = columns(model)
    f = ca.Function("f", [x, u], [symbolic(model).derivative(model, 0.7, x, u)])
    rng = np.random.default_rng(5)
    at = rng.normal(size=x.numel()), rng.normal(size=u.numel())
    np.testing.assert_allclose(np.array(f(*at)).ravel(), derivative(model)(0.7, *at), atol=1e-12)


def test_pose_and_rates_agree(model):
    x, _ = columns(model)
    body = symbolic(model).kinematics(model, x)
    out = [body.position, body.rotation, body.velocity]
    at = np.random.default_rng(6).normal(size=x.numel())
    position, rotation, velocity = (np.array(v) for v in ca.Function("k", [x], out)(at))
    pose, (moving, _) = model.pose(at), model.velocity(at)
    np.testing.assert_allclose(position.ravel(), pose.position, atol=1e-14)
    np.testing.assert_allclose(rotation, pose.rotation, atol=1e-14)
    np.testing.assert_allclose(velocity.ravel(), moving, atol=1e-14)


@pytest.mark.parametrize("angle", [0.4, -2.9])
def test_in_the_plane_one_row_tells_the_turn_that_is_left(angle):
    body = symbolic(users.rover()).kinematics(users.rover(), ca.DM([0, 0, angle, 0, 0]))
    target = np.array([np.cos(0.2), 0, 0, np.sin(0.2)])
    error = body.attitude_error(ca.DM(target))
    assert error.numel() == 1
    assert float(error) == pytest.approx(np.sin(0.5 * (angle - 0.4)))


def test_without_rates_there_are_none():
    body = symbolic(users.sliding()).kinematics(users.sliding(rates=None), ca.SX.sym("x", 6))
    assert body.velocity is None
    assert body.rate_body is None


def test_a_mistake_is_told():
    model = users.sliding(derivative=lambda t, x, u, p, xp: np.concatenate([x[3:], u]))
    with pytest.raises(InputError, match=r"user model sliding\.derivative: raises"):
        symbolic(model).derivative(model, 0.0, *columns(model))


VOCABULARY = {
    "exp": lambda x, xp: xp.exp(x[0]),
    "log": lambda x, xp: xp.log(x[1]),
    "sqrt": lambda x, xp: xp.sqrt(x[1]) + xp.norm(x),
    "arctan": lambda x, xp: xp.arctan(x[0]) + xp.arctan2(x[0], x[1]),
    "extremes": lambda x, xp: xp.abs(x[0]) + xp.minimum(x[0], x[1]) + xp.maximum(x[0], 0.1),
    "where": lambda x, xp: xp.where(x[0] > 0, x[1], x[2]),
    "tan": lambda x, xp: xp.tan(x[0]) + xp.tanh(x[1]),
    "plane": lambda x, xp: xp.rotate_plane(x[0], x[1:3])[1],
    "matrix": lambda x, xp: xp.matvec(np.eye(3)[::-1], x)[0],
    "circle": lambda x, xp: xp.pi * x[0] ** 2,
}


@pytest.mark.parametrize("name", VOCABULARY)
@pytest.mark.parametrize("first", [-0.7, 0.4])
def test_the_vocabulary_means_one_thing(name, first):
    x = ca.SX.sym("x", 3)
    at = np.array([first, 1.3, -2.0])
    function = ca.Function("f", [x], [VOCABULARY[name](x, CASADI)])
    assert float(function(at)) == pytest.approx(float(VOCABULARY[name](at, NUMPY)), rel=1e-14)
