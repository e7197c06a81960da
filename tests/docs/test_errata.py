"""Each erratum of docs/errata.md, shown."""

from __future__ import annotations

import re
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import berthing as bt
from berthing.clearance.separation import PairQuery, separation
from berthing.geometry import quaternion
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.proximity.formulations import formulate

ROOT = Path(__file__).parents[2]


def test_1_the_printed_plate_is_three_metres_thick() -> None:
    faces = np.concatenate([np.eye(3), -np.eye(3)])
    printed = Polytope(faces, np.array([1.0, 3, 3, 2, 3, 3]))
    thickness = np.ptp(printed.vertices()[:, 0])
    assert thickness == pytest.approx(3.0)
    plate = bt.load("scenario-a").structure("T1").body.parts[0].shape
    assert np.ptp(plate.vertices()[:, 0]) == pytest.approx(2.0)


def _c_si(q: np.ndarray) -> np.ndarray:
    """The paper's C_sI of (η, ε)."""
    eta, eps = q[0], q[1:]
    cross = np.array([[0, -eps[2], eps[1]], [eps[2], 0, -eps[0]], [-eps[1], eps[0], 0]])
    return (eta**2 - eps @ eps) * np.eye(3) + 2 * np.outer(eps, eps) - 2 * eta * cross


@pytest.mark.parametrize(("sign", "holds"), [(1.0, True), (-1.0, False)])
def test_2_kinematics_need_the_other_sign(sign: float, holds: bool) -> None:
    rng = np.random.default_rng(2)
    q, w, step = rng.normal(size=4), rng.normal(size=3), 1e-6
    q = q / np.linalg.norm(q)
    eps_rate = 0.5 * (q[0] * w + sign * np.cross(q[1:], w))
    rate = np.concatenate([[-0.5 * q[1:] @ w], eps_rate])
    change = (_c_si(q + step * rate) - _c_si(q - step * rate)) / (2 * step)
    # Poisson's equation for a matrix that turns inertial into body components: Ċ = -ω^× C.
    cross = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
    assert np.allclose(change, -cross @ _c_si(q), atol=1e-7) is holds


def test_4_velocity_and_inertia() -> None:
    q = quaternion.from_axis_angle(np.array([0.0, 0, 1]), np.array(0.5 * np.pi))
    north = np.array([0.0, 1, 0])
    # A body turned a quarter about z that moves along inertial y moves along its own x.
    assert np.allclose(_c_si(q) @ north, [1, 0, 0])
    assert np.allclose(_c_si(q).T @ north, [-1, 0, 0])
    sizes, mass = np.array([4.0, 2, 2]), 3.0
    uniform = mass / 12 * (sizes @ sizes - sizes**2)
    assert np.allclose(uniform, [2, 5, 5])
    model = bt.load("scenario-a").phases[0].vehicles[0].model
    assert np.allclose(np.diag(model.inertia_kg_m2), 5)


def test_5_scenario_b_is_met_by_a_straight_line() -> None:
    scenario = bt.load("scenario-b")
    vehicle = scenario.phases[0].vehicles[0]
    x = np.linspace(0.0, 9.5, 200)
    line = Pose(np.stack([x, 0 * x, 0 * x], axis=1), np.tile(np.eye(3), (200, 1, 1)))
    least = min(
        PairQuery(pair.part_a.shape, pair.part_b.shape)
        .batch(line, pair.owner_b.motion.pose(np.zeros(1))[0].compose(pair.part_b.placement))[0]
        .min()
        for pair in scenario.pairs(scenario.phases[0])
    )
    assert vehicle.goal.position_m == pytest.approx([9.5, 0, 0])
    assert least == pytest.approx(0.5, abs=1e-6)


def test_6_the_goal_of_a_is_not_at_the_boundary() -> None:
    scenario = bt.load("scenario-a")
    distances = {}
    for pair in scenario.pairs(scenario.phases[0]):
        goal = Pose(pair.owner_a.goal.position_m, np.eye(3))
        structure = pair.owner_b.motion.pose(np.zeros(1))[0].compose(pair.part_b.placement)
        found = separation(pair.part_a.shape, goal, pair.part_b.shape, structure)
        distances[pair.part_b.name] = found.distance
    assert distances["plate"] == pytest.approx(2.0, abs=1e-6)
    assert distances["cylinder"] == pytest.approx(1.0, abs=1e-6)
    assert min(distances.values()) > 5 * scenario.margins.default_m


