"""The three cases whose time is promised: Scenario A, thirty parts, and a long slide."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from berthing.geometry.box import Box
from berthing.planner import plan
from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.certificate import Certificate, certify
from berthing.verify.claims import claims_of
from berthing.verify.recheck import check_claims
from berthing.verify.replay import replay
from berthing.verify.tube import Tube, tubes_of
from support import hand_made

PARTS = 15


@dataclass(frozen=True)
class Timed:
    """A certificate to be found and checked again."""

    name: str
    promised_ms: float
    search: Callable[[], Certificate]
    check: Callable[[], Certificate]
    pairs: int
    intervals: int
    verdicts: str


def timed_cases() -> list[Timed]:
    return [
        timed("scenario-a", 25.0, *scenario_a()),
        timed("two vehicles of 15 parts each", 1000.0, *thirty_parts()),
        timed("60 s within 1e-4 m of the margin", 200.0, *slide()),
    ]


def timed(
    name: str, promised_ms: float, whole: Scenario, flown: PhaseTrajectory, tubes: dict[str, Tube]
) -> Timed:
    """With the verdicts counted, which the check must share."""
    phase = whole.phases[0]

    def search() -> Certificate:
        return certify(whole, phase, flown, tubes=tubes)

    found = search()
    claims = claims_of([found], "").phase(phase.name)

    def check() -> Certificate:
        return check_claims(whole, phase, flown, claims, tubes)

    said, again = (Counter(v.verdict for v in c.verdicts) for c in (found, check()))
    assert said == again, (said, again)
    intervals = sum(len(e.leaves.pair) for e in found.evidence)
    words = ", ".join(f"{count} {word}" for word, count in said.items())
    return Timed(name, promised_ms, search, check, len(found.verdicts), intervals, words)


def scenario_a() -> tuple[Scenario, PhaseTrajectory, dict[str, Tube]]:
    """As planned, with the tube of its replay."""
    whole = load("scenario-a")
    made = plan(whole).plan
    assert made is not None
    (phase,), (flown,) = whole.phases, made.phases
    tubes = tubes_of(replay(phase.vehicle(own.vehicle).model, own) for own in flown.vehicles)
    return whole, flown, tubes


def thirty_parts() -> tuple[Scenario, PhaseTrajectory, dict[str, Tube]]:
    """Two turning rows of boxes pass each other, the nearest two 3 mm beyond the margin."""
    rng = np.random.default_rng(5)
    vehicles, flown = [], []
    for name, side in (("one", 1.0), ("other", -1.0)):
        shapes = [Box(rng.uniform(0.1, 0.4, 3)) for _ in range(PARTS)]
        at = [hand_made.placed([1.0 * (i - PARTS // 2), 0, 0]) for i in range(PARTS)]
        own = hand_made.vehicle(*shapes, name=name, at=at)

        def position(t: np.ndarray, side: float = side) -> np.ndarray:
            return np.stack([side * (0.1 * t - 3.0), side * (0.5 + 0.0 * t), 0.0 * t], axis=1)

        roll = hand_made.turn_about([1, 0, 0], lambda t, side=side: 0.02 * side * t)
        flown.append(hand_made.path(own, position, roll, duration_s=60.0, segments=20))
        vehicles.append(own)
    whole = hand_made.scenario(vehicles, [], 0.025, 60.0)
    return whole, PhaseTrajectory("main", tuple(flown)), {}


def slide() -> tuple[Scenario, PhaseTrajectory, dict[str, Tube]]:
    """A box rocks along a face, its lowest edge always 1e-4 m above the margin."""
    box = hand_made.vehicle(Box(np.array([2.0, 1.0, 1.0])))
    face = hand_made.structure(Box(np.array([6.0, 3.0, 3.0])))

    def angle(t: np.ndarray) -> np.ndarray:
        return 0.6 * np.sin(np.pi * t / 30.0)

    def position(t: np.ndarray) -> np.ndarray:
        height = 3.1001 + 2.0 * np.abs(np.sin(angle(t))) + np.cos(angle(t))
        return np.stack([0.1 * t - 3.0, height, 0.0 * t], axis=1)

    turning = hand_made.turn_about([0, 0, 1], angle)
    flown = hand_made.path(box, position, turning, duration_s=60.0, segments=32)
    return hand_made.scenario([box], [face], 0.1, 60.0), PhaseTrajectory("main", (flown,)), {}
