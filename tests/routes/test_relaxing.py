"""Paths made motions of little energy that keep clear."""

import numpy as np
import pytest

import berthing as bt
from berthing.routes.checker import Checker
from berthing.routes.relaxing import SPARE, WEIGHTS, Relaxing, straight_energy
from berthing.routes.second_differences import SecondDifferences
from support import hand_made

DURATION_S, MASS_KG, LENGTH_M = 20.0, 3.0, 6.0
MASSES = np.array([[MASS_KG] * 3 + [0.1] * 3])
END = bt.End(np.array([LENGTH_M, 0.0, 0.0]))


def checker(*structures):
    craft = hand_made.vehicle(bt.Box(np.array([0.3, 0.2, 0.2])), goal=END)
    return Checker(hand_made.scenario([craft], list(structures)))


def way(*positions):
    path = np.zeros((len(positions), 1, 7))
    path[:, 0, :3], path[:, 0, 3] = positions, 1.0
    return path


def relaxed(known, path):
    found = Relaxing.of(known.space, known.compiled, path, MASSES, DURATION_S)
    for weight in WEIGHTS:
        found.follow(weight)
    return found


DETOUR = way([0.0, 0.0, 0.0], [2.0, 2.0, 1.0], [LENGTH_M, 0.0, 0.0])


def test_with_nothing_in_the_way_it_is_the_motion_of_least_energy():
    found = relaxed(checker(), DETOUR)
    least = 12.0 * MASS_KG**2 * LENGTH_M**2 / DURATION_S**3
    assert straight_energy(DETOUR[0], DETOUR[-1], MASSES, DURATION_S) == pytest.approx(least)
    assert found.energy == pytest.approx(least, rel=2e-3)
    tau = np.linspace(0.0, 1.0, len(found.states))
    cubic = LENGTH_M * tau**2 * (3.0 - 2.0 * tau)
    assert found.states[:, 0, 0] == pytest.approx(cubic, abs=0.01 * LENGTH_M)


def test_around_a_thing_it_keeps_clear_on_the_side_of_its_path():
    ball = hand_made.structure(bt.Sphere(1.0), at=[hand_made.placed([3.0, 0.2, 0.0])])
    known = checker(ball)
    least = straight_energy(DETOUR[0], DETOUR[-1], MASSES, DURATION_S)
    costs = []
    for side in (1.0, -1.0):
        bent = way([0.0, 0.0, 0.0], [3.0, side * 2.2, 0.0], [LENGTH_M, 0.0, 0.0])
        found = relaxed(known, bent)
        assert np.array_equal(found.states[[0, -1]], bent[[0, -1]])
        size_m = known.space.arm_m[0]
        excess = [known.clearance_of(state).excess_m for state in found.states]
        assert -SPARE * size_m <= min(excess) < 0.1
        assert side * found.states[len(found.states) // 2, 0, 1] > 0.8
        costs.append(found.energy)
    # The far side of what lies aside is dearer.
    assert least < costs[1] < costs[0]


def test_a_path_that_touches_too_deeply_is_none():
    wall = hand_made.structure(bt.Box(np.ones(3)), at=[hand_made.placed([3.0, 0.0, 0.0])])
    known = checker(wall)
    straight = way([0.0, 0.0, 0.0], [LENGTH_M, 0.0, 0.0])
    assert Relaxing.of(known.space, known.compiled, straight, MASSES, DURATION_S) is None
    still = straight[[0, 0]]
    assert Relaxing.of(known.space, known.compiled, still, MASSES, DURATION_S) is None


def test_newton_steps_solve_what_is_quadratic():
    rng = np.random.default_rng(1)
    count, weights = 7, np.array([2.0, 0.5, 1.0])
    own = SecondDifferences(count, 0.3, weights)
    x, where = rng.normal(size=(count + 1, 3)), np.array([0, 2, 2, 5])
    slope, wanted = rng.normal(size=(4, 3)), rng.normal(size=4)

    def value(inner):
        whole = x.copy()
        whole[1:-1] += inner.reshape(-1, 3)
        left = np.sum(slope * whole[1:-1][where], axis=1) - wanted
        return own.energy(np.diff(whole, axis=0)) + 50.0 * left @ left

    left = np.sum(slope * x[1:-1][where], axis=1) - wanted
    step = own.newton(
        np.diff(x, axis=0), where, slope, 100.0 * left, np.full(4, 100.0), 0.0
    ).ravel()  # fmt: skip
    for axis in range(len(step)):
        to = 1e-3 * np.eye(len(step))[axis]
        assert value(step) < min(value(step + to), value(step - to))
