"""A plan folder made by hand, with attitudes that no other order of a quaternion gives."""

from __future__ import annotations

import json
from itertools import pairwise

import numpy as np
from numpy.polynomial import chebyshev
from scipy.spatial.transform import Rotation

from berthing.scenario.files import from_document
from berthing.scenario.normal import document_sha256
from berthing.trajectory import PhaseTrajectory, Segment, VehicleTrajectory
from berthing.trajectory_io import write_interpolant, write_nodes
from berthing.verify.folder import SCHEMA_VERSION
from support import documents, synthetic

SEGMENTS, DEGREE = 8, 14
AXES = (np.array([0.6, -0.48, 0.64]), np.array([0.0, 0.6, 0.8]))
META = {
    "epoch": "2026-03-01T12:34:56.789Z",
    "centre": "EARTH",
    "frame": "EME2000",
    "object_names": {"carrier": "MODULE CARRIER"},
    "object_ids": {"carrier": "2026-001A", "scout": "2026-001B"},
    "naif_ids": {"carrier": -100001, "scout": -100002},
}


def scenario(*names, meta=META, point=None):
    """Vehicles of those names and a point mass, among a box, a spinning beam and a tetrahedron."""
    vehicles = [documents.spacecraft(name) for name in names]
    if point is not None:
        vehicles.append(
            {
                "name": point,
                "parts": [{"name": "ball", "shape": {"type": "sphere", "radius_m": 0.5}}],
                "dynamics": {"model": "point-mass", "mass_kg": 2},
                "start": {"position_m": [0, 20, 0]},
                "goal": {"position_m": [6, 20, 0]},
            }
        )
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    beam = {"type": "cylinder", "radius_m": 0.3, "length_m": 4, "axis": "y"}
    spin = {"type": "spin", "axis": [0, 0, 1], "rate_rad_s": 0.01}
    structures = [
        documents.structure("block", [40, 0, 0], documents.box(1, 2, 3)),
        documents.structure("spinner", [40, 10, 5], beam, motion=spin),
        documents.structure("rock", [40, 20, 0], {"type": "polytope", "vertices_m": corners}),
    ]
    return documents.scenario(*vehicles, structures=structures, meta=meta)


def two_phase_scenario():
    """There and on, past nothing."""
    one, other = documents.spacecraft("carrier"), documents.spacecraft("carrier")
    other["parts"] = [{"name": "hull", "shape": documents.box(6, 2, 2)}]
    horizon = {"duration_s": documents.DURATION_S}
    phases = [
        {"name": name, "horizon": horizon, "vehicles": [vehicle]}
        for name, vehicle in (("out", one), ("on", other))
    ]
    document = {
        "schema_version": 1, "name": "two-phases", "phases": phases,
        "margins": {"default_m": 0.1}, "meta": META,
    }  # fmt: skip
    return from_document(document, "test.yaml")


def motion(t, shift_m):
    """Native states (k, 13) of a body that turns about two axes in turn, at the times t (k,)."""
    s = t / documents.DURATION_S
    r = np.stack([10 * s**2, 3 * np.sin(2 * s) + shift_m, 2 * s - s**3], axis=-1)
    rates = np.stack([20 * s, 6 * np.cos(2 * s), 2 - 3 * s**2], axis=-1) / documents.DURATION_S
    first = Rotation.from_rotvec(np.outer(0.3 + 1.9 * s**2, AXES[0]))
    then = Rotation.from_rotvec(np.outer(0.7 - 1.1 * s, AXES[1]))
    w = then.inv().apply(np.outer(3.8 * s, AXES[0])) + np.outer(np.full(len(t), -1.1), AXES[1])
    q = synthetic_continuous((first * then).as_quat(scalar_first=True))
    return np.hstack([r, rates, q, w / documents.DURATION_S])


def synthetic_continuous(q):
    """Neighbouring rows with the same sign."""
    sign = np.sign(np.einsum("ki,ki->k", q[1:], q[:-1]))
    return q * np.cumprod(np.concatenate([[1.0], sign]))[:, None]


