"""All forms give one distance, take the sets that the documentation says, and need λ ≥ 0."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import nnls

from berthing.clearance.separation import PairQuery
from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.proximity.formulation import PairFormulation
from berthing.proximity.formulations import FORMULATIONS, formulate
from berthing.proximity.optimality import OptimalityFormulation
from support.closest import solved_points
from support.shapes import SHAPES, size

TABLE = Path(__file__).parents[2] / "docs" / "formulations.md"
SMOOTHED = SmoothedPolytope.inner(Box([1.0, 1.0, 1.0]), 8.0)
# Rows of the table by what stands in their first cell.
ROWS: dict[str, ConvexSet] = {
    "Box": SHAPES["box"],
    "Sphere, points among them": SHAPES["point"],
    "Ellipsoid": SHAPES["ellipsoid"],
    "Cylinder": SHAPES["cylinder-x"],
    "Polytope": SHAPES["wedge"],
    "HalfSpace": SHAPES["wall"],
    "Superellipsoid of exponents that are powers of two": SHAPES["paper-cylinder"],
    "Superellipsoid of other exponents": SHAPES["pillow"],
    "SmoothedPolytope": SHAPES["inner-box"],
    "Capsule": SHAPES["capsule"],
    "Cone": SHAPES["cone"],
    "TruncatedCone": SHAPES["lampshade"],
    "Offset of a set with a conic form": SHAPES["padded-box"],
    "Offset of another set": Offset(SMOOTHED, 0.1),
    "Intersection of sets that `kkt` takes": SHAPES["cut-cylinder"],
    "Intersection of other sets": Intersection([Capsule(1.0, 1.0), Box([1.0, 1.0, 1.0])]),
}
PARTNER = Sphere(1.0)
# The others part enclosures of the sets.
EXACT = [name for name in FORMULATIONS if not name.startswith("bounding-")]

PAIRS = [
    ("box", "cylinder-x"), ("ball", "cut-prism"), ("wedge", "ellipsoid"),
    ("point", "paper-cylinder"),
    ("inner-box", "outer-wedge"), ("paper-cylinder", "pillow"), ("ball", "wall"),
    ("cut-cylinder", "needle"), ("capsule", "cone"), ("padded-box", "lampshade"),
    ("rectangle", "triangle"), ("superellipse", "inner-square"), ("lens", "disc"),
    ("stadium", "padded-triangle"), ("ellipse", "edge"),
]  # fmt: skip
SMOOTH_PAIRS = [
    ("ball", "ellipsoid"), ("needle", "paper-cylinder"), ("pillow", "inner-box"),
    ("inner-box", "ball"), ("superellipse", "ellipse"), ("inner-square", "disc"),
]  # fmt: skip
# Of distances, in terms of the sizes: IPOPT at 1e-9 stops this near the tips of cones, and the
# last stage of complementarity leaves 1e-8 of the squared size on the squared distance.
SOLVED = 3e-6
# Of KKT rows at points that SLSQP or Clarabel found: a gap of 1e-8 leaves points up to its root
# aside where boundaries are flat.
VANISHING = 5e-5
MARGIN_M = 1e-3
Poses = Callable[[int, int, float], Pose]


def table() -> dict[str, dict[str, bool]]:
    """Set → formulation → whether it is taken, as the documentation has it."""
    lines = TABLE.read_text(encoding="utf-8").split("## Which form takes which set")[1].splitlines()
    cells = [[c.strip() for c in line.strip("|").split("|")] for line in lines if line[:1] == "|"]
    names = [name.strip("`") for name in cells[0][1:]]
    assert all(cell in ("yes", "no") for row in cells[2:] for cell in row[1:])
    return {
        row[0]: dict(zip(names, (c == "yes" for c in row[1:]), strict=True)) for row in cells[2:]
    }


def taken(name: str, shape: ConvexSet) -> bool:
    try:
        formulate(name, shape, PARTNER)
        formulate(name, PARTNER, shape)
    except CapabilityError:
        return False
    return True


def test_the_documented_table_is_what_the_code_does() -> None:
    documented = table()
    assert set(documented) == set(ROWS)
    for row, shape in ROWS.items():
        assert set(documented[row]) == set(FORMULATIONS)
        assert documented[row] == {name: taken(name, shape) for name in FORMULATIONS}, row


def test_every_kind_of_set_is_in_the_table() -> None:
    kinds = {type(shape) for shape in SHAPES.values()}
    assert kinds == {type(shape) for shape in ROWS.values()}


@pytest.mark.parametrize("name", FORMULATIONS)
def test_what_a_form_does_not_take_is_told_the_alternatives(name: str) -> None:
    for shape in ROWS.values():
        if not taken(name, shape):
            with pytest.raises(CapabilityError) as caught:
                formulate(name, shape, PARTNER)
            message = str(caught.value)
            # Of an intersection the member may be named that is to blame.
            blamed = [shape, *(shape.sets if isinstance(shape, Intersection) else ())]
            names = "|".join(type(one).__name__ for one in blamed)
            assert re.search(rf"\b({names})\b", message)
            assert "`plane`" in message
            assert "`kkt`" in message
            assert "Box" in message


def solve(
    form: PairFormulation, start: Array, at: tuple[Pose, Pose], eps: float, *, bounded: bool = True
) -> Array:
    """The variables that make the separation row largest, IPOPT beginning at ``start``.

    Without ``bounded`` the bounds on the variables, λ ≥ 0, are dropped.
    """
    v = ca.SX.sym("v", len(form.variables))
    world = [(ca.DM(p.position), ca.DM(p.rotation)) for p in at]
    rows = form.rows(v, *world, MARGIN_M, 1.0, eps)
    others = [i for i in range(rows.expression.numel()) if i != rows.separation]
    nlp = {"x": v, "f": -rows.expression[rows.separation], "g": rows.expression[others]}
    ipopt = {"print_level": 0, "sb": "yes", "tol": 1e-9, "bound_relax_factor": 0.0,
             "acceptable_iter": 0, "max_iter": 300, "mu_strategy": "adaptive"}  # fmt: skip
    options = {"print_time": False} | {f"ipopt.{key}": value for key, value in ipopt.items()}
    bounds = (
        {"lbx": form.variables.lower, "ubx": form.variables.upper} if bounded else {}
    )  # fmt: skip
    answer = ca.nlpsol("gap", "ipopt", nlp, options)(
        x0=start, lbg=rows.lower[others], ubg=rows.upper[others], **bounds
    )
    return np.asarray(answer["x"]).ravel()


def values(form: PairFormulation, v: Array, at: tuple[Pose, Pose], eps: float) -> Array:
    """Of all rows."""
    world = [(ca.DM(p.position), ca.DM(p.rotation)) for p in at]
    symbol = ca.SX.sym("v", len(v))
    rows = form.rows(symbol, *world, MARGIN_M, 1.0, eps)
    return np.asarray(ca.Function("rows", [symbol], [rows.expression])(v)).ravel()


def distance(form: PairFormulation, v: Array, at: tuple[Pose, Pose], eps: float) -> float:
    """What the separation row says, in metres."""
    row = float(values(form, v, at, eps)[0])
    if not isinstance(form, OptimalityFormulation):
        return row + MARGIN_M
    return float(np.sqrt(max(2.0 * MARGIN_M * row + MARGIN_M**2, 0.0)))


def apart(pair: tuple[ConvexSet, ConvexSet], poses: Poses, count: int) -> list[tuple[Pose, Pose]]:
    """Poses at which the sets are apart: their balls are, and half-spaces are drawn away."""
    a, b = pair
    sizes = size(a) + size(b)
    at_a, at_b = poses(count, a.dim, 0.2 * sizes), poses(count, a.dim, 1.0)
    way = at_b.position / np.linalg.norm(at_b.position, axis=1, keepdims=True)
    away = at_a.position + 1.05 * sizes * way
    if not np.isfinite(b.bounding_radius):
        found, normal, _ = PairQuery(a, b).batch(at_a, Pose(away, at_b.rotation))
        away = away + (0.3 * sizes - found)[:, None] * normal
    return [(at_a[i], Pose(away[i], at_b.rotation[i])) for i in range(count)]


def row_of(shape: ConvexSet) -> str:
    """The row of the table that a shape of the laws belongs to."""
    if shape is SHAPES["pillow"] or shape is SHAPES["superellipse"]:
        return "Superellipsoid of other exponents"
    return next(row for row, known in ROWS.items() if type(known) is type(shape))


DOCUMENTED = table()
CASES = [
    (name, *names)
    for names in PAIRS
    for name in EXACT
    if all(DOCUMENTED[row_of(SHAPES[n])][name] for n in names)
]


@pytest.mark.parametrize(("name", "a", "b"), CASES, ids=["|".join(case) for case in CASES])
def test_every_form_gives_the_distance(name: str, a: str, b: str, poses: Poses) -> None:
    """From starts for poses that are a little off, so that the rows have to be solved."""
    pair = SHAPES[a], SHAPES[b]
    form = formulate(name, *pair)
    sizes = size(pair[0]) + size(pair[1])
    for at in apart(pair, poses, 2):
        expected = PairQuery(*pair).query(*at)
        nudged = Pose(at[1].position + 0.02 * sizes * expected.normal, at[1].rotation)
        stages = form.homotopy or (0.0,)
        normal = expected.normal[None]
        v = form.start(at[0][None], nudged[None], normal, stages[0])[0]
        for eps in stages:
            v = solve(form, v, at, eps)
        found = distance(form, v, at, stages[-1])
        assert found == pytest.approx(expected.distance, abs=SOLVED * max(sizes, 1.0))


def multipliers(form: OptimalityFormulation, side: int, s: Array, delta_own: Array) -> Array:
    """λ ≥ 0 of one set that leave the least of its stationarity, by non-negative least squares."""
    functions = (form.functions_a, form.functions_b)[side]
    _, jacobian = functions.values(s[None])
    pull = 2.0 * functions.radius_m / form.unit_m2 * delta_own
    return nnls(jacobian[0].T, -pull)[0]


def at_points(form: OptimalityFormulation, at: tuple[Pose, Pose], x: Array, y: Array) -> Array:
    """The form's variables at points of the world, with the best multipliers."""
    sides = zip((form.functions_a, form.functions_b), at, (x, y), strict=True)
    s_a, s_b = (
        (pose.unrotate(point - pose.position) - side.centre_m) / side.radius_m
        for side, pose, point in sides
    )
    lam = multipliers(form, 0, s_a, at[0].unrotate(x - y))
    mu = multipliers(form, 1, s_b, at[1].unrotate(y - x))
    return np.concatenate([s_a, s_b, lam, mu])


