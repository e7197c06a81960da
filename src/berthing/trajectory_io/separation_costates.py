"""Multipliers of the separation rows in plan.json."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from berthing.errors import InputError
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.trajectory import SeparationCostate
from berthing.trajectory_io.strict_json import array, number, objects, text

KEY = "separation_costates"

MOST_ROWS = 50_000
"""Plans have hundreds; each takes a query of the distance."""


def separations_document(separations: Sequence[SeparationCostate]) -> list[dict[str, Any]]:
    """As plan.json holds them."""
    return [
        {
            "phase": own.phase,
            "pair": own.pair,
            "time_s": own.time_s,
            "multiplier": own.multiplier,
            "jumps": {name: jump.tolist() for name, jump in own.jumps.items()},
        }
        for own in separations
    ]


def read_separations(
    optimality: Mapping[str, Any], scenario: Scenario, where: str
) -> tuple[SeparationCostate, ...]:
    """Read them back.

    Raises:
        InputError: malformed, or of phases, pairs or vehicles that the scenario has not.
    """
    rows = objects(optimality, KEY, where, empty=True)
    if len(rows) > MOST_ROWS:
        raise InputError(f"{where}.{KEY}", f"are {len(rows)}", f"at most {MOST_ROWS}")
    pairs = {p.name: {pair.name for pair in scenario.pairs(p)} for p in scenario.phases}
    phases = {phase.name: phase for phase in scenario.phases}
    return tuple(_row(row, phases, pairs, f"{where}.{KEY}[{i}]") for i, row in enumerate(rows))


def _row(
    row: Mapping[str, Any], phases: Mapping[str, Phase], pairs: Mapping[str, set[str]], where: str
) -> SeparationCostate:
    phase, pair = text(row, "phase", where), text(row, "pair", where)
    if pair not in pairs.get(phase, ()):
        raise InputError(where, f"is of {pair!r} in {phase!r}", "a pair of the scenario")
    jumps, sizes = row.get("jumps"), {v.name: v.model for v in phases[phase].vehicles}
    if not isinstance(jumps, dict):
        raise InputError(f"{where}.jumps", "is not an object")
    found = {}
    for name in jumps:
        if name not in sizes:
            raise InputError(f"{where}.jumps", f"name {name!r}", "a vehicle of the phase")
        found[name] = array(jumps, name, 1, f"{where}.jumps")
        if len(found[name]) != len(sizes[name].state_names):
            raise InputError(f"{where}.jumps.{name}", "is of another length", "one a state")
    return SeparationCostate(
        phase, pair, number(row, "time_s", where), number(row, "multiplier", where), found
    )
