"""Which answers step through things."""

from __future__ import annotations

import numpy as np

from berthing.refine.astray import ASTRAY, astray
from berthing.refine.sampling import SampledClearance
from support.documents import box, puck, scenario, structure

GIVEN = scenario(puck(), structures=[structure("square", [3, 0], box(1.4, 1.4))])
(PAIR,) = GIVEN.pairs(GIVEN.phases[0])
# Of the puck, which is the smaller of the two.
RADIUS_M = 0.5


def sampled(*distances_m: float, margin_m: float = 0.1) -> SampledClearance:
    distances = np.array([distances_m])
    return SampledClearance(np.arange(3.0), distances, np.full_like(distances, margin_m))


def test_a_deep_overlap_is_astray_and_a_shallow_one_is_not() -> None:
    assert astray([PAIR], sampled(1.0, -1.1 * ASTRAY * RADIUS_M, 1.0))
    assert not astray([PAIR], sampled(1.0, -0.9 * ASTRAY * RADIUS_M, 1.0))
    assert not astray([], SampledClearance(np.arange(3.0), np.empty((0, 3)), np.empty((0, 3))))


def test_pairs_that_may_touch_are_not_astray() -> None:
    assert not astray([PAIR], sampled(1.0, -0.4, 1.0, margin_m=np.nan))
