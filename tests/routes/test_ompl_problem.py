import numpy as np
import pytest

import berthing as bt
from berthing.errors import InputError
from berthing.routes import ompl_problem
from berthing.routes.ompl_problem import OmplProblem, ompl
from berthing.routes.space import between
from support import hand_made

CASES = ["scenario-b-tight", "piano-mover", "point-mass-2d", "point-mass-3d", "two-vehicles-swap"]


def drawn(problem, count=6):
    rng = np.random.default_rng(5)
    low, high = np.full(3, -2.0), np.full(3, 2.0)
    return [problem.checker.space.sample(rng, low, high) for _ in range(count)]


def rows(problem, state):
    return problem._answers.rows(state)


def same(one, other):
    """States whose attitudes agree up to the sign of the quaternion."""
    dots = np.abs(np.sum(one[:, 3:] * other[:, 3:], axis=1))
    return np.allclose(one[:, :3], other[:, :3]) and np.allclose(dots, 1.0)


@pytest.mark.parametrize("name", CASES)
def test_states_are_the_same_on_both_sides(name):
    problem = OmplProblem(bt.load(name))
    for state in (problem.start, problem.goal, *drawn(problem)):
        there = problem.state(state)
        assert same(rows(problem, there), state)
        assert problem.information.isValid(there) == problem.checker.valid_state(state)


@pytest.mark.parametrize("name", CASES)
def test_what_is_certified_is_what_ompl_interpolates(name):
    problem = OmplProblem(bt.load(name))
    one, other = drawn(problem, 2)
    middle = problem.space.allocState()
    for fraction in (0.25, 0.5, 0.9):
        problem.space.interpolate(problem.state(one), problem.state(other), fraction, middle)
        assert same(rows(problem, middle), between(one, other, np.array([fraction]))[0])


def sheet_between():
    """A wall of 0.2 mm between start and goal, which no sampling of some length sees."""
    wall = hand_made.structure(
        bt.Box(np.array([1e-4, 3.0, 3.0])), at=[hand_made.placed([1.2345, 0.0, 0.0])]
    )
    craft = hand_made.vehicle(bt.Sphere(0.01), goal=bt.End(np.array([4.0, 0.0, 0.0])))
    return hand_made.scenario([craft], [wall], margins=1e-4)


def test_motions_are_proven_where_samples_see_nothing():
    for certified in (True, False):
        problem = OmplProblem(sheet_between(), certified=certified)
        ends = problem.state(problem.start), problem.state(problem.goal)
        assert all(problem.information.isValid(end) for end in ends)
        assert problem.information.checkMotion(*ends) == (not certified)


def test_a_motion_of_half_a_turn_is_not_valid():
    problem = OmplProblem(bt.load("scenario-b"))
    turned = problem.start.copy()
    turned[0, 3:] = [0.0, 1.0, 0.0, 0.0]
    assert not problem.information.checkMotion(problem.state(problem.start), problem.state(turned))
    assert problem.information.checkMotion(
        problem.state(problem.start), problem.state(problem.start)
    )


def test_a_planner_finds_a_way_in_the_plane_that_is_certified():
    problem = OmplProblem(bt.load("point-mass-2d"))
    setup = problem.setup()
    setup.setPlanner(ompl("geometric").RRTConnect(problem.information))
    setup.solve(30.0)
    assert setup.haveExactSolutionPath()
    states = problem.path(setup.getSolutionPath())
    assert problem.checker.legs(states).certified
    assert np.allclose(states[[0, -1]], [problem.start, problem.goal])


def test_what_moves_is_refused_and_what_is_missing_named(monkeypatch):
    with pytest.raises(InputError, match="moves"):
        OmplProblem(bt.load("spinning-structure"))

    def missing(name):
        raise ModuleNotFoundError(name=name.split(".")[0])

    monkeypatch.setattr(ompl_problem, "import_module", missing)
    with pytest.raises(InputError, match=r"berthing\[ompl\]"):
        OmplProblem(bt.load("scenario-b"))
