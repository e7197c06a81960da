"""The bounding radius covers the set and is attained."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from support.shapes import radius_slack

# Steps to the point farthest away; curved shapes approach it geometrically. Radii that are known to
# a thousandth need no more than the second.
CLIMBS, FEW_CLIMBS = 60, 10
COARSE = 1e-3


def check_covers(shape: ConvexSet, x: Array) -> None:
    assert np.max(np.linalg.norm(x, axis=1)) <= shape.bounding_radius * (1.0 + 1e-12)


def farthest(shape: ConvexSet, n: Array, climbs: int) -> float:
    """The greatest |x| of support points, each climbing on: the next direction is the last point.

    |x| cannot fall: x·y ≥ |x|² for the support point y in the direction x.
    """
    for _ in range(climbs):
        n = shape.support(n)[1]
    return float(np.max(np.linalg.norm(n, axis=1)))


def check_tight(shape: ConvexSet, n: Array, slack: float = 1e-12) -> None:
    climbs = CLIMBS if slack < COARSE else FEW_CLIMBS
    assert farthest(shape, n, climbs) >= shape.bounding_radius * (1.0 - slack)


def test_covers_every_member(shape: ConvexSet, members: Callable[[ConvexSet], Array]) -> None:
    check_covers(shape, members(shape))


def test_is_attained(bounded: ConvexSet, directions: Callable[[int, int], Array]) -> None:
    check_tight(bounded, directions(60, bounded.dim), radius_slack(bounded))


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
