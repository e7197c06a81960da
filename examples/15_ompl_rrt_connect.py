"""OMPL's RRT-Connect in SE(3), every motion of it certified, through a narrow mouth."""

import berthing as bt
from berthing.routes.ompl_problem import OmplProblem, ompl

RANGE_M, SEED, LONGEST_S = 1.0, 1, 60.0


def main():
    ompl("util").setLogLevel(ompl("util").LOG_WARN)
    ompl("util").RNG.setSeed(SEED)
    problem = OmplProblem(bt.load("scenario-b-tight"))
    setup = problem.setup()
    planner = ompl("geometric").RRTConnect(problem.information)
    planner.setRange(RANGE_M)
    setup.setPlanner(planner)
    setup.solve(LONGEST_S)
    assert setup.haveExactSolutionPath()
    states = problem.path(setup.getSolutionPath())
    legs = problem.checker.legs(states)
    assert legs.certified
    print(f"{len(states)} states, clearance at least {min(legs.bound_m):.4f} m: certified")


if __name__ == "__main__":
    main()
