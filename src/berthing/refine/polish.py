"""From a certified plan to an extremal: rounds of solves that close in on the touches.

The regulariser of the planes is left out, for it pulls on the motion wherever a plane is free, and
the barrier is taken lower; what is left of the drift of the lower Hamiltonian are its jumps at the
touches, and what segments do not resolve.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field

import numpy as np

from berthing.guess.path import resample
from berthing.refine.facing import Turn, least_turn
from berthing.refine.place import dips_of
from berthing.refine.refiner import BACKOFF_M, SPACING, SWEEP, Refinement, Refiner, Step
from berthing.refine.sampling import SampledClearance, sample_clearance
from berthing.refine.touches import (
    ROUNDING,
    Place,
    Touch,
    bottoms,
    closed_in,
    cut,
    pulls,
    touch_sites,
)
from berthing.result import Attempt
from berthing.solve.ipopt import Answer
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.scheme import ONE_SEGMENT
from berthing.transcription.sites import Site
from berthing.verify.optimality import relative_drift
from berthing.verify.verification import Verification

ROUNDS = 20

FACE_RAD = 1e-3
"""A best normal that turns by less in one body's frame belongs to a face of it."""

FACE_PAD = 0.45
"""In mean distances of nodes: how far beyond two sites the face must last, for the motion moves."""

DIP_M = 0.5 * BACKOFF_M
"""What a plan may dip below the margin and its back-off; deeper dips get a row."""

SHARPEN, ZOOMS = 17, 3
"""Samples and rounds in which a least clearance is found between two samples."""

QUIET = 0.25
"""Share of the tolerance: a touch about which H moves by no more is narrow enough."""

RESTLESS = 0.25
"""Share of the tolerance: segments without a touch in which H moves by more are halved."""


def polish(refiner: Refiner, name: str, result: Refinement, tolerance: float) -> list[Attempt]:
    """Close in on the touches of a certified answer until the lower Hamiltonian drifts by no
    more than ``tolerance`` of its mean; ``result`` keeps every certified step that drifts less.

    Returns:
        The solves that this took.
    """
    attempts: list[Attempt] = []
    if result.answer is None or not result.certified or refiner.mesh.scheme in ONE_SEGMENT:
        return attempts
    work = _Polish.begin(refiner, result.answer)
    for round_ in range(ROUNDS):
        drift = drift_of(result.verification)
        if drift <= tolerance or time.monotonic() > refiner.deadline:
            break
        work.narrow(result.verification if round_ == 0 else work.last, tolerance)
        step = work.solve(f"{name}, touches, round {round_ + 1}", attempts)
        if step.sampled is None:
            break
        trial = Refinement()
        refiner.verify(trial, step)
        work.last = trial.verification
        if trial.certified and drift_of(trial.verification) < drift:
            result.plan, result.verification = trial.plan, trial.verification
            result.outcome, result.answer = step.outcome, Answer(step.problem, step.outcome)
    return attempts


def drift_of(verification: Verification | None) -> float:
    """Of the lower Hamiltonian; infinite where it is unknown."""
    drift = None if verification is None else verification.hamiltonian_relative_drift
    return float("inf") if drift is None else drift


