"""Two convex parts that must stay apart."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.geometry.body import Part
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle


@dataclass(frozen=True)
class Pair:
    """A part of a vehicle and a part of a structure, or of another vehicle."""

    owner_a: Vehicle
    part_a: Part
    owner_b: Vehicle | Structure
    part_b: Part

    @property
    def ref_a(self) -> str:
        """``owner.part`` of the first, as margins name it."""
        return f"{self.owner_a.name}.{self.part_a.name}"

    @property
    def ref_b(self) -> str:
        """``owner.part`` of the second."""
        return f"{self.owner_b.name}.{self.part_b.name}"

    @property
    def name(self) -> str:
        """The pair in files and tables: ``spacecraft.hull|truss.bay3``."""
        return f"{self.ref_a}|{self.ref_b}"

    @property
    def label(self) -> str:
        """The pair in messages: ``spacecraft.hull, truss.bay3``."""
        return f"{self.ref_a}, {self.ref_b}"
