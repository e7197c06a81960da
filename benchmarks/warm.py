"""Scenario A re-solved after its start and its structures have moved; the paper's form likewise.

The start moves by up to 0.3 m and each structure by up to 0.1 m, every way equally likely. Each
case begins from the same certified plan. Three times are taken of each:

- *re-solve*: the solve itself, from the parameters of the moved scenario to the optimality
  conditions at the usual tolerance of 1e-8; what is built once a planner is not in it;
- *certified*: the whole of ``Planner.replan``: that, the plan made of it, and its verification;
- *rows at sites*: the solve of the same case with all rows of the plan, by the interior-point
  method from the plan and its multipliers, to compare costs with.

``kkt-complementarity`` is re-solved by IPOPT on the planner's coarse mesh with rows at its nodes,
which is the smaller programme, from its own answer for the plan's scenario and its multipliers
where it has one, else from the plan's motion; solvers are built beforehand.
"""

from __future__ import annotations

import argparse
import copy
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy as np

import berthing as bt
from benchmarks._by_case import write
from benchmarks._coarse import coarse_problem
from berthing.geometry.pose import Pose
from berthing.guess.normals import exact_normals
from berthing.guess.path import resample
from berthing.planner import plan_with_answer
from berthing.refine.refiner import BACKOFF_M, Refiner
from berthing.refine.touching import FORMULATION
from berthing.scenario.clock import begun_at
from berthing.scenario.scenario import Scenario
from berthing.solve.homotopy import solve_by_stages
from berthing.solve.ipopt import Answer, Budget, Solver, Start
from berthing.solve.quick import QuickSolver

CASE, VEHICLE = "scenario-a", "spacecraft"
START_M, STRUCTURE_M = 0.3, 0.1
BUDGET = Budget(1500, 20.0)


@dataclass(frozen=True)
class Moved:
    """One case.

    Attributes:
        state: native state to begin in; structures: where these are.
        scenario: the same as a scenario of its own.
    """

    seed: int
    state: np.ndarray
    structures: dict[str, Pose]
    scenario: Scenario


def cases(scenario: Scenario, state: np.ndarray, count: int) -> Iterator[Moved]:
    """Seeded moves of the start and of every structure."""
    for seed in range(count):
        rng = np.random.default_rng(seed)
        moved = state.copy()
        moved[:3] += _within(rng, START_M)
        structures = {}
        for own in scenario.structures:
            pose = own.motion.pose(np.zeros(1))[0]
            structures[own.name] = Pose(pose.position + _within(rng, STRUCTURE_M), pose.rotation)
        yield Moved(seed, moved, structures, begun_at(scenario, moved, 0.0, structures))


def _within(rng: np.random.Generator, most_m: float) -> np.ndarray:
    """A vector of uniform direction and length."""
    way = rng.normal(size=3)
    return way / np.linalg.norm(way) * most_m * rng.random()


def ours(planner: bt.Planner, again: QuickSolver, answer: Answer, case: Moved) -> dict:
    """One case, by ``replan`` and with rows at sites."""
    own = copy.copy(planner)  # Each case begins from the first plan.
    found = own.replan(case.state, 0.0, structures=case.structures)
    start = Start(answer.outcome.motion, exact_normals(answer.problem.pairs))
    sites = again.solve(case.scenario, start, backoff_m=BACKOFF_M, previous=answer)
    return {
        "seed": case.seed, "outcome": found.outcome, "rows": found.rows,
        "steps": found.iterations, "resolve_s": round(found.solving_s, 5),
        "certified_s": round(found.seconds, 4), "cost": found.plan.cost if found.fresh else None,
        "sites": sites.status, "sites_steps": sites.iterations,
        "sites_s": round(sites.wall_time_s, 4), "sites_cost": sites.cost,
    }  # fmt: skip


def with_sites(scenario: Scenario) -> Answer:
    """The plan with rows at sites alone, as many as it takes to be certified."""
    (phase,), begun = scenario.phases, plan_with_answer(scenario)[1]
    refiner = Refiner(
        scenario, phase, begun.problem.mesh, FORMULATION, 0, lambda *_: None, float("inf")
    )
    refined = refiner.follow("with sites", begun)
    assert refined.certified
    return refined.answer


