"""Propositions 2 and 3: the rows hold at closest points, and hold elsewhere only without λ ≥ 0.

The points come from SciPy's SLSQP on the paper's functions, written out here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import minimize

from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.proximity.formulations import formulate

FORMS = ["kkt", "kkt-complementarity"]
SOLVED = 1e-4
"""SLSQP stops within 1e-12 of the squared distance, and so within its root of the points."""

STEP = 1e-6


@dataclass(frozen=True)
class Known:
    """A set and its function as the paper prints it."""

    shape: ConvexSet
    f: Callable[[np.ndarray], float]


HALF = np.array([2.0, 1.0, 1.0])
AXES = np.array([1.0, 2.0, 0.5])
BALL = Known(Sphere(0.8), lambda x: float(x @ x - 0.64))
ELLIPSOID = Known(Ellipsoid(AXES), lambda x: float(np.sum((x / AXES) ** 2) - 1))
TANK = Known(
    Superellipsoid(np.array([2.0, 1, 1]), np.array([8, 2, 2])),
    lambda x: float((x[0] / 2) ** 8 + x[1] ** 2 + x[2] ** 2 - 1),
)
HULL = Known(
    SmoothedPolytope.inner(Box(HALF), 8.0),
    lambda x: float(np.log(np.sum(np.exp(8 * np.concatenate([x - HALF, -x - HALF])))) / 8),
)
APART = [(HULL, TANK), (HULL, HULL), (TANK, ELLIPSOID), (BALL, HULL), (ELLIPSOID, ELLIPSOID)]


def turned(position: list[float], axis: list[float], angle: float) -> Pose:
    turn = np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * np.array(axis)])
    return Pose.from_quaternion(np.array(position), turn / np.linalg.norm(turn))


POSE_A, POSE_B = turned([0.3, -0.2, 0.1], [0, 0, 1], 0.4), turned([3.1, 3.4, 1.5], [1, 0, 0], 0.7)


def closest(a: Known, b: Known) -> tuple[np.ndarray, np.ndarray]:
    """Closest points in each set's own frame."""

    def square(z: np.ndarray) -> float:
        gap = POSE_A.apply(z[:3]) - POSE_B.apply(z[3:])
        return float(gap @ gap)

    limits = [
        {"type": "ineq", "fun": lambda z: -a.f(z[:3])},
        {"type": "ineq", "fun": lambda z: -b.f(z[3:])},
    ]
    done = minimize(
        square, np.zeros(6), method="SLSQP", constraints=limits, tol=1e-14,
        options={"maxiter": 500},
    )  # fmt: skip
    return done.x[:3], done.x[3:]


def gradient(f: Callable[[np.ndarray], float], x: np.ndarray) -> np.ndarray:
    return np.array([(f(x + STEP * e) - f(x - STEP * e)) / (2 * STEP) for e in np.eye(3)])


def rows_of(form, w: np.ndarray, p: np.ndarray, margin_m: float) -> tuple[np.ndarray, float, float]:
    """All rows but the distance at two points with the best multipliers, and these."""
    own = [
        (x - side.centre_m) / side.radius_m
        for x, side in ((w, form.functions_a), (p, form.functions_b))
    ]
    v = ca.SX.sym("v", len(form.variables))
    a, b = ((ca.DM(q.position), ca.DM(q.rotation)) for q in (POSE_A, POSE_B))
    rows = form.rows(v, a, b, margin_m, 1.0)
    others = [i for i in range(rows.expression.numel()) if i != rows.separation]
    at = ca.Function("rows", [v], [rows.expression[others]])

    def values(multipliers: np.ndarray) -> np.ndarray:
        return np.asarray(at(np.concatenate([*own, multipliers]))).ravel()

    # Rows are affine in the multipliers but for λ f, and f = 0 here.
    zero = values(np.zeros(2))
    slope = np.stack([values(e) - zero for e in np.eye(2)], axis=1)
    best = np.linalg.lstsq(slope, -zero, rcond=None)[0]
    return values(best), float(best[0]), float(best[1])


