"""The whole of what the user asks for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

from berthing.errors import InputError
from berthing.scenario.margin import MarginPolicy
from berthing.scenario.options import SolverOptions
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.structure import Structure


@dataclass(frozen=True, eq=False)
class Scenario:
    """Vehicles over phases, among structures.

    Attributes:
        name, description: as in the file.
        phases: one or more, in order of time; the clock starts at 0.
        structures: the same throughout.
        margins: how far apart things stay.
        solver: the file's wishes of method.
        meta: what exports need (epoch, centre, frame, object ids); free-form.
        document: the file in normal form, JSON-able; ``from_document`` of it gives this again.
    """

    name: str
    description: str
    phases: tuple[Phase, ...]
    structures: tuple[Structure, ...]
    margins: MarginPolicy
    solver: SolverOptions = field(default_factory=SolverOptions)
    meta: Mapping[str, Any] = field(default_factory=dict)
    document: Mapping[str, Any] = field(default_factory=dict)

    @property
    def dim(self) -> int:
        """2 or 3; one for all."""
        return self.phases[0].vehicles[0].dim

    def phase(self, name: str) -> Phase:
        """The phase called ``name``; InputError where there is none."""
        return self.phases[_index(name, [p.name for p in self.phases], self.name, "phase")]

    def structure(self, name: str) -> Structure:
        """The structure called ``name``; InputError where there is none."""
        names = [s.name for s in self.structures]
        return self.structures[_index(name, names, self.name, "structure")]

    def pairs(self, phase: Phase) -> tuple[Pair, ...]:
        """Pairs of parts that the margins speak of: vehicle–structure, then vehicle–vehicle.

        Parts of one body are rigid to each other, and structures move as they are told, so
        neither make pairs. Pairs that may touch for a while, or always, are among them.
        """
        with_structures = [
            Pair(vehicle, part, structure, other)
            for vehicle in phase.vehicles
            for part in vehicle.body.parts
            for structure in self.structures
            for other in structure.body.parts
        ]
        among_vehicles = [
            Pair(a, part, b, other)
            for a, b in combinations(phase.vehicles, 2)
            for part in a.body.parts
            for other in b.body.parts
        ]
        return (*with_structures, *among_vehicles)


def _index(name: str, names: list[str], where: str, kind: str) -> int:
    if name not in names:
        options = f"one of: {', '.join(names)}" if names else f"no {kind}, for there is none"
        raise InputError(where, f"has no {kind} {name!r}", options)
    return names.index(name)
