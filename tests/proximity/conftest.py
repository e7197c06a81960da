"""Shapes of every kind, pairs of them, and the best value of a separation row."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations_with_replacement

import casadi as ca
import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.proximity.formulation import PairFormulation, Rows

WEDGE = [[1, 0, 0], [3, 0, 0], [1, 2, 0], [1, 0, 1], [3, 0, 0.5], [1, 2, 1]]
SPACE: dict[str, ConvexSet] = {
    "box": Box([2.0, 1.0, 0.5]),
    "ball": Sphere(0.8),
    "point": Sphere(0.0),
    "ellipsoid": Ellipsoid([1.0, 2.0, 0.5]),
    "cylinder-x": Cylinder(1.0, 2.0),
    "disc-z": Cylinder(1.5, 0.05, "z"),
    "wedge": Polytope.from_vertices(WEDGE),
}
PLANE: dict[str, ConvexSet] = {
    "rectangle": Box([2.0, 0.5]),
    "disc": Sphere(0.8, dim=2),
    "point-2d": Sphere(0.0, dim=2),
    "ellipse": Ellipsoid([1.0, 2.5]),
    "triangle": Polytope.from_vertices([[0.5, 0.0], [2.0, 0.3], [1.0, 1.5]]),
}
SHAPES = SPACE | PLANE
# A against B is not B against A: the normal lives in B's frame.
PAIRS = [
    *combinations_with_replacement(SPACE, 2), *combinations_with_replacement(PLANE, 2),
    ("wedge", "box"), ("cylinder-x", "ball"), ("triangle", "rectangle"),
]  # fmt: skip


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "shape" in metafunc.fixturenames:
        metafunc.parametrize("shape", SHAPES.values(), ids=SHAPES.keys())
    if "pair" in metafunc.fixturenames:
        pairs = [(SHAPES[a], SHAPES[b]) for a, b in PAIRS]
        metafunc.parametrize("pair", pairs, ids=[f"{a}|{b}" for a, b in PAIRS])


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240613)


@pytest.fixture
def poses(rng: np.random.Generator) -> Callable[[int, int, float], Pose]:
    """A batch of random poses of the dimension asked, at ``distance`` from the origin."""

    def draw(count: int, dim: int, distance: float) -> Pose:
        way = rng.normal(size=(count, dim))
        position = distance * way / np.linalg.norm(way, axis=1, keepdims=True)
        if dim == 2:
            return Pose.planar(position, rng.uniform(-3, 3, size=count))
        return Pose.from_quaternion(position, quaternion.normalise(rng.normal(size=(count, 4))))

    return draw


Value = Callable[[PairFormulation, Array, Pose, Pose, float], tuple[Array, Rows]]


def symbols(
    form: PairFormulation, pose_a: Pose, pose_b: Pose, margin_m: float
) -> tuple[ca.SX, Rows]:
    """The variables of a pair at two single poses, and its rows."""
    v = ca.SX.sym("v", len(form.variables))
    a, b = ((ca.DM(p.position), ca.DM(p.rotation)) for p in (pose_a, pose_b))
    return v, form.rows(v, a, b, margin_m, 1.0)


@pytest.fixture
def rows_at() -> Value:
    """Values (m,) of a pair's rows at numbers for its variables, and the rows."""

    def value(
        form: PairFormulation, v: Array, pose_a: Pose, pose_b: Pose, margin_m: float
    ) -> tuple[Array, Rows]:
        symbol, rows = symbols(form, pose_a, pose_b, margin_m)
        f = ca.Function("rows", [symbol], [rows.expression])
        return np.asarray(f(v)).ravel(), rows

    return value


@pytest.fixture
def best_gap() -> Callable[[PairFormulation, Array, Pose, Pose], float]:
    """The largest left side of the separation row over all feasible variables, from a start."""

    def largest(form: PairFormulation, start: Array, pose_a: Pose, pose_b: Pose) -> float:
        v, rows = symbols(form, pose_a, pose_b, 0.0)
        others = [i for i in range(rows.expression.numel()) if i != rows.separation]
        nlp = {"x": v, "f": -rows.expression[rows.separation], "g": rows.expression[others]}
        # Relaxed bounds would let the tip of a cone slip by the root of what they are relaxed by.
        ipopt = {"print_level": 0, "sb": "yes", "tol": 1e-9, "bound_relax_factor": 0.0,
                 "acceptable_iter": 0}  # fmt: skip
        options = {"print_time": False} | {f"ipopt.{key}": value for key, value in ipopt.items()}
        answer = ca.nlpsol("gap", "ipopt", nlp, options)(
            x0=start, lbg=rows.lower[others], ubg=rows.upper[others]
        )
        # Where it stalls at the tip of a cone, the value tells whether it got there.
        return -float(answer["f"])

    return largest
