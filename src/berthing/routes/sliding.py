"""Pushing a state out of what it is too near to, so that a search slides along things."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.compiled_scene import CompiledScene
from berthing.routes.space import between, moved, stride

ROUNDS = 8

# A state further in than this, in steps, is given up; a push aims beyond the pad by that share.
DEEP, BEYOND = 3.0, 0.4

# Singular values of the pushes below this share of the largest do not count.
RANK = 1e-3

# An extension ends when a step brings it nearer by less than this share of the step.
PROGRESS = 0.01
LONGEST = 400

# Of a leg that is looked at, to a step of the search. What they miss the certificate finds.
SAMPLES_A_STEP = 2.0


class Slider(Protocol):
    """Takes states and legs to where margins and pad are kept."""

    def keeps(self, states: Array) -> bool:
        """Whether all states (k, V, 7) keep limits, margins and pad."""

    def settled(self, x: Array) -> Array | None:
        """A state near ``x`` (V, 7) that keeps margins and pad; None where none was found."""

    def extended(self, x: Array, target: Array, *, whole: bool) -> tuple[Array, bool]:
        """States (n, V, 7) from x towards the target, each settled, as far as it goes.

        Args:
            whole: meet the target as it is: the end of a scenario may be nearer than the pad.

        Returns:
            The states without x, and whether the last one is the target as it is.
        """

    def blocked(self, a: Array, b: Array, *, lax: float = 0.0) -> float | None:
        """A fraction of the leg from a to b (V, 7) that lacks limits, margins or pad, by more than
        ``lax`` steps; None where none is found. The margins of its ends are not looked at."""


def slider(checker: Checker, pad_m: float, step_m: float) -> Slider:
    """By Newton steps of least length on what is too near; compiled where that can be.

    Args:
        checker: of the scenario.
        pad_m: kept beyond every margin.
        step_m: of the search.
    """
    if checker.compiled is not None:
        return CompiledSlider(checker.compiled, pad_m, step_m)
    return PlainSlider(checker, pad_m, step_m)


class CompiledSlider:
    """In native/slide.h and native/route_calls.h."""

    def __init__(self, scene: CompiledScene, pad_m: float, step_m: float) -> None:
        self._scene, self._pad_m, self._step_m = scene, pad_m, step_m
        self._how = np.array([float(ROUNDS), pad_m, DEEP * step_m, BEYOND, RANK])

    def keeps(self, states: Array) -> bool:
        return bool(np.all(self._scene.valid(states, self._pad_m)))

    def settled(self, x: Array) -> Array | None:
        return self._scene.settled(x, self._how)

    def extended(self, x: Array, target: Array, *, whole: bool) -> tuple[Array, bool]:
        step_m = self._step_m
        return self._scene.extended(
            x, target, step_m, PROGRESS * step_m, self._how, LONGEST, whole=whole
        )

    def blocked(self, a: Array, b: Array, *, lax: float = 0.0) -> float | None:
        step_m = self._step_m
        return self._scene.blocked(a, b, step_m / SAMPLES_A_STEP, self._pad_m - lax * step_m)


class PlainSlider:
    """Without a compiler, and for sets that the compiled distance does not know."""

    def __init__(self, checker: Checker, pad_m: float, step_m: float) -> None:
        self._checker, self._pad_m, self._step_m = checker, pad_m, step_m
        space = checker.space
        arms = np.where(space.arm_m > 0.0, space.arm_m, 1.0)
        # Turns by the metres that they move; components that there are not stay 0.
        self._scale = space.free / np.repeat(
            np.stack([np.ones_like(arms), arms], axis=1), 3, axis=1
        )

    def keeps(self, states: Array) -> bool:
        return bool(np.all(self._checker.valid_states(states, self._pad_m)))

    def settled(self, x: Array) -> Array | None:
        space = self._checker.space
        for _ in range(ROUNDS):
            short, slopes = self._checker.short_of(x, self._pad_m)
            if not len(short):
                return x if space.within(x) else None
            if np.max(short) > DEEP * self._step_m:
                return None
            J = slopes * self._scale
            wanted = short + BEYOND * self._pad_m
            by = np.linalg.lstsq(J.reshape(len(short), -1), wanted, rcond=RANK)[0]
            x = moved(x, by.reshape(self._scale.shape) * self._scale)
            x[:, :3] = np.clip(x[:, :3], space.lower_m, space.upper_m)
        return x if self._checker.valid_state(x, self._pad_m) else None

    def extended(self, x: Array, target: Array, *, whole: bool) -> tuple[Array, bool]:
        space, step_m = self._checker.space, self._step_m
        found: list[Array] = []
        way = stride(x, target)
        left = float(space.length(way))
        for _ in range(LONGEST):
            last = left <= step_m
            if last and whole:
                return np.array([*found, target]), True
            state = self.settled(target if last else moved(x, (step_m / left) * way))
            if state is None:
                break
            way = stride(state, target)
            ahead = float(space.length(way))
            if ahead > left - PROGRESS * step_m:
                break
            left, x = ahead, state
            found.append(state)
            if last:
                break
        return np.reshape(found, (-1, *target.shape)), False

    def blocked(self, a: Array, b: Array, *, lax: float = 0.0) -> float | None:
        space = self._checker.space
        if not space.within(np.stack([a, b])).all():
            return float(space.within(a))
        length = float(space.length(stride(a, b)))
        count = 2 + int(SAMPLES_A_STEP * length / self._step_m)
        where = np.linspace(0.0, 1.0, count)[1:-1]
        if not len(where):
            return None
        pad_m = self._pad_m - lax * self._step_m
        good = self._checker.valid_states(between(a, b, where), pad_m)
        return None if np.all(good) else float(where[np.argmin(good)])
