"""One state at a time, as planners ask: buffers made once, in place of arrays made anew."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from berthing.clearance.kernel import DISTANCE, WIDTH
from berthing.geometry.arrays import Array
from berthing.routes.pair_query import FramesQuery
from berthing.routes.slots import Slots


class OneState:
    """Parts of vehicles at the state that was placed last, and distances there.

    Args:
        moving: parts of vehicles, by row of the state.
        resting: parts of structures.
        pairs: slots of both parts, and whether the second rests.
    """

    def __init__(
        self,
        moving: Slots,
        resting: Slots,
        pairs: Sequence[tuple[int, int, bool]],
        queries: Sequence[FramesQuery],
    ) -> None:
        self._moving = moving
        self.turn, self.place = np.empty_like(moving.turn), np.empty_like(moving.place)
        self.rows = np.zeros((len(queries), WIDTH))
        self._frames = np.empty((int(np.max(moving.rows, initial=0)) + 1, 3, 3))
        self._ask = [
            queries[i].at(
                self.turn[a], self.place[a],
                resting.turn[b] if rests else self.turn[b],
                resting.place[b] if rests else self.place[b],
                self.rows[i],
            )
            for i, (a, b, rests) in enumerate(pairs)
        ]  # fmt: skip

    def put(self, state: Array) -> None:
        """Place the parts at the state (V, 7), its quaternions of unit length."""
        frames, own = self._frames, self._moving
        for i, (_, _, _, w, x, y, z) in enumerate(state.tolist()):
            frames[i] = (
                (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
                (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
                (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
            )
        turns = frames[own.rows]
        np.matmul(turns, own.turn, out=self.turn)
        np.add(state[own.rows, :3], (turns @ own.place[:, :, None])[..., 0], out=self.place)

    def distance(self, pair: int) -> float:
        """Of the pair, where its parts are; its other numbers are in ``rows``."""
        self._ask[pair]()
        return float(self.rows[pair, DISTANCE])

    def clear(self, pairs: Iterable[int], required_m: Sequence[float]) -> bool:
        """Whether every one of the pairs keeps what is required of it, by number of the pair."""
        return all(self.distance(i) >= required_m[i] for i in pairs)
