"""From vectors to trajectories and nodes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from berthing.transcription import extract
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build
from berthing.verify.equations import derivative
from support.documents import DURATION_S, scenario, spacecraft
from support.solving import Solved, guessed, posed, solved

TURNING = spacecraft(
    dynamics={
        "model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [4, 5, 6],
        "first_moment_kg_m": [0.6, 0.3, 0],
        "wrenches": [{"name": "arm", "point_m": [1, 0, 0], "times_s": [0, 100],
                      "force_n": [[0, 0.002, 0], [0, -0.002, 0.001]],
                      "torque_nm": [[0, 0, 0], [0.001, 0, 0]]}],
    },
    goal={"position_m": [4, 1, 0], "attitude": [0.5, 0.5, 0.5, 0.5]},
)  # fmt: skip


@pytest.fixture(scope="module")
def turning() -> Solved:
    found = solved(scenario(TURNING), 4, 7)
    assert found.outcome.solved
    return found


def test_trajectories_pass_through_the_nodes(turning) -> None:
    own, nodes = turning.trajectory.vehicles[0], turning.nodes[0]
    np.testing.assert_allclose(own.state(nodes.times_s), nodes.states, atol=1e-12)
    np.testing.assert_allclose(own.control(nodes.times_s[:-1]), nodes.controls[:-1], atol=1e-12)
    np.testing.assert_allclose(own.breaks_s, np.linspace(0.0, DURATION_S, 5), atol=1e-12)
    assert own.state_names == turning.problem.phase.vehicles[0].model.state_names


def test_the_last_point_has_no_control_and_every_point_a_costate(turning) -> None:
    nodes = turning.nodes[0]
    assert np.isnan(nodes.controls[-1]).all()
    assert np.isfinite(nodes.controls[:-1]).all()
    assert np.isfinite(nodes.costates).all()


def test_the_equations_of_motion_agree_when_flown_independently(turning) -> None:
    # The controls alone, by an adaptive integrator with the check's own equations.
    own, model = turning.trajectory.vehicles[0], turning.problem.phase.vehicles[0].model
    f, states = derivative(model), turning.outcome.motion.states["spacecraft"]
    x = states[:, 0]
    for t0, t1 in pairwise(own.breaks_s):
        # The control may jump where segments meet: the end of each is left out by rounding.
        run = solve_ivp(
            lambda t, x: f(t, x, own.control(np.array([t]))[0]), (t0, t1 - 1e-9), x,
            "DOP853", rtol=1e-9, atol=1e-10,
        )  # fmt: skip
        x = run.y[:, -1]
    np.testing.assert_allclose(x, states[:, -1], atol=2e-6)
    drifted = solve_ivp(lambda t, x: f(t, x, np.zeros(6)), (0.0, DURATION_S), states[:, 0])
    assert np.max(np.abs(drifted.y[:, -1] - states[:, -1])) > 0.1


def test_costates_are_the_slope_of_the_cost(turning) -> None:
    # ∂J/∂x(0) = λ(0), by solving again from a start moved a little.
    step, costates = 1e-3, turning.nodes[0].costates[0]
    for axis in range(2):
        costs = []
        for h in (step, -step):
            moved = TURNING | {"start": {"position_m": [h * (axis == i) for i in range(3)]}}
            costs.append(solved(scenario(moved), 4, 7).outcome.cost)
        slope = (costs[0] - costs[1]) / (2 * step)
        assert slope == pytest.approx(costates[axis], rel=1e-4, abs=1e-9)
        assert abs(slope) > 1e-6


def test_costates_do_not_jump_where_segments_meet(turning) -> None:
    # The end of a segment follows from another row than the start of the next.
    problem = turning.problem
    first, second = problem.defect_rows["spacecraft"][:2]
    nodes = problem.mesh.node_set(0)
    before = -nodes.D[:, -1] @ turning.outcome.multipliers[first]
    after = -turning.outcome.multipliers[second][0] / nodes.weights[0]
    np.testing.assert_allclose(before, after, atol=1e-3 * np.max(np.abs(after)))


def test_a_later_phase_begins_at_its_own_time() -> None:
    given = scenario()
    mesh = Mesh.uniform("lgr", 2, 3)
    problem = build(given, given.phases[0], mesh, [], "plane", t0_s=40.0)
    motion = guessed(posed(given, 2, 3))
    trajectory = extract.trajectories(problem, motion)
    assert (trajectory.t0_s, trajectory.t1_s) == (40.0, 140.0)
    nodes = extract.nodes(problem, motion, np.zeros(problem.layout.rows.size))[0]
    np.testing.assert_allclose(nodes.times_s[[0, -1]], [40.0, 140.0])