@pytest.mark.parametrize(("a", "b"), SMOOTH_PAIRS, ids=["|".join(p) for p in SMOOTH_PAIRS])
def test_kkt_rows_vanish_at_points_found_by_another_solver(a: str, b: str, poses: Poses) -> None:
    pair = SHAPES[a], SHAPES[b]
    form = formulate("kkt", *pair)
    assert isinstance(form, OptimalityFormulation)
    assert not form.homotopy
    for at in apart(pair, poses, 2):
        x, y = solved_points(pair, *at)
        v = at_points(form, at, x, y)
        np.testing.assert_allclose(values(form, v, at, 0.0)[1:], 0.0, atol=VANISHING)
        assert distance(form, v, at, 0.0) == pytest.approx(float(np.linalg.norm(x - y)))
        # And not elsewhere: at the point of A that lies a hundredth of its size aside.
        aside = x + 0.01 * size(pair[0]) * np.roll(x - y, 1) / np.linalg.norm(x - y)
        moved = values(form, at_points(form, at, aside, y), at, 0.0)[1:]
        assert np.max(np.abs(moved)) > 20.0 * VANISHING


def farthest(pair: tuple[ConvexSet, ConvexSet], at: tuple[Pose, Pose]) -> tuple[Array, Array]:
    """Points x of A and y of B in the world that no points near them are farther apart than.

    Each is the support point along the line to the other, so that their distance cannot fall.
    """
    (a, b), (pose_a, pose_b) = pair, at
    across = pose_b.position - pose_a.position
    for _ in range(300):
        x = pose_a.apply(a.support(pose_a.unrotate(-across))[1])
        y = pose_b.apply(b.support(pose_b.unrotate(across))[1])
        across = y - x
    return x, y


