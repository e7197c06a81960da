"""Vehicles that fill a box: convex ones, and unions that reach each of its sides."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from benchmarks.tight3d._motion import At
from benchmarks.tight3d._scene import Craft, about, part, rod
from support.documents import box


def _block(long: float, b: float, h: float) -> list[dict]:
    return [part("hull", box(long, b, h))]


def _tug(long: float, b: float, h: float) -> list[dict]:
    """A box in front of a tank."""
    tank = 0.6 * long
    return [
        part("bus", box(long - tank, b, h), (0.5 * tank, 0, 0)),
        part("tank", rod(0.45 * min(b, h), tank), (-0.5 * (long - tank), 0, 0)),
    ]


def _winged(long: float, b: float, h: float) -> list[dict]:
    """A body with a panel across it."""
    return [
        part("body", box(long, 0.5 * b, h)),
        part("panel", box(0.4 * long, b, 0.1), (-0.2 * long, 0, 0)),
    ]


def _masted(long: float, b: float, h: float) -> list[dict]:
    """A plate with a mast upright on it and a ball on top."""
    ball, plate = 0.15 * h, 0.2 * h
    return [
        part("plate", box(long, b, plate), (0, 0, 0.5 * (plate - h))),
        part("mast", rod(0.5 * ball, h - plate - ball, "z"), (0.2 * long, 0, 0.5 * (plate - ball))),
        part("head", {"type": "sphere", "radius_m": ball}, (0.2 * long, 0, 0.5 * h - ball)),
    ]


def _angle(long: float, b: float, h: float) -> list[dict]:
    """An L."""
    arm = 0.35 * min(long, h)
    return [
        part("foot", box(long, b, arm), (0, 0, 0.5 * (arm - h))),
        part("post", box(arm, b, h - arm), (0.5 * (arm - long), 0, 0.5 * arm)),
    ]


def _fork(long: float, b: float, h: float) -> list[dict]:
    """A U."""
    prong = 0.3 * b
    return [
        part("back", box(0.3 * long, b, h), (-0.35 * long, 0, 0)),
        part("left", box(0.7 * long, prong, h), (0.15 * long, 0.5 * (b - prong), 0)),
        part("right", box(0.7 * long, prong, h), (0.15 * long, -0.5 * (b - prong), 0)),
    ]


def _cross(long: float, b: float, h: float) -> list[dict]:
    """A cylinder with a beam across and a dish in front."""
    dish = 0.2 * long
    cone = rod(0.5 * min(b, h), dish, kind="cone")
    # Its base forward.
    front = At(np.array([0.5 * (long - dish), 0.0, 0.0]), about("y", np.pi))
    return [
        part("core", rod(0.25 * h, long - dish), (-0.5 * dish, 0, 0)),
        part("beam", box(0.15 * long, b, 0.3 * h), (-0.2 * long, 0, 0)),
        part("dish", cone, front),
    ]


FORMS: dict[str, Callable[[float, float, float], list[dict]]] = {
    "block": _block, "tug": _tug, "winged": _winged, "masted": _masted,
    "angle": _angle, "fork": _fork, "cross": _cross,
}  # fmt: skip

SIMPLE = ("block", "tug", "winged")
NOT_CONVEX = ("tug", "winged", "masted", "angle", "fork", "cross")


def craft(rng: np.random.Generator, size: Sequence[float], forms: Sequence[str]) -> Craft:
    """One of the forms, in a box of that size (3,)."""
    form = FORMS[forms[int(rng.integers(len(forms)))]]
    return Craft(form(*map(float, size)), np.asarray(size, dtype=float))