@pytest.mark.slow
def test_6_the_thrust_of_a_never_saturates() -> None:
    result = bt.plan(bt.load("scenario-a"))
    trajectory = result.plan.phases[0].vehicles[0]
    t = np.linspace(trajectory.t0_s, trajectory.t1_s, 2001)
    assert np.abs(trajectory.control(t)[:, :3]).max() < 0.75 * 0.02


def _f_app(x: np.ndarray, half: float, q: float, q_last: float, base: float = np.e) -> np.ndarray:
    faces = np.concatenate([x - half, -x - half], axis=-1)
    return np.log(np.sum(base ** (q * faces), axis=-1)) / (q_last * np.log(base))


def test_7_log_sum_exp() -> None:
    rng = np.random.default_rng(7)
    x, y = rng.normal(size=(2, 2000, 3))
    middle = _f_app(0.5 * (x + y), 1.0, 8, 8)
    assert np.all(middle <= 0.5 * (_f_app(x, 1.0, 8, 8) + _f_app(y, 1.0, 8, 8)) + 1e-12)
    inside = _f_app(x, 1.0, 8, 8) <= 0
    # The last exponent changes nothing, and another base is another exponent.
    assert np.array_equal(inside, _f_app(x, 1.0, 8, 80) <= 0)
    assert np.array_equal(_f_app(x, 1.0, 8, 8, 2.0) <= 0, _f_app(x, 1.0, 8 * np.log(2), 1) <= 0)
    # Inside the cube, and empty where the cube is small.
    assert np.all(np.abs(x[inside]).max(axis=1) < 1.0)
    assert _f_app(np.zeros((1, 3)), np.log(6) / 8 - 1e-6, 8, 8) > 0
    assert _f_app(np.zeros((1, 3)), np.log(6) / 8 + 1e-6, 8, 8) < 0


def test_8_the_summed_condition_is_not_sufficient() -> None:
    def gradient_f(x: np.ndarray) -> np.ndarray:
        return 2 * x  # f = ‖x‖² - 1 in each ball's own frame

    centre = np.array([4.0, 0, 0])
    w, p = np.array([0.0, 1, 0]), np.array([0.0, 0, 1])
    difference = w - (p + centre)
    summed = 2 * difference + 0 * gradient_f(w) - 2 * difference + 0 * gradient_f(p)
    assert np.allclose(summed, 0)  # holds with λ = μ = 0 ...
    assert np.linalg.norm(difference) > 2 + 1  # ... where the distance is 2
    closest, other = np.array([1.0, 0, 0]), np.array([-1.0, 0, 0])
    gap = closest - (other + centre)
    multiplier = 2.0
    assert np.allclose(2 * gap + multiplier * gradient_f(closest), 0)
    assert np.allclose(-2 * gap + multiplier * gradient_f(other), 0)
    # One condition a set cannot be met at the points above by any multiplier.
    assert np.linalg.matrix_rank(np.stack([difference, gradient_f(w)])) == 2


def test_9_a_constant_hamiltonian_is_not_enough() -> None:
    """Turning not at all and turning once around end alike; both have constant Hamiltonians."""
    inertia, duration = 5.0, 150.0
    t = np.linspace(0, duration, 101)
    costs = []
    for angle in (0.0, 2 * np.pi):
        # θ = angle (3τ² - 2τ³), g = J θ̈ = -λ_ω / 2, λ̇_θ = 0, λ̇_ω = -λ_θ / J·J.
        rate = angle * 6 * (t / duration) * (1 - t / duration) / duration
        torque = inertia * angle * (6 - 12 * t / duration) / duration**2
        slope = inertia * angle * -12 / duration**3
        hamiltonian = torque**2 + 2 * slope * inertia * rate - 2 * torque * torque
        assert np.ptp(hamiltonian) <= 1e-12
        costs.append(np.trapezoid(torque**2, t))
    assert costs[1] > costs[0] + 1e-3


