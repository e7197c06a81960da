"""From a coarse answer to a certified plan by convex steps alone.

As the refiner: solve, look where the answer dips between the samples, take more samples there. But
planes are held in every step, so that crowded scenes cost little more than empty ones, and no step
leaves the passage. What is left to gain is below a percent.
"""

from __future__ import annotations

import time

import numpy as np

from berthing.geometry.arrays import Array
from berthing.guess.normals import exact_normals
from berthing.guess.path import resample
from berthing.refine.place import dips_of
from berthing.refine.refiner import BACKOFF_M, Refinement, Refiner, Step, attempt
from berthing.refine.remesh import graded, split_unresolved
from berthing.solve.convex_steps import ConvexSteps
from berthing.solve.ipopt import Answer, Budget, Start
from berthing.solve.outcome import TIME_LIMIT
from berthing.solve.samples import spread_evenly
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.verify.verdict import UNDECIDED, VIOLATED

BETWEEN = 1
"""Samples between two points of the mesh to begin with."""

REGION = 0.03
"""Trust region of the first step in the first round."""

LATER, DEPTHS, CALM = 0.005, 4.0, 5e-4
"""In those after it so many times the deepest dip, but at most and at least this much: what else
moves dips elsewhere."""

MEND_M = 2e-3
"""Dips that are not deeper than this are mended, and nothing else is changed."""

SETTLED = 3e-3
"""Promised gain, as a share of the objective, at which steps end."""

LEFT = 0.25
"""Of the back-off: the overlap that steps may leave."""

NEAR_M = 0.05
"""Beyond the margin: pairs further apart are not sampled for dips."""

ROUNDS = 10
STEPS = 25

ALLOWED = -0.5
"""Of the back-off: a dip that reaches further into it gets samples."""

FAILURES = 2
"""Rounds without an answer that are put up with: the next one has another region."""

AROUND = np.arange(-3, 4)
"""Steps, from a dip, at which samples are added."""

SPACING, SHRINK = 0.3, 0.6
"""Of those steps, in the mean distance of two samples, and the factor from round to round."""

SAME = 0.1
"""Of the spacing: samples that are nearer to each other are one."""


def stepped(refiner: Refiner, name: str, coarse: Problem, motion: Motion) -> Refinement:
    """Refine ``motion``, the answer of ``coarse``, until certified or out of rounds."""
    result, failed = Refinement(stepped=True), 0
    guessed = trajectories(coarse, motion)
    mesh = graded(coarse.mesh, refiner.phase, guessed, refiner.mesh.segments)
    motion = resample(motion, refiner.phase, coarse.mesh, mesh)
    problem, fractions = _problem(refiner, mesh), spread_evenly(mesh, BETWEEN)
    length_m, region, mends = problem.layout.scale.length_m, REGION, False
    spacing = SPACING / len(fractions)
    dips = [t for _, t in dips_of(refiner.sample(problem, motion, NEAR_M), 0.0)]
    fractions = _denser(fractions, _fractions(problem, motion, dips), spacing)
    for round_ in range(ROUNDS):
        left = max(refiner.deadline - time.monotonic(), 0.1)
        budget = Budget(STEPS, left)
        solver = ConvexSteps(problem, budget, fractions, region, SETTLED, LEFT * BACKOFF_M, mends)
        start = Start(motion, exact_normals(problem.pairs))
        outcome = solver.solve(refiner.scenario, start, backoff_m=BACKOFF_M)
        label = f"{name}, round {round_ + 1}"
        result.attempts.append(attempt(label, problem, outcome))
        result.outcome = outcome
        failed += not outcome.solved
        if failed > FAILURES or outcome.status == TIME_LIMIT:
            break
        motion = outcome.motion
        sampled = refiner.sample(problem, motion, NEAR_M)
        refiner.report(label, outcome.iterations, -sampled.worst_m)
        dips = [t for _, t in dips_of(sampled, ALLOWED * BACKOFF_M)]
        region = float(np.clip(DEPTHS * sampled.worst_m / length_m, CALM, LATER))
        mends = outcome.solved and sampled.worst_m < MEND_M
        if not dips:
            result.answer = Answer(problem, outcome)
            refiner.verify(result, Step(problem, outcome, sampled))
            if result.certified:
                break
            dips = _not_proven(result)
        if dips:
            spacing *= SHRINK
            fractions = _denser(fractions, _fractions(problem, motion, dips), spacing)
            continue
        assert result.plan is not None
        finer = split_unresolved(mesh, refiner.phase, result.plan.phases[0])
        if finer == mesh:
            break
        motion = resample(motion, refiner.phase, mesh, finer)
        fractions = _denser(fractions, spread_evenly(finer, BETWEEN), 0.0)
        mesh, problem = finer, _problem(refiner, finer)
    return result


def _not_proven(result: Refinement) -> list[float]:
    """Times at which a pair was not shown to keep its margin, though more samples may help."""
    assert result.verification is not None
    return [
        t
        for verdict in result.verification.pairs
        if verdict.verdict in (VIOLATED, UNDECIDED) and not verdict.lost_to_tube
        for t in (*verdict.violations_s, verdict.time_s)
    ]


def _fractions(problem: Problem, motion: Motion, times_s: list[float]) -> Array:
    return np.asarray((np.array(times_s) - problem.layout.t0_s) / motion.duration_s)


def _problem(refiner: Refiner, mesh: Mesh) -> Problem:
    """Without separation rows."""
    return build(
        refiner.scenario, refiner.phase, mesh, [], refiner.formulation,
        shapes_of=refiner.shapes_of,
    )  # fmt: skip


def _denser(fractions: Array, dips: Array, spacing: float) -> Array:
    """``fractions`` and more of them around each of ``dips``."""
    more = (dips[:, None] + spacing * AROUND).ravel()
    every = np.union1d(fractions, more[(more > 0.0) & (more < 1.0)])
    return np.asarray(every[np.concatenate([[True], np.diff(every) > SAME * spacing])])
