"""Balls and ellipsoids that hold a set."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.enclosing import enclosing_ball, enclosing_ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.sphere import Sphere

FAR = [[5, 0, 0], [7, 0, 0], [5, 2, 0], [5, 0, 1], [7, 0, 0.5], [5, 2, 1]]
SHAPES = {
    "box": Box([2.0, 1.0, 0.5]),
    "rectangle": Box([2.0, 0.5]),
    "ball": Sphere(0.8),
    "ellipsoid": Ellipsoid([1.0, 2.0, 0.5]),
    "cylinder": Cylinder(1.0, 2.0, "z"),
    "capsule": Capsule(0.3, 1.0),
    "wedge": Polytope.from_vertices(FAR),
}

ROUNDING = 1e-9


@pytest.mark.parametrize("enclose", [enclosing_ball, enclosing_ellipsoid])
@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES.keys())
def test_nothing_sticks_out(enclose, shape) -> None:
    held = enclose(shape)
    n = np.random.default_rng(1).normal(size=(2000, shape.dim))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    outer = held.shape.support(held.placement.unrotate(n))[0] + n @ held.placement.position
    assert np.min(outer - shape.support(n)[0]) >= -ROUNDING


def volume(shape: Ellipsoid) -> float:
    return float(np.prod(shape.semi_axes))


@pytest.mark.parametrize("shape", [SHAPES["box"], SHAPES["rectangle"]], ids=["box", "rectangle"])
def test_that_of_a_box_is_the_least(shape) -> None:
    held = enclosing_ellipsoid(shape).shape
    least = np.prod(np.sqrt(shape.dim) * shape.half_extents)
    assert volume(held) == pytest.approx(least, rel=1e-5)


def test_that_of_a_cylinder_is_the_least() -> None:
    shape = Cylinder(1.3, 0.4)
    held = volume(enclosing_ellipsoid(shape).shape)
    for share in np.linspace(0.05, 0.95, 181):
        # a² = h²/share and b² = r²/(1 − share) touch the rims too.
        assert held <= 0.4 / share**0.5 * 1.3**2 / (1.0 - share) * (1.0 + ROUNDING * 10)


def test_that_of_a_polytope_is_smaller_than_a_slightly_smaller_one_would_be() -> None:
    points = np.array(FAR, dtype=float)
    held = enclosing_ellipsoid(Polytope.from_vertices(FAR))
    local = held.placement.unrotate(points - held.placement.position) / held.shape.semi_axes
    reach = np.linalg.norm(local, axis=1)
    assert np.max(reach) <= 1.0
    # Of the least ellipsoid, points that touch balance: Σ w p = 0 and Σ w p pᵀ = I/d.
    touching = local[reach > 1.0 - 1e-3]
    rows = [np.append(np.outer(p, p)[np.triu_indices(3)], p) for p in touching]
    from scipy.optimize import nnls

    target = np.append(np.eye(3)[np.triu_indices(3)] / 3.0, np.zeros(3))
    _, residual = nnls(np.array(rows).T, target)
    assert residual < 5e-3


def test_a_ball_around_a_ball_is_itself() -> None:
    assert enclosing_ball(Sphere(0.8)).shape.radius == pytest.approx(0.8)
    assert enclosing_ball(Box([2.0, 1.0, 1.0])).shape.radius == pytest.approx(np.sqrt(6.0))
