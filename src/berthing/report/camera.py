"""An orthographic camera: points of space on paper, and how near they are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array


@dataclass(frozen=True, eq=False)
class Camera:
    """Unit vectors of a view, inertial axes.

    Attributes:
        right, up: of the paper (3,).
        towards: out of the paper, to the viewer (3,).
    """

    right: Array
    up: Array
    towards: Array

    @staticmethod
    def at(azimuth_deg: float, elevation_deg: float) -> Camera:
        """Seen from this azimuth about z, x being 0, and this elevation above the xy plane."""
        a, e = np.radians([azimuth_deg, elevation_deg])
        towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return Camera(right, np.cross(towards, right), towards)

    def project(self, points: Array) -> Array:
        """Points (..., 3) on the paper (..., 2), in metres."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def depth(self, points: Array) -> Array:
        """How near the points (..., 3) are to the viewer (...), in metres, from the origin."""
        return np.asarray(points @ self.towards, dtype=np.float64)
