"""Separation rows again: how far apart the pair is there, and what moves it but the vehicle."""

from __future__ import annotations

import numpy as np

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.scenario.pair import Pair
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.trajectory import PhaseTrajectory, Plan

STEP = 1e-4
"""Of the phase: distances are good to 1e-10 or so, and structures turn by little meanwhile."""


def rooms_m(scenario: Scenario, plan: Plan) -> list[float]:
    """What pairs are apart at the times of the plan's rows beyond margin and back-off."""
    out = np.zeros(len(plan.separations))
    for rows, pair, trajectory in _by_pair(scenario, plan):
        t = np.array([plan.separations[i].time_s for i in rows])
        apart = _distances(pair, trajectory, t, t)
        for i, at, distance in zip(rows, t, apart, strict=True):
            margin = scenario.margins.margin(pair.ref_a, pair.ref_b, float(at))
            out[i] = 0.0 if margin is None else distance - margin - plan.backoff_m
    return [float(room) for room in out]


def drawn_m_s(scenario: Scenario, plan: Plan) -> list[float]:
    """∂g/∂t of the plan's rows: how fast pairs part by the structure's own motion."""
    out = np.zeros(len(plan.separations))
    moving = {own.name for own in scenario.structures if own.motion.kind != "fixed"}
    for rows, pair, trajectory in _by_pair(scenario, plan) if moving else ():
        # A is a vehicle always.
        if pair.owner_b.name in moving:
            t = np.array([plan.separations[i].time_s for i in rows])
            step = STEP * (trajectory.t1_s - trajectory.t0_s)
            later, sooner = (_distances(pair, trajectory, t, at) for at in (t + step, t - step))
            out[rows] = (later - sooner) / (2.0 * step)
    return [float(speed) for speed in out]


def _by_pair(scenario: Scenario, plan: Plan) -> list[tuple[list[int], Pair, PhaseTrajectory]]:
    """Indices of the rows of every pair that has any."""
    groups: dict[tuple[str, str], list[int]] = {}
    for i, row in enumerate(plan.separations):
        groups.setdefault((row.phase, row.pair), []).append(i)
    found = []
    for (name, pair_name), rows in groups.items():
        pairs = scenario.pairs(scenario.phase(name))
        pair = next(p for p in pairs if p.name == pair_name)
        found.append((rows, pair, next(p for p in plan.phases if p.phase == name)))
    return found


def _distances(pair: Pair, trajectory: PhaseTrajectory, t: Array, structures_at: Array) -> Array:
    """Distances (k,) with vehicles where they are at t (k,), structures at other times (k,)."""
    a, b = (
        (
            owner.motion.pose(structures_at)
            if isinstance(owner, Structure)
            else owner.model.pose(trajectory.vehicle(owner.name).state(t))
        ).compose(part.placement)
        for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b))
    )
    query = PairQuery(pair.part_a.shape, pair.part_b.shape)
    return np.array([query.query(a[i], b[i]).distance for i in range(len(t))])
