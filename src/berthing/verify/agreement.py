"""Whether the tables of a plan folder say the same as its interpolant."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan, VehicleNodes, VehicleTrajectory, evaluate
from berthing.trajectory_io import MIN_SAMPLES, TrajectoryTable, trajectory_columns
from berthing.verify.body_motion import Mask
from berthing.verify.settings import CONTINUITY_TOLERANCE, TABLE_TOLERANCE, TIME_TOLERANCE


def table_faults(scenario: Scenario, plan: Plan, table: TrajectoryTable) -> list[str]:
    """Where trajectory.csv is not a dense enough sample of the interpolant."""
    wanted = {own.vehicle for phase in plan.phases for own in phase.vehicles}
    if set(table.vehicles) != wanted:
        return [f"trajectory.csv has the vehicles {sorted(table.vehicles)}, not {sorted(wanted)}"]
    found = []
    for name in sorted(wanted):
        columns = table.vehicles[name]
        unexplained = np.ones(len(columns["t_s"]), dtype=np.bool_)
        for phase, trajectory in zip(scenario.phases, plan.phases, strict=True):
            if name in {own.vehicle for own in trajectory.vehicles}:
                own, model = trajectory.vehicle(name), phase.vehicle(name).model
                t = columns["t_s"]
                inside = (t >= own.t0_s - TIME_TOLERANCE) & (t <= own.t1_s + TIME_TOLERANCE)
                if not _covers(own, t[inside]):
                    found.append(
                        f"trajectory.csv[{name}] does not run from {own.t0_s:g} to {own.t1_s:g} s "
                        f"in {MIN_SAMPLES} samples or more, in order"
                    )
                said = {key: values[inside] for key, values in columns.items()}
                unexplained[inside] &= ~_same(said, trajectory_columns(model, own, t[inside]))
        if np.any(unexplained):
            first = float(columns["t_s"][np.argmax(unexplained)])
            found.append(
                f"trajectory.csv[{name}, t = {first:.6g} s] differs from the interpolant; so do "
                f"{np.count_nonzero(unexplained)} rows in all"
            )
    return found


def _covers(own: VehicleTrajectory, t: Array) -> bool:
    return (
        len(t) >= MIN_SAMPLES
        and bool(np.all(np.diff(t) >= 0.0))
        and abs(t[0] - own.t0_s) <= TIME_TOLERANCE
        and abs(t[-1] - own.t1_s) <= TIME_TOLERANCE
    )


def _same(said: dict[str, Array], true: dict[str, Array]) -> Mask:
    """Rows (k,) in which every column agrees; empty cells only where there is nothing to say."""
    rows = np.ones(len(said["t_s"]), dtype=np.bool_)
    for name, values in said.items():
        if name != "t_s":
            expected = true.get(name)
            rows &= np.isnan(values) if expected is None else _close(values, expected)
    return rows


def node_faults(plan: Plan) -> list[str]:
    """Where nodes.csv does not lie on the interpolant.

    A control at a break may belong to either segment; there is none where its cells are empty,
    and none to compare where controls are not flown as polynomials.
    """
    found = []
    present = [(nodes.phase, nodes.vehicle) for nodes in plan.nodes]
    wanted = [(phase.phase, own.vehicle) for phase in plan.phases for own in phase.vehicles]
    if sorted(present) != sorted(wanted):
        return [f"nodes.csv has nodes of {sorted(present)}, not of {sorted(wanted)}"]
    trajectories = {(p.phase, own.vehicle): own for p in plan.phases for own in p.vehicles}
    for nodes in plan.nodes:
        own = trajectories[nodes.phase, nodes.vehicle]
        outside = ~((nodes.times_s >= own.t0_s) & (nodes.times_s <= own.t1_s))
        off = outside | ~_on(own, nodes)
        if np.any(off):
            first = float(nodes.times_s[np.argmax(off)])
            found.append(
                f"nodes.csv[{nodes.vehicle}, t = {first:.6g} s] differs from the interpolant; so "
                f"do {np.count_nonzero(off)} nodes in all"
            )
    return found


def _on(own: VehicleTrajectory, nodes: VehicleNodes) -> Mask:
    states = _close_rows(nodes.states, [own.state(nodes.times_s)])
    if own.control_interpolation != "polynomial":
        return states
    sides = [_control(own, nodes.times_s, side) for side in ("left", "right")]
    return states & (_close_rows(nodes.controls, sides) | np.isnan(nodes.controls).all(axis=1))


def _control(own: VehicleTrajectory, t: Array, side: str) -> Array:
    """Controls (k, nu) at t, at a break those of the segment on that side."""
    place = np.searchsorted(own.breaks_s, t, side="left" if side == "left" else "right")
    out = np.empty((len(t), len(own.control_names)))
    for row, index in enumerate(np.clip(place - 1, 0, len(own.segments) - 1)):
        segment = own.segments[index]
        out[row] = evaluate(segment.control, segment.local(t[row : row + 1]))[0]
    return out


def _close_rows(values: Array, candidates: Sequence[Array]) -> Mask:
    rows = [
        np.all(np.abs(values - c) <= CONTINUITY_TOLERANCE * np.maximum(1.0, np.abs(c)), axis=1)
        for c in candidates
    ]
    return np.asarray(np.any(rows, axis=0))


def _close(values: Array, expected: Array) -> Mask:
    # NaN, an empty cell, is never close.
    return np.asarray(
        np.abs(values - expected) <= TABLE_TOLERANCE * np.maximum(1.0, np.abs(expected))
    )
