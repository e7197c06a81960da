"""Our guesses beside the paper's continuation: how often the whole coarse problem is solved.

Each row is one solve of the whole problem, on the planner's coarse mesh, from one guess. For the
paper's continuation the seeds bow the sub-problems' starts to random sides (seed 0 is as printed),
and its seconds include its sub-problems. Of ours, those that no seed changes are run once.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from statistics import median

from benchmarks._by_case import run
from berthing.guess.continuation import Continuation
from berthing.guess.first_motions import first_motions
from berthing.guess.normals import exact_normals
from berthing.planner import COARSE_SEGMENTS, DEGREE
from berthing.refine.first_answers import COARSE_ITERATIONS
from berthing.refine.refiner import BACKOFF_M
from berthing.scenario.files import load
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build
from berthing.transcription.sites import node_sites

CASES = ("scenario-a", "scenario-b-tight")
GUESSES = ("default", "paper-continuation")


@dataclass
class Whole:
    """The coarse problem of one case."""

    name: str
    spent: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.scenario = load(self.name)
        (self.phase,) = self.scenario.phases
        mesh = Mesh.uniform("lgr", COARSE_SEGMENTS, DEGREE)
        pairs = self.scenario.pairs(self.phase)
        self.normals = exact_normals(pairs)
        sites = node_sites(mesh, len(pairs))
        budget = Budget(COARSE_ITERATIONS)
        self.solver = Solver.build(
            build(self.scenario, self.phase, mesh, sites, "plane"), "cold", budget
        )
        self.make = Continuation(
            self.scenario, self.phase, mesh, "plane", budget, BACKOFF_M,
            lambda name, problem, outcome: self.spent.append(outcome.iterations),
        )  # fmt: skip

    def rows(self, guess: str, seed: int, seen: set[str]) -> list[dict]:
        """Solve from every motion that the guess gives for this seed, if not seen before."""
        self.spent.clear()
        began = time.perf_counter()
        motions = first_motions(guess, self.make, seed)
        before = time.perf_counter() - began
        out = []
        for name, motion in motions:
            drawn = guess == "paper-continuation" or name.startswith("random")
            if not drawn and name in seen:
                continue
            seen.add(name)
            outcome = self.solver.solve(
                self.scenario, Start(motion, self.normals), backoff_m=BACKOFF_M
            )
            out.append(
                {
                    "case": self.name, "guess": guess, "name": name,
                    "seed": seed if drawn else None,
                    "status": outcome.status, "iterations": outcome.iterations,
                    "iterations_before": sum(self.spent),
                    "seconds": round(before / len(motions) + outcome.wall_time_s, 2),
                    "cost": outcome.cost if outcome.solved else None,
                }
            )  # fmt: skip
        return out


def table(rows: list[dict]) -> str:
    """A line a case and guess."""
    lines = [
        "| case | guess | solved | cheapest passage | median cost | iterations, median "
        "| sub-problems' iterations, median | s, median |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for case, guess in dict.fromkeys((row["case"], row["guess"]) for row in rows):
        mine = [row for row in rows if (row["case"], row["guess"]) == (case, guess)]
        good = [row for row in mine if row["status"] == "solved"]
        best = min(row["cost"] for row in rows if row["case"] == case and row["cost"])
        cheap = sum(row["cost"] <= 1.01 * best for row in good)
        lines.append(
            f"| {case} | {guess} | {len(good)} of {len(mine)} | {cheap} "
            f"| {median(row['cost'] for row in good):.6f} "
            f"| {median(row['iterations'] for row in mine):.0f} "
            f"| {median(row['iterations_before'] for row in mine):.0f} "
            f"| {median(row['seconds'] for row in mine):.1f} |"
        )
    return "\n".join(lines)


def rows_of(name: str, seeds: int) -> Iterator[list[dict]]:
    """Of one case: every guess from every seed."""
    whole = Whole(name)
    for guess in GUESSES:
        seen: set[str] = set()
        for seed in range(seeds):
            yield whole.rows(guess, seed, seen)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    return run("guesses", CASES, rows_of, table, arguments)