def test_10_the_index_depends_on_the_unit_of_length() -> None:
    """Which of two controls is cheaper turns on whether torque is in N·m or in N·mm."""
    push, turn = np.array([2.0, 0.0]), np.array([0.0, 1.0])
    in_metres = [np.sum(u**2) for u in (push, turn)]
    in_millimetres = [np.sum((u * [1, 1e3]) ** 2) for u in (push, turn)]
    assert in_metres[0] > in_metres[1]
    assert in_millimetres[0] < in_millimetres[1]


@pytest.mark.parametrize(("name", "regular"), [("kkt", True), ("kkt-complementarity", False)])
def test_15_products_of_multiplier_and_function_are_degenerate(name: str, regular: bool) -> None:
    """Rank of the active rows at the closest points of two ellipsoids."""
    form = formulate(name, Ellipsoid([1.0, 2, 0.5]), Ellipsoid([0.7, 0.8, 1.5]))
    a, b = Pose.identity(3), Pose(np.array([2.5, 1.5, 1.0]), np.eye(3))
    (start,) = form.start(
        Pose(a.position[None], a.rotation[None]), Pose(b.position[None], b.rotation[None]),
        np.array([[0.8, 0.5, 0.33]]) / np.linalg.norm([0.8, 0.5, 0.33]),
    )  # fmt: skip
    v = ca.SX.sym("v", len(form.variables))
    poses = [(ca.DM(pose.position), ca.DM(pose.rotation)) for pose in (a, b)]
    rows = form.rows(v, poses[0], poses[1], 0.1, 1.0)
    values, slopes = ca.Function(
        "at", [v], [rows.expression, ca.jacobian(rows.expression, v)]
    )(start)  # fmt: skip
    found = np.asarray(values).ravel()
    nearest = np.minimum(np.abs(found - rows.lower), np.abs(found - rows.upper))
    active = [i for i in np.flatnonzero(nearest < 1e-6) if i != rows.separation]
    # Eight conditions for eight variables hold at once, and with products two more.
    assert len(active) == (8 if regular else 10)
    rank = int(np.linalg.matrix_rank(np.asarray(slopes)[active], tol=1e-6))
    assert (rank == len(active)) is regular


PAPER_LABELS = (
    "dyn", "gen-const", "cost-func", "org-colavoid", "ocp", "ocp-min", "ocp-init-term-cond",
    "ocp-dyn", "ocp-const", "ocp-colavoid", "dist-opt", "set-def", "rot-trans", "c-func", "setC",
    "d-func", "setD-ex", "d-func2", "d-func3", "setD-app", "prop2", "pm-ocp", "prop3", "fd-ocp",
    "diff-cond-ocp", "d-safe-ocp", "pos-vel-sc", "lagrange-eqs-m", "objective-u", "scenA-models",
    "inertial-sc", "inertial-st",
)  # fmt: skip
"""Every equation that the paper labels."""


def test_every_labelled_equation_of_the_paper_is_there() -> None:
    text = (ROOT / "docs" / "equations.md").read_text()
    rows = [line for line in text.splitlines() if line.startswith("| ")]
    for label in PAPER_LABELS:
        (row, *_) = [r for r in rows if f"({label})" in r.split("|")[1]] or [""]
        assert "`tests/" in row, label
        assert "`berthing." in row, label


def test_every_test_that_the_docs_name_exists() -> None:
    for page in ("errata.md", "equations.md"):
        text = (ROOT / "docs" / page).read_text()
        named = re.findall(r"`(tests/[\w/]+\.py)::(\w+)`", text)
        assert named, page
        for file, test in named:
            assert re.search(rf"^def {test}\(", (ROOT / file).read_text(), re.MULTILINE), test


def test_every_function_that_the_equations_name_exists() -> None:
    text = (ROOT / "docs" / "equations.md").read_text()
    named = re.findall(r"`(berthing(?:\.\w+)+):(\w+)`", text)
    assert named
    for module, name in named:
        path = ROOT / "src" / Path(*module.split("."))
        source = path.with_suffix(".py") if path.with_suffix(".py").exists() else path
        assert re.search(rf"^(def|class) {name}\b", source.read_text(), re.MULTILINE), name
