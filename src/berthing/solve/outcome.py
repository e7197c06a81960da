"""What came of one solve: an answer, or why there is none and what to try."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.geometry.arrays import Array
from berthing.transcription.problem import Motion

SOLVED = "solved"
LOCALLY_INFEASIBLE = "locally_infeasible"
ITERATION_LIMIT = "iteration_limit"
TIME_LIMIT = "time_limit"
NOT_CONVERGED = "not_converged"

# "Acceptable" means that IPOPT stalled short of its tolerance: no solution is claimed.
STATUS = {
    "Solve_Succeeded": SOLVED,
    "Solved_To_Acceptable_Level": NOT_CONVERGED,
    "Infeasible_Problem_Detected": LOCALLY_INFEASIBLE,
    "Maximum_Iterations_Exceeded": ITERATION_LIMIT,
    "Maximum_CpuTime_Exceeded": TIME_LIMIT,
    "Maximum_WallTime_Exceeded": TIME_LIMIT,
}

ADVICE = {
    SOLVED: "",
    LOCALLY_INFEASIBLE: (
        "no way through from this guess; try another seed, a longer horizon or a smaller margin"
    ),
    ITERATION_LIMIT: "the solver wandered; try another seed or other nodes",
    TIME_LIMIT: "raise --time-limit",
    NOT_CONVERGED: "the solver stalled; try another seed or more nodes",
}


@dataclass(frozen=True)
class Outcome:
    """One solve, free of casadi objects so that it passes between processes.

    Attributes:
        status: ``solved`` or a reason.
        x, multipliers, bound_multipliers: vectors at the end, whatever the status.
        motion: the same in physical units.
        cost: in physical units, regulariser excluded.
        worst_row: name and amount of the row that is violated most.
    """

    status: str
    x: Array
    multipliers: Array
    bound_multipliers: Array
    parameters: Array
    motion: Motion
    cost: float
    iterations: int
    wall_time_s: float
    worst_row: str

    @property
    def solved(self) -> bool:
        return self.status == SOLVED

    @property
    def advice(self) -> str:
        return ADVICE[self.status]
