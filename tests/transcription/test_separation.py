"""Separation rows: what they state, where they hold, and where they do not reach."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.solve.ipopt import Solver, Start
from berthing.transcription import extract
from berthing.transcription.problem import Motion, Problem, build, states_at
from berthing.transcription.sites import Site, node_sites, site_times
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure
from support.solving import BACKOFF_M, Solved, guessed, posed, solved, start_of

MARGIN_M = 0.1

TWO_PARTS = [
    {"name": "hull", "shape": box(4, 2, 2)},
    {"name": "boom", "shape": {"type": "cylinder", "radius_m": 0.2, "length_m": 3},
     "position_m": [0, 2, 0.5], "attitude": [0.8, 0, 0, 0.6]},
]  # fmt: skip


def busy() -> Scenario:
    """Everything at once: parts off their owner's frame, and structures that move."""
    truss = {
        "name": "truss",
        "parts": [
            {"name": "bay", "shape": {"type": "sphere", "radius_m": 0.7}, "position_m": [1, 0, 2]},
            {"name": "wedge", "position_m": [-1, 0, 0], "attitude": [0.6, 0, 0.8, 0],
             "shape": {"type": "polytope", "vertices_m": [[0, 0, 0], [1, 0, 0], [0, 1, 0],
                                                          [0, 0, 1]]}},
        ],
        "position_m": [5, -6, 4], "attitude": [0.5, 0.5, 0.5, -0.5],
        "motion": {"type": "spin", "rate_rad_s": 0.02, "velocity_m_s": [0, 0.01, 0]},
    }  # fmt: skip
    drone = spacecraft(
        "drone", parts=[{"name": "hull", "shape": box(1, 1, 1)}],
        start={"position_m": [0, 8, 0]}, goal={"position_m": [10, 9, 0]},
    )  # fmt: skip
    lead = spacecraft(
        parts=TWO_PARTS, goal={"position_m": [10, 3, 0], "attitude": [0.6, 0.8, 0, 0]}
    )
    return scenario(lead, drone, structures=[truss], margin_m=MARGIN_M)


def true_distances(problem: Problem, motion: Motion) -> Array:
    """Exact distance of each site's pair, by the numeric poses alone."""
    sites = problem.separation.sites
    times = site_times(list(sites), problem.mesh, 0.0, motion.duration_s)
    out = []
    for site, t in zip(sites, times, strict=True):
        pair, poses = problem.pairs[site.pair], []
        for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b)):
            if isinstance(owner, Structure):
                pose: Pose = owner.motion.pose(np.array([t]))[0]
            else:
                place = [(site.segment, site.s)]
                x = states_at(problem.mesh, motion.states[owner.name], place)[0]
                pose = owner.model.pose(x)
            poses.append(pose.compose(part.placement))
        out.append(PairQuery(pair.part_a.shape, pair.part_b.shape).query(*poses).distance)
    return np.array(out)


def test_rows_at_the_start_are_the_true_distances_of_all_pairs() -> None:
    given = busy()
    mesh_sites = node_sites(posed(given, 2, 3, sites=[]).mesh, len(given.pairs(given.phases[0])))
    between = [Site(k, s, pair) for k in (0, 1) for s in (-0.43, 0.71) for pair in range(8)]
    problem = posed(given, 2, 3, sorted([*mesh_sites, *between]))
    assert len(problem.pairs) == 8
    start = start_of(problem)
    x = start.vector(problem, given)
    p = problem.parameter_vector(given, BACKOFF_M, DURATION_S)
    g = np.asarray(problem.nlp["jac_g"](x, p)[0]).ravel()
    stated = g[list(problem.separation.rows)] * problem.layout.scale.length_m
    distances = true_distances(problem, start.motion)
    assert np.all(distances > 0.0)
    np.testing.assert_allclose(stated + MARGIN_M + BACKOFF_M, distances, atol=1e-6)
    # And they all differ, so that no two rows were mixed up.
    assert len(np.unique(np.round(distances, 6))) > 0.9 * len(distances)


def test_poses_between_the_nodes_start_on_the_polynomial() -> None:
    given = busy()
    problem = posed(given, 2, 3, [Site(0, -0.43, 0), Site(0, -0.43, 1), Site(1, 0.2, 7)])
    lifted = problem.separation.lifted
    # Pairs at one place share it; the last pair is of two vehicles, of which each has its own.
    assert set(lifted) == {("spacecraft", 0, -0.43), ("spacecraft", 1, 0.2), ("drone", 1, 0.2)}
    start = start_of(problem)
    x = start.vector(problem, given)
    g = np.asarray(problem.nlp["jac_g"](x, problem.parameter_vector(given, 0.0, 100.0))[0]).ravel()
    rows = [b for b in problem.layout.rows.blocks if b.label(0).startswith("interpolation")]
    assert sum(block.size for block in rows) == 3 * 7
    for block in rows:
        np.testing.assert_allclose(g[block.offset : block.offset + block.size], 0.0, atol=1e-14)
    moved = x.copy()
    moved[problem.layout.variables.blocks["main/drone/state"].indices[0]] += 0.1
    g = np.asarray(problem.nlp["jac_g"](moved, problem.parameter_vector(given, 0.0, 100.0))[0])
    assert np.max(np.abs(g.ravel()[rows[-1].offset : rows[-1].offset + 7])) > 0.05


POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})


@pytest.fixture(scope="module")
def around() -> Solved:
    """A disc past a post, rows at the nodes of a coarse mesh."""
    found = solved(scenario(puck(), structures=[POST]), 4, 3, guess=1)
    assert found.outcome.solved
    return found


def sampled(found: Solved, times: Array) -> Array:
    own = found.trajectory.vehicles[0].state(times)
    return np.linalg.norm(own[:, :2] - [3.0, 0.1], axis=1) - 0.6 - 0.5


