"""A path made a motion of little energy that keeps clear: what a guess is best begun from.

States at equal times along the path move together: Newton's method on the energy of their second
differences and a logarithmic barrier on what near pairs keep. (N. Ratliff and others move paths by
gradients of the like, CHOMP, 10.1109/ROBOT.2009.5152817; with the curvature of the barrier some
tens of steps do.) A barrier is not crossed, so that motions stay in the passage of their path.
Nothing is proven of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.routes.broad_phase import Index
from berthing.routes.compiled_scene import CompiledScene
from berthing.routes.second_differences import SecondDifferences
from berthing.routes.sliding import CompiledSlider
from berthing.routes.space import Space, along, moved, stride

# Lengths below are in reaches of the largest body.

# States are that far apart at a mean speed, but so many at least and at most.
APART, FEWEST, MOST = 0.3, 32, 80

# How far the barrier reaches, and how much less than its margin it lets a pair keep: paths that
# touch leave room for a step then, and what the last weight keeps of it is about as much.
REACH, SPARE = 0.12, 4e-3

# Weights of the barrier, the first of which tells how dear a passage is: the force by which a pair
# with ``SPARE`` is pushed, in energies a path.
WEIGHTS = (30.0, 6.0, 1.2)

# Newton steps a weight, at most; one that gains less than that share of the energy is the last.
STEPS, ENOUGH = 20, 2e-3

# A step goes that share of the way to where a pair has nothing left, and no state moves further
# than LONGEST. One that gains nothing is tried again with more damping, in terms of the energy's
# largest second derivative; after a step that was hardly cut short there is less of it.
TO_BOUNDARY, LONGEST, TRIES = 0.9, 1.0, 8
DAMPED, MORE, LESS, WHOLE = 1e-7, 10.0, 0.1, 0.5

# States in between those of a path are settled as by searches with steps so long.
STEP = 0.04

# Legs between states are looked at so finely, for things that they leap: those that lie deeper than
# a chord does in a turn.
LOOK, CHORD = 0.06, 0.08


@dataclass(frozen=True)
class Near:
    """Pairs near inner states: of each the state (m,), what is left to the barrier (m,), and how
    that grows by a stride (m, c), turns times the arm."""

    where: Index
    left: Array
    slope: Array


class Relaxing:
    """One path. ``of`` makes it.

    Attributes:
        states: (n + 1, V, 7), at equal times.
        energy: of the motion, ∫ |weights · acceleration|² dt.
    """

    def __init__(
        self, space: Space, scene: CompiledScene, states: Array, length_m: float, weights: Array,
        duration_s: float,
    ) -> None:  # fmt: skip
        self._space, self._scene = space, scene
        arms = np.where(space.arm_m > 0.0, space.arm_m, 1.0)
        # Turns by the metres that they move.
        self._scale = np.repeat(np.stack([np.ones_like(arms), arms], axis=1), 3, axis=1)
        self._size_m, self._length_m = float(np.max(arms)), length_m
        count = len(states) - 1
        whole = (weights / self._scale).ravel()
        self._band = SecondDifferences(count, duration_s / count, whole)
        self._damping = 0.0
        self.states = states
        self.energy = self._band.energy(self._differences(states))
        self._leaps = self._leaping(states)
        self._near = self._found = self._nearby(states)

    @staticmethod
    def of(
        space: Space, scene: CompiledScene, path: Array, weights: Array, duration_s: float
    ) -> Relaxing | None:
        """From a path (n + 1, V, 7); None where its states leave no room for a barrier.

        Args:
            weights: (V, 6), of an acceleration along a stride: masses and moments of inertia.
            duration_s: of the motion, at rest at both ends.
        """
        length_m = float(np.sum(space.length(stride(path[:-1], path[1:]))))
        if length_m == 0.0:
            return None
        size_m = float(np.max(space.arm_m)) or 1.0
        count = int(np.clip(length_m / (APART * size_m), FEWEST, MOST))
        tau = np.linspace(0.0, 1.0, count + 1)
        states = along(space, path, tau**2 * (3.0 - 2.0 * tau))
        slides = CompiledSlider(scene, 0.0, STEP * size_m)
        for i in range(1, count):
            # Legs of paths that are clear at samples may keep a little less.
            if not slides.keeps(states[i : i + 1]):
                settled = slides.settled(states[i])
                states[i] = states[i] if settled is None else settled
        found = Relaxing(space, scene, states, length_m, weights, duration_s)
        return None if found._near is None else found

    def follow(self, weight: float) -> None:
        """Take Newton steps with a weight of the barrier, until they bring little."""
        for _ in range(STEPS):
            gain = self._step(weight * SPARE * self._size_m / self._length_m * self.energy)
            if gain < ENOUGH * self.energy:
                break

    def _differences(self, states: Array) -> Array:
        way = stride(states[:-1], states[1:]) * self._scale
        return np.asarray(way.reshape(len(way), -1))

    def _nearby(self, states: Array) -> Near | None:
        """None where a pair has nothing left, or limits are not kept."""
        if not np.all(self._space.within(states)):
            return None
        spare_m = SPARE * self._size_m
        where, kept, slope = self._scene.near(states[1:-1], REACH * self._size_m - spare_m)
        left = kept + spare_m
        if np.any(left <= 0.0):
            return None
        return Near(where, left, slope.reshape(len(left), self._scale.size))

    def _leaping(self, states: Array) -> Flags:
        """Which legs between states lie in something deeper than a chord would."""
        step_m, deep_m = LOOK * self._size_m, CHORD * self._size_m
        found = [self._scene.blocked(a, b, step_m, -deep_m) for a, b in pairwise(states)]
        return np.array([at is not None for at in found])

    def _barrier(self, left: Array) -> float:
        """Of a pair −ln t + t − 1 for what is left in reaches t: 0 with its slope at the reach."""
        t = left / (REACH * self._size_m)
        return float(np.sum(t - 1.0 - np.log(t)))

    def _step(self, force: float) -> float:
        """Take a Newton step, and return what it gains: 0 where none gains anything."""
        near = self._near
        assert near is not None
        differences = self._differences(self.states)
        now = self._band.energy(differences) + force * self._barrier(near.left)
        first = force * (1.0 / (REACH * self._size_m) - 1.0 / near.left)
        second = force / near.left**2
        for _ in range(TRIES):
            by = self._band.newton(
                differences, near.where, near.slope, first, second, self._damping
            )
            share = self._share(by, near)
            there = self.states.copy()
            metres = by.reshape(len(by), *self._scale.shape) / self._scale
            there[1:-1] = moved(there[1:-1], share * metres)
            gain = now - self._value(there, force)
            if gain > 0.0 and not np.any((leaps := self._leaping(there)) & ~self._leaps):
                self._damping *= LESS if share > WHOLE else 1.0
                self.states, self._leaps, self._near = there, leaps, self._found
                self.energy = self._band.energy(self._differences(there))
                return gain
            self._damping = max(MORE * self._damping, DAMPED)
        return 0.0

    def _share(self, by: Array, near: Near) -> float:
        """Of the step that may be taken."""
        steps = by.reshape(len(by), *self._scale.shape)
        longest = float(np.max(np.linalg.norm(steps, axis=(1, 2)), initial=0.0))
        fall = -np.sum(near.slope * by[near.where], axis=1) / near.left
        steepest = float(np.max(fall, initial=0.0))
        return min(
            1.0,
            LONGEST * self._size_m / max(longest, 1e-300),
            TO_BOUNDARY / max(steepest, 1e-300),
        )

    def _value(self, states: Array, force: float) -> float:
        """Energy and barrier, infinite beyond it; what is near is kept for a step that is taken."""
        self._found = self._nearby(states)
        if self._found is None:
            return np.inf
        energy = self._band.energy(self._differences(states))
        return energy + force * self._barrier(self._found.left)


def straight_energy(start: Array, goal: Array, weights: Array, duration_s: float) -> float:
    """Of the straight motion from rest to rest between states (V, 7): 12 |weights · way|²/T³."""
    return 12.0 * float(np.sum((weights * stride(start, goal)) ** 2)) / duration_s**3
