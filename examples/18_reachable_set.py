"""What can be reached from the start by certified motions, among poses that are sampled."""

from dataclasses import replace

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

import berthing as bt

SAMPLES, STRIDE_M, REACH_M, SEED = 700, 1.0, 2.0, 0
START, BERTH = [0.0, 0.0, np.pi / 2], [9.5, 0.0, 0.0]


def sampled(rng):
    """x, y and the turn about z: half of them anywhere, half nearly as in the berth."""
    wide = rng.uniform([-1.0, -2.0, 0.0], [10.0, 2.0, np.pi / 2], (SAMPLES, 3))
    narrow = rng.normal([0.0, 0.0, 0.0], [0.0, 0.06, 0.02], (SAMPLES, 3))
    narrow[:, 0] = rng.uniform(4.0, 10.0, SAMPLES)
    return np.vstack([START, BERTH, wide[::2], narrow[::2]])


def poses(rows):
    half, zero = 0.5 * rows[:, 2], np.zeros(len(rows))
    return np.stack([rows[:, 0], rows[:, 1], zero, np.cos(half), zero, zero, np.sin(half)], axis=1)


def reachable(scenario):
    """The samples (n, 3) that are valid, and whether each is reached (n,), the berth second."""
    checker = bt.Checker(scenario)
    rows = sampled(np.random.default_rng(SEED))
    rows = rows[checker.valid(poses(rows))]
    pairs = cKDTree(rows * [1.0, 1.0, REACH_M]).query_pairs(STRIDE_M, output_type="ndarray")
    legs = checker.motion(poses(rows[pairs[:, 0]]), poses(rows[pairs[:, 1]]))
    good = pairs[legs.excess_m >= 0.0]
    graph = coo_array((np.ones(len(good)), tuple(good.T)), shape=(len(rows), len(rows)))
    label = connected_components(graph, directed=False)[1]
    return rows, label == label[0], len(pairs)


if __name__ == "__main__":
    scenario = bt.load("scenario-b-tight")
    rows, reached, motions = reachable(scenario)
    assert reached[1]
    print(f"{motions} motions; {sum(reached)} of {len(rows)} samples are reached, certified")
    print(f"the berth is among them: {reached[1]}")
    margins = replace(scenario.margins, default_m=0.26)
    rows, reached, _ = reachable(replace(scenario, margins=margins))
    print(f"with a margin of 0.26 m the furthest is at x = {max(rows[reached, 0]):.1f} m")
