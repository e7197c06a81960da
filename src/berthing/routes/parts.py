"""The parts of a phase where states put them, and the distances of those that are near."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.clearance.kernel import BY_A, BY_B, DISTANCE
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.routes.broad_phase import BroadPhase, Index
from berthing.routes.compiled_scene import CompiledScene
from berthing.routes.pair_query import FramesQuery
from berthing.routes.slots import Slots
from berthing.routes.space import Space
from berthing.scenario.pair import Pair
from berthing.scenario.structure import Structure
from berthing.verify.pair_motion import cross


@dataclass(frozen=True, eq=False)
class Placed:
    """Parts of vehicles at states (k, V, 7).

    Attributes:
        turn, place: of each moving part (k, s, 3, 3), (k, s, 3).
        centre: of their balls (k, s, 3).
        origin: of the vehicles' frames (k, V, 3), or states (k, V, 7) that begin with it.
    """

    turn: Array
    place: Array
    centre: Array
    origin: Array


@dataclass(frozen=True, eq=False)
class Found:
    """Distances (m,) of pairs that were near, with the state (m,) and the pair (m,) of each.

    Attributes:
        gradient: by a stride of all vehicles (m, V, 6); None where it was not asked for.
    """

    state: Index
    pair: Index
    distance: Array
    gradient: Array | None


class Parts:
    """Every part of the pairs given.

    Args:
        pairs: of one phase.
        vehicles: their names, in the order of the rows of a state.
        time_s: when structures are looked at.
    """

    def __init__(self, pairs: Sequence[Pair], vehicles: Sequence[str], time_s: float) -> None:
        slot: dict[str, int] = {}
        moving: list[tuple[Part, int, Pose]] = []
        resting: list[tuple[Part, int, Pose]] = []
        when = np.array([time_s])
        for pair in pairs:
            for ref, owner, part in (
                (pair.ref_a, pair.owner_a, pair.part_a), (pair.ref_b, pair.owner_b, pair.part_b),
            ):  # fmt: skip
                if ref in slot:
                    continue
                if isinstance(owner, Structure):
                    slot[ref] = len(resting)
                    resting.append((part, 0, owner.motion.pose(when)[0].compose(part.placement)))
                else:
                    slot[ref] = len(moving)
                    moving.append((part, vehicles.index(owner.name), part.placement))
        self._moving, self._resting = (
            Slots(*zip(*own, strict=True)) if own else Slots((), (), ())
            for own in (moving, resting)
        )
        self._a = np.array([slot[p.ref_a] for p in pairs], dtype=np.intp)
        self._b = np.array([slot[p.ref_b] for p in pairs], dtype=np.intp)
        self._b_rests = np.array([isinstance(p.owner_b, Structure) for p in pairs], dtype=np.bool_)
        self._queries = [FramesQuery(p.part_a.shape, p.part_b.shape) for p in pairs]
        self._broad = BroadPhase(self._resting.centre, self._resting.radius)
        # The pair of a moving and a resting part; −1 where they are none.
        self._table = np.full((len(moving), len(resting)), -1, dtype=np.intp)
        rests = self._b_rests
        self._table[self._a[rests], self._b[rests]] = np.flatnonzero(rests)
        self._mutual = np.flatnonzero(~rests)
        self._pairs = tuple(pairs)

    def compiled(self, space: Space, required_m: Array) -> CompiledScene | None:
        """With what each pair has to keep; None where that cannot be."""
        b = self._b + np.where(self._b_rests, len(self._moving.radius), 0)
        ends = np.stack([self._a, b], axis=1)
        return CompiledScene.of(space, self._pairs, required_m, self._moving, self._resting, ends)

    def place(self, states: Array) -> Placed:
        """At states (k, V, 7)."""
        turn = quaternion.rotation_matrix(states[..., 3:])
        origin, own = states[..., :3], self._moving
        turns, origins = turn[:, own.rows], origin[:, own.rows]
        return Placed(
            turns @ own.turn,
            origins + (turns @ own.place[:, :, None])[..., 0],
            origins + (turns @ own.centre[:, :, None])[..., 0],
            origin,
        )

    def near(self, placed: Placed, reach_m: float) -> tuple[Index, Index]:
        """States and pairs (m,) whose balls have a gap of ``reach_m`` at most, sorted by state."""
        count, slots = placed.centre.shape[:2]
        states, pairs = [np.empty(0, dtype=np.intp)], [np.empty(0, dtype=np.intp)]
        if len(self._resting.radius):
            reach = np.tile(reach_m + self._moving.radius, count)
            rows, balls = self._broad.near(placed.centre.reshape(-1, 3), reach)
            found = self._table[rows % slots, balls]
            states.append((rows // slots)[found >= 0])
            pairs.append(found[found >= 0])
        if len(self._mutual):
            a, b = self._a[self._mutual], self._b[self._mutual]
            away = np.linalg.norm(placed.centre[:, a] - placed.centre[:, b], axis=-1)
            radii = self._moving.radius
            rows, columns = np.nonzero(away <= reach_m + radii[a] + radii[b])
            states.append(rows)
            pairs.append(self._mutual[columns])
        every_state, every_pair = np.concatenate(states), np.concatenate(pairs)
        order = np.lexsort((every_pair, every_state))
        return every_state[order], every_pair[order]

    def found(self, placed: Placed, reach_m: float, *, gradients: bool = False) -> Found:
        """Distances of the pairs whose balls have a gap of ``reach_m`` at most."""
        state, pair = self.near(placed, reach_m)
        distance = np.empty(len(pair))
        whole = np.zeros((len(pair), placed.origin.shape[1], 6)) if gradients else None
        for i in np.unique(pair):
            here = np.flatnonzero(pair == i)
            rows = self._rows(placed, int(i), state[here])
            distance[here] = rows[:, DISTANCE]
            if whole is not None:
                self._add_gradients(whole, here, placed, int(i), state[here], rows)
        return Found(state, pair, distance, whole)

    def _rows(self, placed: Placed, pair: int, states: Index) -> Array:
        a, b = self._a[pair], self._b[pair]
        turn_a, place_a = placed.turn[states, a], placed.place[states, a]
        if self._b_rests[pair]:
            turn_b, place_b = self._resting.turn[b : b + 1], self._resting.place[b : b + 1]
        else:
            turn_b, place_b = placed.turn[states, b], placed.place[states, b]
        return self._queries[pair](turn_a, place_a, turn_b, place_b)

    def _add_gradients(
        self, whole: Array, here: Index, placed: Placed, pair: int, states: Index, rows: Array
    ) -> None:
        """From gradients about the parts' origins to those about the vehicles'."""
        ends = [(self._a[pair], BY_A)] + ([] if self._b_rests[pair] else [(self._b[pair], BY_B)])
        for slot, columns in ends:
            vehicle = self._moving.rows[slot]
            arm = placed.place[states, slot] - placed.origin[states, vehicle, :3]
            push, turn = rows[:, columns][:, :3], rows[:, columns][:, 3:]
            whole[here, vehicle] = np.concatenate([push, turn + cross(arm, push)], axis=1)
