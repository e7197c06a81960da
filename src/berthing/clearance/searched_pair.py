"""Distances of sets that the collision library does not know, from their support functions."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import replace

import numpy as np

from berthing.clearance.answer import Answer, PairMethod
from berthing.clearance.support_search import best_normal
from berthing.geometry.arrays import Array

# Sets nearer than this fraction of their sizes are treated as touching: the direction from the
# one to the other is then the search's to find.
TOUCHING = 1e-7
# Of the directions that the search is to find; they are made exact afterwards.
SEARCH_TOLERANCE_RAD = 1e-4
# Gap, as a fraction of the sizes, to which overlapping sets are parted along a normal.
PARTED = 0.05
# Gains, as a fraction of the sizes, that are worth another parting; a handful are usual.
GAIN_TOLERANCE, MAX_PARTINGS = 1e-12, 50


class SearchedPair(PairMethod):
    """A method for sets apart, completed by a search for those that touch or overlap."""

    @abstractmethod
    def apart(self, rotation: Array, position: Array) -> list[Answer]:
        """Answers at k poses; of sets that are not apart, one with about zero distance."""

    def one(self, rotation: Array, position: Array) -> Answer:
        return self._settled(self.apart(rotation[None], position[None])[0], rotation, position)

    def many(self, rotation: Array, position: Array) -> tuple[Array, Array, Array]:
        found = zip(self.apart(rotation, position), rotation, position, strict=True)
        answers = [self._settled(*answer_and_pose) for answer_and_pose in found]
        distance = np.array([answer.distance for answer in answers])
        normal = np.array([answer.normal for answer in answers]).reshape(position.shape)
        return distance, normal, np.array([answer.proven for answer in answers])

    def _settled(self, answer: Answer, rotation: Array, position: Array) -> Answer:
        """The answer, if the sets are apart, or the least depth at which they overlap.

        Parted along a normal n by s = |s| n, the sets have the distance bound(m) + m·s, m being
        the normal there: the largest such sum, so that bound(m) ≥ bound(n) + (n − m)·s, which is
        no less than bound(n). Repeated, this ends at a normal that is its own: a local maximum of
        the bound, as exact as distances of sets apart are.
        """
        if answer.distance > TOUCHING * self.size:
            return answer
        normal = best_normal(self.a, self.b, rotation, position, SEARCH_TOLERANCE_RAD)
        proven = float(self.proven(rotation, position, normal))
        for _ in range(MAX_PARTINGS):
            away = position + (PARTED * self.size - proven) * normal
            parted = self.apart(rotation[None], away[None])[0]
            before, normal = proven, parted.normal
            proven = float(self.proven(rotation, position, normal))
            if proven - before <= GAIN_TOLERANCE * self.size:
                break
        beyond = parted.point_a + proven * normal
        return replace(parted, distance=proven, normal=normal, point_b=beyond, proven=proven)
