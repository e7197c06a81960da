"""Whether a plan belongs to its scenario at all."""

from __future__ import annotations

import sys

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory, Plan, VehicleTrajectory
from berthing.verify.size_limits import require_modest_trajectory

# No state, control or time in SI units of anything that berths comes near this; beyond it sums
# and squares of coefficients lose what the checks rely on.
LARGEST_NUMBER = 1e12

# Coefficients that controls may have on a segment, for what is said to fly between samples.
CONTROL_ROWS = {"polynomial": sys.maxsize, "linear": 2, "constant": 1}


def require_fit(scenario: Scenario, plan: Plan) -> None:
    """Refuse a plan of other phases, vehicles, models or columns, and numbers that are unsound.

    Raises:
        InputError: names the phase, the vehicle and what differs.
    """
    _same("plan", "phases", [p.phase for p in plan.phases], [p.name for p in scenario.phases])
    for phase, trajectory in zip(scenario.phases, plan.phases, strict=True):
        _require_phase(phase, trajectory)
    for nodes in plan.nodes:
        where = f"nodes of {nodes.vehicle!r} in phase {nodes.phase!r}"
        model = scenario.phase(nodes.phase).vehicle(nodes.vehicle).model
        count, nx, nu = len(nodes.times_s), len(model.state_names), len(model.control_names)
        shapes = [
            np.shape(a) for a in (nodes.times_s, nodes.states, nodes.controls, nodes.costates)
        ]
        _same(where, "shapes", shapes, [(count,), (count, nx), (count, nu), (count, nx)])


def _require_phase(phase: Phase, trajectory: PhaseTrajectory) -> None:
    found = sorted(own.vehicle for own in trajectory.vehicles)
    _same(f"phase {phase.name!r}", "vehicles", found, sorted(v.name for v in phase.vehicles))
    for own in trajectory.vehicles:
        _require_vehicle(phase.vehicle(own.vehicle), own)


def _require_vehicle(vehicle: Vehicle, own: VehicleTrajectory) -> None:
    where, model = f"trajectory of {vehicle.name!r}", vehicle.model
    _same(where, "model", own.model, model.kind)
    _same(where, "state names", own.state_names, model.state_names)
    _same(where, "control names", own.control_names, model.control_names)
    if own.control_interpolation not in CONTROL_ROWS:
        options = ", ".join(CONTROL_ROWS)
        raise InputError(where, f"interpolates by {own.control_interpolation!r}", options)
    if not own.segments:
        raise InputError(where, "has no segments", "at least one")
    require_modest_trajectory(own, where)
    rows = CONTROL_ROWS[own.control_interpolation]
    for segment in own.segments:
        _require_numbers(where, np.array([segment.t0_s, segment.t1_s]), (2,))
        _require_numbers(where, segment.state, (None, len(model.state_names)))
        _require_numbers(where, segment.control, (None, len(model.control_names)))
        if len(segment.control) > rows:
            what = (
                f"flies {own.control_interpolation} controls of degree {len(segment.control) - 1}"
            )
            raise InputError(where, what, f"degree {rows - 1} at most")


def _require_numbers(where: str, values: Array, shape: tuple[int | None, ...]) -> None:
    found = np.shape(values)
    fits = len(found) == len(shape) and all(
        n is None or n == m for n, m in zip(shape, found, strict=True)
    )
    if not fits or 0 in found:
        raise InputError(where, f"has coefficients of shape {found}", f"{shape}")
    # Written so that NaN fails too.
    if not np.all(np.abs(values) <= LARGEST_NUMBER):
        raise InputError(
            where, "contains NaN or a huge number", f"numbers below {LARGEST_NUMBER:g}"
        )


def _same(where: str, what: str, found: object, wanted: object) -> None:
    if found != wanted:
        raise InputError(where, f"has the {what} {found}", f"{wanted}")
