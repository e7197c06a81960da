"""Vehicles and structures of one plan, sampled for the page."""

from __future__ import annotations

from typing import Any

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.report.controls import Panel, control_panels
from berthing.report.offline.packing import Packing
from berthing.report.offline.shapes import packed_body
from berthing.report.placed import STRUCTURE_GHOSTS, ghost_indices
from berthing.report.space import in_space
from berthing.report.track import Motion, Track, motion, same_sign
from berthing.scenario.motion import Fixed
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import VehicleTrajectory


def packed_track(
    track: Track, trajectory: VehicleTrajectory, times: Array, packing: Packing
) -> dict[str, Any]:
    """One vehicle in one phase: shape, motion at ``times`` (k,), nodes, and times of ghosts."""
    vehicle = track.vehicle
    dense = motion(vehicle, times, trajectory.state(times), trajectory.control(times))
    panels = control_panels(vehicle)
    return {
        "vehicle": vehicle.name,
        "phase": track.phase,
        "body": packed_body(vehicle.body, packing),
        "turns": any("rad_s" in name for name in vehicle.model.state_names),
        "dense": _packed_motion(dense, dense.q_IB, panels, packing),
        "nodes": _packed_motion(track.nodes, same_sign(track.nodes, dense), panels, packing),
        "controls": [_packed_panel(vehicle, panel) for panel in panels],
        "ghosts": track.dense.times_s[ghost_indices(track)].tolist(),
    }


def packed_structure(structure: Structure, times: Array, packing: Packing) -> dict[str, Any]:
    """A structure at ``times`` (k,), or at the first alone where it rests."""
    rests = isinstance(structure.motion, Fixed)
    pose = in_space(structure.motion.pose(times[:1] if rests else times))
    ghosts = [] if rests else np.linspace(times[0], times[-1], STRUCTURE_GHOSTS).tolist()
    return {
        "name": structure.name,
        "body": packed_body(structure.body, packing),
        "t": packing.exact(times[:1] if rests else times),
        "p": packing.floats(pose.position),
        "q": packing.floats(quaternion.from_matrix(pose.rotation)),
        "ghosts": ghosts,
    }


def _packed_motion(
    found: Motion, q_IB: Array, panels: list[Panel], packing: Packing
) -> dict[str, Any]:
    """Rows over time: position, attitude, velocity, rates, and controls by panel."""
    return {
        "t": packing.exact(found.times_s),
        "p": packing.floats(_in_space(found.pose)),
        "q": packing.floats(q_IB),
        "v": packing.floats(found.velocity_m_s),
        "w": packing.floats(found.rate_rad_s),
        "u": [packing.floats(found.control[:, panel.columns]) for panel in panels],
    }


def _in_space(pose: Pose) -> Array:
    return in_space(pose).position


def _packed_panel(vehicle: Vehicle, panel: Panel) -> dict[str, Any]:
    limits = vehicle.limits
    return {
        "title": panel.title,
        "unit": panel.unit,
        "names": [vehicle.model.control_names[i].rsplit("_", 1)[0] for i in panel.columns],
        "lower": _bounds(limits.control_lower, panel),
        "upper": _bounds(limits.control_upper, panel),
    }


def _bounds(values: Array, panel: Panel) -> list[float | None]:
    """None where there is no bound."""
    return [float(values[i]) if np.isfinite(values[i]) else None for i in panel.columns]
