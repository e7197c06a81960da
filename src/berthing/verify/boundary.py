"""Start and goal conditions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.goal import End
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory
from berthing.verify.chebyshev import at_end, at_start
from berthing.verify.frames import lifted_rotation
from berthing.verify.settings import BOUNDARY_TOLERANCE


@dataclass(frozen=True)
class EndErrors:
    """How far an end of a trajectory is from the set asked for; 0 inside, or where free.

    Attributes:
        phase, vehicle: names. end: ``start`` or ``goal``.
        position_m, attitude_rad, velocity_m_s, rate_rad_s: distances from the set.
        native: the largest error of a native component that is given by name, in its unit.
    """

    phase: str
    vehicle: str
    end: str
    time_s: float
    position_m: float
    attitude_rad: float
    velocity_m_s: float
    rate_rad_s: float
    native: float = 0.0

    @property
    def reasons(self) -> list[str]:
        """Each condition that is missed by more than the tolerance."""
        found = {
            "position": (self.position_m, "m"),
            "attitude": (self.attitude_rad, "rad"),
            "velocity": (self.velocity_m_s, "m/s"),
            "rate": (self.rate_rad_s, "rad/s"),
            "native state": (self.native, "of its unit"),
        }
        return [
            f"{self.end}[{self.vehicle}, {name}, t = {self.time_s:.6g} s] is missed by "
            f"{error:.3g} {unit}"
            for name, (error, unit) in found.items()
            if not error <= BOUNDARY_TOLERANCE
        ]


def end_errors(scenario: Scenario, phase: Phase, trajectory: PhaseTrajectory) -> list[EndErrors]:
    """Errors at the start and the goal of every vehicle of the phase."""
    found = []
    for vehicle in phase.vehicles:
        own = trajectory.vehicle(vehicle.name)
        start, last = at_start(own.segments[0].state), at_end(own.segments[-1].state)
        ends = (("start", vehicle.start, own.t0_s, start),
                ("goal", vehicle.goal, own.t1_s, last))  # fmt: skip
        found += [_errors(scenario, phase, vehicle, name, end, t, x) for name, end, t, x in ends]
    return found


def _errors(
    scenario: Scenario, phase: Phase, vehicle: Vehicle, name: str, end: End, t: float, x: Array
) -> EndErrors:
    wanted = end.resolve(t, scenario)
    pose = vehicle.model.pose(x)
    velocity, rate = vehicle.model.velocity(x)
    rotation = lifted_rotation(pose.rotation)
    q = quaternion.from_matrix(rotation)
    distance = float(np.linalg.norm(pose.position - wanted.position_m))
    tolerance = getattr(wanted.attitude, "tolerance_rad", 0.0)
    wanted_rate = wanted.rate_rad_s(q)
    return EndErrors(
        phase.name,
        vehicle.name,
        name,
        t,
        max(0.0, distance - wanted.position_tolerance_m),
        max(0.0, float(wanted.attitude.error_rad(q)) - tolerance),
        _distance(velocity, wanted.velocity_m_s),
        _distance(rate @ rotation, wanted_rate),
        _native_error(vehicle, end, x),
    )


def _native_error(vehicle: Vehicle, end: End, x: Array) -> float:
    names = vehicle.model.state_names
    errors = [abs(float(x[names.index(name)]) - value) for name, value in end.states.items()]
    return float(np.max(errors)) if errors else 0.0


def _distance(found: Array, wanted: Array | None) -> float:
    return 0.0 if wanted is None else float(np.linalg.norm(found - wanted))
