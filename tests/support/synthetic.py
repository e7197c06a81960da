"""Scenarios and plans made by hand: quick, and with nothing solved."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.polynomial import chebyshev

from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.result import Attempt, Result
from berthing.scenario.attitude import FixedAttitude
from berthing.scenario.goal import End
from berthing.scenario.horizon import Horizon
from berthing.scenario.limits import Limits
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.motion import ConstantSpin, Fixed
from berthing.scenario.phase import Phase
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory, Plan, Segment, VehicleNodes, VehicleTrajectory
from berthing.verify.boundary import EndErrors
from berthing.verify.certificate import certify
from berthing.verify.claims import claims_of
from berthing.verify.replay import Replay
from berthing.verify.verdict import PairVerdict
from berthing.verify.verification import Verification

DURATION_S, SEGMENTS, DEGREE = 150.0, 10, 5
UNIT_Q = np.array([1.0, 0.0, 0.0, 0.0])


def spacecraft(name="spacecraft", offset=(0.0, 0.0, 0.0)):
    """The paper's box of 4 × 2 × 2 m, 10 m to go."""
    start = np.array(offset)
    limits = Limits(
        np.repeat([-0.02, -0.01], 3), np.repeat([0.02, 0.01], 3),
        np.full(13, -np.inf), np.full(13, np.inf),
    )  # fmt: skip
    ends = [
        End(p, attitude=FixedAttitude(UNIT_Q), velocity_m_s=np.zeros(3), rate_rad_s=np.zeros(3))
        for p in (start, start + np.array([10.0, 3.0, 0.0]))
    ]
    body = Body((Part("hull", Box(np.array([2.0, 1.0, 1.0])), Pose.identity(3)),))
    return Vehicle(name, body, RigidBody(3.0, 5.0 * np.eye(3)), limits, *ends)


def block(name="block", at=(5.0, 0.0, 0.0)):
    body = Body((Part("core", Box(np.array([1.0, 1.0, 1.5])), Pose.identity(3)),))
    return Structure(name, body, Fixed(Pose(np.array(at), np.eye(3))))


def spinner():
    """A cylinder and a ball that turn about z."""
    body = Body(
        (
            Part("beam", Cylinder(0.3, 2.0), Pose.identity(3)),
            Part("tip", Sphere(0.6), Pose(np.array([2.2, 0.0, 0.0]), np.eye(3))),
        )
    )
    pose = Pose(np.array([6.0, 7.0, 1.0]), np.eye(3))
    return Structure(
        "spinner", body, ConstantSpin(pose, np.array([0.0, 0.0, 1.0]), 0.01, np.zeros(3))
    )


def scenario(vehicles=None, structures=None, name="synthetic", document=None):
    vehicles = (spacecraft(),) if vehicles is None else tuple(vehicles)
    structures = (block(), spinner()) if structures is None else tuple(structures)
    margins = MarginPolicy(
        0.1, (MarginOverride("spacecraft.hull", "spinner.tip", 0.02, (100.0, 150.0)),)
    )
    phase = Phase("main", vehicles, Horizon.fixed(DURATION_S))
    return Scenario(
        name, "Made by hand.", (phase,), structures, margins, document=document or {"name": name}
    )


def two_phase_scenario():
    """There, and on from there."""
    one = spacecraft()
    other = spacecraft(offset=one.goal.position_m)
    base = scenario((one,), name="two-phases")
    phases = tuple(
        Phase(name, (vehicle,), Horizon.fixed(DURATION_S))
        for name, vehicle in (("out", one), ("on", other))
    )
    return replace(base, phases=phases)


def _spacecraft_states(t, vehicle):
    """Over the block in a smooth arc, turning about z and back."""
    s = t / DURATION_S
    ease = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
    ease_rate = 30.0 * s**2 * (1.0 - s) ** 2 / DURATION_S
    r0, r1 = vehicle.start.position_m, vehicle.goal.position_m
    bump, bump_rate = np.sin(np.pi * ease) ** 2, np.pi * np.sin(2 * np.pi * ease) * ease_rate
    r = r0 + ease[:, None] * (r1 - r0) + np.outer(bump, [0.0, 0.0, 3.2])
    v = np.outer(ease_rate, r1 - r0) + np.outer(bump_rate, [0.0, 0.0, 3.2])
    q = quaternion.from_axis_angle(np.tile([0.0, 0.0, 1.0], (len(t), 1)), 0.6 * bump)
    return np.concatenate([r, v, q, np.outer(0.6 * bump_rate, [0.0, 0.0, 1.0])], axis=1)


def _point_states(t, vehicle):
    s = (t / DURATION_S)[:, None]
    r0, r1 = vehicle.start.position_m, vehicle.goal.position_m
    r = r0 + s**2 * (3.0 - 2.0 * s) * (r1 - r0)
    return np.concatenate([r, 6.0 * s * (1.0 - s) * (r1 - r0) / DURATION_S], axis=1)


