"""The cost on meshes twice halved: how fast it settles, by measurement."""

from __future__ import annotations

import math
from dataclasses import dataclass

from berthing.guess.path import resample
from berthing.refine.refiner import Refiner
from berthing.result import Attempt
from berthing.solve.ipopt import Answer
from berthing.transcription.problem import build
from berthing.transcription.scheme import ONE_SEGMENT
from berthing.transcription.sites import Site

RESOLVED = 1e-10
"""Of the cost: differences below this are the solver's own and show no order."""


@dataclass(frozen=True)
class OrderCheck:
    """The cost on the plan's mesh, with every segment halved, and halved again.

    Attributes:
        costs: of the three meshes, rows of separation where they are.
        order: log2 of the ratio of their differences; None where they are too small to tell.
    """

    costs: tuple[float, float, float]

    @property
    def differences(self) -> tuple[float, float]:
        """|J_h − J_h/2| and |J_h/2 − J_h/4| as shares of the cost."""
        first, second, third = self.costs
        scale = max(abs(third), 1e-300)
        return abs(first - second) / scale, abs(second - third) / scale

    @property
    def order(self) -> float | None:
        """p where the cost's error falls as the width of segments to the power p."""
        wide, narrow = self.differences
        if wide <= RESOLVED or narrow <= 0.0:
            return None
        # A difference below what is resolved may be anything up to it: a bound from below.
        return math.log2(wide / max(narrow, RESOLVED))


def order_check(
    refiner: Refiner, name: str, answer: Answer, attempts: list[Attempt]
) -> OrderCheck | None:
    """Solve ``answer``'s problem on finer meshes; None where one fails or the mesh is one segment.

    Rows of separation and shared planes stay where they are, so that the only change is how finely
    the motion is resolved.
    """
    if refiner.mesh.scheme in ONE_SEGMENT:
        return None
    old, motion = answer.problem, answer.outcome.motion
    places = [(s.pair, old.mesh.fraction(s.segment, s.s)) for s in old.separation.sites]
    shared = {(_key(*places[w.first]), _key(*places[w.last])) for w in old.sweeps}
    mesh, costs = old.mesh, []
    for halvings in range(3):
        if halvings:
            mesh = mesh.split(set(range(mesh.segments)))
        here = mesh

        def shares(first: Site, last: Site) -> bool:
            ends = [_key(s.pair, here.fraction(s.segment, s.s)) for s in (first, last)]  # noqa: B023
            return (ends[0], ends[1]) in shared

        problem = build(
            refiner.scenario, refiner.phase, mesh,
            sorted(Site(*mesh.locate(at), pair) for pair, at in places), refiner.formulation,
            shapes_of=refiner.shapes_of, sweep_within=1.0, shares=shares, regulariser=0.0,
        )  # fmt: skip
        start = resample(motion, refiner.phase, old.mesh, mesh)
        step = refiner.step(f"{name}, {halvings} halvings", problem, start, None, attempts, "sharp")
        if not step.outcome.solved:
            return None
        costs.append(step.outcome.cost)
    return OrderCheck((costs[0], costs[1], costs[2]))


def _key(pair: int, at: float) -> tuple[int, float]:
    return pair, round(at, 10)
