"""Checks of models of the user's own: the same verdicts as for a model that is known."""

from itertools import pairwise

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.sphere import Sphere
from berthing.scenario.cost import Cost, RunningCost
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_function import UserFunction
from berthing.trajectory import PhaseTrajectory, Segment, VehicleTrajectory
from berthing.verify.certificate import certify
from berthing.verify.equations import derivative, knots_s
from berthing.verify.frames import vehicle_motion
from berthing.verify.path_constraints import path_excesses
from berthing.verify.polynomial_motion import UnboundedAttitudeError
from support import users


def flown(model, states, controls=None, breaks=(0.0, 1.0, 2.5)):
    """States of time ((nx,) polynomial coefficients in t, rising) on segments."""
    segments = []
    for t0, t1 in pairwise(breaks):
        s = np.cos(np.pi * (np.arange(5) + 0.5) / 5)
        t = 0.5 * (t0 + t1 + (t1 - t0) * s)
        fit = np.linalg.inv(np.polynomial.chebyshev.chebvander(s, 4))
        u = np.zeros((5, len(model.control_names))) if controls is None else controls(t)
        segments.append(Segment(t0, t1, fit @ states(t), fit @ u))
    return VehicleTrajectory(
        "craft", model.kind, model.state_names, model.control_names, tuple(segments)
    )


def tumbling(t):
    """Rigid-body states whose position and quaternion are polynomials."""
    q = np.stack([1 + 0 * t, 0.2 * t, 0.1 * t**2, -0.3 * t], axis=-1)
    r = np.stack([t, t**2, 1 - t**3 / 6], axis=-1)
    return np.hstack([r, 0 * r, q, 0 * r])


def test_equations_are_the_users():
    model = RigidBody(3.0, np.diag([2.0, 5.0, 6.0]))
    rng = np.random.default_rng(1)
    x, u = rng.normal(size=13), rng.normal(size=6)
    x[6:10] /= np.linalg.norm(x[6:10])
    np.testing.assert_allclose(
        derivative(users.twin(model))(0.3, x, u), derivative(model)(0.3, x, u), atol=1e-12
    )
    assert list(knots_s(users.sliding(kinks_s=(1.0, 2.0)))) == [1.0, 2.0]


def test_the_motion_is_that_of_the_model_it_copies():
    model = RigidBody(3.0, np.diag([2.0, 5.0, 6.0]))
    known = vehicle_motion(model, flown(model, tumbling))
    own = vehicle_motion(users.twin(model), flown(users.twin(model), tumbling))
    assert own.turns
    assert not own.rests
    t = np.array([0.0, 0.3, 0.99, 1.0, 2.4])
    cells = [np.searchsorted(m.edges_s, t, side="right") - 1 for m in (known, own)]
    jets = known.jet(t, cells[0]), own.jet(t, cells[1])
    for name in ("position", "velocity", "acceleration", "rotation", "rate", "rate_dot"):
        np.testing.assert_allclose(*(getattr(j, name) for j in jets), atol=1e-10)


def test_ceilings_hold_the_motion():
    model = users.rover()

    def turning(t):
        return np.stack([t, 0.1 * t**2, 0.4 * t**2, 1 + 0 * t, 0.1 * t], axis=-1)

    motion = vehicle_motion(model, flown(model, turning))
    for cell in range(len(motion.edges_s) - 1):
        t = np.linspace(motion.edges_s[cell], motion.edges_s[cell + 1], 9)
        jet = motion.jet(t, np.full(9, cell))
        assert np.max(np.linalg.norm(jet.rate, axis=1)) <= motion.ceilings.rate[cell] + 1e-12
        assert np.max(np.linalg.norm(jet.rate_dot, axis=1)) <= motion.ceilings.rate_dot[cell] + 1e-9
        assert motion.ceilings.acceleration[cell] >= 0.2 - 1e-9
        assert motion.ceilings.acceleration[cell] <= 0.25
    pose = model.pose(turning(np.array([0.7])))[0]
    (index,) = np.searchsorted(motion.edges_s, [0.7], side="right") - 1
    jet = motion.jet(np.array([0.7]), np.array([index]))
    np.testing.assert_allclose(jet.rotation[0][:2, :2], pose.rotation, atol=1e-12)
    np.testing.assert_allclose(jet.position[0][:2], pose.position, atol=1e-12)


def test_a_quaternion_near_zero_is_noticed():
    model = users.twin(RigidBody(3.0, np.eye(3)))

    def through_zero(t):
        x = tumbling(t)
        x[:, 6:10] = np.stack([1 - t, 0 * t, 0 * t, 0 * t], axis=-1)
        return x

    with pytest.raises(UnboundedAttitudeError):
        vehicle_motion(model, flown(model, through_zero))


