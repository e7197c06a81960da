"""Claims about the distance of two sets as optimality conditions."""

from __future__ import annotations

import numpy as np

from berthing.clearance.separation import separation
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.proximity.closest_points import closest_points, difference
from berthing.proximity.level_functions import level_functions
from berthing.reproduce.finding import FAILS, HOLDS, Finding, verdict
from berthing.reproduce.sets import HULL, INNER, TANK

AGREE_M = 1e-6
"""Distances of two solvers that share nothing."""

MU = 1e-12
"""Complementarity that is left."""


def findings() -> list[Finding]:
    """All of them, in the order of the paper."""
    return [_on_the_boundary(), _sufficient(), _by_newton()]


def _solved(turn: float) -> tuple[float, float, float]:
    """Distance by the conditions and by a search, and the largest |f|, of A's hull and cylinder."""
    a, b = INNER.of(HULL), INNER.of(TANK)
    c, s = np.cos(turn), np.sin(turn)
    rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    pose_a, pose_b = Pose(np.array([4.0, 3.5, 0.7]), rotation), Pose(np.zeros(3), np.eye(3))
    fa, fb = level_functions(a), level_functions(b)
    batch = Pose(pose_a.position[None], pose_a.rotation[None])
    offset, slope = difference(fa, batch, fb, Pose(np.zeros((1, 3)), np.eye(3)[None]))
    unit_m2 = (fa.radius_m + fb.radius_m) ** 2
    found = closest_points(fa, fb, offset, slope, unit_m2, np.full(2, MU))
    gap = offset + np.einsum("nij,nj->ni", slope, np.concatenate([found.s_a, found.s_b], axis=1))
    values = [fa.values(found.s_a)[0], fb.values(found.s_b)[0]]
    exact = separation(a, pose_a, b, pose_b).distance
    return float(np.linalg.norm(gap)), float(exact), float(np.max(np.abs(values)))


def _on_the_boundary() -> Finding:
    gaps = np.array([_solved(turn) for turn in np.linspace(0.0, 1.5, 7)])
    most = float(np.max(gaps[:, 2]))
    return Finding(
        "Section III.A", "closest points always lie on the boundaries",
        f"for sets apart f vanishes there to {most:.0e}; for sets that overlap any common point is "
        "closest, inside or not",
        verdict(most < AGREE_M), {"largest_f": most},
    )  # fmt: skip


def _sufficient() -> Finding:
    """Two unit balls 4 m apart: λ = μ = 0 and points that are no closest ones."""
    w, p, centre = np.array([0.0, 1, 0]), np.array([0.0, 0, 1]), np.array([4.0, 0, 0])
    gap = w - (p + centre)
    summed = 2 * gap - 2 * gap
    each = float(np.linalg.norm(2 * gap))
    ball = Sphere(1.0)
    least = separation(ball, Pose.identity(3), ball, Pose(centre, np.eye(3))).distance
    apart = float(np.linalg.norm(gap))
    wrong = not np.any(summed) and apart > least + AGREE_M
    return Finding(
        "Propositions 2 and 3", "the stationarity printed, one sum, is necessary and sufficient",
        f"with both multipliers zero it holds at points {apart:.2f} m apart of balls that are "
        f"{least:.2f} m apart; one condition a set, each in its frame, is off by {each:.1f} there",
        FAILS if wrong else HOLDS,
        {"points_m": apart, "distance_m": float(least), "residual": each},
    )  # fmt: skip


def _by_newton() -> Finding:
    gaps = np.array([_solved(turn) for turn in np.linspace(0.0, 1.5, 7)])
    most = float(np.max(np.abs(gaps[:, 0] - gaps[:, 1])))
    return Finding(
        "Discussion", "outside a programme, Newton's method on the conditions gives the distance",
        f"hull and cylinder of Scenario A, exponent 8, seven attitudes: within {most:.0e} m of a "
        "search over support functions; Newton's steps are damped by a barrier",
        verdict(most < AGREE_M), {"largest_difference_m": most},
    )  # fmt: skip
