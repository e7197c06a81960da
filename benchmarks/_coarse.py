"""The coarse problem that formulations are compared on."""

from __future__ import annotations

from berthing.planner import COARSE_SEGMENTS, DEGREE
from berthing.scenario.scenario import Scenario
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build
from berthing.transcription.sites import node_sites


def coarse_problem(scenario: Scenario, formulation: str) -> Problem:
    """On the planner's coarse mesh, with rows at every node."""
    (phase,) = scenario.phases
    mesh = Mesh.uniform("lgr", COARSE_SEGMENTS, DEGREE)
    sites = node_sites(mesh, len(scenario.pairs(phase)))
    return build(scenario, phase, mesh, sites, formulation)
