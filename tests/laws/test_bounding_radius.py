"""The bounding radius covers the set and is attained."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet


def check_covers(shape: ConvexSet, x: Array) -> None:
    assert np.max(np.linalg.norm(x, axis=1)) <= shape.bounding_radius * (1.0 + 1e-12)


def check_tight(shape: ConvexSet, n: Array) -> None:
    reached = np.max(np.linalg.norm(shape.support(n)[1], axis=1))
    assert reached >= shape.bounding_radius * (1.0 - 1e-12)


def test_covers_every_member(shape: ConvexSet, members: Callable[[ConvexSet], Array]) -> None:
    check_covers(shape, members(shape))


def test_is_attained(shape: ConvexSet, directions: Callable[[int, int], Array]) -> None:
    check_tight(shape, directions(500, shape.dim))


@dataclass(frozen=True, eq=False)
class _Claims(ConvexSet):
    bounding_radius: float = 1.0
    dim: int = 3

    def support(self, n: Array) -> tuple[Array, Array]:
        return Box([1.0, 1.0, 1.0]).support(n)


def test_the_checks_notice_a_wrong_radius(directions: Callable[[int, int], Array]) -> None:
    n = directions(100, 3)
    with pytest.raises(AssertionError):
        check_covers(_Claims(1.7), _Claims(1.7).support(n)[1])
    with pytest.raises(AssertionError):
        check_tight(_Claims(1.8), n)
