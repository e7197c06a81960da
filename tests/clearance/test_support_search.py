"""The search by support functions agrees with coal where coal is right."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.clearance.support_search import best_normal, sphere_samples
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

PAIRS = [
    (Box([1.0, 2.0, 0.5]), Cylinder(0.5, 1.5, "z")),
    (Ellipsoid([1.0, 2.0, 0.5]), Ellipsoid([0.5, 0.5, 1.0])),
    (Sphere(1.0), Sphere(0.5)),
    (Box([1.0, 2.0]), Polytope.from_vertices([[0.0, 0.0], [1.0, 0.2], [0.0, 1.5]])),
]


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("spread", [0.3, 4.0])
def test_finds_the_distance(pair: tuple[ConvexSet, ConvexSet], spread: float) -> None:
    rng = np.random.default_rng(12)
    dim = pair[0].dim
    home = Pose.identity(dim)
    for _ in range(4):
        position = spread * rng.normal(size=dim)
        there = (
            Pose.planar(position, rng.uniform(-3, 3))
            if dim == 2
            else Pose.from_quaternion(position, rng.normal(size=4))
        )
        n = best_normal(*pair, there.rotation, there.position)
        assert np.linalg.norm(n) == pytest.approx(1.0, abs=1e-14)
        found = float(plane_bound(pair[0], home, pair[1], there, n))
        assert found == pytest.approx(PairQuery(*pair).query(home, there).distance, abs=1e-6)


@pytest.mark.parametrize(("count", "dim", "reach_rad"), [(720, 2, 0.0045), (2000, 3, 0.08)])
def test_samples_leave_no_hole(count: int, dim: int, reach_rad: float) -> None:
    n = sphere_samples(count, dim)
    assert n.shape == (count, dim)
    np.testing.assert_allclose(np.linalg.norm(n, axis=1), 1.0, atol=1e-14)
    tried = np.random.default_rng(0).normal(size=(2000, dim))
    tried /= np.linalg.norm(tried, axis=1, keepdims=True)
    nearest = np.arccos(np.clip(np.max(tried @ n.T, axis=1), -1.0, 1.0))
    assert np.max(nearest) < reach_rad
    half = np.arccos(np.clip(np.max(tried @ n[: count // 2].T, axis=1), -1.0, 1.0))
    assert np.max(half) > reach_rad
