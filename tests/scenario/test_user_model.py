"""Models of the user's own: maps, names, and mistakes that are told as the user's."""

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.attitude import AxisAttitude, FixedAttitude, FreeAttitude
from berthing.scenario.cost import Cost, RunningCost
from berthing.scenario.goal import End
from berthing.scenario.limits import Limits
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_function import UserFunction
from berthing.scenario.vehicle import Vehicle
from berthing.xp import NUMPY
from support import users


def test_a_twin_has_the_pose_and_rates_of_what_it_copies():
    model = RigidBody(3.0, np.diag([2.0, 5.0, 6.0]))
    x = np.random.default_rng(0).normal(size=(4, 2, 13))
    own = users.twin(model)
    np.testing.assert_allclose(own.pose(x).position, model.pose(x).position)
    np.testing.assert_allclose(own.pose(x).rotation, model.pose(x).rotation, atol=1e-14)
    for found, wanted in zip(own.velocity(x), model.velocity(x), strict=True):
        np.testing.assert_allclose(found, wanted, atol=1e-12)
    r, v = x[..., :3], x[..., 3:6]
    q, w = np.broadcast_to(x[0, 0, 6:10], (4, 2, 4)), x[..., 10:13]
    np.testing.assert_array_equal(own.assemble(r, q, v, w), model.assemble(r, q, v, w))


def test_in_the_plane_the_attitude_is_an_angle():
    rover = users.rover()
    x = np.array([[1.0, 2.0, 0.5 * np.pi, 2.0, 0.0]])
    pose = rover.pose(x)[0]
    np.testing.assert_allclose(pose.apply(np.array([1.0, 0.0])), [1.0, 3.0], atol=1e-15)
    velocity, rate = rover.velocity(x)
    np.testing.assert_allclose(velocity, [[0.0, 2.0]], atol=1e-15)
    np.testing.assert_allclose(rate, [[0.0, 0.0, 0.0]])
    q = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.float64(0.3))
    row = rover.assemble(np.array([1.0, 2.0]), q, np.zeros(2), np.zeros(3))
    np.testing.assert_allclose(row, [1.0, 2.0, 0.3, 0.0, 0.0])


def test_states_are_assembled_as_told():
    def assemble(r, angle, v, rate, p):
        return [*r, angle, np.hypot(*v), p["wheelbase_m"] * rate]

    from dataclasses import replace

    rover = replace(users.rover(), assemble_state=assemble)
    q = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.float64(0.3))
    row = rover.assemble(np.array([1.0, 2.0]), q, np.array([3.0, 4.0]), np.array([0, 0, 0.2]))
    np.testing.assert_allclose(row, [1.0, 2.0, 0.3, 5.0, 0.2])


def test_what_the_state_does_not_tell_is_not_a_number():
    silent = users.sliding(rates=None)
    velocity, rate = silent.velocity(np.zeros((2, 6)))
    assert velocity.shape == rate.shape == (2, 3)
    assert np.all(np.isnan(velocity))


MISTAKES = {
    "raises ZeroDivisionError": {"derivative": lambda t, x, u, p, xp: 1 / 0},
    "raises KeyError: 'weight'": {"derivative": lambda t, x, u, p, xp: p["weight"]},
    "gives 2 values (expected 6)": {"derivative": lambda t, x, u, p, xp: x[0:2]},
    "gives nothing": {"derivative": lambda t, x, u, p, xp: None},
    "has no attribute 'sinh'": {"derivative": lambda t, x, u, p, xp: xp.sinh(x)},
}


@pytest.mark.parametrize("message", MISTAKES)
def test_mistakes_are_the_users(message):
    model = users.sliding(**MISTAKES[message])
    with pytest.raises(InputError) as error:
        model.f(0.0, np.zeros(6), np.zeros(3), NUMPY)
    assert str(error.value).startswith("user model sliding.derivative: ")
    assert message in str(error.value)


def test_a_pose_has_two_parts_where_it_turns():
    from dataclasses import replace

    rover = replace(users.rover(), place=lambda x, p, xp: x[0:2])
    with pytest.raises(InputError, match="gives one thing"):
        rover.pose(np.zeros((1, 5)))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"workspace_dim": 4}, "is 4"),
        ({"attitude": "angle"}, "none or quaternion"),
        ({"attitude": "euler"}, "'euler'"),
        ({"states": ("x_m", "x_m")}, "repeats a name"),
        ({"states": ()}, "no states"),
    ],
)
def test_bad_models_are_refused(changes, message):
    with pytest.raises(InputError, match=message):
        users.sliding(**changes)


def vehicle(model, start=None, goal=None):
    body = Body((Part("core", Sphere(0.1, model.dim), Pose.identity(model.dim)),))
    limits = Limits.unbounded(len(model.state_names), len(model.control_names))
    free = End(np.zeros(model.dim), attitude=FreeAttitude())
    return Vehicle("craft", body, model, limits, start or free, goal or free)


@pytest.mark.parametrize(
    ("end", "message"),
    [
        ({"states": {"mass_kg": 3.0}}, "has 'mass_kg'"),
        ({"attitude": AxisAttitude(np.eye(3)[0], np.eye(3)[1])}, "leaves the plane"),
        ({"attitude": FixedAttitude(np.array([0.6, 0.8, 0, 0]))}, "leaves the plane"),
    ],
)
def test_ends_ask_for_what_there_is(end, message):
    with pytest.raises(InputError, match=message):
        vehicle(users.rover(), goal=End(np.zeros(2), **({"attitude": FreeAttitude()} | end)))


def test_rates_are_not_asked_of_a_model_that_does_not_tell_them():
    silent = users.sliding(rates=None)
    with pytest.raises(InputError, match=r"craft\.start\.velocity_m_s"):
        vehicle(silent, start=End(np.zeros(3), velocity_m_s=np.zeros(3)))


def test_a_state_given_is_a_number():
    with pytest.raises(InputError, match="speed_m_s"):
        End(np.zeros(2), states={"speed_m_s": np.nan})


@pytest.mark.parametrize("key", ["tolerance", "scale"])
def test_constraints_have_positive_sizes(key):
    function = UserFunction("g", lambda t, x, u, p, xp: x[0])
    with pytest.raises(InputError, match=key):
        PathConstraint("g", function, **{key: 0.0})


def test_a_running_cost_is_something_to_minimise():
    function = UserFunction("h", lambda t, x, u, p, xp: x[0])
    assert Cost(0.0, 0.0, [RunningCost("craft", function)]).running[0].scale == 1.0
    with pytest.raises(InputError, match="scale"):
        RunningCost("craft", function, -1.0)
    with pytest.raises(InputError, match="something to minimise"):
        Cost(0.0, 0.0)
