"""The figure of a route: structures, trails, and hulls at several places on the way."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.report.scene import draw_scene
from berthing.report.style import VEHICLE_COLOURS, VEHICLE_DASHES
from berthing.report.track import SAMPLES, SAMPLES_PER_SEGMENT, Motion, Track
from berthing.routes.resting import at_rest
from berthing.routes.routing import Route
from berthing.routes.space import between, stride
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle


def draw_route(scenario: Scenario, route: Route) -> Figure:
    """In the frame in which the structures rest. A leg stands for a second."""
    still, _ = at_rest(scenario)
    phase = still.phases[0]
    tracks = [
        _track(phase.name, own, i, route.states[:, i]) for i, own in enumerate(phase.vehicles)
    ]
    return draw_scene(still, tracks)


def _track(phase: str, own: Vehicle, rank: int, states: Array) -> Track:
    """Of the states (n + 1, 7) of one vehicle."""
    legs = len(states) - 1
    count = max(SAMPLES_PER_SEGMENT, SAMPLES // legs)
    s = np.linspace(0.0, 1.0, count)
    rows = [between(states[i : i + 1], states[i + 1 : i + 2], s)[:, 0] for i in range(legs)]
    times = np.concatenate([i + s for i in range(legs)])
    colour = VEHICLE_COLOURS[rank % len(VEHICLE_COLOURS)]
    dash = VEHICLE_DASHES[rank % len(VEHICLE_DASHES)]
    way = np.repeat(stride(states[:-1], states[1:]), count, axis=0)
    dense = _motion(own, times, np.concatenate(rows), way)
    ends = _motion(own, np.arange(legs + 1.0), states, np.zeros((legs + 1, 6)))
    return Track(phase, own, dense, ends, colour, dash)


def _motion(own: Vehicle, times: Array, rows: Array, way: Array) -> Motion:
    d = own.dim
    whole = Pose.from_quaternion(rows[:, :3], rows[:, 3:])
    pose = Pose.sound(whole.position[:, :d], whole.rotation[:, :d, :d])
    control = np.full((len(times), len(own.model.control_names)), np.nan)
    # Rates in inertial axes: only their size counts in this figure.
    return Motion(times, pose, way[:, :d], rows[:, 3:], way[:, 3:], control)
