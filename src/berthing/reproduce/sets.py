"""Claims about the smoothed sets."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.shape_model import ShapeModel, model_error_m
from berthing.proximity.formulations import formulate
from berthing.proximity.level_functions import LevelFunctions, level_functions
from berthing.reproduce.finding import FAILS, HOLDS, PARTLY, Finding, verdict
from berthing.reproduce.smoothing import corner_error, recession

EXPONENT, D_SAFE_M = 8.0, 0.1
HULL = Box(np.array([2.0, 1.0, 1.0]))
TANK = Cylinder(1.0, 2.0, "x")
INNER = ShapeModel("inner", exponent=EXPONENT)

PAIRS = 4000
"""Pairs of points at which convexity is looked for."""

ROUNDING = 1e-12
SAME = 1e-6
"""Of recessions: as good as equal."""

HUGE = 8e4
"""An exponent whose exponentials are beyond floating-point numbers."""


def findings() -> list[Finding]:
    """All of them, in the order of the paper."""
    return [_convex(), _sharp_enough(), _smaller(), _falls(), _size(), _huge()]


def _midpoints(functions: LevelFunctions, rng: np.random.Generator) -> float:
    """The most by which f at a midpoint exceeds the mean of f at the ends."""
    x, y = 1.5 * rng.normal(size=(2, PAIRS, functions.dim))
    values: list[Array] = [functions.values(s)[0] for s in (x, y, 0.5 * (x + y))]
    return float(np.max(values[2] - 0.5 * (values[0] + values[1])))


def _convex() -> Finding:
    rng = np.random.default_rng(1)
    worst = {
        name: _midpoints(level_functions(model), rng)
        for name, model in (("f_app", INNER.of(HULL)), ("f_E", INNER.of(TANK)), ("f_ex", HULL))
    }
    most = max(worst.values())
    return Finding(
        "Proposition 1", "f_E, f_E,ex and f_E,app are convex",
        f"no midpoint of {PAIRS} pairs of points lies above the chord by more than {most:.0e}; the "
        "proof given for f_app, from a minimum inside, would not show it",
        verdict(most <= ROUNDING), worst,
    )  # fmt: skip


def _sharp_enough() -> Finding:
    corner = np.sqrt(3) * recession(EXPONENT, 1.0, 3)
    edge = np.sqrt(2) * recession(EXPONENT, 1.0, 2)
    proven = model_error_m(HULL, INNER.of(HULL))
    return Finding(
        "Section IV.B",
        "with exponent 8 corners are sharp enough, and d_safe makes up for the rest",
        f"corners of a 2 m cube recede by {corner:.3f} m and edges by {edge:.3f} m; d_safe is "
        f"{D_SAFE_M} m. The hull lies within {proven:.3f} m of its model (proven)",
        verdict(corner <= D_SAFE_M),
        {"corner_m": corner, "edge_m": edge, "hull_bound_m": proven, "d_safe_m": D_SAFE_M},
    )  # fmt: skip


def _smaller() -> Finding:
    exact = formulate("kkt", HULL, HULL).variables
    smooth = formulate("kkt", INNER.of(HULL), INNER.of(HULL)).variables
    return Finding(
        "Section III.A", "one function in place of m inequalities makes the programme smaller",
        f"two boxes take {len(smooth)} variables an instant instead of {len(exact)}",
        verdict(len(smooth) < len(exact)), {"smoothed": len(smooth), "exact": len(exact)},
    )  # fmt: skip


def _falls() -> Finding:
    found = corner_error()
    one = found.recession_m[:, list(found.half_sizes_m).index(1.0)]
    return Finding(
        "Discussion, Fig. err-analysis", "the error falls as the exponent grows",
        f"for a 2 m square from {one[0]:.3f} m at {found.exponents[0]:.0f} to {one[-1]:.4f} m at "
        f"{found.exponents[-1]:.0f}, as ln 2 over the exponent",
        verdict(bool(np.all(np.diff(one) < 0.0))), {"at_least_m": one[-1], "at_most_m": one[0]},
    )  # fmt: skip


def _size() -> Finding:
    found = corner_error(np.array([EXPONENT]))
    metres, shares = found.recession_m[0], found.relative[0]
    some = np.isfinite(metres)
    spread = float(np.ptp(metres[some]))
    empty = found.half_sizes_m[~some]
    same = spread <= SAME and not len(empty)
    least = np.log(4.0) / EXPONENT
    partly = PARTLY if np.ptp(metres[found.half_sizes_m >= 1.0]) <= SAME else FAILS
    return Finding(
        "Discussion, Fig. err-analysis", "the size of the polyhedron does not affect the accuracy",
        f"at exponent 8 large squares err alike in metres, but by {np.nanmin(shares):.1%} to "
        f"{np.nanmax(shares):.0%} of their half-size, and one of half-size below {least:.3f} m is "
        f"empty ({len(empty)} of the {len(metres)} sizes tried)",
        HOLDS if same else partly,
        {"spread_m": spread, "least_share": float(np.nanmin(shares)),
         "largest_share": float(np.nanmax(shares)), "empty": len(empty), "empty_below_m": least},
    )  # fmt: skip


def _huge() -> Finding:
    with np.errstate(over="ignore"):
        plain = np.exp(HUGE * (1.0 - 0.5 * HULL.half_extents[0]) + HUGE * 0.01)
    functions = level_functions(ShapeModel("inner", exponent=HUGE).of(HULL))
    value, slope = functions.values(np.array([[1.2, 0.0, 0.0]]))
    finite = bool(np.all(np.isfinite(value)) and np.all(np.isfinite(slope)))
    return Finding(
        "Discussion, scaling", "in units of their own, exponents may be huge without overflow",
        f"with e^(Q f) taken as printed, exponent {HUGE:.0e} gives {plain}; with the largest term "
        f"taken out first, value and gradient are finite in any unit: {finite}",
        verdict(finite), {"exponent": HUGE, "value": float(value[0, 0])},
    )  # fmt: skip
