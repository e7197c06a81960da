"""The paper's initial guess: one part in the way at a time, then all the answers superposed.

The paper's Discussion solves a sub-problem for each component of the structure and superimposes
the answers, and leaves the rest open. We read it as follows. X₀ is the answer with nothing in the
way, from a straight line; X_i the answer with part i alone, from X₀; and the guess is
X₀ + Σ (X_i − X₀), the sum of what each part asks for. Translation is linear in the controls, so
that the sum is a motion again; quaternions are normalised. (Of two parts that ask for the same
detour the sum makes it twice as wide, which clears both; their mean would halve what one of them
asks for alone.) A sub-problem without an answer is begun again from X₀ bowed to a random side: a
line through the middle of a part leaves the solver undecided between its sides. If it still has
none it adds nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, ShapesOf, build, planned_shapes
from berthing.transcription.sites import node_sites

BEND = 0.1
"""Of the way's length: by how much a seed other than 0 bows the obstacle-free answer."""

AGAIN = 2
"""Further starts of a sub-problem without an answer."""

QUATERNION = ("qw", "qx", "qy", "qz")

Report = Callable[[str, Problem, Outcome], None]


@dataclass(frozen=True)
class Continuation:
    """Sub-problems of one phase on one mesh.

    Attributes:
        formulation: how separation is written.
        budget: of each sub-problem.
        backoff_m: added to every margin.
        report: is told (name of the sub-problem, the sub-problem, its outcome).
        shapes_of: what stands for the parts of a pair.
    """

    scenario: Scenario
    phase: Phase
    mesh: Mesh
    formulation: str
    budget: Budget
    backoff_m: float
    report: Report
    shapes_of: ShapesOf = planned_shapes

    def motion(self, seed: int) -> Motion:
        """The superposed guess.

        Seed 0 is the paper's. Any other bows the start of each sub-problem to a random side, for
        the paper's has nothing that could be drawn again.
        """
        straight = candidates(self.scenario, self.phase, 0)[0]
        start = motion_along(straight, self.phase, self.mesh, self.phase.horizon.nominal_s)
        free = self._answer("nothing in the way", [], start) or start
        rng, answers = np.random.default_rng(seed), []
        for name, pairs in self._components().items():
            begin = bowed(free, self.phase, self.mesh, rng) if seed else free
            answer = self._answer(f"only {name}", pairs, begin)
            for _ in range(AGAIN):
                if answer is None:
                    begin = bowed(free, self.phase, self.mesh, rng)
                    answer = self._answer(f"only {name}, bowed", pairs, begin)
            if answer is not None:
                answers.append(answer)
        return superposed(free, answers, self.phase)

    def _components(self) -> dict[str, list[int]]:
        """Pairs by the part that stands in the way: of a structure, or of another vehicle."""
        found: dict[str, list[int]] = {}
        for i, pair in enumerate(self.scenario.pairs(self.phase)):
            found.setdefault(pair.ref_b, []).append(i)
        return found

    def _answer(self, name: str, pairs: Sequence[int], start: Motion) -> Motion | None:
        """With separation rows of these pairs only; None where the solver finds nothing."""
        count = len(self.scenario.pairs(self.phase))
        sites = [site for site in node_sites(self.mesh, count) if site.pair in pairs]
        problem = build(
            self.scenario, self.phase, self.mesh, sites, self.formulation,
            shapes_of=self.shapes_of,
        )  # fmt: skip
        solver = Solver.build(problem, "cold", self.budget)
        begin = Start(start, exact_normals(problem.pairs))
        outcome = solver.solve(self.scenario, begin, backoff_m=self.backoff_m)
        self.report(name, problem, outcome)
        return outcome.motion if outcome.solved else None


def superposed(free: Motion, answers: Sequence[Motion], phase: Phase) -> Motion:
    """``free`` and the sum of what each of the answers does otherwise."""
    states, controls = {}, {}
    for vehicle in phase.vehicles:
        x, u = free.states[vehicle.name], free.controls[vehicle.name]
        x_all = [answer.states[vehicle.name] - x for answer in answers]
        u_all = [answer.controls[vehicle.name] - u for answer in answers]
        states[vehicle.name] = _normalised(vehicle, sum(x_all, x.copy()))
        controls[vehicle.name] = sum(u_all, u.copy())
    longer_s = sum(answer.duration_s - free.duration_s for answer in answers)
    duration_s = np.clip(free.duration_s + longer_s, phase.horizon.min_s, phase.horizon.max_s)
    return Motion(float(duration_s), states, controls)


def bowed(motion: Motion, phase: Phase, mesh: Mesh, rng: np.random.Generator) -> Motion:
    """``motion`` with the positions of every vehicle bowed to a random side, both ends kept."""
    states = dict(motion.states)
    bow = np.sin(np.pi * mesh.point_fractions()) ** 2
    for vehicle in phase.vehicles:
        x, dim = states[vehicle.name].copy(), vehicle.dim
        positions = vehicle.model.pose(x.T).position
        length_m = float(np.linalg.norm(positions[-1] - positions[0]))
        side = BEND * length_m * rng.normal(size=dim)
        for axis, offset in zip("xyz", side, strict=False):
            if f"{axis}_m" in vehicle.model.state_names:
                x[vehicle.model.state_names.index(f"{axis}_m")] += offset * bow
        states[vehicle.name] = x
    return Motion(motion.duration_s, states, motion.controls)


def _normalised(vehicle: Vehicle, x: Array) -> Array:
    """States (nx, points) with unit quaternions; a sum that vanishes is left alone."""
    names = vehicle.model.state_names
    if set(QUATERNION) <= set(names):
        rows = [names.index(name) for name in QUATERNION]
        norm = np.linalg.norm(x[rows], axis=0)
        x[rows] /= np.where(norm > 0.0, norm, 1.0)
    return x