def test_the_margin_holds_at_the_nodes_and_is_reached(around) -> None:
    nodes = around.nodes[0].times_s
    distances = sampled(around, nodes)
    assert np.min(distances) == pytest.approx(MARGIN_M + BACKOFF_M, abs=1e-5)


def test_between_the_nodes_it_does_not_until_there_is_a_row(around) -> None:
    fine = np.linspace(0.0, DURATION_S, 2001)
    before = sampled(around, fine)
    assert np.min(before) < MARGIN_M - 0.02
    t = float(fine[np.argmin(before)])
    problem = around.problem
    site = Site(*problem.mesh.locate(t / DURATION_S), 0)
    more = posed(problem.scenario, 4, 3, sorted([*problem.separation.sites, site]))
    start = Start(around.outcome.motion, start_of(more).normals)
    outcome = Solver.build(more, "near").solve(problem.scenario, start, backoff_m=BACKOFF_M)
    assert outcome.solved
    assert sampled(Solved(more, outcome), np.array([t]))[0] >= MARGIN_M + BACKOFF_M - 1e-7
    assert outcome.cost > around.outcome.cost


def test_rows_are_named_by_pair_and_time_and_short_by_metres(around) -> None:
    problem, motion = around.problem, guessed(around.problem)
    x = Start(motion, start_of(problem).normals).vector(problem, problem.scenario)
    p = problem.parameter_vector(problem.scenario, BACKOFF_M, DURATION_S)
    g = np.asarray(problem.nlp["jac_g"](x, p)[0]).ravel()
    # The straight line goes through the post: only separation is violated at its start, the
    # dynamics aside.
    lower, upper = problem.layout.rows.bounds()
    for block in problem.layout.rows.blocks:
        if not block.label(0).startswith("separation"):
            part = slice(block.offset, block.offset + block.size)
            g[part] = np.clip(g[part], lower[part], upper[part])
    worst = problem.layout.rows.worst(g)
    assert worst.startswith("separation[puck.rim, post.core, t = ")
    t = float(worst.split("t = ")[1].split(" s]")[0])
    short = float(worst.split("short by ")[1].removesuffix(" m"))
    place = extract.trajectories(problem, motion).vehicles[0].state(np.array([t]))[0, :2]
    true = np.linalg.norm(place - [3.0, 0.1]) - 1.1
    assert short == pytest.approx(MARGIN_M + BACKOFF_M - true, abs=0.01)


def test_two_vehicles_keep_apart() -> None:
    other = puck("other", start={"position_m": [6, 0.2]}, goal={"position_m": [0, 0.2]})
    given = scenario(puck(), other)
    guess = 1
    found = solved(given, 4, 3, guess=guess)
    assert found.outcome.solved
    states = found.outcome.motion.states
    gaps = np.linalg.norm(states["puck"][:2] - states["other"][:2], axis=0) - 1.0
    assert np.min(gaps) == pytest.approx(MARGIN_M + BACKOFF_M, abs=1e-5)
    alone = solved(given, 4, 3, guess=guess, sites=[])
    states = alone.outcome.motion.states
    assert np.min(np.linalg.norm(states["puck"][:2] - states["other"][:2], axis=0) - 1.0) < -0.3


WALL = structure("wall", [7.5, 0], box(2, 4))
TOUCH = {"between": ["puck", "wall"], "contact": "allowed", "window_s": [80, 100]}


def berthed(overrides: list[dict[str, object]]) -> Solved:
    vehicle = puck(goal={"position_m": [6, 0]})
    margins = {"default_m": MARGIN_M, "overrides": overrides}
    return solved(scenario(vehicle, structures=[WALL], margins=margins), 4, 3, iterations=100)


def test_a_goal_in_contact_is_reached_where_contact_is_allowed() -> None:
    found = berthed([TOUCH])
    assert found.outcome.solved
    margins = found.problem.layout.parameters.split(found.outcome.parameters)["main/margins_m"]
    in_force = np.unique(np.round(margins, 9))
    # Below zero, where a normal of zero holds the row with room to spare.
    assert in_force[0] < -1.0
    np.testing.assert_allclose(in_force[1:], MARGIN_M + BACKOFF_M)
    times = found.nodes[0].times_s
    gaps = 6.5 - 0.5 - found.outcome.motion.states["puck"][0]
    assert gaps[-1] == pytest.approx(0.0, abs=1e-7)
    outside = gaps[times < 80.0]
    assert np.min(outside) >= MARGIN_M + BACKOFF_M - 1e-6


def test_where_it_is_not_the_margin_stands_in_the_way() -> None:
    found = berthed([])
    assert not found.outcome.solved
    assert found.outcome.worst_row.startswith("separation[puck.rim, wall.core, t = ")


def test_the_regulariser_moves_the_cost_little_and_is_no_part_of_it(around) -> None:
    problem = around.problem
    less = build(
        problem.scenario, problem.phase, problem.mesh, problem.separation.sites, "plane",
        regulariser=1e-6,
    )  # fmt: skip
    start = Start(around.outcome.motion, start_of(less).normals)
    outcome = Solver.build(less, "near").solve(problem.scenario, start, backoff_m=BACKOFF_M)
    assert outcome.solved
    assert around.outcome.cost == pytest.approx(outcome.cost, rel=1e-3)
    scaled = float(problem.nlp["grad_f"](around.outcome.x, around.outcome.parameters)[0])
    assert scaled * problem.layout.scale.cost > around.outcome.cost


def test_no_sites_no_rows() -> None:
    problem = posed(scenario(puck(), structures=[POST]), 2, 3, sites=[])
    assert problem.separation == replace(problem.separation, sites=(), blocks=(), rows=())
    assert problem.separation.lifted == {}
