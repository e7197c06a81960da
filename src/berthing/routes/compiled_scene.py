"""All pairs of a phase in compiled code: a whole batch, extension or leg in one call."""

from __future__ import annotations

import ctypes
import weakref
from collections.abc import Sequence

import numpy as np

from berthing.clearance.kernel import library
from berthing.clearance.set_numbers import set_numbers
from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.routes.broad_phase import Index
from berthing.routes.pair_query import APART_M, OVERLAP_M
from berthing.routes.slots import Slots
from berthing.routes.space import Space
from berthing.scenario.pair import Pair

# Pairs near a state, for which there is room at first.
NEAR = 16


class CompiledScene:
    """Not for two threads at a time. ``of`` makes it where that can be.

    Args:
        handle: of native/route_calls.h.
        keep: what the handle points to.
    """

    def __init__(self, handle: int, keep: object) -> None:
        found = library()
        assert found is not None
        self._calls, self._handle, self._keep = found, handle, keep
        weakref.finalize(self, found.berthing_scene_free, handle)

    @staticmethod
    def of(
        space: Space, pairs: Sequence[Pair], required_m: Array, moving: Slots, resting: Slots,
        ends: Index,
    ) -> CompiledScene | None:  # fmt: skip
        """None without a compiler, or where it does not know a set.

        Args:
            ends: slots (n, 2) of the pairs' parts; those that rest follow those that move.
        """
        sets = [[set_numbers(part.shape) for part in (p.part_a, p.part_b)] for p in pairs]
        calls = library()
        if calls is None or any(one is None for both in sets for one in both):
            return None
        addresses = [one.ctypes.data for both in sets for one in both if one is not None]
        owner = np.concatenate([moving.rows, np.full(len(resting.rows), -1)])
        of_vehicles = (space.free, space.arm_m, space.lower_m, space.upper_m)
        given = (
            np.array(owner, dtype=ctypes.c_long),
            np.concatenate([_numbers(moving), _numbers(resting)]),
            np.array(ends, dtype=ctypes.c_long, order="C"),
            np.array(addresses, dtype=np.uintp),
            np.array(required_m, dtype=np.float64),
            np.concatenate([np.ravel(x).astype(np.float64) for x in of_vehicles]),
        )
        handle = calls.berthing_scene_new(
            len(space.arm_m), len(owner), len(pairs), pairs[0].part_a.shape.dim if pairs else 3,
            *(array.ctypes.data for array in given), APART_M, OVERLAP_M,
        )  # fmt: skip
        if not handle:
            raise MemoryError("no memory for the parts of a scene")
        return CompiledScene(handle, sets)

    def valid(self, states: Array, pad_m: float) -> Flags:
        """Which states (k, V, 7) keep limits, margins and pad."""
        states = np.ascontiguousarray(states)
        good = np.empty(len(states), dtype=np.bool_)
        self._calls.berthing_scene_valid(
            self._handle, len(states), states.ctypes.data, pad_m, good.ctypes.data
        )
        return good

    def settled(self, x: Array, how: Array) -> Array | None:
        """``how`` (5,): see native/slide.h."""
        x = np.array(x)
        found = self._calls.berthing_scene_settle(self._handle, x.ctypes.data, how.ctypes.data)
        return x if found else None

    def extended(
        self, x: Array, target: Array, step_m: float, progress_m: float, how: Array, most: int,
        *, whole: bool,
    ) -> tuple[Array, bool]:  # fmt: skip
        """States (n, V, 7) from x towards the target, and whether it was met as it is."""
        out, met = np.empty((most, *x.shape)), ctypes.c_int()
        x, target = np.ascontiguousarray(x), np.ascontiguousarray(target)
        count = self._calls.berthing_scene_extend(
            self._handle, x.ctypes.data, target.ctypes.data, step_m, progress_m, whole,
            how.ctypes.data, most, out.ctypes.data, ctypes.addressof(met),
        )  # fmt: skip
        return out[:count], bool(met.value)

    def near(self, states: Array, reach_m: float) -> tuple[Index, Array, Array]:
        """Of the pairs that keep less than ``reach_m`` beyond their margins at states (k, V, 7).

        Returns:
            The states (m,) in rising order, what is kept (m,), and its gradient (m, V, 6) by a
            stride whose turns are times the arm.
        """
        states = np.ascontiguousarray(states)
        most = NEAR * len(states)
        while True:
            where, slack = np.empty(most, dtype=ctypes.c_long), np.empty(most)
            gradient = np.empty((most, states.shape[1], 6))
            count = self._calls.berthing_scene_near(
                self._handle, len(states), states.ctypes.data, reach_m, most,
                where.ctypes.data, slack.ctypes.data, gradient.ctypes.data,
            )  # fmt: skip
            if count <= most:
                return where[:count].astype(np.intp), slack[:count], gradient[:count]
            most = count

    def blocked(self, a: Array, b: Array, step_m: float, pad_m: float) -> float | None:
        """A fraction of the leg from a to b (V, 7) that lacks limits, margins or pad."""
        a, b = np.ascontiguousarray(a), np.ascontiguousarray(b)
        found = self._calls.berthing_scene_blocked(
            self._handle, a.ctypes.data, b.ctypes.data, step_m, pad_m
        )
        return float(found) if found <= 1.0 else None


def _numbers(own: Slots) -> Array:
    """(n, 16): rotations, places, centres and radii of their balls."""
    turns = own.turn.reshape(-1, 9)
    return np.concatenate([turns, own.place, own.centre, own.radius[:, None]], axis=1)