class Reference:
    """``kkt-complementarity`` on the coarse mesh, solved for the plan's scenario first."""

    def __init__(self, scenario: Scenario, answer: Answer) -> None:
        self.problem = coarse_problem(scenario, "kkt-complementarity")
        phase, mesh = self.problem.phase, self.problem.mesh
        motion = resample(answer.outcome.motion, phase, answer.problem.mesh, mesh)
        self.start = Start(motion, exact_normals(self.problem.pairs))
        first = solve_by_stages(
            self.problem, scenario, self.start, preset="near", budget=BUDGET, backoff_m=BACKOFF_M
        )
        self.previous = Answer(self.problem, first) if first.solved else None
        preset = "warm" if self.previous else "near"
        self.solver = Solver.build(self.problem, preset, BUDGET)

    def solve(self, case: Moved) -> dict:
        """One case."""
        outcome = self.solver.solve(
            case.scenario, self.start, backoff_m=BACKOFF_M, previous=self.previous
        )
        return {
            "seed": case.seed, "kind": "kkt-complementarity", "outcome": outcome.status,
            "from": "its answer" if self.previous else "the plan's motion",
            "steps": outcome.iterations, "resolve_s": round(outcome.wall_time_s, 4),
            "cost": outcome.cost,
        }  # fmt: skip


def table(rows: list[dict], reference: list[dict]) -> str:
    """A line a time; then how costs compare and what was not certified."""
    lines = ["| what | good | median ms | worst ms | steps, median | most |", "|---" * 6 + "|"]
    for name, key, steps, own in (
        ("re-solve", "resolve_s", "steps", rows),
        ("certified", "certified_s", "steps", rows),
        ("rows at sites", "sites_s", "sites_steps", rows),
        ("`kkt-complementarity`", "resolve_s", "steps", reference),
    ):
        if own:
            status = "sites" if key == "sites_s" else "outcome"
            good = sum(row[status] in ("certified", "solved") for row in own)
            ms, counts = [1e3 * row[key] for row in own], [row[steps] for row in own]
            lines.append(
                f"| {name} | {good} of {len(own)} | {median(ms):.1f} | {max(ms):.1f} "
                f"| {median(counts):g} | {max(counts)} |"
            )
    more = [1e2 * (row["cost"] / row["sites_cost"] - 1.0) for row in rows if row["cost"]]
    low, middle, high = np.quantile(more, [0.0, 0.5, 1.0])
    less = f"{low:+.3f} to {high:+.3f} %, median {middle:+.3f} %"
    lines.append(f"\ncost against rows at sites: {less}")
    lines.append(f"solved with rows at: {dict(Counter(row['rows'] for row in rows))}")
    if reference:
        times = median(r["resolve_s"] for r in reference) / median(r["resolve_s"] for r in rows)
        lines.append(f"faster than `kkt-complementarity`: {times:.0f} times")
    lines += [f"not certified: {row}" for row in rows if row["outcome"] != "certified"]
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks warm")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--reference", type=int, default=3, help="cases of the paper's form")
    options = parser.parse_args(arguments)
    scenario = bt.load(CASE)
    planner = bt.Planner(scenario)
    flown = planner.plan().plan.phases[0].vehicle(VEHICLE)
    answer = with_sites(scenario)
    again = QuickSolver(answer.problem, "warm", falls_back=False)
    given = list(cases(scenario, flown.state(np.zeros(1))[0], options.cases))
    ours(planner, again, answer, given[0])  # What is loaded when first used counts as import.
    rows = [ours(planner, again, answer, case) for case in given]
    reference: list[dict] = []
    if options.reference:
        other = Reference(scenario, answer)
        reference = [other.solve(case) for case in given[: options.reference]]
    print(table(rows, reference))
    write(options.json, [*rows, *reference])
    return 0 if all(row["outcome"] == "certified" for row in rows) else 1
