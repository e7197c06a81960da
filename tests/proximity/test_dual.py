"""The dual form: what it starts from, that it proves no more than is there, and all of that."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from berthing.clearance.separation import PairQuery
from berthing.errors import CapabilityError
from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.proximity.dual import DualFormulation

ROUNDING = 1e-9

SOLVED = 2e-6
"""IPOPT at 1e-9 stops this near the corners of the feasible set; distances are of order one."""


def test_start_is_feasible_and_tight_where_the_sets_are_apart(pair, poses, rows_at) -> None:
    a, b = pair
    form, query = DualFormulation(a, b), PairQuery(a, b)
    distance = 1.2 * (a.bounding_radius + b.bounding_radius) + 0.1
    poses_a, poses_b = poses(2, a.dim, 0.1), poses(2, a.dim, distance)
    gaps, normals, _ = query.batch(poses_a, poses_b)
    starts = form.start(poses_a, poses_b, normals)
    assert starts.shape == (2, len(form.variables))
    assert np.all(starts >= form.variables.lower)
    for i in range(2):
        values, rows = rows_at(form, starts[i], poses_a[i], poses_b[i], 0.0)
        assert np.all(values >= rows.lower - ROUNDING)
        assert np.all(values <= rows.upper + ROUNDING)
        assert values[rows.separation] == pytest.approx(gaps[i], abs=1e-6 * distance)
        held, _ = rows_at(form, starts[i], poses_a[i], poses_b[i], gaps[i] + 0.01)
        assert held[rows.separation] < 0.0


def test_any_feasible_multipliers_understate(pair, rng, poses, rows_at) -> None:
    a, b = pair
    form = DualFormulation(a, b)
    pose_a, pose_b = poses(1, a.dim, 0.3)[0], poses(1, a.dim, 5.0)[0]
    distance = PairQuery(a, b).query(pose_a, pose_b).distance
    for n in rng.normal(size=(2, a.dim)):
        n = n / np.linalg.norm(n) * rng.uniform(0.1, 1.0)
        values, rows = rows_at(form, form.start(pose_a, pose_b, n), pose_a, pose_b, 0.0)
        assert np.all(values[1:] >= rows.lower[1:] - ROUNDING)
        assert values[rows.separation] <= max(distance, 0.0) + 1e-6


def test_multipliers_that_do_not_meet_are_infeasible(rows_at) -> None:
    form = DualFormulation(Box([1, 1, 1]), Box([1, 2, 1]))
    a, b = Pose.identity(3), Pose(np.array([4.0, 0, 0]), np.eye(3))
    v = form.start(a, b, np.array([1.0, 0, 0]))
    v[form.size_a] += 0.3
    values, rows = rows_at(form, v, a, b, 0.0)
    assert np.max(np.abs(values[2:5])) > 0.1
    assert np.all(rows.upper[2:5] == 0.0)
    longer, _ = rows_at(form, 1.1 * form.start(a, b, np.array([1.0, 0, 0])), a, b, 0.0)
    assert longer[1] < 0.0


def test_the_best_multipliers_give_the_distance(pair, poses, best_gap) -> None:
    a, b = pair
    form, query = DualFormulation(a, b), PairQuery(a, b)
    size = a.bounding_radius + b.bounding_radius
    pose_a, pose_b = poses(1, a.dim, 0.3)[0], poses(1, a.dim, 1.3 * size + 0.5)[0]
    way = pose_b.position - pose_a.position
    start = form.start(pose_a, pose_b, way / np.linalg.norm(way))
    # best_gap lets multipliers be negative; where they are bounded, bound them by rows.
    gap = best_gap(_Bounded(form), start, pose_a, pose_b)
    expected = query.query(pose_a, pose_b).distance
    assert gap == pytest.approx(expected, abs=SOLVED * (1.0 + size))


class _Bounded:
    """The same rows with the bounds of the variables among them."""

    def __init__(self, form: DualFormulation) -> None:
        self.form, self.variables = form, form.variables

    def rows(self, v, pose_a, pose_b, margin_m, length_m, eps=0.0):
        rows = self.form.rows(v, pose_a, pose_b, margin_m, length_m, eps)
        return replace(
            rows,
            expression=ca.vertcat(rows.expression, v),
            lower=np.concatenate([rows.lower, self.variables.lower]),
            upper=np.concatenate([rows.upper, self.variables.upper]),
        )


def test_what_it_cannot_take_is_told_apart() -> None:
    with pytest.raises(CapabilityError, match=r"`dual` cannot take Capsule.*`plane` or `kkt`"):
        DualFormulation(Capsule(0.2, 0.5), Sphere(1.0))
