"""What several placed convex sets have in common."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np

from berthing.errors import CapabilityError, InputError
from berthing.geometry import direction_cover
from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form, level
from berthing.geometry.conic_algebra import intersected, placed
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import Standard, standard
from berthing.geometry.convex_set import ConvexSet, last_axis, norm, unit
from berthing.geometry.hulls import FLATNESS_TOLERANCE, enclosed
from berthing.geometry.inscribed import inscribed_ball
from berthing.geometry.mesh import Mesh, support_mesh
from berthing.geometry.pose import Pose

WHERE = "Intersection"


@final
@dataclass(frozen=True, eq=False, init=False)
class Intersection(ConvexSet):
    """{x : x is in every one of the placed sets}: polyhedral and ellipsoidal ones mixed at will.

    Its conic form is all of theirs, and its support function is that form's dual, solved to 1e-9
    of the size, and most often to 1e-12.

    Attributes:
        sets: two or more with a conic form; half-spaces are welcome.
        placements: a single pose of each, its own frame in that of the intersection.

    Raises:
        InputError: fewer than two, dimensions that differ, a set without a conic form, or sets
            that have no volume or no bounded set in common.
    """

    sets: tuple[ConvexSet, ...]
    placements: tuple[Pose, ...]

    def __init__(self, sets: Sequence[ConvexSet], placements: Sequence[Pose] | None = None) -> None:
        """``placements`` are all identities if not given."""
        sets = tuple(sets)
        if len(sets) < 2:
            raise InputError(WHERE, f"has {len(sets)} sets", "two or more")
        poses = tuple(placements or (Pose.identity(sets[0].dim) for _ in sets))
        if len(poses) != len(sets):
            found = f"has {len(poses)} placements of {len(sets)} sets"
            raise InputError(WHERE, found, "one each")
        if len({s.dim for s in sets} | {p.dim for p in poses}) > 1:
            raise InputError(WHERE, "mixes two and three dimensions", "one or the other")
        if any(pose.batch_shape for pose in poses):
            raise InputError(WHERE, "has a batch of placements", "single poses")
        object.__setattr__(self, "sets", sets)
        object.__setattr__(self, "placements", poses)
        self._refuse_flat()

    @property
    def dim(self) -> int:
        return self.sets[0].dim

    @cached_property
    def bounding_radius(self) -> float:
        """sup |x|, at most 0.1% too large."""
        cones = direction_cover.orthants(self.dim)
        proven = direction_cover.largest(lambda u: self.support(u)[0], cones)
        return min(proven, self._reach)

    @property
    def centre(self) -> Array:
        """A point (dim,) well inside, in metres."""
        return self._ball[0]

    def support(self, n: Array) -> tuple[Array, Array]:
        """The value is an upper bound, from the dual; the point is a member."""
        n = last_axis(n, self.dim, f"{WHERE}.support: n")
        rays = unit(n).reshape(-1, self.dim)
        some = np.flatnonzero(np.any(rays != 0.0, axis=-1))
        value, point = np.zeros(len(rays)), np.tile(self.centre, (len(rays), 1))
        if len(some):
            objective = np.zeros((len(some), self.conic_form().size))
            objective[:, : self.dim] = -rays[some]
            best = minimise(self.problem, objective)
            point[some] = best.point[:, : self.dim]
            value[some] = np.maximum(-best.dual, np.sum(rays * point, axis=-1)[some])
        return norm(n) * value.reshape(n.shape[:-1]), point.reshape(n.shape)

    def level(self, x: Array) -> Array:
        """The largest of the sets' levels, whatever their units."""
        x = last_axis(x, self.dim, f"{WHERE}.level: x")
        own = [pose.unrotate(x - pose.position) for pose in self.placements]
        return np.asarray(
            np.max([level(s, points) for s, points in zip(self.sets, own, strict=True)], axis=0)
        )

    def conic_form(self) -> ConicForm:
        return self._form

    def mesh(self) -> Mesh:
        return support_mesh(self.support, self.dim)

    @cached_property
    def _form(self) -> ConicForm:
        pairs = zip(self.sets, self.placements, strict=True)
        try:
            return intersected([placed(conic_form(s), pose) for s, pose in pairs])
        except CapabilityError as error:
            raise InputError(f"{WHERE}.sets", str(error)) from None

    @cached_property
    def _reach(self) -> float:
        """No member is farther from the origin than this, in metres."""
        return min(self._reaches)

    @cached_property
    def _reaches(self) -> tuple[float, ...]:
        """Of the sets that are bounded; of the half-spaces together, where none is."""
        placed_sets = zip(self.sets, self.placements, strict=True)
        found = [float(norm(pose.position)) + s.bounding_radius for s, pose in placed_sets]
        bounded = tuple(reach for reach in found if np.isfinite(reach))
        if bounded:
            return bounded
        corners = enclosed(self._form.linear_A, self._form.linear_b, WHERE)[2]
        return (float(np.max(norm(corners))),)

    @cached_property
    def _ball(self) -> tuple[Array, float]:
        return inscribed_ball(self._form, self._reach)

    @cached_property
    def problem(self) -> Standard:
        """The conic form, scaled, as solvers want it."""
        return standard(self._form, self._reach, max(self._reaches))

    def _refuse_flat(self) -> None:
        if self._reach == 0.0:
            raise InputError(WHERE, "is flat: one of its sets is a point", "a volume")
        radius = self._ball[1]
        thin = FLATNESS_TOLERANCE * self._reach
        if radius < -thin:
            raise InputError(WHERE, "is empty: no point lies in all of its sets", "a volume")
        if radius <= thin:
            raise InputError(WHERE, "is flat: its sets have no volume in common", "a volume")
