"""Two trees of states, from start and goal, that slide along things towards each other.

Rapidly exploring trees as of J. Kuffner and S. LaValle (10.1109/ROBOT.2000.844730), but
a step that comes too near something is pushed out instead of refused, so that narrow passages are
found by what lines them.
"""

from __future__ import annotations

import time

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.region import Region
from berthing.routes.sliding import Slider
from berthing.routes.space import Space


class Tree:
    """States and the one that each came from; the first is the root."""

    def __init__(self, root: Array, arm_m: Array) -> None:
        self._states = np.empty((256, *root.shape))
        self._states[0] = root
        self._parent = [-1]
        self._arm = arm_m

    def __len__(self) -> int:
        return len(self._parent)

    def __getitem__(self, i: int) -> Array:
        return np.asarray(self._states[i])

    def add(self, state: Array, parent: int) -> int:
        """Its number."""
        if len(self) == len(self._states):
            self._states = np.concatenate([self._states, np.empty_like(self._states)])
        self._states[len(self)] = state
        self._parent.append(parent)
        return len(self) - 1

    def nearest(self, target: Array) -> int:
        """The state with the shortest stride to the target."""
        own = self._states[: len(self)]
        away = np.sum((own[..., :3] - target[:, :3]) ** 2, axis=-1)
        dots = np.abs(np.einsum("kvi,vi->kv", own[..., 3:], target[:, 3:]))
        turn = 2.0 * np.arccos(np.minimum(dots, 1.0))
        return int(np.argmin(np.sum(away + (self._arm * turn) ** 2, axis=-1)))

    def back_from(self, i: int) -> list[Array]:
        """The states from this one to the root."""
        found = []
        while i >= 0:
            found.append(self[i])
            i = self._parent[i]
        return found


class Trees:
    """One search, for one pad.

    Args:
        space: of the states.
        slider: settles them.
        region: where to look.
        rng: what is drawn.
        deadline: on the monotonic clock.
    """

    def __init__(
        self,
        space: Space,
        slider: Slider,
        region: Region,
        rng: np.random.Generator,
        deadline: float,
    ) -> None:
        self._space, self._slider, self._region, self._rng = space, slider, region, rng
        self._deadline = deadline

    def path(self, start: Array, goal: Array, rounds: int) -> Array | None:
        """States (n + 1, V, 7) from start to goal, a step apart or less; None where none was found.

        Every state but the two ends keeps the pad; what lies between them is not looked at.
        """
        one, other = Tree(start, self._space.arm_m), Tree(goal, self._space.arm_m)
        self._ends = start, goal
        for number in range(rounds):
            if time.monotonic() > self._deadline:
                return None
            drawn = number > 0
            target = self._drawn() if drawn else goal
            i, _ = self._extend(one, one.nearest(target), target, whole=not drawn)
            j, met = self._extend(other, other.nearest(one[i]), one[i], whole=True)
            if met:
                halves = one.back_from(i)[::-1], other.back_from(j)[1:]
                # The trees take turns: the first is the goal's in every second round.
                whole = [*halves[0], *halves[1]]
                return np.array(whole if number % 2 == 0 else whole[::-1])
            one, other = other, one
        return None

    def _drawn(self) -> Array:
        state = self._space.sample(self._rng, self._region.lower_m, self._region.upper_m)
        if np.isfinite(self._region.detour):
            self._gather(state)
        return state

    def _gather(self, state: Array) -> None:
        """Into the ellipsoid about each vehicle's ends that ways of no more length are in."""
        start, goal = self._ends
        for i, row in enumerate(state):
            way = goal[i, :3] - start[i, :3]
            half = 0.5 * float(np.linalg.norm(way))
            long = half + self._region.detour * (half + self._space.arm_m[i])
            point = self._rng.normal(size=3)
            point *= self._rng.random() ** (1.0 / 3.0) / np.linalg.norm(point)
            along = way / (2.0 * half) if half > 0.0 else np.zeros(3)
            wide = np.sqrt(long**2 - half**2)
            point = wide * point + (long - wide) * (along @ point) * along
            free = self._space.free[i, :3]
            row[:3] = np.where(free, 0.5 * (start[i, :3] + goal[i, :3]) + point, row[:3])
        state[:, :3] = np.clip(state[:, :3], self._space.lower_m, self._space.upper_m)

    def _extend(self, tree: Tree, i: int, target: Array, *, whole: bool) -> tuple[int, bool]:
        """Step towards the target, as far as it goes; the last state, and whether it was met."""
        states, met = self._slider.extended(tree[i], target, whole=whole)
        for state in states:
            i = tree.add(state, i)
        return i, met
