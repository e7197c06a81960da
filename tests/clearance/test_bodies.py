"""The clearance of bodies is that of their closest parts, however many are culled."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from berthing.clearance import bodies as module
from berthing.clearance.bodies import clearance
from berthing.clearance.separation import Separation, separation
from berthing.errors import InputError
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

RNG = np.random.default_rng(21)


def at(*position: float) -> Pose:
    return Pose(np.array(position), np.eye(len(position)))


def any_pose(spread: float) -> Pose:
    return Pose.from_quaternion(spread * RNG.normal(size=3), RNG.normal(size=4))


SHIP = Body(
    (
        Part("hull", Box([2.0, 1.0, 1.0]), at(0.0, 0.0, 0.0)),
        Part("boom", Cylinder(0.1, 2.0), any_pose(2.0)),
        Part("dish", Sphere(0.7), any_pose(2.0)),
    )
)
TRUSS = Body(tuple(Part(f"bay{i}", Box([0.5, 0.4, 0.3]), any_pose(4.0)) for i in range(6)))


@pytest.mark.parametrize("spread", [2.0, 8.0, 30.0])
def test_is_the_smallest_over_all_pairs(spread: float) -> None:
    for _ in range(10):
        here, there = any_pose(spread), any_pose(spread)
        found, part_a, part_b = clearance(SHIP, here, TRUSS, there)
        every = {
            (a.name, b.name): separation(
                a.shape, here.compose(a.placement), b.shape, there.compose(b.placement)
            ).distance
            for a, b in product(SHIP.parts, TRUSS.parts)
        }
        assert found.distance == min(every.values())
        assert every[part_a.name, part_b.name] == found.distance


def test_asks_only_the_pairs_that_may_be_closest(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def counted(*arguments: Any) -> Separation:
        asked.append(arguments)
        return separation(*arguments)

    monkeypatch.setattr(module, "separation", counted)
    row = Body(tuple(Part(f"p{i}", Sphere(0.5), at(3.0 * i, 0.0, 0.0)) for i in range(20)))
    found, _, part = clearance(Body((row.parts[0],)), at(0.0, 2.0, 0.0), row, at(0.0, 0.0, 0.0))
    assert (part.name, found.distance) == ("p0", 1.0)
    assert len(asked) == 1


def test_bad_input_is_refused() -> None:
    flat = Body((Part("disc", Sphere(1.0, dim=2), at(0.0, 0.0)),))
    with pytest.raises(InputError, match="clearance: of 3 and 2 dimensions"):
        clearance(SHIP, at(0.0, 0.0, 0.0), flat, at(0.0, 0.0))
    with pytest.raises(InputError, match="clearance: was given a batch"):
        clearance(SHIP, Pose(np.zeros((2, 3)), np.eye(3)), TRUSS, at(0.0, 0.0, 0.0))
    with pytest.raises(InputError, match=r"Pose.compose: joins 2 with 3"):
        clearance(SHIP, at(0.0, 0.0), TRUSS, at(0.0, 0.0, 0.0))
