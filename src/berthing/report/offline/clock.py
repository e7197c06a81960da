"""The times at which motion is handed to the page, which interpolates between them."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory, Plan

# Even samples of one phase: a plot is about as many pixels wide.
SAMPLES = 401
# The largest turn between two samples; between them the page turns evenly about one axis.
TURN_RAD = 0.2
MOST_SAMPLES = 4001
# How long before a break of the polynomials its left value is taken, in parts of the phase, so
# that jumps of the control stand upright.
JUST_BEFORE = 1e-9


def motion_times(scenario: Scenario, plan: Plan, phase: PhaseTrajectory) -> Array:
    """Sorted times (k,) of one phase: even ones, the solver's nodes, both sides of each break."""
    t0, t1 = phase.t0_s, phase.t1_s
    breaks = np.concatenate([own.breaks_s[1:-1] for own in phase.vehicles])
    nodes = [own.times_s for own in plan.nodes if own.phase == phase.phase]
    even = np.linspace(t0, t1, _count(scenario, phase))
    times = np.concatenate([even, breaks, breaks - JUST_BEFORE * (t1 - t0), *nodes])
    return np.unique(np.clip(times, t0, t1))


def _count(scenario: Scenario, phase: PhaseTrajectory) -> int:
    rates = [s.motion.speed_bound(phase.t0_s, phase.t1_s)[1] for s in scenario.structures]
    fastest = max([*rates, *_vehicle_rates(scenario, phase)], default=0.0)
    wanted = fastest * (phase.t1_s - phase.t0_s) / TURN_RAD
    return int(np.clip(np.nan_to_num(wanted), SAMPLES, MOST_SAMPLES))


def _vehicle_rates(scenario: Scenario, phase: PhaseTrajectory) -> Iterable[float]:
    times = np.linspace(phase.t0_s, phase.t1_s, SAMPLES)
    for own in phase.vehicles:
        model = scenario.phase(phase.phase).vehicle(own.vehicle).model
        _, rate = model.velocity(own.state(times))
        yield float(np.max(np.linalg.norm(rate, axis=1)))
