"""Scenario A by each formulation from the same 20 guesses: success, cold and warm effort, cost.

Every row is one solve of the whole problem on the planner's coarse mesh, rows at every node. *Cold*
is from a guess; *warm* is from that answer and its multipliers after the start has moved. ``kkt
after plane`` begins with ``plane``'s answer from the guess, as the planner does.

Rows are written as they come, and those that the file has already are not solved again.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks._by_case import write
from benchmarks._coarse import coarse_problem
from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.refine.refiner import BACKOFF_M
from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario
from berthing.solve.homotopy import solve_by_stages
from berthing.solve.ipopt import Answer, Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.transcription.problem import Problem

FORMULATIONS = ("plane", "kkt", "kkt after plane", "kkt-complementarity")
GUESSES = 20
ITERATIONS = 1500
LIMIT_S = 60.0
"""Of one cold solve, an equal share for each of its stages; as long for a warm one."""

MOVED_M = np.array([0.0, 0.15, 0.0])
"""By how much the start moves for the warm solve."""


@dataclass(frozen=True)
class Case:
    """The scenario with its guesses."""

    scenario: Scenario

    @property
    def moved(self) -> Scenario:
        """With another start."""
        (phase,) = self.scenario.phases
        (craft,) = phase.vehicles
        start = replace(craft.start, position_m=craft.start.position_m + MOVED_M)
        phase = replace(phase, vehicles=(replace(craft, start=start),))
        return replace(self.scenario, phases=(phase,))

    def problem(self, formulation: str) -> Problem:
        """On the planner's coarse mesh, with rows at every node."""
        return coarse_problem(self.scenario, formulation)

    def starts(self, problem: Problem) -> list[tuple[str, Start]]:
        """The fixed guesses and then random ones, ``GUESSES`` in all, the same for every form."""
        phase, normals = problem.phase, exact_normals(problem.pairs)
        found: dict[str, Start] = {}
        seed = 0
        while len(found) < GUESSES:
            for guess in candidates(self.scenario, phase, seed):
                drawn = guess.name.startswith("random")
                name = f"{guess.name}, seed {seed}" if drawn else guess.name
                motion = motion_along(guess, phase, problem.mesh, phase.horizon.nominal_s)
                found.setdefault(name, Start(motion, normals))
            seed += 1
        return list(found.items())[:GUESSES]


@dataclass(frozen=True)
class Form:
    """One formulation, built once."""

    case: Case
    name: str
    limit_s: float = LIMIT_S

    def prepared(self) -> tuple[Problem, Callable[[Start], Outcome]]:
        """The problem whose answer counts, and how it is solved from a guess."""
        own = self.case.problem(self.name.split()[0])
        if self.name == "kkt after plane":
            first = self.case.problem("plane")
            begin, follow = self._solver(first, "cold"), self._solver(own, "warm")

            def both(start: Start) -> Outcome:
                answer = begin.solve(self.case.scenario, start, backoff_m=BACKOFF_M)
                if not answer.solved:
                    return answer
                done = follow.solve(
                    self.case.scenario, Start(answer.motion, start.normals), backoff_m=BACKOFF_M,
                    previous=Answer(first, answer),
                )  # fmt: skip
                return replace(
                    done,
                    iterations=done.iterations + answer.iterations,
                    wall_time_s=done.wall_time_s + answer.wall_time_s,
                )

            return own, both
        if len(own.homotopy) > 1:
            budget = Budget(ITERATIONS, self.limit_s / len(own.homotopy))
            return own, lambda start: solve_by_stages(
                own, self.case.scenario, start, preset="cold", budget=budget, backoff_m=BACKOFF_M
            )
        solver = self._solver(own, "cold")
        return own, lambda start: solver.solve(self.case.scenario, start, backoff_m=BACKOFF_M)

    def _solver(self, problem: Problem, preset: str) -> Solver:
        return Solver.build(problem, preset, Budget(ITERATIONS, self.limit_s))

    def rows(self, known: set[str], until: float):
        """A row a guess that is not ``known``, until the clock says so."""
        problem, cold = self.prepared()
        again = self._solver(problem, "warm")
        for guess, start in self.case.starts(problem):
            if guess in known or time.monotonic() > until:
                continue
            outcome = cold(start)
            row = {
                "formulation": self.name, "guess": guess, "status": outcome.status,
                "iterations": outcome.iterations, "seconds": round(outcome.wall_time_s, 3),
                "limit_s": self.limit_s,
            }  # fmt: skip
            if outcome.solved:
                warm = again.solve(
                    self.case.moved, Start(outcome.motion, start.normals), backoff_m=BACKOFF_M,
                    previous=Answer(problem, outcome),
                )  # fmt: skip
                row |= {
                    "cost": outcome.cost, "warm_status": warm.status,
                    "warm_iterations": warm.iterations,
                    "warm_seconds": round(warm.wall_time_s, 3),
                }  # fmt: skip
            yield row


def table(rows: list[dict]) -> str:
    """A line a formulation; effort is that of the solves that succeed."""
    lines = [
        "| formulation | solved | cheapest passage | cost, median | cold: iterations | s "
        "| warm: solved | iterations | s |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    best = min((r["cost"] for r in rows if "cost" in r), default=np.inf)
    for name in FORMULATIONS:
        mine = [r for r in rows if r["formulation"] == name]
        good = [r for r in mine if r["status"] == "solved"]
        warm = [r for r in good if r["warm_status"] == "solved"]
        cheap = sum(r["cost"] <= 1.01 * best for r in good)
        lines.append(
            f"| {name} | {len(good)} of {len(mine)} | {cheap} | {_median(good, 'cost', 6)} "
            f"| {_median(good, 'iterations', 0)} | {_median(good, 'seconds', 2)} "
            f"| {len(warm)} of {len(good)} "
            f"| {_median(warm, 'warm_iterations', 0)} | {_median(warm, 'warm_seconds', 2)} |"
        )
    return "\n".join(lines)


def _median(rows: list[dict], key: str, digits: int) -> str:
    return f"{median(r[key] for r in rows):.{digits}f}" if rows else "–"


def main(arguments: list[str]) -> int:
    """Run what is missing, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks formulations")
    parser.add_argument("--json", type=Path, required=True)
    parser.add_argument("--case", default="scenario-a")
    parser.add_argument("--formulation", action="append", choices=FORMULATIONS)
    parser.add_argument("--seconds", type=float, default=np.inf, help="stop after about so many")
    parser.add_argument("--limit", type=float, default=LIMIT_S, help="seconds of one solve")
    options = parser.parse_args(arguments)
    until = time.monotonic() + options.seconds
    rows = json.loads(options.json.read_text()) if options.json.exists() else []
    case = Case(load(options.case))
    for name in options.formulation or FORMULATIONS:
        known = {row["guess"] for row in rows if row["formulation"] == name}
        if len(known) >= GUESSES or time.monotonic() > until:
            continue
        for row in Form(case, name, options.limit).rows(known, until):
            rows.append(row)
            print(row, flush=True)
            write(options.json, rows)
    print(table(rows))
    return 0
