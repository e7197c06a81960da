"""How long A takes to solve again, from its own answer, when its start has moved."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.guess.candidates import candidates
from berthing.guess.path import motion_along
from berthing.planner import COARSE_SEGMENTS, DEGREE
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer, Solver, Start
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build
from berthing.transcription.separation import Normals
from berthing.transcription.sites import node_sites

SHIFTS_M = ((0.0, 0.15, 0.0), (0.0, -0.15, 0.0), (-0.15, 0.0, 0.0), (0.0, 0.0, 0.15), (0, 0, -0.15))


def resolve_times(scenario: Scenario, normals: Normals, backoff_m: float) -> list[float]:
    """Seconds of every warm solve that ended well."""
    (phase,) = scenario.phases
    mesh = Mesh.uniform("lgr", COARSE_SEGMENTS, DEGREE)
    problem = build(scenario, phase, mesh, node_sites(mesh, len(scenario.pairs(phase))), "plane")
    begin = Start(
        motion_along(candidates(scenario, phase, 0)[0], phase, mesh, phase.horizon.nominal_s),
        normals,
    )
    first = Solver.build(problem, "cold").solve(scenario, begin, backoff_m=backoff_m)
    again, found = Solver.build(problem, "warm"), []
    for shift in SHIFTS_M:
        craft = phase.vehicles[0]
        start = replace(craft.start, position_m=craft.start.position_m + np.array(shift))
        vehicles = (replace(craft, start=start), *phase.vehicles[1:])
        moved = replace(scenario, phases=(replace(phase, vehicles=vehicles),))
        done = again.solve(
            moved, Start(first.motion, normals), backoff_m=backoff_m,
            previous=Answer(problem, first),
        )  # fmt: skip
        if done.solved:
            found.append(done.wall_time_s)
    return found
