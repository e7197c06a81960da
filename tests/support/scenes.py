"""Scenes of many things about vehicles, states of these, and how near the things are."""

from __future__ import annotations

import numpy as np

import berthing as bt
from support import hand_made


def states(checker, count, seed=0):
    rng = np.random.default_rng(seed)
    low, high = np.full(3, -6.0), np.full(3, 16.0)
    return np.array([checker.space.sample(rng, low, high) for _ in range(count)])


def least_excess(checker, state):
    """Over all pairs, each asked by itself at objects that are made anew."""
    frames = {
        own.name: bt.Pose.from_quaternion(row[:3], row[3:])
        for own, row in zip(checker.vehicles, state, strict=True)
    }
    found = []
    for pair, margin in zip(checker.pairs, checker.margins_m, strict=True):
        placed = []
        for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b)):
            frame = frames.get(owner.name)
            if frame is None:
                frame = owner.motion.pose(np.zeros(1))[0]
            placed.append(frame.compose(part.placement))
        apart = bt.distance(pair.part_a.shape, pair.part_b.shape, tuple(placed)).distance
        found.append(float(apart) - margin)
    return min(found)


def clutter(count, vehicles=1):
    """Boxes of very different sizes about the origin; more pairs than are asked without a tree."""
    rng = np.random.default_rng(3)
    sizes = 10.0 ** rng.uniform(-2.0, 0.3, (count, 1))
    at = [hand_made.placed(rng.uniform(-6.0, 16.0, 3)) for _ in range(count)]
    wall = hand_made.structure(*(bt.Box(s * np.ones(3)) for s in sizes), at=at)
    crew = [
        hand_made.vehicle(bt.Box(np.array([2.0, 0.5, 0.5])), bt.Sphere(0.4), name=f"craft{i}",
                          at=[hand_made.placed(), hand_made.placed([0.0, 1.0, 0.0])])
        for i in range(vehicles)
    ]  # fmt: skip
    return hand_made.scenario(crew, [wall])
