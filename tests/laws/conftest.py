"""The shapes that every law is tried on, by name.

A law takes ``shape`` or the two of ``pair``; a new shape enters here and is under all of them.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import HasMesh, HasVertices, level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

# A wedge away from its own origin, and a prism cut by a slanted plane.
WEDGE = [[1, 0, 0], [3, 0, 0], [1, 2, 0], [1, 0, 1], [3, 0, 0.5], [1, 2, 1]]
CUT_ROWS = [[1, 0, 0], [-1, 0, 0], [0, 2, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [1, 1, 1]]
CUT_OFFSETS = [1, 1, 1, 0.5, 0.7, 0.7, 1.2]
SPACE: dict[str, ConvexSet] = {
    "box": Box([2.0, 1.0, 0.5]),
    "plate": Box([2.0, 2.0, 0.01]),
    "ball": Sphere(0.8),
    "point": Sphere(0.0),
    "ellipsoid": Ellipsoid([1.0, 2.0, 0.5]),
    "needle": Ellipsoid([3.0, 0.1, 0.1]),
    "cylinder-x": Cylinder(1.0, 2.0),
    "cylinder-y": Cylinder(0.3, 1.0, "y"),
    "disc-z": Cylinder(1.5, 0.05, "z"),
    "wedge": Polytope.from_vertices(WEDGE),
    "cut-prism": Polytope(CUT_ROWS, CUT_OFFSETS),
}
PLANE: dict[str, ConvexSet] = {
    "rectangle": Box([2.0, 0.5]),
    "disc": Sphere(0.8, dim=2),
    "point-2d": Sphere(0.0, dim=2),
    "ellipse": Ellipsoid([1.0, 2.5]),
    "triangle": Polytope.from_vertices([[0.5, 0.0], [2.0, 0.3], [1.0, 1.5]]),
    "pentagon": Polytope([[1, 0], [0, 1], [-1, 0], [0, -1], [1, 1]], [1, 1, 1, 1, 1.5]),
}
SHAPES = SPACE | PLANE
PAIRS = [*product(SPACE, repeat=2), *product(PLANE, repeat=2)]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "shape" in metafunc.fixturenames:
        metafunc.parametrize("shape", SHAPES.values(), ids=SHAPES.keys())
    if "pair" in metafunc.fixturenames:
        pairs = [(SHAPES[a], SHAPES[b]) for a, b in PAIRS]
        metafunc.parametrize("pair", pairs, ids=[f"{a}|{b}" for a, b in PAIRS])


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240607)


@pytest.fixture
def directions(rng: np.random.Generator) -> Callable[[int, int], Array]:
    """(count, dim): random directions of random lengths, the axes among them."""

    def draw(count: int, dim: int) -> Array:
        axes = np.concatenate([np.eye(dim), -np.eye(dim)])
        lengths = 10.0 ** rng.uniform(-2, 2, size=(count, 1))
        return np.concatenate([axes, lengths * rng.normal(size=(count, dim))])

    return draw


@pytest.fixture
def members(rng: np.random.Generator) -> Callable[[ConvexSet], Array]:
    """Points of a set, found without its support function: by its level, mesh and vertices."""

    def draw(shape: ConvexSet) -> Array:
        tried = rng.uniform(-1, 1, size=(4000, shape.dim)) * shape.bounding_radius
        found = [tried[level(shape, tried) <= 0.0]]
        if isinstance(shape, HasMesh):
            found.append(shape.mesh().vertices[:, : shape.dim])
        if isinstance(shape, HasVertices):
            found.append(shape.vertices())
        return np.concatenate(found)

    return draw


@pytest.fixture
def poses(rng: np.random.Generator) -> Callable[[int, int, float], Pose]:
    """A batch of random poses of the dimension asked, positions within ``spread``."""

    def draw(count: int, dim: int, spread: float) -> Pose:
        position = rng.uniform(-spread, spread, size=(count, dim))
        if dim == 2:
            return Pose.planar(position, rng.uniform(-np.pi, np.pi, size=count))
        return Pose.from_quaternion(position, quaternion.normalise(rng.normal(size=(count, 4))))

    return draw
