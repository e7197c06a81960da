"""OMPL's RRT* in SE(3), planned out of the berth, where the only way is narrow at first."""

import numpy as np

import berthing as bt
from berthing.routes.ompl_problem import OmplProblem, ompl

RANGE_M, BIAS, SEED = 1.0, 0.3, 1
SLICE_S, SLICES = 4.0, 30


def main():
    ompl("util").setLogLevel(ompl("util").LOG_WARN)
    ompl("util").RNG.setSeed(SEED)
    problem = OmplProblem(bt.load("scenario-b-tight"))
    setup = ompl("geometric").SimpleSetup(problem.information)
    home, berth = problem.state(problem.start), problem.state(problem.goal)
    setup.setStartAndGoalStates(berth, home)
    planner = ompl("geometric").RRTstar(problem.information)
    planner.setRange(RANGE_M)
    planner.setGoalBias(BIAS)
    setup.setPlanner(planner)
    for _ in range(SLICES):  # it goes on where it stopped
        setup.solve(SLICE_S)
        if setup.haveExactSolutionPath():
            break
    path = setup.getSolutionPath()
    states = problem.path(path)[::-1]  # flown the other way
    legs = problem.checker.legs(states)
    assert np.allclose(states[0], problem.start)
    assert np.allclose(states[-1], problem.goal)
    assert legs.certified
    print(f"{len(states)} states, {path.length():.1f} m: certified")


if __name__ == "__main__":
    main()
