"""Distances of sets apart that have conic forms: one small cone problem a pose, many at once."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from berthing.clearance.answer import Answer
from berthing.clearance.searched_pair import SearchedPair
from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.conic_algebra import Columns, joined
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import Standard, standard
from berthing.geometry.convex_set import ConvexSet, norm, unit


class ConicPair(SearchedPair):
    """min τ with ‖r + R y − x‖ ≤ τ, x in A and y in B, y in B's own frame.

    Only that cone depends on the pose. Its multiplier is (1, −n) with n the unit normal, and it is
    known more exactly than the difference of close points.

    Raises:
        CapabilityError: a set without a conic form.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        super().__init__(a, b)
        self._forms = _form(a), _form(b)

    def apart(self, rotation: Array, position: Array) -> list[Answer]:
        if not len(position):
            return []
        unit_m = max(self.size, float(np.max(norm(position))))
        objective = np.zeros((len(position), self._both.size))
        objective[:, -1] = 1.0
        found = minimise(self._placed(rotation, position, unit_m), objective)
        x, y = self._columns
        on_a = np.zeros(position.shape)
        on_a[:, : len(x)] = found.point[:, x]
        on_b = position + np.einsum("kij,kj->ki", rotation[:, :, : len(y)], found.point[:, y])
        normal = unit(-found.cone_dual[:, -1, 1 : 1 + self.dim])
        proven = self.proven(rotation, position, normal)
        distance = np.maximum(norm(on_b - on_a), proven)
        return [
            Answer(float(distance[i]), normal[i], on_a[i], on_b[i], float(proven[i]))
            for i in range(len(position))
        ]

    def _placed(self, rotation: Array, position: Array, unit_m: float) -> Standard:
        rows, (x, y) = self.dim + 1, self._columns
        G, h = np.zeros((len(position), rows, self._both.size)), np.zeros((len(position), rows))
        G[:, 0, -1] = -1.0
        G[:, 1:, x] = np.eye(self.dim)[:, : len(x)]
        G[:, 1:, y] = -rotation[:, :, : len(y)]
        h[:, 1:] = position / unit_m
        return standard(self._both, unit_m).with_cone(G, h)

    @cached_property
    def _both(self) -> ConicForm:
        return joined(self._forms, 0, 1)

    @cached_property
    def _columns(self) -> tuple[Columns, Columns]:
        """Of x and of y; a point has none, for it has nowhere to go."""
        form_a, form_b = self._forms
        return np.arange(form_a.dim), form_a.size + np.arange(form_b.dim)


def _form(shape: ConvexSet) -> ConicForm:
    if shape.bounding_radius == 0.0:
        return ConicForm(0, np.zeros((0, 0)), np.zeros(0), ())
    return conic_form(shape)
