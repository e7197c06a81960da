"""One plan in a process of its own, and why it missed where it did."""

from __future__ import annotations

import json
import multiprocessing
import os
import signal
import time
from collections import Counter
from contextlib import suppress
from multiprocessing.connection import Connection

from benchmarks.tight3d._scene import Case
from berthing.guess.search import EFFORTS as _EFFORTS

# Here, and not where a child first asks for it: imports are no part of its time.
from berthing.planner import plan
from berthing.result import CERTIFIED, Result
from berthing.scenario.normal import document_sha256
from berthing.scenario.options import SolverOptions

EFFORTS = tuple(_EFFORTS)

LIMIT_S = 30.0
"""Of one plan."""

GRACE_S = 20.0
"""A planner that has not stopped so long after its limit is killed."""


def planned(case: Case, effort: str, limit_s: float) -> dict:
    """Plan a case from no guess: outcome, seconds in the planner, cost, and a miss's cause."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_child, args=(sender, case, effort, limit_s))
    child.start()
    sender.close()
    row = {"outcome": "killed", "seconds": limit_s + GRACE_S, "cause": "did not stop"}
    try:
        if receiver.poll(limit_s + GRACE_S):
            row = json.loads(receiver.recv())
    except EOFError:
        row = {"outcome": "died", "seconds": None, "cause": "the process died"}
    # Its own group: the solves that it began end with it.
    with suppress(ProcessLookupError):
        os.killpg(child.pid, signal.SIGKILL)
    child.join()
    receiver.close()
    known = {
        "family": case.family, "seed": case.seed, "effort": effort, "limit_s": limit_s,
        "sha256": document_sha256(case.document)[:16],
    }  # fmt: skip
    return known | row


def _child(sender: Connection, case: Case, effort: str, limit_s: float) -> None:
    os.setsid()
    scenario = case.scenario()
    began, worked = time.perf_counter(), _worked_s()
    options = SolverOptions(effort=effort, time_limit_s=limit_s)
    result = plan(scenario, options=options)
    spent = {
        "seconds": round(time.perf_counter() - began, 3), "cpu_s": round(_worked_s() - worked, 3)
    }  # fmt: skip
    sender.send(json.dumps({"outcome": result.outcome} | spent | _row(result)))
    sender.close()


def _worked_s() -> float:
    """Processor time of this process and of its children that have ended."""
    return sum(os.times()[:4])


def _row(result: Result) -> dict:
    guesses = [a for a in result.attempts if ", round" not in a.guess]
    row: dict = {
        "guesses": len(guesses), "answers": sum(a.cost is not None for a in guesses),
        "tried": [f"{a.guess}: {a.outcome}, {a.iterations}" for a in result.attempts],
    }  # fmt: skip
    if result.plan is not None and result.verification is not None:
        row["cost"] = float(f"{result.plan.cost:.6g}")
        row["stages"] = {k: round(v, 2) for k, v in result.plan.wall_time_s.items()}
        row["bound_m"] = round(result.verification.clearance_lower_bound_m, 6)
    if result.outcome != CERTIFIED:
        row["cause"] = _cause(result)
    return row


def _cause(result: Result) -> str:
    """In a few words: no answer from any guess, or what the refinement or the check ended on."""
    if result.verification is not None:
        return f"plan not certified: {'; '.join(result.verification.reasons[:2])}"
    rounds = [a for a in result.attempts if ", round" in a.guess]
    if rounds:
        last = rounds[-1]
        return f"refinement ended: {last.guess}: {last.outcome}, {last.note}"
    counts = Counter(a.outcome for a in result.attempts)
    told = ", ".join(f"{n} {what}" for what, n in counts.most_common())
    if counts["solved"]:
        return f"no answer of a guess was refined: {told}"
    return f"no guess led to an answer: {told or 'none ended in time'}"
