"""What planning hands back, and what it says on the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from berthing.trajectory import Plan

if TYPE_CHECKING:
    from berthing.verify.extremal import Extremality
    from berthing.verify.observed_order import OrderCheck
    from berthing.verify.second_order import SecondOrder
    from berthing.verify.verification import Verification

CERTIFIED = "certified"
NOT_CERTIFIED = "not_certified"
UNDECIDED = "undecided"
LOCALLY_INFEASIBLE = "locally_infeasible"
ITERATION_LIMIT = "iteration_limit"
TIME_LIMIT = "time_limit"
INTERRUPTED = "interrupted"

OUTCOMES = (
    CERTIFIED, NOT_CERTIFIED, UNDECIDED,
    LOCALLY_INFEASIBLE, ITERATION_LIMIT, TIME_LIMIT, INTERRUPTED,
)  # fmt: skip


@dataclass(frozen=True)
class Attempt:
    """One solve that was tried.

    Attributes:
        guess: what it started from, in words: ``straight``, ``over truss.bay3``.
        outcome: how the solver left it.
        nodes, iterations: its size and effort.
        wall_time_s: how long it took.
        cost: in the scenario's units; None where no point was reached.
        clearance_m: the clearance certified or reached; None where unknown.
        note: what went wrong, naming rows: ``separation[spacecraft.hull, dock, t = 61.2 s] short
            by 0.017 m``.
    """

    guess: str
    outcome: str
    nodes: int = 0
    iterations: int = 0
    wall_time_s: float = 0.0
    cost: float | None = None
    clearance_m: float | None = None
    note: str = ""


@dataclass(frozen=True)
class ProgressEvent:
    """What planning is at, for whoever watches.

    Attributes:
        stage: ``guess``, ``solve``, ``refine``, ``verify``, ….
        detail: what of it, in a few words; may be empty.
        iterations: of the solver, so far over all attempts.
        clearance_m: the best clearance bound so far; None where there is none yet.
    """

    stage: str
    detail: str = ""
    iterations: int = 0
    clearance_m: float | None = None


@dataclass(frozen=True)
class Result:
    """The answer to a scenario; a failure is an answer too.

    Attributes:
        outcome: one of ``OUTCOMES``.
        plan: the trajectory; None where none was found.
        verification: the independent check of the plan; None where there is no plan.
        attempts: what was tried, in order.
        advice: what to try next; empty where the plan is certified.
        extremality: residuals of the conditions of optimality; None where they are not known.
        order: how fast the cost settles on finer meshes; None where nobody asked (by a
            tolerance) or a solve failed.
        second_order: whether the programme's answer is a minimum; None where that is not known.
    """

    outcome: str
    plan: Plan | None
    verification: Verification | None
    attempts: tuple[Attempt, ...] = ()
    advice: str = ""
    extremality: Extremality | None = None
    order: OrderCheck | None = None
    second_order: SecondOrder | None = None
