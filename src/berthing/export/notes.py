"""What every file says of itself, in ASCII lines that fit any format's comments."""

from __future__ import annotations

import numpy as np

from berthing._version import __version__
from berthing.export.handover import Handover, Track
from berthing.scenario.rigid_body import RigidBody

# In micrometres the two points are one.
SAME_POINT_M = 1e-6

_CONTROLS = {
    "polynomial": "polynomials of time on each segment",
    "linear": "linear in time on each segment",
    "constant": "constant on each segment",
}
NO_CONTROLS = "They are not in this file; interpolant.json of the plan has them."


def notes(
    handover: Handover, *, quaternion: str, units: str, controls: str = NO_CONTROLS
) -> list[str]:
    """Source, verdict, clock, frame, units, quaternion, controls; one to a line.

    Args:
        handover: the plan.
        quaternion: how attitude stands in the file; empty where it does not.
        units: of what stands in the file.
        controls: where they are.
    """
    return [
        f"Written by berthing {__version__}: a plan of the scenario {handover.scenario.name}.",
        _verdict(handover),
        _clock(handover),
        _frame(handover),
        f"Units: {units}.",
        f"Quaternion: {quaternion}." if quaternion else "Attitude: not in this file.",
        *(line for track in handover.tracks for line in _of_track(track, controls)),
    ]


def _verdict(handover: Handover) -> str:
    if handover.outcome == "certified":
        return "Outcome: certified, as plan.json says; `berthing verify` checks it again."
    return f"Outcome: {handover.outcome}. NOT CERTIFIED: this motion is not proven to be safe."


def _clock(handover: Handover) -> str:
    epoch = handover.meta.epoch
    if epoch is None:
        return "Epoch: not given; times are seconds from the start of the plan."
    return f"Epoch: t = 0 is {epoch.iso()} {epoch.scale}; times count SI seconds from it."


def _frame(handover: Handover) -> str:
    frame, centre = handover.meta.frame, handover.meta.centre
    named = "not named" if frame is None else frame
    about = "centre not named" if centre is None else f"centred on {centre}"
    return f"Frame: {named}, {about}; the plan takes it for inertial."


def _of_track(track: Track, controls: str) -> list[str]:
    where = f"{track.name} in phase {track.phase.name}"
    count = len(track.trajectory.segments)
    how = _CONTROLS[track.trajectory.control_interpolation]
    names = ", ".join(track.trajectory.control_names)
    return [
        f"Position of {where}: of the body's reference point{_off_centre(track)}.",
        f"Controls of {where}: {names}; {how}, {count} in all. {controls}",
    ]


def _off_centre(track: Track) -> str:
    model = track.vehicle.model
    if not isinstance(model, RigidBody) or np.linalg.norm(model.centre_of_mass_m) < SAME_POINT_M:
        return ", which is its centre of mass"
    x, y, z = model.centre_of_mass_m
    return f"; its centre of mass is at ({x:.9g}, {y:.9g}, {z:.9g}) m in body axes"