def vehicle_trajectory(vehicle, start_s=0.0):
    states = _spacecraft_states if vehicle.model.kind == "rigid-body" else _point_states
    nu = len(vehicle.model.control_names)
    edges = np.linspace(0.0, DURATION_S, SEGMENTS + 1)
    local = np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    segments = []
    for t0, t1 in pairwise(edges):
        t = 0.5 * (t0 + t1) + 0.5 * (t1 - t0) * local
        u = 0.008 * np.cos(np.outer(t, np.linspace(0.02, 0.08, nu)))
        fit = chebyshev.chebvander(local, DEGREE)
        x = np.linalg.solve(fit, states(t, vehicle))
        segments.append(Segment(start_s + t0, start_s + t1, x, np.linalg.solve(fit, u)))
    model = vehicle.model
    return VehicleTrajectory(
        vehicle.name, model.kind, model.state_names, model.control_names, tuple(segments)
    )


def nodes(trajectory, phase="main"):
    t = np.linspace(trajectory.t0_s, trajectory.t1_s, 41)
    control = trajectory.control(t)
    control[-1] = np.nan
    costate = 1e-3 * np.ones_like(trajectory.state(t))
    return VehicleNodes(phase, trajectory.vehicle, t, trajectory.state(t), control, costate)


def plan(of):
    phases = tuple(
        PhaseTrajectory(p.name, tuple(vehicle_trajectory(v, i * DURATION_S) for v in p.vehicles))
        for i, p in enumerate(of.phases)
    )
    return Plan(
        scenario_name=of.name,
        phases=phases,
        nodes=tuple(nodes(t, p.phase) for p in phases for t in p.vehicles),
        formulation="plane", scheme="lgr", cost=0.0089, iterations=123, seed=0,
        backoff_m=0.001, wall_time_s={"guess": 0.1, "solve": 1.2, "verify": 0.2, "total": 1.5},
    )  # fmt: skip


def planar_scenario():
    """A disc that goes around a square in the plane."""
    disc = Body((Part("hull", Sphere(0.3, dim=2), Pose.identity(2)),))
    limits = Limits(np.full(2, -1.0), np.full(2, np.inf), np.full(4, -np.inf), np.full(4, np.inf))
    ends = [End(np.array(p), velocity_m_s=np.zeros(2)) for p in ([0.0, 0.0], [4.0, 2.0])]
    vehicle = Vehicle("puck", disc, PointMass(1.0, 2), limits, *ends)
    square = Body((Part("core", Box(np.array([0.6, 0.4])), Pose.identity(2)),))
    wall = Structure("wall", square, Fixed(Pose(np.array([2.0, -1.0]), np.eye(2))))
    return scenario((vehicle,), (wall,), "planar")


def verification(of, certified=True):
    """As if checked: every pair just above its margin, or the first one violated."""
    names = [pair.name for phase in of.phases for pair in of.pairs(phase)]
    bound = 0.1004 if certified else 0.02
    verdicts = [
        PairVerdict("main", name, "certified", bound + i, 0.1, 0.0004 + i, 52.0 + i)
        for i, name in enumerate(names)
    ]
    if not certified and names:
        verdicts[0] = PairVerdict(
            "main", names[0], "violated", 0.02, 0.1, -0.08, 52.0, 0.08, (52.0,)
        )
    vehicles = [v.name for v in of.phases[0].vehicles]
    times = np.linspace(0.0, DURATION_S, 40)
    return Verification(
        clearance_lower_bound_m=bound if names else np.inf,
        required_clearance_m=0.1,
        backoff_m=0.001,
        closest_pair=names[0] if names else None,
        closest_time_s=52.0 if names else None,
        closest_distance_m=bound if names else None,
        replay_position_error_m=3e-7,
        replay_attitude_error_rad=2e-8,
        hamiltonian_relative_drift=0.03,
        limits_ok=True,
        model_check="independent",
        certified=certified,
        reasons=() if certified else ("clearance[a, b, t = 52 s] is short of 0.1 m by 0.08 m",),
        pairs=tuple(verdicts),
        ends=tuple(EndErrors("main", v, "goal", DURATION_S, 1e-9, 0.0, 0.0, 0.0) for v in vehicles),
        replays=tuple(Replay(v, 3e-7, 2e-8, 1e-9, 1e-10, 1e-7, 1e-8, 140.0) for v in vehicles),
        hamiltonian=(("main", times, 1e-4 * (1.0 + 0.01 * np.sin(times))),),
    )


def certified(of):
    return Result("certified", plan(of), verification(of))


def not_certified(of):
    advice = "Try --nodes 80."
    return Result("not_certified", plan(of), verification(of, certified=False), advice=advice)


def failed(of, outcome="locally_infeasible"):
    attempts = (
        Attempt("straight", outcome, 40, 310, 2.4, note="separation[a, b] short by 1 m"),
        Attempt("over block.core", "iteration_limit", 40, 3000, 21.0, cost=0.3),
    )
    return Result(outcome, None, None, attempts, "Allow more time, or another --seed.")


def claims(of):
    """What a search proves of the plan made by hand, which in places is nothing."""
    proven = [certify(of, of.phase(trajectory.phase), trajectory) for trajectory in plan(of).phases]
    return claims_of(proven, "")
