"""How a phase is cut into segments, and where each node lies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.transcription.scheme import (
    ONE_SEGMENT,
    ONE_SEGMENT_NODES,
    NodeSet,
    scheme,
)


@dataclass(frozen=True)
class Mesh:
    """Segments of one phase.

    Attributes:
        scheme: name of the collocation scheme.
        breaks: (segments + 1,) rising fractions of the phase from 0 to 1.
        degrees: one a segment.
    """

    scheme: str
    breaks: tuple[float, ...]
    degrees: tuple[int, ...]

    def __post_init__(self) -> None:
        if len(self.breaks) != len(self.degrees) + 1 or self.breaks[0] != 0 or self.breaks[-1] != 1:
            raise InputError(
                "mesh", f"breaks {self.breaks}", "fractions from 0 to 1, one a segment"
            )
        if any(b <= a for a, b in zip(self.breaks[:-1], self.breaks[1:], strict=True)):
            raise InputError("mesh", "the breaks do not rise", "strictly rising fractions")

    @staticmethod
    def uniform(scheme_name: str, segments: int, degree: int) -> Mesh:
        """``segments`` equal segments of one degree."""
        return Mesh(
            scheme_name, tuple(np.linspace(0, 1, segments + 1).tolist()), (degree,) * segments
        )

    @staticmethod
    def of_nodes(scheme_name: str, nodes: int | None, segments: int, degree: int) -> Mesh:
        """About ``nodes`` collocated nodes in segments of at most ``degree``.

        Without ``nodes`` there are ``segments`` of ``degree``. A scheme of one segment takes the
        number exactly, whatever the degree.
        """
        ends = len(scheme(scheme_name)(degree).collocated) - degree
        if scheme_name in ONE_SEGMENT:
            return Mesh.uniform(scheme_name, 1, (nodes or ONE_SEGMENT_NODES) - ends)
        if nodes is None:
            return Mesh.uniform(scheme_name, segments, degree)
        degree = min(degree, nodes - ends)
        return Mesh.uniform(scheme_name, max(1, round(nodes / (degree + ends))), degree)

    @property
    def segments(self) -> int:
        return len(self.degrees)

    def node_set(self, k: int) -> NodeSet:
        """The nodes of segment k on [-1, 1]."""
        return scheme(self.scheme)(self.degrees[k])

    def point_offset(self, k: int) -> int:
        """Index of the first state point of segment k; neighbours share their common point."""
        return sum(len(self.node_set(i).points) - 1 for i in range(k))

    def control_offset(self, k: int) -> int:
        """Index of the first control of segment k; every segment has its own."""
        return sum(len(self.node_set(i).collocated) for i in range(k))

    @property
    def dependent(self) -> bool:
        """Whether a segment has as many defects as points, so that they may depend on each other:
        a constant has no slope, and the rows of its derivative at n points are n - 1 in truth."""
        nodes = self.node_set(0)
        return len(nodes.collocated) == len(nodes.points)

    @property
    def point_count(self) -> int:
        return self.point_offset(self.segments) + 1

    @property
    def control_count(self) -> int:
        return self.control_offset(self.segments)

    def fraction(self, k: int, s: float) -> float:
        """Fraction of the phase at the local coordinate s of segment k."""
        b0, b1 = self.breaks[k], self.breaks[k + 1]
        return b0 + (b1 - b0) * (s + 1.0) / 2.0

    def point_fractions(self) -> Array:
        """(point_count,) fractions of all state points."""
        inner = [
            self.fraction(k, float(s))
            for k in range(self.segments)
            for s in self.node_set(k).points[:-1]
        ]
        return np.array([*inner, 1.0])

    def locate(self, fraction: float) -> tuple[int, float]:
        """Segment and local coordinate of a fraction of the phase."""
        k = int(
            np.clip(np.searchsorted(self.breaks, fraction, side="right") - 1, 0, self.segments - 1)
        )
        b0, b1 = self.breaks[k], self.breaks[k + 1]
        return k, float(np.clip(2.0 * (fraction - b0) / (b1 - b0) - 1.0, -1.0, 1.0))

    def split(self, segments: set[int]) -> Mesh:
        """Halve the segments named; a mesh that is one segment throughout stays as it is."""
        if self.scheme in ONE_SEGMENT:
            return self
        breaks, degrees = [0.0], []
        for k, degree in enumerate(self.degrees):
            if k in segments:
                breaks.append(0.5 * (self.breaks[k] + self.breaks[k + 1]))
                degrees.append(degree)
            breaks.append(self.breaks[k + 1])
            degrees.append(degree)
        return Mesh(self.scheme, tuple(breaks), tuple(degrees))
