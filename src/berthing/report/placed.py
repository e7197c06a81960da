"""What stands in the picture of a scene: parts of bodies, placed and coloured."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.body import Body
from berthing.geometry.capability import mesh
from berthing.geometry.pose import Pose
from berthing.report.space import in_space
from berthing.report.style import MUTED, STRUCTURE_COLOUR, TEXT
from berthing.report.surface import Surface
from berthing.report.track import Track
from berthing.scenario.motion import Fixed
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure

# Hulls drawn along a track, the first and the last included; fewer of a structure that moves.
GHOSTS, STRUCTURE_GHOSTS = 7, 4
# Opacity of faces and of lines, at the first and at the last of several.
FACE_ALPHA, LINE_ALPHA = (0.05, 0.34), (0.30, 1.0)
# A structure shows what is inside it.
FIXED_ALPHA, FIXED_LINE_ALPHA = 0.5, 0.75


@dataclass(frozen=True, eq=False)
class Placed:
    """One convex part at one pose of space.

    Attributes:
        surface: its mesh.
        pose: a single pose in three dimensions.
        colour, alpha: of its faces.
        line, line_alpha: of its edges.
    """

    surface: Surface
    pose: Pose
    colour: str
    alpha: float
    line: str
    line_alpha: float

    @property
    def points(self) -> Array:
        """Its vertices (k, 3), inertial."""
        return self.pose.apply(self.surface.vertices)


def placed_parts(scenario: Scenario, tracks: list[Track]) -> list[Placed]:
    """Structures, at several times where they move, and vehicles at several times."""
    found: list[Placed] = []
    span = (min(t.dense.times_s[0] for t in tracks), max(t.dense.times_s[-1] for t in tracks))
    for structure in scenario.structures:
        found += _structure(structure, *span)
    for track in tracks:
        poses = track.dense.pose[ghost_indices(track)]
        found += _faded(track.vehicle.body, poses, track.colour)
    return found


def ghost_indices(track: Track) -> list[int]:
    """Samples of the track at even steps of the way that its outermost point may have gone."""
    dense = track.dense
    speed = np.linalg.norm(dense.velocity_m_s, axis=1)
    turning = np.linalg.norm(dense.rate_rad_s, axis=1) * track.vehicle.body.bounding_radius
    step = 0.5 * np.diff(dense.times_s) * np.convolve(speed + turning, [1.0, 1.0], "valid")
    way = np.concatenate([[0.0], np.cumsum(step)])
    wanted = np.linspace(0.0, way[-1], GHOSTS)
    return sorted({0, *np.searchsorted(way, wanted[1:-1]).tolist(), len(way) - 1})


def _structure(structure: Structure, t0: float, t1: float) -> Iterator[Placed]:
    if not isinstance(structure.motion, Fixed):
        times = np.linspace(t0, t1, STRUCTURE_GHOSTS)
        poses = structure.motion.pose(times)
        yield from _faded(structure.body, poses, STRUCTURE_COLOUR, line=MUTED)
        return
    pose = structure.motion.pose(np.array([t0]))[0]
    for surface, placement in _surfaces(structure.body):
        at = in_space(pose.compose(placement))
        yield Placed(surface, at, STRUCTURE_COLOUR, FIXED_ALPHA, TEXT, FIXED_LINE_ALPHA)


def _faded(body: Body, poses: Pose, colour: str, line: str = "") -> Iterator[Placed]:
    parts = list(_surfaces(body))
    count = len(poses)
    for i in range(count):
        share = i / max(count - 1, 1)
        alpha = FACE_ALPHA[0] + share * (FACE_ALPHA[1] - FACE_ALPHA[0])
        line_alpha = LINE_ALPHA[0] + share * (LINE_ALPHA[1] - LINE_ALPHA[0])
        for surface, placement in parts:
            pose = in_space(poses[i].compose(placement))
            yield Placed(surface, pose, colour, alpha, line or colour, line_alpha)


def _surfaces(body: Body) -> Iterable[tuple[Surface, Pose]]:
    return ((Surface.of(mesh(part.shape)), part.placement) for part in body.parts)
