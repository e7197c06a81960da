"""Plans solved at their touches: rows at the instants of least clearance alone, by Newton's method.

Between two plans that are near each other the touches move a little in time and place, and hardly
ever come or go. So the rows that count are one at each touch, at an instant that moves along, and
the rows that bind are known: three or four steps, each a matrix half the size of that with rows
at sites. Nothing here looks for touches that were not there; the check of the plan does, and
where it finds some, or where the method fails, the caller goes back to rows at sites.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.guess.normals import exact_normals
from berthing.refine.place import dips_of
from berthing.refine.refiner import BACKOFF_M, LOOK_M, SAMPLES, Step
from berthing.refine.sampling import SampledClearance, sample_clearance, sample_times
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve import newton
from berthing.solve.ipopt import TOLERANCE, Answer, Start
from berthing.solve.newton import Bearing, Group, Newton, Reached
from berthing.solve.outcome import ITERATION_LIMIT, NOT_CONVERGED, SOLVED, Outcome
from berthing.solve.quick import outcome_of, with_rows_alone
from berthing.trajectory import PhaseTrajectory
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.sites import Site

TOUCHES_M = 0.01
"""A least clearance with no more room than this may be a touch: planes that neighbouring sites
share keep Scenario A's plan up to 7 mm off its margin where the vehicle turns past an edge."""

APART = 2.0
"""Samples of one pair nearer than this many steps are one least clearance."""

HAIR = 1e-6
"""Local coordinates of instants in one segment differ by this at least, to be told apart."""

STEPS = 15
"""Of Newton's method: answers come in three to six, or not at all."""

INSIDE = 1.0 + 1e-9
"""Local coordinates up to this are in their segment, rounding allowed for."""

HOPS = 4
"""Times that an instant may leave its segment for the next one in a solve."""

STATUS = {newton.SOLVED: SOLVED, newton.ITERATIONS: ITERATION_LIMIT}

FORMULATION = "plane"
"""The form that this is for: its rows hold planes fast where they bind."""


@dataclass(frozen=True)
class Touched:
    """An answer with rows at its touches, to go on from."""

    touching: Touching
    bearing: Bearing
    outcome: Outcome

    @property
    def answer(self) -> Answer:
        """The same with each site where its touch is."""
        return Answer(self.touching.problem.settled(self.bearing.x), self.outcome)


