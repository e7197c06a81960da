"""glTF 2.0 as one binary file: true shapes, animated along the plan.

glTF is in float32: seven digits. Times are rounded to it first and the plan is sampled there, so
that poses are off by their own rounding only.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from berthing._version import __version__
from berthing.errors import CapabilityError
from berthing.export.glb import ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER, Glb
from berthing.export.handover import Handover, Track
from berthing.export.notes import notes
from berthing.export.order import SCALAR_LAST, scalar_last
from berthing.export.samples import continuous, in_space, sample
from berthing.geometry.arrays import Array
from berthing.geometry.body import Body
from berthing.geometry.capability import mesh
from berthing.scenario.structure import Structure

STRUCTURE_SAMPLES = 1001
# glTF's y points up; the plan's z is drawn up, by a turn of −90° about x.
Z_UP = [-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]
_COLOURS = ([0.12, 0.47, 0.71, 1.0], [0.55, 0.55, 0.55, 1.0])
VEHICLE, STRUCTURE = 0, 1


def write(handover: Handover, path: Path) -> None:
    """A root that turns z up; below it, in the plan's axes, vehicles and structures with parts."""
    scene = _Scene(handover)
    children = [scene.vehicle(name) for name in handover.vehicles]
    children += [scene.structure(s) for s in handover.scenario.structures]
    scene.finish(children, path)


class _Scene:
    """The file in the making, and its one animation."""

    def __init__(self, handover: Handover) -> None:
        self.handover = handover
        self.glb = Glb({"asset": {"version": "2.0", "generator": f"berthing {__version__}"}})
        self.glb.document["materials"] = [
            {
                "pbrMetallicRoughness": {
                    "baseColorFactor": colour, "metallicFactor": 0.1, "roughnessFactor": 0.8
                },
                "doubleSided": True,
            }
            for colour in _COLOURS
        ]  # fmt: skip
        self.animation: dict[str, Any] = {"name": "plan", "channels": [], "samplers": []}

    def vehicle(self, name: str) -> int:
        """The node of a vehicle; its parts below it, of each phase in a group where several."""
        tracks = self.handover.of(name)
        groups = [self._parts(track.vehicle.body, VEHICLE) for track in tracks]
        if len(tracks) > 1:
            groups = [[self._group(t, g)] for t, g in zip(tracks, groups, strict=True)]
        children = [child for group in groups for child in group]
        node = self._node(name, children)
        t, position, q = _rounded(tracks)
        self._animate(node, t, position, q)
        return node

    def structure(self, structure: Structure) -> int:
        """The node of a structure, animated where it moves."""
        node = self._node(structure.name, self._parts(structure.body, STRUCTURE))
        t = np.unique(np.linspace(*self.handover.span_s, STRUCTURE_SAMPLES).astype(np.float32))
        position, q = in_space(structure.motion.pose(t.astype(np.float64)))
        self._animate(node, t.astype(np.float64), position, continuous(q))
        return node

    def finish(self, children: list[int], path: Path) -> None:
        """Add the root, the notes and the animation, and write."""
        root = self._node(self.handover.scenario.name, children)
        document = self.glb.document
        document["nodes"][root]["rotation"] = Z_UP
        document |= {"scene": 0, "scenes": [{"nodes": [root]}]}
        if self.animation["channels"]:
            document["animations"] = [self.animation]
        document["asset"]["extras"] = {"berthing": self._told()}
        self.glb.write(path)

    def _told(self) -> list[str]:
        told = notes(self.handover, quaternion=SCALAR_LAST, units="m, s; float32")
        return [*told, "Axes: the root node turns the plan's z to glTF's y; below it, the plan's."]

    def _node(self, name: str, children: list[int]) -> int:
        return self.glb.append(
            "nodes", {"name": name, **({"children": children} if children else {})}
        )

    def _parts(self, body: Body, material: int) -> list[int]:
        found = []
        for part in body.parts:
            node = self._node(part.name, [])
            position, q = in_space(part.placement)
            entry = self.glb.document["nodes"][node]
            entry |= {"translation": position.tolist(), "rotation": scalar_last(q).tolist()}
            try:
                surface = mesh(part.shape)
            except CapabilityError:
                # Without a surface there is still the frame.
                pass
            else:
                entry["mesh"] = self._mesh(surface.vertices, surface.triangles, material)
            found.append(node)
        return found

    def _mesh(self, vertices: Array, triangles: Any, material: int) -> int:
        primitive = {
            "attributes": {"POSITION": self.glb.add(vertices, target=ARRAY_BUFFER)},
            "indices": self.glb.add(triangles.ravel(), target=ELEMENT_ARRAY_BUFFER),
            "material": material,
        }
        return self.glb.append("meshes", {"primitives": [primitive]})

    def _group(self, track: Track, parts: list[int]) -> int:
        """Parts that are there in one phase only: outside it they have no size."""
        node = self._node(f"{track.name} in {track.phase.name}", parts)
        start, end = track.trajectory.t0_s, track.trajectory.t1_s
        first, last = self.handover.span_s
        steps = {first: 0.0, start: 1.0, **({end: 0.0} if end < last else {})}
        sizes = np.repeat(np.array(list(steps.values()))[:, None], 3, axis=1)
        self._channel(node, "scale", np.array(list(steps)), sizes, "STEP")
        return node

    def _animate(self, node: int, t: Array, position: Array, q: Array) -> None:
        entry = self.glb.document["nodes"][node]
        rows = {"translation": position, "rotation": scalar_last(q)}
        for path, values in rows.items():
            entry[path] = values[0].tolist()
            if not np.all(values == values[0]):
                self._channel(node, path, t, values, "LINEAR")

    def _channel(self, node: int, path: str, t: Array, values: Array, how: str) -> None:
        sampler = {
            "input": self.glb.add(t), "output": self.glb.add(values), "interpolation": how
        }  # fmt: skip
        self.animation["samplers"].append(sampler)
        index = len(self.animation["samplers"]) - 1
        self.animation["channels"].append(
            {"sampler": index, "target": {"node": node, "path": path}}
        )


def _rounded(tracks: Sequence[Track]) -> tuple[Array, Array, Array]:
    """Times (k,) that float32 holds, and positions and quaternions at them."""
    times: list[Array] = []
    positions: list[Array] = []
    quaternions: list[Array] = []
    for track in tracks:
        t = np.unique(track.samples.t_s.astype(np.float32)).astype(np.float64)
        if times:
            t = t[t > times[-1][-1]]
        s = sample(track.vehicle.model, track.trajectory, t)
        times.append(t)
        positions.append(s.position_m)
        quaternions.append(s.q_IB)
    return (
        np.concatenate(times), np.concatenate(positions), continuous(np.concatenate(quaternions))
    )  # fmt: skip
