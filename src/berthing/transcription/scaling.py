"""Units of the solver: states, controls, time and cost of order one (Ross et al., balancing)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_model import UserModel
from berthing.scenario.vehicle import Vehicle

ENERGY_FACTOR = 12.0
"""Minimum energy rest to rest over a distance d in a time T is 12 m² d² / T³."""

UNITS = ("m", "m_s", "m_s2", "rad_s", "rad_s2", "n", "nm")
"""Those that a scale is known for."""


@dataclass(frozen=True)
class VehicleScale:
    """Physical = shift + scale · stored, componentwise; state (nx,), control (nu,)."""

    state: Array
    state_shift: Array
    control: Array


@dataclass(frozen=True)
class PhaseScale:
    """Scales of one phase.

    Attributes:
        time_s: the nominal duration.
        length_m: the farthest that a vehicle must go, or its size where that is more.
        cost: of the order of the least cost.
        vehicles: in the order of the phase's.
    """

    time_s: float
    length_m: float
    cost: float
    vehicles: tuple[VehicleScale, ...]


def phase_scale(scenario: Scenario, phase: Phase) -> PhaseScale:
    """Scales of ``phase`` from the distances, sizes and times that the scenario names."""
    time_s = phase.horizon.nominal_s
    reach = {v.name: _displacement(scenario, v, time_s) for v in phase.vehicles}
    length_m = max(
        max(float(np.linalg.norm(reach[v.name][1])), v.body.bounding_radius, 1e-3)
        for v in phase.vehicles
    )
    vehicles = []
    energy = 0.0
    for vehicle in phase.vehicles:
        scale, control_energy = _vehicle_scale(vehicle, reach[vehicle.name], length_m, time_s)
        vehicles.append(scale)
        energy += control_energy
    running = sum(own.scale for own in phase.cost.running)
    cost = phase.cost.control_energy * energy + (phase.cost.time + running) * time_s
    return PhaseScale(time_s, length_m, cost, tuple(vehicles))


def _displacement(scenario: Scenario, vehicle: Vehicle, time_s: float) -> tuple[Array, Array]:
    start = vehicle.start.resolve(0.0, scenario).position_m
    goal = vehicle.goal.resolve(time_s, scenario).position_m
    return 0.5 * (start + goal), goal - start


def _vehicle_scale(
    vehicle: Vehicle, reach: tuple[Array, Array], length_m: float, time_s: float
) -> tuple[VehicleScale, float]:
    centre, _ = reach
    state_units = {"m": length_m, "m_s": length_m / time_s, "m_s2": length_m / time_s**2,
                   "rad_s": np.pi / time_s, "rad_s2": np.pi / time_s**2}  # fmt: skip
    model = vehicle.model
    state = np.array([state_units.get(_unit(name), 1.0) for name in model.state_names])
    shift = np.zeros(len(state))
    for axis, value in zip("xyz", centre, strict=False):
        if f"{axis}_m" in model.state_names:
            shift[model.state_names.index(f"{axis}_m")] = value
    mass = float(getattr(model, "mass_kg", 1.0))
    inertia = float(np.trace(getattr(model, "inertia_kg_m2", np.eye(3)))) / 3.0
    force = np.sqrt(ENERGY_FACTOR) * mass * length_m / time_s**2
    units = state_units | {"n": force, "nm": np.sqrt(ENERGY_FACTOR) * inertia / time_s**2}
    reference = np.array([units.get(_unit(name), 1.0) for name in model.control_names])
    limit = np.maximum(np.abs(vehicle.limits.control_lower), np.abs(vehicle.limits.control_upper))
    bounded = np.isfinite(limit) & (limit > 0.0)
    control = np.where(bounded, np.minimum(limit, 10.0 * reference), reference)
    scale = VehicleScale(state, shift, control)
    if isinstance(model, UserModel):
        # Nothing is known of how it moves; its controls are of the order that they are scaled by.
        return scale, float(np.sum(control**2) * time_s)
    return scale, float(force**2 * time_s)


def _unit(name: str) -> str:
    """The unit that a native name ends in, the longest of those known: left_wheel_m_s → m_s."""
    endings = [unit for unit in UNITS if name.endswith(f"_{unit}")]
    return max(endings, key=len, default="")