@dataclass(frozen=True)
class Touching:
    """A programme with rows at instants in given segments, and Newton's method on it.

    Attributes:
        others: the same with instants in other segments, built when first asked for.
    """

    problem: Problem
    method: Newton
    others: dict[tuple[int, ...], Touching] = field(default_factory=dict)

    @staticmethod
    def build(scenario: Scenario, phase: Phase, mesh: Mesh, sites: list[Site]) -> Touching:
        """With an instant at each of ``sites``, free to move."""
        problem = build(scenario, phase, mesh, sites, FORMULATION, moving=True)
        groups = [Group(own.variables, own.rows, own.gap) for own in problem.instants]
        return Touching(problem, Newton(*with_rows_alone(problem), groups))

    def first(self, scenario: Scenario, motion: Motion) -> Touched | None:
        """From a motion near the answer, the rows that bind being those with no room; None where
        the method fails."""
        start = Start(motion, exact_normals(self.problem.pairs))
        parameters = self._parameters(scenario, motion.duration_s)
        bearing = self.method.begin(start.vector(self.problem, scenario), parameters)
        touched = self.solve(parameters, bearing, motion.duration_s)
        return touched if touched.outcome.solved else None

    def again(self, scenario: Scenario, last: Touched) -> Touched | None:
        """From an answer to the same problem with other numbers; None where the method fails."""
        duration_s = last.outcome.motion.duration_s
        touched = self.solve(self._parameters(scenario, duration_s), last.bearing, duration_s)
        return touched if touched.outcome.solved else None

    def solve(self, parameters: Array, bearing: Bearing, duration_s: float) -> Touched:
        """Solve from ``bearing``; the outcome says whether it ended well."""
        began = time.perf_counter()
        touching, steps = self, 0
        for _ in range(HOPS):
            reached = touching.method.solve(
                bearing, parameters, tolerance=TOLERANCE, iterations=STEPS
            )
            steps += reached.iterations
            hopped = touching._hopped(reached)
            if hopped is None:
                break
            touching, bearing = hopped
        outcome = touching._outcome(reached, hopped is None, parameters, duration_s)
        spent = time.perf_counter() - began
        return Touched(
            touching, reached.bearing, replace(outcome, iterations=steps, wall_time_s=spent)
        )

    def _parameters(self, scenario: Scenario, duration_s: float) -> Array:
        return self.problem.parameter_vector(scenario, BACKOFF_M, duration_s)

    def _outcome(
        self, reached: Reached, stayed: bool, parameters: Array, duration_s: float
    ) -> Outcome:
        """No answer where an instant is still on its way into another segment."""
        status = STATUS.get(reached.status, NOT_CONVERGED) if stayed else NOT_CONVERGED
        own = reached.bearing
        return outcome_of(self.problem, status, own.x, own.y, parameters, duration_s)

    def _hopped(self, reached: Reached) -> tuple[Touching, Bearing] | None:
        """The programme with instants in the segments that they have moved to, and the same point
        in it; None where none has left its segment, or the method has failed."""
        if reached.status != newton.SOLVED:
            return None
        problem, x = self.problem, reached.bearing.x.copy()
        sites = list(problem.settled(x).separation.sites)
        moved = False
        for i, site in enumerate(sites):
            if abs(site.s) > INSIDE and not reached.bearing.out[i]:
                fraction = problem.mesh.fraction(site.segment, site.s)
                segment, s = problem.mesh.locate(fraction)
                if segment != site.segment:
                    moved = True
                    sites[i] = Site(segment, s, site.pair)
                    x[problem.layout.variables.blocks[problem.instants[i].place].offset] = s
        if not moved:
            return None
        key = tuple(site.segment for site in sites)
        if key not in self.others:
            built = Touching.build(problem.scenario, problem.phase, problem.mesh, sites)
            self.others[key] = replace(built, others=self.others)
        return self.others[key], replace(reached.bearing, x=x)


def touch_sites(
    scenario: Scenario, flown: PhaseTrajectory, mesh: Mesh, from_s: float = 0.0
) -> list[Site]:
    """Sites at the least clearances of a plan after ``from_s`` that may be touches.

    Args:
        mesh: of the time from ``from_s`` to the end of ``flown``.
    """
    pairs = scenario.pairs(scenario.phase(flown.phase))
    times = sample_times(flown, SAMPLES)
    sampled = sample_clearance(scenario, pairs, flown, times, scenario.margins.default_m + LOOK_M)
    return least_sites(sampled, mesh, from_s)


def least_sites(sampled: SampledClearance, mesh: Mesh, from_s: float = 0.0) -> list[Site]:
    """Likewise, of a motion sampled already."""
    times = sampled.times_s
    t0, t1, step = max(from_s, float(times[0])), float(times[-1]), float(np.max(np.diff(times)))
    sites: list[Site] = []
    last: dict[int, float] = {}
    for pair, t in sorted(dips_of(sampled, -TOUCHES_M)):
        if not t0 + step < t < t1 - step or t - last.get(pair, -np.inf) < APART * step:
            continue
        last[pair] = t
        segment, s = mesh.locate((t - t0) / (t1 - t0))
        while any(q.segment == segment and abs(q.s - s) < HAIR for q in sites):
            s += HAIR
        sites.append(Site(segment, s, pair))
    return sites


def finished(scenario: Scenario, step: Step) -> Answer | None:
    """A step of a refinement solved on at its touches; None where the method fails."""
    if step.sampled is None:
        return None
    problem, motion = step.problem, step.outcome.motion
    sites = least_sites(step.sampled, problem.mesh)
    touched = Touching.build(scenario, problem.phase, problem.mesh, sites).first(scenario, motion)
    return None if touched is None else touched.answer
