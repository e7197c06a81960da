"""Mass, first moment and inertia of solids."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.mesh.solid import Solid


@dataclass(frozen=True, eq=False)
class MassProperties:
    """Moments of a distribution of mass about the origin of a frame.

    Attributes:
        mass_kg: its mass.
        first_moment_kg_m: mass times the centre of mass (3,).
        second_moment_kg_m2: ∫ x xᵀ dm (3, 3); it moves between frames more simply than the
            inertia, tr(S) 1 − S.
    """

    mass_kg: float
    first_moment_kg_m: Array
    second_moment_kg_m2: Array

    @staticmethod
    def of_inertia(mass_kg: float, inertia_kg_m2: Array) -> MassProperties:
        """From the inertia (3, 3) about the centre of mass, which is the origin.

        tr J = 2 tr S, so S = ½ tr(J) 1 − J.
        """
        second = 0.5 * np.trace(inertia_kg_m2) * np.eye(3) - inertia_kg_m2
        return MassProperties(mass_kg, np.zeros(3), second)

    @property
    def inertia_kg_m2(self) -> Array:
        """About the origin (3, 3)."""
        second = self.second_moment_kg_m2
        return np.asarray(np.trace(second) * np.eye(3) - second)

    def seen_from(self, pose: Pose) -> MassProperties:
        """The same mass in the frame in which its own frame has the single pose.

        x' = R x + r gives ∫ x'x'ᵀ dm = R S Rᵀ + R c rᵀ + r (R c)ᵀ + m r rᵀ.
        """
        r, turned = pose.position, pose.rotate(self.first_moment_kg_m)
        mixed = np.outer(turned, r)
        second = pose.rotation @ self.second_moment_kg_m2 @ pose.rotation.T
        return MassProperties(
            self.mass_kg,
            turned + self.mass_kg * r,
            second + mixed + mixed.T + self.mass_kg * np.outer(r, r),
        )

    def __add__(self, other: MassProperties) -> MassProperties:
        """Both together, about the same origin."""
        return MassProperties(
            self.mass_kg + other.mass_kg,
            self.first_moment_kg_m + other.first_moment_kg_m,
            self.second_moment_kg_m2 + other.second_moment_kg_m2,
        )

    def scaled(self, factor: float) -> MassProperties:
        """The same distribution, denser by a factor."""
        return MassProperties(
            factor * self.mass_kg,
            factor * self.first_moment_kg_m,
            factor * self.second_moment_kg_m2,
        )


NOTHING = MassProperties(0.0, np.zeros(3), np.zeros((3, 3)))


def of_solid(solid: Solid, density_kg_m3: float = 1.0) -> MassProperties:
    """Of a solid of even density, about the origin of its frame.

    The solid is the signed sum of the tetrahedra (p, a, b, c) over its triangles, p being any
    point. For one with d = det[a, b, c] and s = a + b + c, corners from p:
    V = d/6, ∫ x dV = d/24 s, ∫ x xᵀ dV = d/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ).
    """
    middle = solid.vertices.mean(axis=0)
    corners = solid.corners - middle
    a, b, c = np.moveaxis(corners, 1, 0)
    det = np.einsum("ij,ij->i", a, np.cross(b, c))
    total = corners.sum(axis=1)
    second = np.einsum("i,ijk,ijl->kl", det, corners, corners)
    second += np.einsum("i,ik,il->kl", det, total, total)
    about_middle = MassProperties(
        float(det.sum()) / 6.0, np.einsum("i,ij->j", det, total) / 24.0, second / 120.0
    )
    return about_middle.scaled(density_kg_m3).seen_from(Pose(middle, np.eye(3)))