@pytest.mark.parametrize("gap", [0.15, 0.05])
def test_the_certificate_says_what_it_says_of_the_known_model(make, gap):
    found = []
    for model in (PointMass(3.0), users.sliding()):
        ball = make.vehicle(Sphere(0.5), model=model)
        whole = make.scenario([ball], [make.structure(Box(np.ones(3)))], 0.1)

        def past(t):
            r = np.stack([3 * t - 3, 1.5 + gap + 0 * t, 0.1 * t**2], axis=-1)
            return np.hstack([r, 0 * r])

        trajectory = PhaseTrajectory("main", (flown(model, past),))
        found.append(certify(whole, whole.phases[0], trajectory).verdicts[0])
    assert found[0].verdict == found[1].verdict == ("certified" if gap > 0.1 else "violated")
    assert found[1].lower_bound_m <= gap + 1e-9
    if gap > 0.1:
        assert found[1].lower_bound_m >= 0.1


def climbing(t):
    """A point mass whose height is 4t − t²: 4 m at t = 2 s, between the nodes."""
    r = np.stack([t, 0 * t, 4 * t - t**2], axis=-1)
    return np.hstack([r, 0 * r])


def bounded(make, function, tolerance=1e-6):
    constraint = PathConstraint("ceiling", UserFunction("ceiling", function), tolerance)
    craft = make.vehicle(Sphere(0.5), model=PointMass(3.0))
    from dataclasses import replace

    return replace(craft, path_constraints=(constraint,))


@pytest.mark.parametrize(("height", "excess"), [(4.0 + 1e-9, 0.0), (3.99, 0.01)])
def test_a_path_constraint_is_proven_between_the_nodes(make, height, excess):
    craft = bounded(make, lambda t, x, u, p, xp: xp.vector(x[2] - height, -1.0))
    found = path_excesses(craft, flown(craft.model, climbing))
    assert len(found) == (excess > 0)
    for one in found:
        assert one.component == "path ceiling"
        assert 0 < one.value <= excess + 1e-9
        assert one.time_s == pytest.approx(2.0, abs=0.11)


def test_a_constraint_that_jumps_is_decided_or_doubted(make):
    def jumps(t, x, u, p, xp):
        return xp.where(t > 1.7, -1.0, -2.0)

    craft = bounded(make, jumps)
    assert path_excesses(craft, flown(craft.model, climbing)) == []
    above = bounded(make, lambda t, x, u, p, xp: xp.where(t > 1.7, 1.0, -2.0))
    (one,) = path_excesses(above, flown(above.model, climbing))
    assert one.time_s > 1.7 - 1e-6


def test_a_constraint_sees_the_control(make):
    craft = bounded(make, lambda t, x, u, p, xp: u[1] - 1.0)

    def pushing(t):
        return np.stack([0 * t, 1.2 * t / 2.5, 0 * t], axis=-1)

    (one,) = path_excesses(craft, flown(craft.model, climbing, pushing))
    assert one.time_s > 2.5 / 1.2


def test_numbers_that_are_none_are_a_fault(make):
    craft = bounded(make, lambda t, x, u, p, xp: xp.log(x[0] - 9.0))
    assert path_excesses(craft, flown(craft.model, climbing))


def test_a_running_cost_is_part_of_the_hamiltonian(make):
    from dataclasses import replace

    from berthing.trajectory import VehicleNodes
    from berthing.verify.optimality import hamiltonian

    craft = make.vehicle(Sphere(0.5), model=PointMass(3.0))
    (phase,) = make.scenario([craft], [], 0.1).phases
    h = RunningCost("craft", UserFunction("h", lambda t, x, u, p, xp: x[0] + t))
    t = np.array([1.0, 2.0])
    nodes = VehicleNodes("main", "craft", t, np.full((2, 6), 0.5), np.zeros((2, 3)),
                         np.zeros((2, 6)))  # fmt: skip
    _, values = hamiltonian(replace(phase, cost=Cost(1.0, 0.0, (h,))), [nodes])
    np.testing.assert_allclose(values, [1.5, 2.5])


def test_quaternions_stay_what_they_are():
    model = users.twin(RigidBody(3.0, np.eye(3)))
    x = tumbling(np.array([0.4, 1.9]))
    np.testing.assert_allclose(
        model.pose(x).rotation, quaternion.rotation_matrix(x[:, 6:10]), atol=1e-14
    )
