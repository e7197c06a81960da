"""Distances by the collision library ``coal``, each answer held against a plane that proves it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import log2
from typing import Any

import coal
import numpy as np
import numpy.typing as npt

from berthing.clearance.answer import Answer, PairMethod
from berthing.clearance.coal_shapes import coal_pair
from berthing.clearance.support_search import best_normal, sphere_samples
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet, norm

# With coal's default of 1e-6 distances are off by 5e-6 m and the planes of its normals prove up to
# 2.6 mm less than the distance; with 1e-12 some answers are far off.
GJK_TOLERANCE = 1e-10
MAX_ITERATIONS = 1000
# For overlapping sets. Where the first fails, the next are tried.
EPA_TOLERANCES = (1e-8, 1e-7, 1e-6)
# coal's tolerances and epsilons suit some sizes better than others. With sets enlarged to this
# size together, 8 of 50,000 overlapping pairs of all shapes needed a second answer and no depth
# was wrong; with a size of 4, 290 did, and 18 depths were wrong without notice.
COAL_SIZE = 4096.0
# An answer whose plane proves less than its distance by more than this fraction of the sizes of
# the sets is not believed. Sound answers stay within 3e-7.
ACCEPTED_GAP = 1e-6
# coal answers ±1.8e308 where it fails.
FAILED_DISTANCE = 1e300
# Directions in which the depth of overlapping sets is checked: coal has reported a plane that is
# tangent to both sets but much deeper than need be.
CHECKED_DIRECTIONS = 128
# A normal of coal shorter than this, after its part along z is dropped, is no direction.
SHORTEST_NORMAL = 1e-3
# Gap, as a fraction of the sizes, opened between overlapping sets to find where they would touch.
TOUCH_GAP = 1e-3

Flags = npt.NDArray[np.bool_]


class CoalPair(PairMethod):
    """For sets that coal has counterparts of. The objects are made once and reused.

    Raises:
        CapabilityError: a set that coal has no counterpart of.
    """

    # A query takes as long as thirty NumPy calls, so poses are arrays here.

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        super().__init__(a, b)
        # A power of two, which rounds nothing.
        self._scale = 2.0 ** round(log2(COAL_SIZE / self.size))
        # coal's functor holds bare pointers to the geometries: they must outlive it.
        self._coal_a, self._coal_b = coal_pair(a, b, self._scale)
        self._distance = coal.ComputeDistance(self._coal_a.geometry, self._coal_b.geometry)
        self._result = coal.DistanceResult()
        self._identity = coal.Transform3s.Identity()
        self._pose = coal.Transform3s.Identity()

    def one(self, rotation: Array, position: Array) -> Answer:
        answer = self._ask_coal(rotation, position, EPA_TOLERANCES[0])
        if self._sound(rotation, position, answer):
            return answer
        return self._careful(rotation, position)

    def many(self, rotation: Array, position: Array) -> tuple[Array, Array, Array]:
        distance, normal = self._many(rotation, position)
        proven = self.proven(rotation, position, normal)
        doubtful = ~self._believable(rotation, position, distance, proven)
        distance = np.maximum(distance, proven)
        for i in np.flatnonzero(doubtful):
            answer = self._careful(rotation[i], position[i])
            distance[i], normal[i], proven[i] = answer.distance, answer.normal, answer.proven
        return distance, normal, proven

    def _many(self, rotation: Array, position: Array) -> tuple[Array, Array]:
        """Distances and normals as coal gives them with the tightest request."""
        rotations, positions = self._for_coal(rotation, position)
        distances, normals = np.empty(len(positions)), np.empty(positions.shape)
        request, result, identity = _request(EPA_TOLERANCES[0]), self._result, self._identity
        compute, pose = self._distance, self._pose
        place, clear = pose.setTransform, result.clear
        for i, (turn, shift) in enumerate(zip(rotations, positions, strict=True)):
            place(turn, shift)
            clear()
            distances[i] = compute(identity, pose, request, result)
            normals[i] = result.normal
        return self._metres(distances), self._own_normal(normals)

    def _careful(self, rotation: Array, position: Array) -> Answer:
        """The first sound answer of looser requests and of the search by support functions.

        If none is, the one that proves most is the nearest to the truth, for the signed distance
        is the largest plane bound over all normals.
        """
        answers = []
        for tolerance in EPA_TOLERANCES[1:]:
            answers.append(self._ask_coal(rotation, position, tolerance))
            if self._sound(rotation, position, answers[-1]):
                return answers[-1]
        answers.append(self._search(rotation, position))
        best = max(answers, key=lambda answer: answer.proven)
        return replace(best, distance=best.proven)

    def _sound(self, rotation: Array, position: Array, answer: Answer) -> bool:
        distance, proven = np.array([answer.distance]), np.array([answer.proven])
        return bool(self._believable(rotation[None], position[None], distance, proven)[0])

    def _believable(
        self, rotation: Array, position: Array, distance: Array, proven: Array
    ) -> Flags:
        """Whether the plane proves the distance, and no checked direction disproves the depth."""
        tolerance = ACCEPTED_GAP * self.size
        fine = np.asarray(distance - proven <= tolerance)
        overlapping = np.asarray(fine & (distance < 0.0))
        if overlapping.any():
            n = sphere_samples(CHECKED_DIRECTIONS, self.dim)
            extent_b = self.b.support(-n @ rotation[overlapping])[0]
            bound = position[overlapping] @ n.T - self.a.support(n)[0] - extent_b
            fine[overlapping] = np.max(bound, axis=-1) <= proven[overlapping] + tolerance
        return fine

    def _ask_coal(self, rotation: Array, position: Array, epa_tolerance: float) -> Answer:
        self._pose.setTransform(*self._for_coal(rotation, position))
        result = self._result
        result.clear()
        raw = self._distance(self._identity, self._pose, _request(epa_tolerance), result)
        distance = float(self._metres(np.array(raw)))
        normal = self._own_normal(result.normal)
        to_own = self._coal_a.turn[: self.dim] / self._scale
        point_a, point_b = to_own @ result.getNearestPoint1(), to_own @ result.getNearestPoint2()
        proven = float(self.proven(rotation, position, normal))
        return Answer(max(distance, proven), normal, point_a, point_b, proven)

    def _search(self, rotation: Array, position: Array) -> Answer:
        """By support functions; the witnesses are found where the sets would just not touch."""
        normal = best_normal(self.a, self.b, rotation, position)
        proven = float(self.proven(rotation, position, normal))
        apart = position + (TOUCH_GAP * self.size - proven) * normal
        touch = self._ask_coal(rotation, apart, EPA_TOLERANCES[0])
        found = self._sound(rotation, apart, touch)
        point_a = touch.point_a if found else self.a.support(normal)[1]
        return Answer(proven, normal, point_a, point_a + proven * normal, proven)

    def _for_coal(self, rotation: Array, position: Array) -> tuple[Array, Array]:
        """The pose of B's geometry in the frame of A's, in three dimensions, enlarged."""
        if self.dim == 2:
            batch = position.shape[:-1]
            planar_rotation, planar_position = rotation, position
            rotation, position = np.zeros((*batch, 3, 3)), np.zeros((*batch, 3))
            rotation[..., 2, 2] = 1.0
            rotation[..., :2, :2] = planar_rotation
            position[..., :2] = planar_position
        turn_a, turn_b = self._coal_a.turn, self._coal_b.turn
        return turn_a.T @ rotation @ turn_b, self._scale * (position @ turn_a)

    def _metres(self, distance: Array) -> Array:
        """coal's distance in metres; infinity, which no plane proves, where coal failed."""
        failed = ~(np.abs(distance) < FAILED_DISTANCE)
        return np.asarray(np.where(failed, np.inf, distance / self._scale))

    def _own_normal(self, normal: Array) -> Array:
        """coal's normal in A's frame, d components, of length 1, or 0 where it is no direction."""
        own = (normal @ self._coal_a.turn.T)[..., : self.dim]
        length = norm(own)
        # Not for NaN either.
        usable = length > SHORTEST_NORMAL
        return np.asarray(
            np.where(usable[..., None], own / np.where(usable, length, 1.0)[..., None], 0.0)
        )


@cache
def _request(epa_tolerance: float) -> Any:
    request = coal.DistanceRequest()
    request.gjk_tolerance = GJK_TOLERANCE
    request.gjk_max_iterations = MAX_ITERATIONS
    request.epa_tolerance = epa_tolerance
    request.epa_max_iterations = MAX_ITERATIONS
    request.enable_signed_distance = True
    return request
