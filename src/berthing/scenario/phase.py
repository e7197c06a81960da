"""A phase: the vehicles as they are for a while, and how long that is."""

from __future__ import annotations

from dataclasses import dataclass, field

from berthing.errors import InputError
from berthing.scenario.cost import Cost
from berthing.scenario.horizon import Horizon
from berthing.scenario.vehicle import Vehicle


@dataclass(frozen=True, eq=False)
class Phase:
    """One stretch of the scenario's clock; phases follow each other in their order.

    Attributes:
        name: unique; ``main`` where a scenario has only one.
        vehicles: with the shape and mass that they have in this phase.
        horizon: its duration.
        cost: what it adds to the objective.
    """

    name: str
    vehicles: tuple[Vehicle, ...]
    horizon: Horizon
    cost: Cost = field(default_factory=Cost)

    def vehicle(self, name: str) -> Vehicle:
        """The vehicle called ``name``.

        Raises:
            InputError: there is none.
        """
        for vehicle in self.vehicles:
            if vehicle.name == name:
                return vehicle
        options = ", ".join(v.name for v in self.vehicles)
        raise InputError(f"phase {self.name}", f"has no vehicle {name!r}", f"one of: {options}")
