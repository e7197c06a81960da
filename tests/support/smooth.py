"""A case without corners: a body turns by 120° on its way, its centre of mass off the reference
point, nothing in the way and no limits. Its answer is analytic, so that collocation converges as
fast as it can."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.verify.equations import derivative
from berthing.verify.optimality import hamiltonian, relative_drift
from support.documents import scenario, spacecraft
from support.solving import solved

TURNING = spacecraft(
    dynamics={
        "model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [4, 5, 6],
        "first_moment_kg_m": [0.6, 0.3, 0],
    },
    goal={"position_m": [4, 1, 0], "attitude": [0.5, 0.5, 0.5, 0.5]},
)  # fmt: skip

EXACT = ("lgr", 4, 10)
"""Scheme, segments, degree of what counts as exact."""

PROBES = 401


@dataclass(frozen=True)
class Found:
    """What one mesh gives.

    Attributes:
        nodes: collocated ones.
        defect: largest |ẋ - f| between the nodes, over the largest |ẋ| of its state.
        drift: of the lower Hamiltonian, over its mean.
    """

    scheme: str
    segments: int
    degree: int
    nodes: int
    solved: bool
    cost: float
    defect: float
    drift: float


def found(scheme: str, segments: int, degree: int) -> Found:
    """Solve the case on one mesh."""
    given = scenario(TURNING)
    answer = solved(given, segments, degree, scheme=scheme)
    own = answer.trajectory.vehicles[0]
    f = derivative(given.phases[0].vehicles[0].model)
    t = np.linspace(own.t0_s, own.t1_s, PROBES)[1:-1]
    rates = own.state_rate(t)
    right = np.array([f(*at) for at in zip(t, own.state(t), own.control(t), strict=True)])
    scale = np.max(np.abs(rates), axis=0)
    defect = np.max(np.abs(rates - right) / np.where(scale > 0.0, scale, 1.0))
    drift = relative_drift(hamiltonian(given.phases[0], answer.nodes)[1])
    assert drift is not None
    count = answer.problem.mesh.control_count
    return Found(
        scheme, segments, degree, count, answer.outcome.solved, answer.outcome.cost,
        float(defect), drift,
    )  # fmt: skip
