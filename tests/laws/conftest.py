"""The shapes and pairs that every law is tried on, and points and poses to try it at.

A law takes ``shape``, ``bounded`` (no half-spaces), ``conic`` (those with a conic form) or the two
of ``pair``; a new shape enters ``support.shapes`` and is under all of them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasMesh, HasVertices, level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from support.shapes import (
    BOUNDED,
    CONIC,
    QUICK_PAIRS,
    SEARCHED_PAIRS,
    SHAPES,
    SLOW_PAIRS,
    is_searched,
    size,
)

Pair = tuple[ConvexSet, ConvexSet]
GROUPS = {"shape": SHAPES, "bounded": BOUNDED, "conic": CONIC}
# Poses tried a pair: those that are searched for take up to seconds each where they overlap.
QUICK_COUNT, SEARCHED_COUNT = 12, 2


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    for name, shapes in GROUPS.items():
        if name in metafunc.fixturenames:
            metafunc.parametrize(name, shapes.values(), ids=shapes.keys())
    if "pair" in metafunc.fixturenames:
        slow = [pytest.param(*names, marks=pytest.mark.slow) for names in SLOW_PAIRS]
        chosen = [pytest.param(*names) for names in QUICK_PAIRS + SEARCHED_PAIRS]
        pairs = [
            pytest.param(tuple(SHAPES[n] for n in p.values), marks=p.marks, id="|".join(p.values))
            for p in chosen + slow
        ]
        metafunc.parametrize("pair", pairs)


@pytest.fixture
def count(pair: Pair) -> int:
    """Poses to try of this pair."""
    return SEARCHED_COUNT if is_searched(pair) else QUICK_COUNT


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
        tried = rng.uniform(-1, 1, size=(4000, shape.dim)) * size(shape)
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
