"""The verdict as rows of a table, the same on the terminal and on the page."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from berthing.report.margin_loss import cost_lost
from berthing.result import CERTIFIED, UNDECIDED, Attempt, Result
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.verify.extremal import Extremality
from berthing.verify.observed_order import OrderCheck
from berthing.verify.second_order import SecondOrder
from berthing.verify.verdict import CERTIFIED as PAIR_CERTIFIED
from berthing.verify.verdict import EXEMPT
from berthing.verify.verification import Verification


@dataclass(frozen=True)
class Row:
    """A line of the table.

    Attributes:
        label, value: as read.
        good: None where there is nothing to judge.
        keys: where plan.json has what the value says, a dot between levels.
    """

    label: str
    value: str
    good: bool | None = None
    keys: tuple[str, ...] = ()


def _checked(*names: str) -> tuple[str, ...]:
    return tuple(f"verification.{name}" for name in names)


BOUND, REQUIRED = _checked("clearance_lower_bound_m"), _checked("required_clearance_m")
CLOSEST = _checked("closest_pair", "closest_distance_m", "closest_time_s")
LIMITS, MODEL = _checked("limits_ok"), _checked("model_check")
REPLAY = _checked("replay_position_error_m", "replay_attitude_error_rad")
TUBE = _checked("tube_m")
DRIFT = _checked("hamiltonian_relative_drift")

LOST = ("cost_lost_to_margins",)

WORDS: Mapping[str, str] = {CERTIFIED: "certified", UNDECIDED: "undecided"}


# What flies between samples of the controls.
CONTROLS: Mapping[str, str] = {
    "polynomial": "polynomials, as optimised",
    "linear": "linear over {:g} s at a time",
    "constant": "held for {:g} s at a time",
}


def headline(outcome: str) -> Row:
    """The verdict in a word."""
    return Row("verdict", WORDS.get(outcome, "NOT certified"), outcome == CERTIFIED, ("outcome",))


def verification_rows(verification: Verification) -> list[Row]:
    """What was checked, apart from the solver."""
    v = verification
    clear = all(pair.verdict in (PAIR_CERTIFIED, EXEMPT) for pair in v.pairs)
    off = f"{_metres(v.replay_position_error_m)}, {v.replay_attitude_error_rad:.2g} rad"
    return [
        Row("clearance at every instant", _bound(v.clearance_lower_bound_m), clear, BOUND),
        Row("clearance required", _metres(v.required_clearance_m), None, REQUIRED),
        Row("closest", _closest(v), None, CLOSEST),
        Row("limits between nodes", "met" if v.limits_ok else "EXCEEDED", v.limits_ok, LIMITS),
        Row("start and goal", _missed(v)),
        Row("replay of the controls", f"off by {off} at most", None, REPLAY),
        Row("pose tube", f"{_metres(v.tube_m)} off every bound", None, TUBE),
        Row("Hamiltonian drift", _share(v.hamiltonian_relative_drift), None, DRIFT),
        Row("equations of motion", v.model_check.replace("_", " "), None, MODEL),
    ]


def reason_rows(verification: Verification) -> list[Row]:
    """Why the plan is not certified; none where it is."""
    return [Row("because", reason, False) for reason in verification.reasons]


def plan_rows(plan: Plan, verification: Verification) -> list[Row]:
    """What was found, and at what effort."""
    total = plan.wall_time_s.get("total")
    effort = f"{plan.iterations} iterations" + ("" if total is None else f", {total:.1f} s")
    method = f"{plan.formulation}, {plan.scheme}, {plan.node_count} nodes"
    return [
        Row("cost", f"{plan.cost:.6g}", None, ("cost",)),
        Row("cost of back-off and tube", _lost(plan, verification), None, LOST),
        Row("controls", _controls(plan)),
        Row("method", method, None, ("formulation", "scheme", "nodes")),
        Row("effort", effort, None, ("iterations", "wall_time_s.total")),
        Row("seed", str(plan.seed), None, ("seed",)),
    ]


def optimality_rows(result: Result) -> list[Row]:
    """How nearly the plan meets the conditions of optimality; none where nothing is known."""
    rows = extremality_rows(result.extremality)
    if result.second_order is not None:
        found, key = result.second_order, "optimality.second_order"
        rows.append(Row("second order", _curvature(found), found.minimum, (key,)))
    if result.order is not None:
        wide, narrow = result.order.own.moves
        keys = ("optimality.order_check", "optimality.observed_order")
        rows += [
            Row("cost, mesh halved twice", f"moves by {wide:.1g}, then {narrow:.1g}", None, keys),
            Row("observed order of the cost", _order(result.order), None, keys),
        ]
    return rows


CONDITIONS: Mapping[str, str] = {
    "stationarity": "stationarity of H in the controls",
    "adjoint": "adjoint equations",
    "transversality": "transversality",
    "complementarity": "complementarity",
    "dual": "dual feasibility",
    "primal": "primal feasibility",
}
"""Residuals that are shares of the cost, in words."""


def extremality_rows(found: Extremality | None) -> list[Row]:
    """The residuals of Pontryagin's conditions; none where they are not known."""
    if found is None:
        return []
    near = f"to 1e-{found.digits:.1f}" if found.digits > 0.0 else "not"
    worst = f"{near}: worst is {found.limiting}, {found.worst:.1g} of the cost"
    residuals = found.residuals
    rows = [
        Row(label, f"off by {residuals[key]:.1g} of the cost", None, (f"optimality.{key}",))
        for key, label in CONDITIONS.items()
    ]
    return [Row("Pontryagin extremal", worst, None, ("optimality.worst",)), *rows]


