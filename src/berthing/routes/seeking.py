"""Paths from start to goal that are clear at samples: searches one after the other."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.region import Region
from berthing.routes.shorten import TRIES, shortened
from berthing.routes.sliding import Slider, slider
from berthing.routes.trees import Trees

# Searches, by what they keep beyond margins (an index of ``Region.pads_m``), the share of a whole
# step, and rounds: a passage that a wide pad closes is soon looked for with a narrow one, short
# steps do not leap through what is thin, and patience comes last.
LADDER = (
    (0, 1.0, 400), (1, 1.0, 400), (2, 1.0, 400),
    (0, 0.25, 400), (0, 1.0, 4000), (1, 0.5, 4000), (2, 0.25, 4000),
)  # fmt: skip

# Where the detour is limited: passages near the straight way are found soon, or there are none.
SHORT_LADDER = ((0, 1.0, 60),)


@dataclass(frozen=True)
class Found:
    """What one search came to.

    Attributes:
        pad_m: kept beyond margins. step_m: its steps. rounds: at most.
        paths: states (n + 1, V, 7): first the path made shorter, then as it was found; none where
            there is none.
        slides: what settled its states.
    """

    pad_m: float
    step_m: float
    rounds: int
    paths: tuple[Array, ...]
    slides: Slider


class Seeker:
    """Of one start and one goal.

    Args:
        checker: of the scenario, at rest.
        start, goal: valid states (V, 7).
        shortcuts: that are tried on a path: fewer of them leave it longer, sooner.
    """

    def __init__(self, checker: Checker, start: Array, goal: Array, shortcuts: int = TRIES) -> None:
        self.checker = checker
        self._start, self._goal, self._shortcuts = start, goal, shortcuts
        self._region = Region.of(checker, start, goal)

    @property
    def pads_m(self) -> tuple[float, ...]:
        return self._region.pads_m

    def searches(
        self, seed: int, number: int, deadline: float, detour: float = np.inf
    ) -> Iterator[Found]:
        """Each is made when it is asked for, until time is up.

        Args:
            number: of the route that is looked for; others of the same seed are drawn otherwise.
            deadline: on the monotonic clock.
            detour: that is allowed, as of a ``Region``; what is soon found where there is one.
        """
        ladder = LADDER if np.isinf(detour) else SHORT_LADDER
        for rung, (pad, share, rounds) in enumerate(ladder):
            rng = np.random.default_rng([seed, number, rung])
            region = replace(self._region, step_m=share * self._region.step_m, detour=detour)
            yield self._search(region.pads_m[pad], region, rounds, rng, deadline)
            if time.monotonic() > deadline:
                break

    def _search(
        self, pad_m: float, region: Region, rounds: int, rng: np.random.Generator, deadline: float
    ) -> Found:
        space = self.checker.space
        slides = slider(self.checker, pad_m, region.step_m)
        path = Trees(space, slides, region, rng, deadline).path(self._start, self._goal, rounds)
        paths = () if path is None else (shortened(space, slides, path, rng, self._shortcuts), path)
        return Found(pad_m, region.step_m, rounds, paths, slides)