@pytest.mark.parametrize("name", FORMS)
@pytest.mark.parametrize("both", APART, ids=lambda p: "|".join(type(k.shape).__name__ for k in p))
def test_residuals_vanish_at_closest_points_of_another_solver(name, both) -> None:
    a, b = both
    w, p = closest(a, b)
    form = formulate(name, a.shape, b.shape)
    residual, lam, mu = rows_of(form, w, p, 0.1)
    assert np.max(np.abs(residual)) < SOLVED
    assert lam > 0.0
    assert mu > 0.0
    # Not so at other points of the boundaries.
    wrong, _, _ = rows_of(form, w, -p, 0.1)
    assert np.max(np.abs(wrong)) > 100 * SOLVED


@pytest.mark.parametrize("name", FORMS)
def test_without_signs_the_farthest_points_would_do_as_well(name) -> None:
    """Balls: every row holds at their far sides with λ, μ < 0, where the distance is 2 r too long
    on either side; the bounds λ, μ ≥ 0 are what excludes it."""
    form = formulate(name, BALL.shape, BALL.shape)
    way = POSE_B.position - POSE_A.position
    unit = way / np.linalg.norm(way)
    near = POSE_A.unrotate(0.8 * unit), POSE_B.unrotate(-0.8 * unit)
    far = POSE_A.unrotate(-0.8 * unit), POSE_B.unrotate(0.8 * unit)
    for (w, p), sign in ((near, 1.0), (far, -1.0)):
        residual, lam, mu = rows_of(form, w, p, 0.1)
        assert np.max(np.abs(residual)) < 1e-9
        assert np.sign(lam) == np.sign(mu) == sign
    gap = POSE_A.apply(far[0]) - POSE_B.apply(far[1])
    assert np.linalg.norm(gap) == pytest.approx(np.linalg.norm(way) + 1.6)
    named = dict(zip(form.variables.names, form.variables.lower, strict=True))
    assert named["lambda_0"] == named["mu_0"] == 0.0


def test_a_solver_that_may_drop_the_signs_finds_the_farthest_points() -> None:
    """Newton's method on the rows alone, from beside the far sides, stays there."""
    form = formulate("kkt", ELLIPSOID.shape, BALL.shape)
    v = ca.SX.sym("v", len(form.variables))
    a, b = ((ca.DM(q.position), ca.DM(q.rotation)) for q in (POSE_A, POSE_B))
    rows = form.rows(v, a, b, 0.1, 1.0)
    equal = [i for i in range(rows.expression.numel()) if i != rows.separation]
    system = rows.expression[equal]
    slope = ca.Function("slope", [v], [system, ca.jacobian(system, v)])
    way = POSE_B.position - POSE_A.position
    unit = way / np.linalg.norm(way)

    def solve(sign: float) -> tuple[np.ndarray, np.ndarray]:
        _, w = ELLIPSOID.shape.support(POSE_A.unrotate(sign * unit))
        p = POSE_B.unrotate(-sign * 0.8 * unit)
        own = [w / form.functions_a.radius_m, p / form.functions_b.radius_m]
        x = np.concatenate([*own, [sign, sign]])
        for _ in range(60):
            g, J = (np.asarray(part) for part in slope(x))
            step = np.linalg.lstsq(J, -g.ravel(), rcond=None)[0]
            x = x + min(1.0, 0.2 / max(np.linalg.norm(step), 1e-12)) * step
        assert np.max(np.abs(np.asarray(slope(x)[0]))) < 1e-9
        s = x[:3] * form.functions_a.radius_m, x[3:6] * form.functions_b.radius_m
        return POSE_A.apply(s[0]) - POSE_B.apply(s[1]), x[6:]

    near, with_signs = solve(1.0)
    far, without = solve(-1.0)
    assert np.all(with_signs > 0.0)
    assert np.all(without < 0.0)
    assert np.linalg.norm(far) > np.linalg.norm(near) + 1.6
