"""Commands that keep to a plan: linear-quadratic tracking, flown once and written down.

Commands that merely average the plan's controls drift off it, a little more with every interval.
Each is therefore corrected by what the state is off by when it is given, so that the commands,
flown with no feedback at all, follow the plan and meet its end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from berthing.flight.holds import Hold
from berthing.flight.step import Stepper
from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.trajectory import Segment

OFF = 3e-5
"""Of a pose's range: being off by this costs as much as a correction of ``CORRECTION``."""

CORRECTION = 0.03
"""Of the largest command."""

RATES = 0.1
"""How much less than poses rates matter: a held command is late by half its interval, and what
keeps the position must let the velocity be off a little."""

AT_THE_END = 1e8
"""How much more the last state weighs: goals are met to a micrometre."""


@dataclass(frozen=True)
class Reference:
    """What is to be tracked.

    Attributes:
        times_s: samples (n + 1,). states: of the plan there (n + 1, nx).
        commands: those that average its controls (n + 1, nu).
        weights: of the states (nx,), one where the pose depends on it.
    """

    times_s: Array
    states: Array
    commands: Array
    weights: Array


@dataclass(frozen=True)
class _Law:
    """v = −gain (z, v₋) − bias: the correction from the error z and the correction before it."""

    gain: Array
    bias: Array


def tracked(
    stepper: Stepper, hold: Hold, plan: Reference, limits: tuple[Array, Array]
) -> list[Segment]:
    """What flies under corrected commands, which stay within the limits (nu,) each."""
    first, laws = _laws(stepper, hold, plan)
    lower, upper = limits
    commands = plan.commands.copy()
    x, segments = plan.states[0], list[Segment]()
    commands[0] = np.clip(commands[0] + (first if hold.ends else 0.0), lower, upper)
    for k, law in enumerate(laws):
        before = commands[k] - plan.commands[k] if hold.ends else np.zeros(len(lower))
        off = np.concatenate([x - plan.states[k], before])
        place = k + 1 if hold.ends else k
        correction = -law.gain @ off - law.bias
        commands[place] = np.clip(plan.commands[place] + correction, lower, upper)
        t0, t1 = map(float, plan.times_s[k : k + 2])
        second = commands[k + 1] if hold.ends else commands[k]
        segments += stepper.pieces(hold, t0, t1, x, commands[k], second)
        x = segments[-1].state.sum(axis=0)
    return segments


def _laws(stepper: Stepper, hold: Hold, plan: Reference) -> tuple[Array, list[_Law]]:
    """The first correction and the law of each interval, by Riccati's recursion backwards.

    With y = (z, v₋, 1) and the correction w, the error obeys y₊ = F y + G w; the least cost to go
    from y is yᵀ P y.
    """
    nx, nu = plan.states.shape[1], plan.commands.shape[1]
    off, correction = _weights(plan)
    P = np.diag(np.concatenate([AT_THE_END * off, np.zeros(nu + 1)]))
    laws: list[_Law] = []
    for F, G in _backwards(stepper, hold, plan):
        PG = P @ G
        solve = _solved(np.diag(correction) + G.T @ PG, PG.T @ F)
        P = F.T @ P @ F - F.T @ PG @ solve + np.diag(np.concatenate([off, np.zeros(nu + 1)]))
        P = 0.5 * (P + P.T)
        laws.append(_Law(solve[:, : nx + nu], solve[:, -1]))
    v = slice(nx, nx + nu)
    first = _solved(np.diag(correction) + P[v, v], -P[v, -1])
    return first, laws[::-1]


def _solved(matrix: Array, right: Array) -> Array:
    return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)


def _backwards(stepper: Stepper, hold: Hold, plan: Reference) -> Iterator[tuple[Array, Array]]:
    """F and G of the intervals, the last first."""
    nx, nu = plan.states.shape[1], plan.commands.shape[1]
    for k in range(len(plan.times_s) - 2, -1, -1):
        t0, t1 = map(float, plan.times_s[k : k + 2])
        here, there = plan.commands[k], plan.commands[k + 1 if hold.ends else k]
        x = plan.states[k]
        end = stepper.pieces(hold, t0, t1, x, here, there)[-1].state.sum(axis=0)
        in_x, in_here, in_there = stepper.derivatives(t0, t1, x, here, there)
        F, G = np.zeros((nx + nu + 1, nx + nu + 1)), np.zeros((nx + nu + 1, nu))
        F[:nx, :nx], F[:nx, -1], F[-1, -1] = in_x, end - plan.states[k + 1], 1.0
        if hold.ends:
            F[:nx, nx : nx + nu] = in_here
        G[:nx] = in_there if hold.ends else in_here + in_there
        G[nx : nx + nu] = np.eye(nu)
        yield F, G


def weights(model: Model, x: Array) -> Array:
    """1 for the states that the pose depends on at x (nx,), ``RATES`` for the others."""
    here = model.pose(x)
    out = np.full(len(x), RATES)
    for i in range(len(x)):
        moved = model.pose(x + 1e-3 * (np.arange(len(x)) == i))
        same = np.array_equal(moved.position, here.position)
        if not (same and np.array_equal(moved.rotation, here.rotation)):
            out[i] = 1.0
    return out


def _weights(plan: Reference) -> tuple[Array, Array]:
    """Of squared errors (nx,) and corrections (nu,)."""
    span = np.ptp(plan.states, axis=0)
    # States that hardly move count as the largest of those that do.
    span = np.where(span > 1e-3 * np.max(span), span, max(float(np.max(span)), 1e-9))
    largest = np.max(np.abs(plan.commands), axis=0)
    largest = np.where(largest > 1e-3 * np.max(largest), largest, max(float(np.max(largest)), 1e-9))
    return (plan.weights / (OFF * span)) ** 2.0, (CORRECTION * largest) ** -2.0
