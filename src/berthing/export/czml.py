"""CZML, the scene format of Cesium: paths, attitudes, and the parts it has shapes for.

Positions and attitudes are Earth-fixed, which is the only frame that CZML has for attitudes.
"""

from __future__ import annotations

import json
from datetime import timedelta
from pathlib import Path
from typing import Any

import numpy as np

from berthing.export.ccsds import epoch_of
from berthing.export.czml_shapes import graphics
from berthing.export.earth import placement
from berthing.export.handover import Handover
from berthing.export.joined import joined
from berthing.export.notes import notes
from berthing.export.order import SCALAR_LAST, scalar_last
from berthing.export.samples import continuous, in_space
from berthing.export.thinning import apart
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.body import Body
from berthing.geometry.pose import Pose
from berthing.scenario.structure import Structure

# Cubics through four samples; the plan's own polynomials are of degree 3 to 8 on longer pieces.
DEGREE = 3
# Samples of a structure that moves.
STRUCTURE_SAMPLES = 1001
VEHICLE_RGBA, STRUCTURE_RGBA = [31, 119, 180, 255], [140, 140, 140, 255]

Packet = dict[str, Any]


def write(handover: Handover, path: Path) -> None:
    """A document packet, then packets of vehicles, structures and their parts.

    Positions are sampled as everywhere, attitudes where they differ enough.

    Raises:
        InputError: ``meta:`` does not say where on the Earth the plan is to be drawn.
    """
    stage = _Stage(handover)
    packets = [packet for name in handover.vehicles for packet in stage.vehicle(name)]
    for structure in handover.scenario.structures:
        packets += stage.structure(structure)
    document = [stage.document(), *packets]
    path.write_text(json.dumps(document, allow_nan=False) + "\n", encoding="ascii")


class _Stage:
    """The clock and the frame that all packets share."""

    def __init__(self, handover: Handover) -> None:
        self.handover = handover
        self.epoch = epoch_of(handover)
        self.start = f"{self.epoch.utc.isoformat(timespec='microseconds')}Z"

    def document(self) -> Packet:
        start, end = (self._stamp(t) for t in self.handover.span_s)
        place = placement(self.handover.meta, self.epoch, np.zeros(1))
        told = notes(self.handover, quaternion=SCALAR_LAST, units="m, Earth-fixed axes")
        return {
            "id": "document",
            "name": self.handover.scenario.name,
            "description": "\n".join([*told, f"Placement: {place.told}."]),
            "version": "1.0",
            "clock": {
                "interval": f"{start}/{end}", "currentTime": start, "multiplier": 1,
                "range": "LOOP_STOP", "step": "SYSTEM_CLOCK_MULTIPLIER",
            },
        }  # fmt: skip

    def vehicle(self, name: str) -> list[Packet]:
        """Its path over all phases, and its parts as they are in each."""
        tracks = self.handover.of(name)
        t, position, _, q = joined(tracks)
        colour = {"color": {"rgba": VEHICLE_RGBA}}
        own = {
            "id": name,
            "name": self.handover.meta.object_name(name),
            "point": {"pixelSize": 6, **colour},
            "path": {"width": 2, "material": {"solidColor": colour}},
            **self._pose(t, position, q),
        }
        found = [own]
        for track in tracks:
            s, between = track.samples, None
            if len(tracks) > 1:
                between = (track.trajectory.t0_s, track.trajectory.t1_s)
            body = track.vehicle.body
            parts = self._parts(name, body, s.t_s, s.position_m, s.q_IB, VEHICLE_RGBA)
            found += [self._during(part, track.phase.name, between) for part in parts]
        return found

    def structure(self, structure: Structure) -> list[Packet]:
        """Its frame, and its parts."""
        t = np.linspace(*self.handover.span_s, STRUCTURE_SAMPLES)
        position, q = in_space(structure.motion.pose(t))
        own = {"id": structure.name, "name": structure.name, **self._pose(t, position, q)}
        return [
            own, *self._parts(structure.name, structure.body, t, position, q, STRUCTURE_RGBA)
        ]  # fmt: skip

    def _during(self, packet: Packet, phase: str, between: tuple[float, float] | None) -> Packet:
        """The packet for one phase of several only."""
        if between is None:
            return packet
        shown = "/".join(self._stamp(t) for t in between)
        return {**packet, "id": f"{packet['id']} ({phase})", "availability": shown}

    def _parts(
        self, name: str, body: Body, t: Array, position: Array, q: Array, rgba: list[int]
    ) -> list[Packet]:
        """Of a body with the poses (k, 3) and (k, 4) in the plan's frame."""
        poses = Pose.from_quaternion(position, q)
        found = []
        for part in body.parts:
            drawn = graphics(part.shape, rgba)
            if drawn is not None:
                turn, shape = drawn
                at, part_q = in_space(part.placement)
                placed = quaternion.multiply(quaternion.multiply(q, part_q), turn)
                pose = self._pose(t, poses.apply(at), placed)
                found.append({"id": f"{name}/{part.name}", "parent": name, **pose, **shape})
        return found

    def _pose(self, t: Array, position: Array, q: Array) -> Packet:
        place = placement(self.handover.meta, self.epoch, t)
        at, turned = place.poses(position, q)
        kept = apart(turned)
        attitude = scalar_last(continuous(turned[kept]))
        return {
            "position": {"referenceFrame": "FIXED", **self._values("cartesian", t, at)},
            "orientation": self._values("unitQuaternion", t[kept], attitude),
        }

    def _values(self, key: str, t: Array, rows: Array) -> Packet:
        """Sampled, or one value where it does not change."""
        if np.all(rows == rows[0]):
            return {key: rows[0].tolist()}
        return {
            "epoch": self.start,
            "interpolationAlgorithm": "LAGRANGE",
            "interpolationDegree": DEGREE,
            key: np.hstack([t[:, None], rows]).ravel().tolist(),
        }

    def _stamp(self, t_s: float) -> str:
        return f"{(self.epoch.utc + timedelta(seconds=t_s)).isoformat(timespec='microseconds')}Z"
