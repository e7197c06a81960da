"""Sums of small elements against casadi's own differentiation of the whole."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import pytest

from berthing.transcription.elements import Elements, Kernel
from support.documents import box, scenario, spacecraft, structure
from support.solving import BACKOFF_M, posed, start_of

VARIABLES, PARAMETERS, ROWS = 12, 4, 9


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240619)


def flat(value: Any) -> np.ndarray:
    """A casadi column as an array."""
    return np.asarray(value).ravel()


def spring() -> Kernel:
    """Two rows and a term of the objective; the Hessian is sparse."""
    z, p, c = ca.SX.sym("z", 3), ca.SX.sym("p", 1), ca.SX.sym("c", 2)
    rows = ca.vertcat(ca.sin(z[0] * p[0]) + c[0] * z[1] ** 2, z[2] * z[0] - c[1])
    return Kernel(z, p, c, rows, ca.exp(0.1 * z[1]) * p[0] + z[2] ** 4 * c[1])


def spring_numbers(z: Any, p: Any, c: Any) -> tuple[list[float], float]:
    rows = [np.sin(z[0] * p[0]) + c[0] * z[1] ** 2, z[2] * z[0] - c[1]]
    return rows, np.exp(0.1 * z[1]) * p[0] + z[2] ** 4 * c[1]


class Programme:
    """A random programme, with the same sums written out over plain numbers."""

    def __init__(self, rng: np.random.Generator) -> None:
        n = 5
        self.z = np.array([rng.choice(VARIABLES, 3, replace=False) for _ in range(n)])
        self.p = rng.integers(PARAMETERS, size=(n, 1))
        self.c = rng.normal(size=(n, 2))
        # Two elements add to one row: values that meet are summed.
        self.rows = np.array([[0, 1], [2, 1], [3, 4], [5, 0], [8, 3]])
        self.A = np.zeros((ROWS, VARIABLES))
        elements = Elements()
        elements.add(spring(), self.z, self.p, self.c, self.rows)
        for _ in range(20):
            i, j, value = rng.integers(ROWS), rng.integers(VARIABLES), rng.normal()
            self.A[i, j] += value
            elements.add_linear(i, j, value)
        z, empty = ca.SX.sym("z", 2), ca.SX(0, 1)
        product = Kernel(z, empty, empty, empty, z[0] * z[1])
        elements.add(
            product, [[0, 7], [7, 1]], np.empty((2, 0)), np.empty((2, 0)), np.empty((2, 0))
        )
        self.nlp = elements.programme(VARIABLES, PARAMETERS, ROWS)

    def numbers(self, x: np.ndarray, p: np.ndarray) -> tuple[float, np.ndarray]:
        f, g = x[0] * x[7] + x[7] * x[1], self.A @ x
        for z, own, c, into in zip(self.z, self.p, self.c, self.rows, strict=True):
            rows, term = spring_numbers(x[z], p[own], c)
            f += term
            np.add.at(g, into, rows)
        return f, g


@pytest.fixture
def programme(rng) -> Programme:
    return Programme(rng)


def test_value_is_the_sum_written_out(programme, rng) -> None:
    x, p = rng.normal(size=VARIABLES), rng.normal(size=PARAMETERS)
    f, g = programme.numbers(x, p)
    value, gradient = programme.nlp["grad_f"](x, p)
    assert float(value) == pytest.approx(f, abs=1e-13)
    assert gradient.shape == (VARIABLES, 1)
    np.testing.assert_allclose(flat(programme.nlp["jac_g"](x, p)[0]), g, atol=1e-13)
    # Another parameter gives another value: nothing is frozen in.
    assert abs(float(programme.nlp["grad_f"](x, p + 0.5)[0]) - f) > 1e-3


def test_derivatives_are_casadis_own_of_the_whole(programme, rng) -> None:
    nlp = programme.nlp
    x, p, f, g = (nlp[key] for key in "xpfg")
    lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", ROWS)
    whole = ca.Function("whole", [x, p, lam_f, lam_g], [
        ca.gradient(f, x), ca.jacobian(g, x), ca.hessian(lam_f * f + ca.dot(lam_g, g), x)[0],
    ])  # fmt: skip
    for _ in range(3):
        at = rng.normal(size=VARIABLES), rng.normal(size=PARAMETERS)
        multipliers = rng.normal(), rng.normal(size=ROWS)
        gradient, jacobian, hessian = (np.array(v) for v in whole(*at, *multipliers))
        np.testing.assert_allclose(np.array(nlp["grad_f"](*at)[1]), gradient, atol=1e-12)
        np.testing.assert_allclose(np.array(nlp["jac_g"](*at)[1]), jacobian, atol=1e-12)
        mine = np.array(nlp["hess_lag"](*at, *multipliers))
        np.testing.assert_allclose(mine, np.triu(hessian), atol=1e-12)
        assert np.max(np.abs(np.triu(hessian, 1))) > 0.1


def test_a_variable_twice_in_one_element_is_refused() -> None:
    z, empty = ca.SX.sym("z", 2), ca.SX(0, 1)
    kernel = Kernel(z, empty, empty, empty, z[0] * z[1])
    nothing = np.empty((2, 0))
    with pytest.raises(ValueError, match="names a variable twice"):
        Elements().add(kernel, [[0, 1], [3, 3]], nothing, nothing, nothing)


@pytest.fixture(scope="module")
def real() -> tuple[Any, np.ndarray, np.ndarray]:
    """A programme with every kind of row, off its own start."""
    spinning = {"type": "spin", "rate_rad_s": 0.01}
    given = scenario(
        spacecraft(
            limits={"max_force_n": 0.02, "max_speed_m_s": 1.0},
            goal={"position_m": [0, 3, 0], "frame": "dock", "position_tolerance_m": 0.1,
                  "attitude": [1, 0, 0, 0], "attitude_tolerance_rad": 0.05},
        ),
        structures=[
            structure("block", [5, 1, 0], box(2, 2, 2)),
            structure("dock", [10, 0, 0], box(1, 1, 1), motion=spinning),
        ],
        horizon={"min_s": 80, "max_s": 150},
        cost={"time": 1e-4},
    )  # fmt: skip
    problem = posed(given, 2, 3)
    start = start_of(problem)
    x = start.vector(problem, given)
    x = x + 0.1 * np.random.default_rng(7).normal(size=len(x))
    return problem.nlp, x, problem.parameter_vector(given, BACKOFF_M, 100.0)


def test_a_real_programmes_derivatives_are_its_finite_differences(real, rng) -> None:
    nlp, x, p = real
    count, step = len(x), 1e-6
    lam = rng.normal(size=nlp["g"].shape[0])

    def lagrangian_gradient(at: np.ndarray) -> np.ndarray:
        jacobian = nlp["jac_g"](at, p)[1]
        return flat(0.7 * nlp["grad_f"](at, p)[1] + ca.mtimes(jacobian.T, lam))

    upper = np.array(nlp["hess_lag"](x, p, 0.7, lam))
    hessian = upper + np.triu(upper, 1).T
    assert not np.tril(upper, -1).any()
    for _ in range(3):
        way = rng.normal(size=count)
        ahead, behind = x + step * way, x - step * way
        slope = [(flat(nlp[key](ahead, p)[0]) - flat(nlp[key](behind, p)[0])) / (2 * step)
                 for key in ("grad_f", "jac_g")]  # fmt: skip
        f_slope = flat(nlp["grad_f"](x, p)[1]) @ way
        g_slope = flat(ca.mtimes(nlp["jac_g"](x, p)[1], way))
        bend = (lagrangian_gradient(ahead) - lagrangian_gradient(behind)) / (2 * step)
        np.testing.assert_allclose(slope[0], f_slope, rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(slope[1], g_slope, rtol=1e-5, atol=1e-5)
        np.testing.assert_allclose(hessian @ way, bend, rtol=1e-5, atol=1e-4)
        assert np.max(np.abs(bend)) > 1.0
