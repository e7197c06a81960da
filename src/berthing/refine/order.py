"""Solves on meshes twice halved, which tell how fast the cost settles."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.guess.path import resample
from berthing.refine.refiner import Refiner
from berthing.result import Attempt
from berthing.solve.ipopt import Answer
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build
from berthing.transcription.scheme import ONE_SEGMENT
from berthing.transcription.sites import Site
from berthing.verify.observed_order import OrderCheck, Study


def order_check(
    refiner: Refiner, name: str, answer: Answer, attempts: list[Attempt]
) -> OrderCheck | None:
    """Solve ``answer``'s problem on finer meshes, and with lower degrees until an order shows.

    None where the plan's own degree fails on a finer mesh or where the mesh is one segment. Rows of
    separation and shared planes stay where they are, so that the only change is how finely the
    motion is resolved.
    """
    if refiner.mesh.scheme in ONE_SEGMENT:
        return None
    work = _Studies(refiner, name, answer, attempts)
    highest = max(answer.problem.mesh.degrees)
    own = work.study(highest)
    if own is None:
        return None
    for degree in range(highest, 0, -1):
        found = own if degree == highest else work.study(degree)
        if found is not None and found.order is not None:
            return OrderCheck(own, found)
    return OrderCheck(own, None)


@dataclass(frozen=True)
class _Studies:
    """Solves one answer's problem anew on meshes of its own breaks."""

    refiner: Refiner
    name: str
    answer: Answer
    attempts: list[Attempt]

    def study(self, degree: int) -> Study | None:
        """The cost with polynomials of a degree; None where a solve fails."""
        mesh = self.answer.problem.mesh
        mesh = Mesh(mesh.scheme, mesh.breaks, (degree,) * mesh.segments)
        nodes = mesh.node_set(0)
        expected = len(nodes.collocated) + len(nodes.points) - 2
        segments, costs = [], []
        for _ in range(3):
            cost = self._cost(mesh, f"{self.name}, degree {degree}, {mesh.segments} segments")
            if cost is None:
                return None
            segments.append(mesh.segments)
            costs.append(cost)
            mesh = mesh.split(set(range(mesh.segments)))
        return Study(
            degree, expected, (segments[0], segments[1], segments[2]),
            (costs[0], costs[1], costs[2]),
        )  # fmt: skip

    def _cost(self, mesh: Mesh, label: str) -> float | None:
        refiner, old = self.refiner, self.answer.problem
        places = [(s.pair, old.mesh.fraction(s.segment, s.s)) for s in old.separation.sites]
        shared = {(_key(*places[w.first]), _key(*places[w.last])) for w in old.sweeps}

        def shares(first: Site, last: Site) -> bool:
            ends = [_key(s.pair, mesh.fraction(s.segment, s.s)) for s in (first, last)]
            return (ends[0], ends[1]) in shared

        problem = build(
            refiner.scenario, refiner.phase, mesh,
            sorted(Site(*mesh.locate(at), pair) for pair, at in places), refiner.formulation,
            shapes_of=refiner.shapes_of, sweep_within=1.0, shares=shares, regulariser=0.0,
        )  # fmt: skip
        start = resample(self.answer.outcome.motion, refiner.phase, old.mesh, mesh)
        outcome = refiner.solve(label, problem, start, None, self.attempts, "sharp")
        return outcome.cost if outcome.solved else None


def _key(pair: int, at: float) -> tuple[int, float]:
    return pair, round(at, 10)
