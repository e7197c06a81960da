"""The distance as a conic program in closest points, for a solver of others (Clarabel)."""

from __future__ import annotations

from math import log
from typing import Any

import clarabel
import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid

TOLERANCE = 1e-11


class _Program:
    """Rows G z + s = h with s in cones, gathered one set after the other."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.rows: list[Array] = []
        self.right: list[Array] = []
        self.cones: list[Any] = []

    def add(self, cone: Any, parts: dict[int, Array], right: Array) -> None:
        """One cone: ``parts`` are blocks of columns by where they begin."""
        rows = np.zeros((len(right), self.size))
        for start, block in parts.items():
            rows[:, start : start + block.shape[1]] = block
        self.rows.append(rows)
        self.right.append(right)
        self.cones.append(cone)

    def least_last(self) -> float:
        """The smallest value of the last variable."""
        settings = clarabel.DefaultSettings()
        settings.verbose = False
        settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = TOLERANCE
        q = np.zeros(self.size)
        q[-1] = 1.0
        G, h = sparse.csc_matrix(np.vstack(self.rows)), np.concatenate(self.right)
        zero = sparse.csc_matrix((self.size, self.size))
        return float(clarabel.DefaultSolver(zero, q, G, h, self.cones, settings).solve().x[-1])


def conic_distance(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> float:
    """min τ, ‖p_b − p_a‖ ≤ τ, p_a in A and p_b in B."""
    d, size_a = a.dim, _size(a)
    program = _Program(size_a + _size(b) + 1)
    _include(program, a, 0)
    _include(program, b, size_a)
    first, second, length = (np.zeros((d + 1, k)) for k in (d, d, 1))
    first[1:], second[1:], length[0] = pose_a.rotation, -pose_b.rotation, -1.0
    parts = {0: first, size_a: second, program.size - 1: length}
    right = np.concatenate([[0.0], pose_b.position - pose_a.position])
    program.add(clarabel.SecondOrderConeT(d + 1), parts, right)
    return program.least_last()


def _size(shape: ConvexSet) -> int:
    if shape.bounding_radius == 0.0:
        return shape.dim
    if isinstance(shape, SmoothedPolytope):
        return shape.dim + len(shape.b)
    if isinstance(shape, Superellipsoid):
        return 2 * shape.dim
    return conic_form(shape).size


def _include(program: _Program, shape: ConvexSet, start: int) -> None:
    """Membership of the variables that begin at ``start``."""
    if shape.bounding_radius == 0.0:
        program.add(clarabel.ZeroConeT(shape.dim), {start: np.eye(shape.dim)}, np.zeros(shape.dim))
    elif isinstance(shape, SmoothedPolytope):
        _exponentials(program, shape, start)
    elif isinstance(shape, Superellipsoid):
        _powers(program, shape, start)
    else:
        _blocks(program, shape, start)


def _exponentials(program: _Program, shape: SmoothedPolytope, start: int) -> None:
    """Σ t ≤ 1 and exp(Q (a·x − b)) ≤ t for each row."""
    natural, count = log(shape.base) * shape.exponents, len(shape.b)
    terms = start + shape.dim
    program.add(clarabel.NonnegativeConeT(1), {terms: np.ones((1, count))}, np.ones(1))
    for j in range(count):
        power, term = np.zeros((3, shape.dim)), np.zeros((3, 1))
        power[0], term[2] = -natural[j] * shape.A[j], -1.0
        right = np.array([-natural[j] * shape.b[j], 1.0, 0.0])
        program.add(clarabel.ExponentialConeT(), {start: power, terms + j: term}, right)


def _powers(program: _Program, shape: Superellipsoid, start: int) -> None:
    """Σ t ≤ 1 and |x/r|^P ≤ t for each axis."""
    terms = start + shape.dim
    program.add(clarabel.NonnegativeConeT(1), {terms: np.ones((1, shape.dim))}, np.ones(1))
    for i in range(shape.dim):
        x, term = np.zeros((3, 1)), np.zeros((3, 1))
        x[2], term[0] = -1.0 / shape.reaches[i], -1.0
        cone = clarabel.PowerConeT(1.0 / float(shape.exponents[i]))
        program.add(cone, {start + i: x, terms + i: term}, np.array([0.0, 1.0, 0.0]))


def _blocks(program: _Program, shape: ConvexSet, start: int) -> None:
    """Lines and second-order cones of the set's conic form."""
    form = conic_form(shape)
    if len(form.linear_b):
        cone = clarabel.NonnegativeConeT(len(form.linear_b))
        program.add(cone, {start: form.linear_A}, form.linear_b)
    for block in form.blocks:
        slope = np.zeros((1, form.size)) if block.slope is None else -block.slope[None]
        rows = np.concatenate([slope, -block.A])
        right = np.concatenate([[block.head], block.b])
        program.add(clarabel.SecondOrderConeT(len(right)), {start: rows}, right)