def trajectory(vehicle, shift_m, start_s=0.0, along=motion):
    """Chebyshev pieces through ``along``; a point mass has the first six columns of it."""
    nx, nu = len(vehicle.model.state_names), len(vehicle.model.control_names)
    local = np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    fit = chebyshev.chebvander(local, DEGREE)
    pieces = []
    for t0, t1 in pairwise(np.linspace(0.0, documents.DURATION_S, SEGMENTS + 1)):
        t = 0.5 * (t0 + t1) + 0.5 * (t1 - t0) * local
        states = along(t, shift_m)[:, :nx]
        controls = 0.008 * np.cos(np.outer(t, np.linspace(0.02, 0.08, nu)))
        x, u = np.linalg.solve(fit, states), np.linalg.solve(fit, controls)
        pieces.append(Segment(start_s + t0, start_s + t1, x, u))
    model = vehicle.model
    return VehicleTrajectory(
        vehicle.name, model.kind, model.state_names, model.control_names, tuple(pieces)
    )


def write(folder, of, outcome="certified", along=motion):
    """plan.json, interpolant.json and nodes.csv of hand-made motions."""
    phases = tuple(
        PhaseTrajectory(
            phase.name,
            tuple(
                trajectory(v, 3.0 * i, documents.DURATION_S * k, along)
                for i, v in enumerate(phase.vehicles)
            ),
        )
        for k, phase in enumerate(of.phases)
    )
    nodes = tuple(synthetic.nodes(own, p.phase) for p in phases for own in p.vehicles)
    folder.mkdir(parents=True, exist_ok=True)
    fingerprint = document_sha256(of.document)
    write_interpolant(folder / "interpolant.json", phases, fingerprint)
    write_nodes(folder / "nodes.csv", of, nodes)
    record = {
        "schema_version": SCHEMA_VERSION, "name": of.name, "outcome": outcome,
        "formulation": "plane", "scheme": "lgr", "cost": 0.0, "nodes": 41, "iterations": 1,
        "seed": 0, "verification": {"backoff_m": 0.001}, "scenario_sha256": fingerprint,
        "scenario": dict(of.document),
    }  # fmt: skip
    (folder / "plan.json").write_text(json.dumps(record), encoding="utf-8")
    return folder


class Truth:
    """What interpolant.json says, evaluated here and by nothing of the package.

    Rotations are SciPy's, from body to inertial components.
    """

    def __init__(self, folder, vehicle="carrier"):
        document = json.loads((folder / "interpolant.json").read_text(encoding="utf-8"))
        self.segments = [
            segment
            for phase in document["phases"]
            for own in phase["vehicles"]
            if own["vehicle"] == vehicle
            for segment in own["segments"]
        ]

    def _rows(self, t, key):
        ends = [s["t1_s"] for s in self.segments]
        # At a break the later piece, as it stands in files.
        index = np.clip(np.searchsorted(ends, t, side="right"), 0, len(ends) - 1)
        rows = []
        for k, time in zip(index, t, strict=True):
            s = self.segments[k]
            local = (2 * time - s["t0_s"] - s["t1_s"]) / (s["t1_s"] - s["t0_s"])
            rows.append(np.array(s[key]).T @ np.cos(np.arange(len(s[key])) * np.arccos(
                np.clip(local, -1, 1)
            )))  # fmt: skip
        return np.array(rows)

    def position(self, t):
        return self._rows(t, "state")[:, 0:3]

    def velocity(self, t):
        return self._rows(t, "state")[:, 3:6]

    def rotation(self, t):
        return Rotation.from_quat(self._rows(t, "state")[:, 6:10], scalar_first=True)

    def rate(self, t):
        return self._rows(t, "state")[:, 10:13]

    def control(self, t):
        return self._rows(t, "control")


def assert_rotations(found, true, tolerance_rad=1e-9):
    """Both from body to inertial components."""
    worst = np.max((found.inv() * true).magnitude())
    assert worst <= tolerance_rad, f"off by {worst:.3g} rad"