def _curvature(found: SecondOrder) -> str:
    """The inertia of the KKT matrix, as its least favourable reading."""
    n, m = found.variables, found.rows
    inertia = f"inertia ({n - found.negative - found.flat}, {m + found.negative}, {found.flat})"
    if found.minimum:
        return f"a minimum: {inertia}, least curvature above {found.least:.0e}"
    return f"NOT shown to be a minimum: {inertia} in place of ({n}, {m}, 0)"


def _order(found: OrderCheck) -> str:
    shown = found.shown
    if shown is None or shown.order is None:
        return "none to be seen: every mesh gives the same cost"
    coarse, _, fine = shown.segments
    where = f"degree {shown.degree}, {coarse} to {fine} segments"
    return f"{shown.order:.2f} with {where} ({shown.expected} expected of smooth motion)"


def result_rows(scenario: Scenario, result: Result) -> list[Row]:
    """The whole table of a result: of the plan, or of what was tried in vain."""
    rows = [Row("scenario", scenario.name)]
    if result.plan is None or result.verification is None:
        rows.append(Row("verdict", f"no plan found: {result.outcome.replace('_', ' ')}", False))
        rows += [Row("tried", attempt_line(attempt)) for attempt in result.attempts]
    else:
        rows.append(headline(result.outcome))
        rows += [
            *verification_rows(result.verification),
            *plan_rows(result.plan, result.verification),
            *optimality_rows(result),
        ]
        rows += reason_rows(result.verification)
    return [*rows, Row("try next", result.advice)] if result.advice else rows


def attempt_line(attempt: Attempt) -> str:
    """An attempt in one line.

    >>> attempt_line(Attempt("straight", "locally_infeasible", 40, 310, 2.4))
    'straight: locally infeasible after 310 iterations, 2.4 s'
    """
    effort = f"after {attempt.iterations} iterations, {attempt.wall_time_s:.1f} s"
    line = f"{attempt.guess}: {attempt.outcome.replace('_', ' ')} {effort}"
    return f"{line}; {attempt.note}" if attempt.note else line


def _bound(value: float) -> str:
    if value == math.inf:
        return "nothing to keep clear of"
    if value == -math.inf:
        return "nothing proven"
    # Rounded down: the table never claims more than was proven.
    return f"at least {math.floor(value * 1e5) / 1e5:.5f} m"


def _closest(v: Verification) -> str:
    if v.closest_pair is None or v.closest_time_s is None or v.closest_distance_m is None:
        return "–"
    pair = v.closest_pair.replace("|", " – ")
    return f"{pair}, {v.closest_distance_m:.5f} m at {v.closest_time_s:.2f} s"


def _missed(v: Verification) -> str:
    if not v.ends:
        return "not checked"
    position = max(end.position_m for end in v.ends)
    attitude = max(end.attitude_rad for end in v.ends)
    return f"missed by {_metres(position)}, {attitude:.2g} rad at most"


def _metres(value: float) -> str:
    """In metres, or short where that would be zeros."""
    return f"{value:.4f} m" if abs(value) >= 1e-3 or value == 0.0 else f"{value:.2g} m"


def _lost(plan: Plan, verification: Verification) -> str:
    lost = cost_lost(plan, verification)
    if lost is None or not plan.cost:
        return "unknown"
    return f"about {lost:.2g}, {100.0 * lost / plan.cost:.2g} %"


def _controls(plan: Plan) -> str:
    own = plan.phases[0].vehicles[0]
    longest = max(segment.t1_s - segment.t0_s for segment in own.segments)
    return CONTROLS.get(own.control_interpolation, own.control_interpolation).format(longest)


def _share(value: float | None) -> str:
    return "unknown" if value is None else f"{value:.2g} of its mean"
