"""How far apart a pair of parts must stay, and when."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from berthing.errors import InputError


@dataclass(frozen=True)
class MarginOverride:
    """An exception to the default margin.

    Attributes:
        a, b: selectors, ``owner`` or ``owner.part``, the latter with all pieces of a part from a
            mesh; their order does not matter.
        margin_m: the margin instead; None where the pair may touch.
        window_s: (from, to) on the scenario's clock, ends included; None for always.

    Raises:
        InputError: a negative margin, or a window that ends before it begins.
    """

    a: str
    b: str
    margin_m: float | None
    window_s: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        _check_margin("margin_m", self.margin_m)
        if self.window_s is not None and not self.window_s[0] < self.window_s[1]:
            raise InputError("window_s", f"is {list(self.window_s)}", "[from, to], from < to")

    def concerns(self, ref_a: str, ref_b: str) -> bool:
        """Whether it speaks of the pair of parts ``owner.part``."""
        direct = _selects(self.a, ref_a) and _selects(self.b, ref_b)
        return direct or (_selects(self.a, ref_b) and _selects(self.b, ref_a))

    def holds(self, t: float) -> bool:
        """Whether it applies at the time t."""
        return self.window_s is None or self.window_s[0] <= t <= self.window_s[1]


@dataclass(frozen=True)
class MarginPolicy:
    """One default and its exceptions; where several apply, the last one written wins.

    Attributes:
        default_m: the margin of every other pair.
        overrides: in the order of the file.

    Raises:
        InputError: a negative margin.
    """

    default_m: float
    overrides: tuple[MarginOverride, ...] = ()

    def __post_init__(self) -> None:
        _check_margin("default_m", self.default_m)

    def margin(self, ref_a: str, ref_b: str, t: float) -> float | None:
        """The margin in force between two parts ``owner.part`` at t; None: they may touch."""
        for override in reversed(self.overrides):
            if override.concerns(ref_a, ref_b) and override.holds(t):
                return override.margin_m
        return self.default_m

    def windows(
        self, ref_a: str, ref_b: str, span_s: tuple[float, float]
    ) -> list[tuple[float, float, float | None]]:
        """The span cut where the margin changes: (t0, t1, margin or None), contiguous, in order."""
        start, end = span_s
        concerning = [o.window_s for o in self.overrides if o.concerns(ref_a, ref_b)]
        edges = sorted({start, end, *_inside(concerning, start, end)})
        pieces: list[tuple[float, float, float | None]] = []
        for t0, t1 in pairwise(edges):
            margin = self.margin(ref_a, ref_b, 0.5 * (t0 + t1))
            if pieces and pieces[-1][2] == margin:
                t0 = pieces.pop()[0]
            pieces.append((t0, t1, margin))
        return pieces


def _inside(
    windows: Iterable[tuple[float, float] | None], start: float, end: float
) -> Iterable[float]:
    return (edge for w in windows if w is not None for edge in w if start < edge < end)


def _selects(selector: str, ref: str) -> bool:
    return ref == selector or ref.startswith(f"{selector}.")


def _check_margin(where: str, value: float | None) -> None:
    if value is not None and not 0.0 <= value < math.inf:
        raise InputError(where, f"is {value}", "0 or more, finite")