@dataclass
class _Polish:
    """The state between rounds: the last solve, and what the next one is made of."""

    refiner: Refiner
    step: Step
    base: Mesh
    guards: set[Place]
    touches: list[Touch] = field(default_factory=list)
    last: Verification | None = None

    @staticmethod
    def begin(refiner: Refiner, answer: Answer) -> _Polish:
        problem, motion = answer.problem, answer.outcome.motion
        step = Step(problem, answer.outcome, refiner.sample(problem, motion))
        mesh = problem.mesh
        guards = {(s.pair, mesh.fraction(s.segment, s.s)) for s in problem.separation.sites}
        return _Polish(refiner, step, mesh, guards)

    @property
    def node(self) -> float:
        """Mean distance of two nodes of the mesh that sites were put on, as a fraction."""
        return 1.0 / self.refiner.mesh.control_count

    def narrow(self, found: Verification | None, tolerance: float) -> None:
        """Move touches, guards and the base mesh to where the last solve asks for them."""
        step = self.step
        assert step.sampled is not None
        fractions = self._fractions(step.sampled)
        active = pulls(step.problem, step.outcome)
        lows = bottoms(active, step.sampled, fractions, self._sharpen)
        span = float(step.sampled.times_s[0]), step.outcome.motion.duration_s

        def settled(touch: Touch) -> bool:
            return found is not None and jump(found, span, touch, self.node) <= QUIET * tolerance

        self.touches = [closed_in(self.touches, low, self.node, settled) for low in lows]
        self.guards |= {
            (pair, (t - span[0]) / span[1]) for pair, t in dips_of(step.sampled, -DIP_M)
        }
        if found is not None:
            at = [pull.at for pull in active]
            unrest = restless(found, span, step.problem.mesh, at, tolerance)
            halved = {self.base.locate(t)[0] for t in unrest}
            self.base = self.base.split(halved)

    def solve(self, label: str, attempts: list[Attempt]) -> Step:
        """The next problem's step."""
        old, motion = self.step.problem, self.step.outcome.motion
        mesh = cut(self.base, self.touches)
        sites = touch_sites(mesh, self.touches, self.guards)
        turn = least_turn(self.refiner.scenario, old, motion)
        within = max([self.node, *(1.01 * touch.width for touch in self.touches)])
        problem = build(
            self.refiner.scenario, self.refiner.phase, mesh, sites, self.refiner.formulation,
            shapes_of=self.refiner.shapes_of, sweep_within=within, regulariser=0.0,
            shares=_Shares(mesh, self.touches, turn, self.node),
        )  # fmt: skip
        start = resample(motion, self.refiner.phase, old.mesh, mesh)
        self.step = self.refiner.step(label, problem, start, None, attempts, "sharp")
        return self.step

    def _fractions(self, sampled: SampledClearance) -> np.ndarray:
        t0, t1 = sampled.times_s[0], sampled.times_s[-1]
        return np.asarray((sampled.times_s - t0) / (t1 - t0))

    def _sharpen(self, pair: int, low: float, high: float) -> float:
        problem, motion = self.step.problem, self.step.outcome.motion
        return least_between(self.refiner, problem, motion, pair, low, high)


@dataclass(frozen=True)
class _Shares:
    """Sites of a touch share planes with their neighbours, others with near ones; along a face
    there is no need."""

    mesh: Mesh
    touches: list[Touch]
    turn: Turn
    node: float

    def __call__(self, first: Site, last: Site) -> bool:
        begin, end = (self.mesh.fraction(site.segment, site.s) for site in (first, last))
        places = [(first.pair, begin), (last.pair, end)]
        touching = any(t.near(p, ROUNDING * t.width) for t in self.touches for p in places)
        if not touching and end - begin > SWEEP * SPACING * self.node:
            return False
        pad = FACE_PAD * self.node
        return self.turn(first.pair, begin - pad, end + pad) > FACE_RAD


def least_between(
    refiner: Refiner, problem: Problem, motion: Motion, pair: int, low: float, high: float
) -> float:
    """The fraction of the phase between ``low`` and ``high`` at which a pair is nearest."""
    trajectory = trajectories(problem, motion)
    for _ in range(ZOOMS):
        at = np.linspace(low, high, SHARPEN)
        times = trajectory.t0_s + motion.duration_s * at
        only = (problem.pairs[pair],)
        distances = sample_clearance(refiner.scenario, only, trajectory, times, np.inf).distances_m
        i = int(np.argmin(distances[0]))
        low, high = float(at[max(i - 1, 0)]), float(at[min(i + 1, SHARPEN - 1)])
    return 0.5 * (low + high)


def jump(found: Verification, span_s: tuple[float, float], touch: Touch, around: float) -> float:
    """The range of H, relative to its mean, within ``around`` (a fraction) of a touch."""
    ranges = [0.0]
    for _, times, values in found.hamiltonian:
        at = (times - span_s[0]) / span_s[1]
        here = values[(at >= touch.begin - around) & (at <= touch.end + around)]
        if len(here):
            ranges.append(float(np.ptp(here) / np.mean(np.abs(values))))
    return max(ranges)


def restless(
    found: Verification, span_s: tuple[float, float], mesh: Mesh, touched: list[float],
    tolerance: float,
) -> list[float]:  # fmt: skip
    """Middles of the segments, as fractions, in which H moves by more than their share of the
    tolerance though no row is active inside.

    Args:
        span_s: begin and duration of the phase. touched: fractions with an active row.
    """
    out = []
    for _, times, values in found.hamiltonian:
        if len(values) < 2 or relative_drift(values) in (None, 0.0):
            continue
        at = (times - span_s[0]) / span_s[1]
        allowed = RESTLESS * tolerance * float(np.mean(np.abs(values)))
        for low, high in zip(mesh.breaks[:-1], mesh.breaks[1:], strict=True):
            here = values[(at >= low) & (at < high)]
            inside = any(low + 1e-9 < t < high - 1e-9 for t in touched)
            if len(here) > 1 and not inside and np.ptp(here) > allowed:
                out.append(0.5 * (low + high))
    return out