@pytest.mark.parametrize(("a", "b"), SMOOTH_PAIRS, ids=["|".join(p) for p in SMOOTH_PAIRS])
def test_without_multipliers_above_zero_the_farthest_points_would_do(
    a: str, b: str, poses: Poses
) -> None:
    pair = SHAPES[a], SHAPES[b]
    form = formulate("kkt", *pair)
    assert isinstance(form, OptimalityFormulation)
    at = apart(pair, poses, 1)[0]
    x, y = farthest(pair, at)
    nearest = PairQuery(*pair).query(*at).distance
    v = at_points(form, at, x, y)
    signed = []
    for side, pose, s, delta in zip(
        (form.functions_a, form.functions_b), at, np.split(v[: 2 * len(x)], 2), (x - y, y - x),
        strict=True,
    ):  # fmt: skip
        jacobian = side.values(s[None])[1][0]
        pull = 2.0 * side.radius_m / form.unit_m2 * pose.unrotate(delta)
        signed.append(np.linalg.lstsq(jacobian.T, -pull, rcond=None)[0])
    v = np.concatenate([v[: 2 * len(x)], *signed])
    assert np.all(np.concatenate(signed) < 0.0)
    far = float(np.linalg.norm(y - x))
    assert far > nearest + 0.5 * size(pair[0])
    # Every row holds there, and the separation row claims the greatest distance for the least.
    np.testing.assert_allclose(values(form, v, at, 0.0)[1:], 0.0, atol=VANISHING)
    dropped = solve(form, v, at, 0.0, bounded=False)
    assert distance(form, dropped, at, 0.0) == pytest.approx(far, rel=1e-4)
    # With λ ≥ 0 there is one answer left.
    normal = PairQuery(*pair).query(*at).normal[None]
    start = form.start(at[0][None], at[1][None], normal)[0]
    kept = solve(form, start, at, 0.0)
    assert distance(form, kept, at, 0.0) == pytest.approx(nearest, abs=SOLVED * 10.0)
    assert np.all(kept[2 * len(x) :] >= 0.0)
    assert not form.variables.lower[2 * len(x) :].any()


def test_superellipsoids_of_sixth_powers_are_not_for_planes() -> None:
    with pytest.raises(CapabilityError, match="powers of two"):
        formulate("plane", Superellipsoid([1.0, 1.0], 6), Sphere(1.0, dim=2))
