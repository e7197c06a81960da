"""nodes.csv: what the solver held at its own nodes, costates included."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.trajectory import SeparationCostate, VehicleNodes
from berthing.trajectory_io.columns import HEADER, native_columns
from berthing.trajectory_io.tables import Table, read_table, rows_of, write_table

COSTATE = "costate_"
SEPARATION = "separation_"
MULTIPLIERS = ("limit_", "path_")

SAME_TIME = 1e-9
"""Of the phase: a row this near to a node is at it."""


def write_nodes(
    path: Path, scenario: Scenario, nodes: Sequence[VehicleNodes],
    separations: Sequence[SeparationCostate] = (),
) -> None:  # fmt: skip
    """Write the nodes of every vehicle and phase.

    The columns are those of trajectory.csv, but filled with native values only (a quaternion as
    the solver held it), then ``phase``, a costate for every native state, the multipliers of
    limits and path constraints, and for every pair with a row that pulls ``separation_`` and its
    name: what its rows from this node until before the next add up to.
    """
    known = tuple(dict.fromkeys(name for own in nodes for name in own.multipliers))
    pairs = tuple(dict.fromkeys(SEPARATION + row.pair for row in separations))
    header = (
        *HEADER, *native_columns(scenario), "phase", *_costate_columns(scenario), *known, *pairs,
    )  # fmt: skip
    rows: list[list[str]] = []
    for own in nodes:
        model = scenario.phase(own.phase).vehicle(own.vehicle).model
        names = (*model.state_names, *model.control_names, *_costates(model.state_names))
        values = np.hstack([own.states, own.controls, own.costates]).T
        rows += rows_of(
            header,
            {"vehicle": own.vehicle, "phase": own.phase},
            {
                "t_s": own.times_s,
                **dict(zip(names, values, strict=True)),
                **own.multipliers,
                **_separations(own, separations),
            },
        )
    write_table(path, header, rows)


def read_nodes(path: Path, scenario: Scenario) -> tuple[VehicleNodes, ...]:
    """Read it back; empty cells become NaN.

    Raises:
        InputError: missing or malformed, a phase or vehicle that the scenario has not, a time or
            state that is missing.
    """
    table = read_table(path)
    table.cells("t_s")
    groups = table.rows_by("phase", "vehicle").items()
    return tuple(_nodes(scenario, phase, vehicle, table, rows) for (phase, vehicle), rows in groups)


def _nodes(
    scenario: Scenario, phase: str, vehicle: str, table: Table, rows: Sequence[int]
) -> VehicleNodes:
    model = scenario.phase(phase).vehicle(vehicle).model
    times, states, controls, costates = (
        np.stack([table.numbers(name, rows) for name in names], axis=-1)
        for names in (
            ("t_s",),
            model.state_names,
            model.control_names,
            _costates(model.state_names),
        )
    )
    if np.any(np.isnan(times)) or np.any(np.isnan(states)):
        raise InputError(table.where, f"lacks a time or a state of {vehicle!r}")
    multipliers = {
        name: values
        for name in table.header
        if name.startswith(MULTIPLIERS)
        and not np.all(np.isnan(values := table.numbers(name, rows)))
    }
    return VehicleNodes(phase, vehicle, times[:, 0], states, controls, costates, multipliers)


def _separations(
    own: VehicleNodes, separations: Sequence[SeparationCostate]
) -> dict[str, Array]:
    """By column (k,), of the pairs that pull on this vehicle."""
    out: dict[str, Array] = {}
    near = SAME_TIME * (own.times_s[-1] - own.times_s[0])
    for row in separations:
        if row.phase == own.phase and own.vehicle in row.jumps:
            column = out.setdefault(SEPARATION + row.pair, np.zeros(len(own.times_s)))
            at = int(np.searchsorted(own.times_s, row.time_s + near, side="right")) - 1
            column[max(at, 0)] += row.multiplier
    return out


def _costates(state_names: Sequence[str]) -> tuple[str, ...]:
    return tuple(COSTATE + name for name in state_names)


def _costate_columns(scenario: Scenario) -> tuple[str, ...]:
    models = [v.model for phase in scenario.phases for v in phase.vehicles]
    return tuple(dict.fromkeys(chain.from_iterable(_costates(m.state_names) for m in models)))
