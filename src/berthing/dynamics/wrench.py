"""Known wrenches of the manipulators as functions of time."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from berthing.scenario.wrench import Wrench
from berthing.sym import Sym


def wrench_expression(wrenches: Sequence[Wrench], t: Sym) -> Sym:
    """Σ (f_m, g_m + ρ_m × f_m) (6,) about the reference point, linear between the table's times."""
    total: Sym = ca.DM.zeros(6)
    for wrench in wrenches:
        torque = wrench.torque_nm + np.cross(wrench.point_m, wrench.force_n)
        table = np.hstack([wrench.force_n, torque])
        total = total + ca.vertcat(*(linear_table(t, wrench.times_s, column) for column in table.T))
    return total


def linear_table(t: Sym, times_s: np.ndarray, values: np.ndarray) -> Sym:
    """Piecewise linear through (times_s, values), constant outside."""
    value: Sym = float(values[0])
    for t0, t1, v0, v1 in zip(times_s[:-1], times_s[1:], values[:-1], values[1:], strict=True):
        # A sum of clamped ramps is the table, and constant outside it.
        ramp = ca.fmin(ca.fmax((t - t0) / (t1 - t0), 0.0), 1.0)
        value = value + (float(v1) - float(v0)) * ramp
    return value
