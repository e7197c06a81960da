"""Motions made by hand: rest-to-rest legs, and the trajectory with its controls that follows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
from numpy.polynomial import chebyshev

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Plan, Segment, VehicleNodes, VehicleTrajectory, derivative, evaluate
from support import hand_made

SEGMENTS, DEGREE = 6, 10
"""Of each leg: polynomials then follow a half turn to 1e-8."""

SPEED_M_S, RATE_RAD_S = 0.1, 0.04
"""Mean of a leg, whichever takes longer."""

SHORTEST_S = 10.0


@dataclass(frozen=True)
class At:
    """A pose: position (3,) and q_IB (4,)."""

    r: Array
    q: Array = field(default_factory=lambda: hand_made.IDENTITY)

    def seen_from(self, outer: At) -> At:
        """This pose, given in the frame that lies at ``outer``."""
        turn = quaternion.rotation_matrix(outer.q)
        return At(outer.r + turn @ self.r, np.asarray(quaternion.multiply(outer.q, self.q)))


ORIGIN = At(np.zeros(3))

Poses = Callable[[Array], tuple[Array, Array]]
"""From progress (k,) between 0 and 1 to positions (k, 3) and quaternions (k, 4)."""


@dataclass(frozen=True)
class Leg:
    """A stretch of motion from rest to rest."""

    duration_s: float
    poses: Poses


def straight(start: At, end: At) -> Leg:
    """Along a line, turning about one axis meanwhile."""
    turn = np.asarray(
        quaternion.rotation_vector(quaternion.multiply(quaternion.conjugate(start.q), end.q))
    )
    angle = float(np.linalg.norm(turn))
    axis = turn / angle if angle > 0.0 else np.array([1.0, 0.0, 0.0])

    def poses(s: Array) -> tuple[Array, Array]:
        turned = quaternion.from_axis_angle(np.tile(axis, (len(s), 1)), angle * s)
        return start.r + np.outer(s, end.r - start.r), quaternion.multiply(start.q, turned)

    return Leg(time_for(float(np.linalg.norm(end.r - start.r)), angle), poses)


def through(*poses: At) -> list[Leg]:
    """Straight legs from each pose to the next."""
    return [straight(a, b) for a, b in pairwise(poses)]


def wait(at: At, duration_s: float) -> Leg:
    """No motion at all."""
    return replace(straight(at, at), duration_s=duration_s)


def time_for(length_m: float, angle_rad: float) -> float:
    """Seconds, in tenths."""
    return round(max(length_m / SPEED_M_S, angle_rad / RATE_RAD_S, SHORTEST_S), 1)


def placed(legs: Sequence[Leg], outer: At) -> list[Leg]:
    """The same legs, given in the frame that lies at ``outer``."""
    turn = quaternion.rotation_matrix(outer.q)

    def moved(poses: Poses) -> Poses:
        def seen(s: Array) -> tuple[Array, Array]:
            r, q = poses(s)
            return outer.r + r @ turn.T, np.asarray(quaternion.multiply(outer.q, q))

        return seen

    return [replace(leg, poses=moved(leg.poses)) for leg in legs]


def first(legs: Sequence[Leg]) -> At:
    """Where it begins."""
    return _at(legs[0], 0.0)


def last(legs: Sequence[Leg]) -> At:
    """Where it ends."""
    return _at(legs[-1], 1.0)


def _at(leg: Leg, s: float) -> At:
    r, q = leg.poses(np.array([s]))
    return At(r[0], q[0])


def flown(vehicle: Vehicle, legs: Sequence[Leg]) -> VehicleTrajectory:
    """The trajectory along ``legs`` with the controls that fly it; no first moment of mass."""
    segments: list[Segment] = []
    t0, before = 0.0, first(legs).q
    for leg in legs:
        sign = 1.0 if leg.poses(np.zeros(1))[1][0] @ before > 0.0 else -1.0
        # In tenths, as durations are: sums of them in another order then end at the same time.
        edges = np.linspace(t0, round(t0 + leg.duration_s, 1), SEGMENTS + 1)
        segments += [
            _segment(vehicle, leg, t0, float(a), float(b), sign) for a, b in pairwise(edges)
        ]
        t0, before = float(edges[-1]), sign * leg.poses(np.ones(1))[1][0]
    model = vehicle.model
    return VehicleTrajectory(
        vehicle.name, model.kind, model.state_names, model.control_names, tuple(segments)
    )


def _segment(
    vehicle: Vehicle, leg: Leg, begins: float, t0: float, t1: float, sign: float
) -> Segment:
    def pose(t: Array) -> Array:
        x = np.clip((t - begins) / leg.duration_s, 0.0, 1.0)
        r, q = leg.poses(x**3 * (10.0 - 15.0 * x + 6.0 * x**2))
        return np.hstack([r, sign * q])

    whole = hand_made.fitted(pose, t0, t1, DEGREE)
    rate = derivative(whole, t1 - t0)
    orders = [whole, rate, derivative(rate, t1 - t0)]
    nodes = np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    (_, q), (_, q_rate), (r_accel, q_accel) = (
        np.split(evaluate(order, nodes), [3], axis=1) for order in orders
    )
    # q̇ = ½ q ω, so that the vector parts of 2 q* q̇ and 2 q* q̈ are ω and its rate.
    w, w_rate = (
        2.0 * quaternion.multiply(quaternion.conjugate(q), d)[:, 1:] for d in (q_rate, q_accel)
    )
    turn = quaternion.rotation_matrix(q)
    force = vehicle.model.mass_kg * np.einsum("kji,kj->ki", turn, r_accel)
    spin = w @ vehicle.model.inertia_kg_m2
    torque = w_rate @ vehicle.model.inertia_kg_m2 + np.cross(w, spin)
    fit = chebyshev.chebfit(nodes, np.hstack([w, force, torque]), DEGREE)
    speed = np.zeros((DEGREE + 1, 3))
    speed[: len(rate)] = rate[:, :3]
    state = np.hstack([whole[:, :3], speed, whole[:, 3:], fit[:, :3]])
    return Segment(t0, t1, state, fit[:, 3:])


def witness(scenario: Scenario, legs: dict[str, Sequence[Leg]]) -> Plan:
    """The plan in which every vehicle flies its legs, with its cost."""
    (phase,) = scenario.phases
    own = [flown(phase.vehicle(name), given) for name, given in legs.items()]
    cost = phase.cost.control_energy * sum(map(energy, own))
    made = hand_made.plan(own, [_nodes(phase.name, one) for one in own])
    return replace(made, scenario_name=scenario.name, cost=cost)


def _nodes(phase: str, own: VehicleTrajectory) -> VehicleNodes:
    """Its segments' ends; nothing was optimised, so that there are no costates."""
    t = own.breaks_s
    x = own.state(t)
    return VehicleNodes(phase, own.vehicle, t, x, own.control(t), np.full_like(x, np.nan))


def energy(trajectory: VehicleTrajectory) -> float:
    """∫ ‖u‖² dt in N² s + (N·m)² s, exact for the polynomials."""
    nodes, weights = np.polynomial.legendre.leggauss(DEGREE + 1)
    return sum(
        0.5 * (s.t1_s - s.t0_s) * float(weights @ np.sum(evaluate(s.control, nodes) ** 2, axis=1))
        for s in trajectory.segments
    )


def peaks(trajectory: VehicleTrajectory) -> tuple[float, float]:
    """Largest component of the force (N) and of the torque (N·m), sampled."""
    t = np.linspace(trajectory.t0_s, trajectory.t1_s, 2001)
    u = np.abs(trajectory.control(t))
    return float(np.max(u[:, :3])), float(np.max(u[:, 3:]))
