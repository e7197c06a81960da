"""Planes shared by neighbouring sites leave no corner to step through."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.solve.ipopt import Solver
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build, states_at
from berthing.transcription.sites import Site, node_sites
from berthing.transcription.sweeps import longest_step, neighbours
from support.documents import DURATION_S, box, puck, scenario, structure
from support.solving import BACKOFF_M, Solved, start_of

MARGIN_M = 0.1
MESH = Mesh.uniform("lgr", 4, 4)
FINE = np.linspace(0.0, DURATION_S, 4001)
SPACING = 0.02
SITES = sorted(Site(*MESH.locate(0.2 + SPACING * i), 0) for i in range(30))
"""Every two seconds while the way is blocked."""


def posed(within: float, formulation: str = "plane") -> Problem:
    # The square's corner is in the way, and a plane turns by 45° at it.
    square = structure("square", [3, 0], box(1.4, 1.4), angle_rad=0.7)
    given = scenario(puck(), structures=[square], margin_m=MARGIN_M)
    phase = given.phases[0]
    return build(given, phase, MESH, SITES, formulation, sweep_within=within)


def answered(problem: Problem) -> Solved:
    solver = Solver.build(problem)
    outcome = solver.solve(problem.scenario, start_of(problem, 1), backoff_m=BACKOFF_M)
    assert outcome.solved
    return Solved(problem, outcome)


@pytest.fixture(scope="module")
def swept() -> Solved:
    return answered(posed(1.2 * SPACING))


@pytest.fixture(scope="module")
def apart() -> Solved:
    return answered(posed(0.0))


def bound_of(problem: Problem, planes: Array, states: Array, i: int, j: int) -> float:
    """What the plane of site i proves at site j, by numbers alone."""
    pair, site = problem.pairs[0], problem.separation.sites[j]
    x = states_at(problem.mesh, states, [(site.segment, site.s)])[0]
    puck_pose = Pose(x[:2], np.eye(2))
    square = pair.owner_b.motion.pose(np.zeros(1))[0]
    n = square.rotate(planes[i][:2])
    return float(plane_bound(pair.part_a.shape, puck_pose, pair.part_b.shape, square, n))


def planes_of(found: Solved) -> Array:
    values = found.problem.layout.variables.split(found.outcome.x)
    return np.array([values[block].ravel() for block in found.problem.separation.blocks])


def test_neighbours_are_of_one_pair_and_near_in_time() -> None:
    mesh = Mesh.uniform("lgr", 2, 3)
    sites = [Site(0, 0.0, 0), Site(0, 0.9, 0), Site(1, -0.95, 0), Site(1, 0.9, 0), Site(0, 0.05, 1)]
    # 0.475 and 0.5125 of the phase are near across the break, 0.25 and 0.475 are not.
    assert neighbours(sites, mesh, 0.1) == [(1, 2)]
    assert neighbours(sites, mesh, 0.3) == [(0, 1), (1, 2)]
    assert neighbours(list(reversed(sites)), mesh, 0.1) == [(3, 2)]
    assert neighbours(sites, mesh, 0.0) == []


def test_every_two_neighbours_share_the_plane_of_the_first(swept, apart) -> None:
    problem = swept.problem
    assert [(s.first, s.last) for s in problem.sweeps] == [(i, i + 1) for i in range(29)]
    assert apart.problem.sweeps == ()
    planes, states = planes_of(swept), swept.outcome.motion.states["puck"]
    for sweep in problem.sweeps:
        for j in (sweep.first, sweep.last):
            bound = bound_of(problem, planes, states, sweep.first, j)
            assert bound >= MARGIN_M + BACKOFF_M - 1e-6
    # Without the rows a plane does not last until the next site.
    planes, states = planes_of(apart), apart.outcome.motion.states["puck"]
    lasting = [bound_of(apart.problem, planes, states, i, i + 1) for i in range(29)]
    assert np.min(lasting) < MARGIN_M - 1e-3


def clearance(found: Solved) -> float:
    own, pair = found.trajectory.vehicles[0].state(FINE), found.problem.pairs[0]
    square = pair.owner_b.motion.pose(np.zeros(1))[0]
    local = np.abs(square.unrotate(own[:, :2] - square.position))
    outside = np.linalg.norm(np.maximum(local - 0.7, 0.0), axis=1)
    return float(np.min(outside)) - 0.5


def test_between_the_sites_only_the_bending_of_the_motion_is_lost(swept, apart) -> None:
    # a h²/8 with h = 2 s and the accelerations that this takes.
    bend = np.max(np.abs(swept.outcome.motion.controls["puck"])) / 2.0 * np.sqrt(2.0) * 0.5
    assert clearance(swept) >= MARGIN_M + BACKOFF_M - bend
    assert clearance(swept) > clearance(apart)
    # It costs a little, for a plane that lasts is not the best at either end.
    assert apart.outcome.cost < swept.outcome.cost < 1.1 * apart.outcome.cost


def test_rows_start_tight_and_are_named() -> None:
    problem = posed(1.2 * SPACING)
    start = start_of(problem, 1)
    x = start.vector(problem, problem.scenario)
    p = problem.parameter_vector(problem.scenario, BACKOFF_M, DURATION_S)
    g = np.asarray(problem.nlp["jac_g"](x, p)[0]).ravel() * problem.layout.scale.length_m
    values = problem.layout.variables.split(x)
    planes = np.array([values[block].ravel() for block in problem.separation.blocks])
    for sweep in problem.sweeps:
        states = start.motion.states["puck"]
        bound = bound_of(problem, planes, states, sweep.first, sweep.last)
        assert g[sweep.row] + MARGIN_M + BACKOFF_M == pytest.approx(bound, abs=1e-9)
    names = {block.label(0) for block in problem.layout.rows.blocks}
    assert "separation[puck.rim, square.core, until t = 22.0 s]" in names


def test_formulations_without_planes_have_no_sweeps() -> None:
    assert posed(1.2 * SPACING, "kkt").sweeps == ()


@pytest.mark.parametrize("scheme", ["lgr", "lgl"])
def test_the_longest_step_joins_all_nodes_and_no_more(scheme: str) -> None:
    mesh = Mesh(scheme, (0.0, 0.3, 1.0), (3, 5))
    sites = node_sites(mesh, 2)
    step = longest_step(mesh)
    assert len(neighbours(sites, mesh, step)) == len(sites) - 2
    assert len(neighbours(sites, mesh, 0.999 * step)) < len(sites) - 2
