"""Scenarios and trajectories made by hand, with everything known about them."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.polynomial import chebyshev

from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.scenario.cost import Cost
from berthing.scenario.files import from_document
from berthing.scenario.goal import End
from berthing.scenario.horizon import Horizon
from berthing.scenario.limits import Limits
from berthing.scenario.margin import MarginPolicy
from berthing.scenario.motion import Fixed, Motion
from berthing.scenario.native_state import Model
from berthing.scenario.normal import document_sha256
from berthing.scenario.phase import Phase
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import (
    PhaseTrajectory,
    Plan,
    Segment,
    VehicleNodes,
    VehicleTrajectory,
)
from berthing.trajectory_io import write_interpolant, write_nodes, write_trajectory
from berthing.trajectory_io.separation_costates import KEY, separations_document
from berthing.verify.claims import claims_of, write_claims
from berthing.verify.verification import verify

Array = np.ndarray
MASS, INERTIA = 3.0, 5.0
IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])


def placed(position: Sequence[float] = (0.0, 0.0, 0.0), q: Array = IDENTITY) -> Pose:
    return Pose.from_quaternion(np.array(position, dtype=float), np.asarray(q))


def body(*shapes: ConvexSet, at: Sequence[Pose] = ()) -> Body:
    poses = at or [Pose.identity(s.dim) for s in shapes]
    return Body(
        tuple(Part(f"p{i}", s, p) for i, (s, p) in enumerate(zip(shapes, poses, strict=True)))
    )


def rigid_body() -> RigidBody:
    return RigidBody(MASS, INERTIA * np.eye(3))


def vehicle(
    *shapes: ConvexSet,
    name: str = "craft",
    at: Sequence[Pose] = (),
    model: Model | None = None,
    limits: Limits | None = None,
    start: End | None = None,
    goal: End | None = None,
) -> Vehicle:
    model = model or rigid_body()
    free = Limits.unbounded(len(model.state_names), len(model.control_names))
    origin = End(np.zeros(model.dim))
    return Vehicle(
        name, body(*shapes, at=at), model, limits or free, start or origin, goal or origin
    )


def structure(
    *shapes: ConvexSet, name: str = "wall", at: Sequence[Pose] = (), motion: Motion | None = None
) -> Structure:
    own = body(*shapes, at=at)
    return Structure(name, own, motion or Fixed(Pose.identity(own.dim)))


def scenario(
    vehicles: Sequence[Vehicle],
    structures: Sequence[Structure],
    margins: MarginPolicy | float = 0.1,
    duration_s: float = 10.0,
) -> Scenario:
    policy = margins if isinstance(margins, MarginPolicy) else MarginPolicy(margins)
    phase = Phase("main", tuple(vehicles), Horizon.fixed(duration_s), Cost())
    return Scenario("made-by-hand", "", (phase,), tuple(structures), policy)


def fitted(function: Callable[[Array], Array], t0: float, t1: float, degree: int) -> Array:
    """Chebyshev coefficients of the interpolant through the Lobatto points."""
    s = np.cos(np.pi * np.arange(degree + 1) / degree)
    return chebyshev.chebfit(s, function(0.5 * (t0 + t1) + 0.5 * (t1 - t0) * s), degree)


def trajectory(
    own: Vehicle,
    states: Callable[[Array], Array],
    controls: Callable[[Array], Array] | None = None,
    duration_s: float = 10.0,
    segments: int = 10,
    degree: int = 8,
) -> VehicleTrajectory:
    nu = len(own.model.control_names)
    controls = controls or (lambda t: np.zeros((len(t), nu)))
    edges = np.linspace(0.0, duration_s, segments + 1)
    pieces = tuple(
        Segment(float(a), float(b), fitted(states, a, b, degree), fitted(controls, a, b, degree))
        for a, b in pairwise(edges)
    )
    return VehicleTrajectory(
        own.name, own.model.kind, own.model.state_names, own.model.control_names, pieces
    )


def path(
    own: Vehicle,
    position: Callable[[Array], Array],
    attitude: Callable[[Array], Array] | None = None,
    **options: float,
) -> VehicleTrajectory:
    """A trajectory of which only the pose is filled in: enough for the certificate."""

    def states(t: Array) -> Array:
        x = np.zeros((len(t), 13))
        x[:, :3] = position(t)
        x[:, 6:10] = IDENTITY if attitude is None else attitude(t)
        return x

    return trajectory(own, states, **options)


def turn_about(axis: Sequence[float], angle: Callable[[Array], Array]) -> Callable[[Array], Array]:
    return lambda t: quaternion.from_axis_angle(np.array(axis, dtype=float), angle(t))


def glide(
    own: Vehicle,
    start: Sequence[float],
    end: Sequence[float],
    turn: float = 0.0,
    duration_s: float = 10.0,
    segments: int = 10,
) -> VehicleTrajectory:
    """Rest to rest: the minimum-energy cubic, with a turn about z in step; all of it exact.

    With an isotropic inertia and no first moment f_B = Rᵀ m r̈ and g = J θ̈ about z.
    """
    r0, r1 = np.array(start, dtype=float), np.array(end, dtype=float)
    T = duration_s

    def cubic(t: Array, order: int) -> Array:
        s = t / T
        return (3 * s**2 - 2 * s**3, (6 * s - 6 * s**2) / T, (6 - 12 * s) / T**2)[order][:, None]

    def states(t: Array) -> Array:
        q = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), turn * cubic(t, 0)[:, 0])
        spin = np.array([0.0, 0.0, turn]) * cubic(t, 1)
        return np.hstack([r0 + (r1 - r0) * cubic(t, 0), (r1 - r0) * cubic(t, 1), q, spin])

    def controls(t: Array) -> Array:
        force = np.einsum(
            "kji,kj->ki",
            quaternion.rotation_matrix(states(t)[:, 6:10]),
            MASS * (r1 - r0) * cubic(t, 2),
        )
        return np.hstack([force, INERTIA * np.array([0.0, 0.0, turn]) * cubic(t, 2)])

    return trajectory(own, states, controls, T, segments, 10)


def glide_nodes(own: VehicleTrajectory, per_segment: int = 3) -> VehicleNodes:
    """Nodes along a straight glide with its true costates: λ_v = −2 m f, λ_r = 2 m ḟ."""
    edges = own.breaks_s
    t = np.unique(np.concatenate([np.linspace(a, b, per_segment + 1) for a, b in pairwise(edges)]))
    x, u = own.state(t), own.control(t)
    costates = np.zeros_like(x)
    costates[:, 3:6] = -2.0 * MASS * u[:, :3]
    slope = (own.control(t[-1:]) - own.control(t[:1])) / (t[-1] - t[0])
    costates[:, :3] = 2.0 * MASS * slope[0, :3]
    return VehicleNodes("main", own.vehicle, t, x, u, costates)


def plan(trajectories: Sequence[VehicleTrajectory], nodes: Sequence[VehicleNodes] = ()) -> Plan:
    phase = PhaseTrajectory("main", tuple(trajectories))
    return Plan("made-by-hand", (phase,), tuple(nodes), "plane", "lgr", 0.0, 1, 0, 1e-3)


DOCUMENT = {
    "schema_version": 1,
    "name": "glide",
    "description": "Past a block to a place beside it.",
    "horizon": {"duration_s": 100},
    "margins": {"default_m": 0.1},
    "vehicles": [
        {
            "name": "craft",
            "parts": [{"name": "hull", "shape": {"type": "box", "size_m": [2, 1, 1]}}],
            "dynamics": {
                "model": "rigid-body",
                "mass_kg": MASS,
                "inertia_kg_m2": [INERTIA, INERTIA, INERTIA],
            },
            "limits": {"max_force_n": 0.05, "max_torque_nm": 0.05},
            "start": {"position_m": [0, 0, 0]},
            "goal": {"position_m": [10, 0, 0], "attitude": [np.sqrt(0.5), 0, 0, np.sqrt(0.5)]},
        }
    ],
    "structures": [
        {
            "name": "block",
            "parts": [{"name": "face", "shape": {"type": "box", "size_m": [4, 2, 2]}}],
            "position_m": [5, 2.5, 0],
        },
        {
            "name": "post",
            "parts": [
                {"name": "bar", "shape": {"type": "cylinder", "radius_m": 0.2, "length_m": 4}}
            ],
            "position_m": [5, -3, 0],
        },
    ],
}


def document_plan(turn: float = np.pi / 2) -> tuple[Scenario, Plan]:
    """The scenario of ``DOCUMENT`` and a sound plan for it."""
    whole = from_document(DOCUMENT, "test")
    own = glide(whole.phases[0].vehicles[0], (0, 0, 0), (10, 0, 0), turn, 100.0, 20)
    return whole, plan([own], [glide_nodes(own)])


def write_folder(folder: Path, whole: Scenario, made: Plan) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    sha = document_sha256(whole.document)
    record = {
        "schema_version": 1,
        "scenario": whole.document,
        "scenario_sha256": sha,
        "formulation": made.formulation,
        "scheme": made.scheme,
        "cost": made.cost,
        "iterations": made.iterations,
        "seed": made.seed,
        "verification": {"backoff_m": made.backoff_m, "certified": True},
        "optimality": {KEY: separations_document(made.separations)},
    }
    (folder / "plan.json").write_text(json.dumps(record), encoding="utf-8")
    write_interpolant(folder / "interpolant.json", made.phases, sha)
    write_nodes(folder / "nodes.csv", whole, made.nodes)
    write_trajectory(folder / "trajectory.csv", whole, made.phases)
    certify_folder(folder, whole, made)


def certify_folder(folder: Path, whole: Scenario, made: Plan) -> None:
    """Write the certificate of what can be proven."""
    sha = document_sha256(whole.document)
    claims = claims_of(verify(whole, made).certificates, sha)
    write_claims(folder / "certificate.json", claims)
