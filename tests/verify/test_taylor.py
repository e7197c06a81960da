"""Enclosures hold every derivative of what they enclose, and little else."""

import math

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.casadi_xp import CASADI
from berthing.errors import InputError
from berthing.verify.interval import Interval, angle, cosine
from berthing.verify.taylor import Taylor
from berthing.verify.taylor_xp import TAYLOR
from berthing.xp import NUMPY

ORDER = 3
ROW = np.array([1.0, -2.0, 3.0])

FUNCTIONS = {
    "product": lambda x, xp: x[0] * x[1] + x[2],
    "sine": lambda x, xp: xp.sin(x[0]) * xp.cos(x[1]),
    "exponential": lambda x, xp: xp.exp(x[0]) / (1 + x[1] ** 2),
    "logarithm": lambda x, xp: xp.log(2 + x[0] ** 2),
    "root": lambda x, xp: xp.sqrt(1 + x[0] ** 2 + x[1] ** 4),
    "arctan": lambda x, xp: xp.arctan(x[0] * x[1]),
    "arctan2": lambda x, xp: xp.arctan2(x[0] + 3, x[1]),
    "arctan2 of a number": lambda x, xp: xp.arctan2(2.0, x[1] + 3),
    "abs": lambda x, xp: xp.abs(x[0] + 3),
    "minimum": lambda x, xp: xp.minimum(x[0] - 5, x[1]),
    "maximum": lambda x, xp: xp.maximum(-5.0, x[1]),
    "where": lambda x, xp: xp.where(x[0] > -10, x[0] * x[1], x[2]),
    "where not": lambda x, xp: xp.where(x[0] <= -10, 1.0, x[2]),
    "tangent": lambda x, xp: xp.tan(0.3 * x[0]) + xp.tanh(x[1]),
    "norm": lambda x, xp: xp.norm(x + 10),
    "dot": lambda x, xp: xp.dot(ROW, x) - xp.dot(x, ROW + 1),
    "matrix": lambda x, xp: xp.matvec([[1, 2, 3], [0, 1, 0]], x)[0],
    "powers": lambda x, xp: x[0] ** 3 + (x[1] + 4) ** -2 + x[2] ** 1 + x[0] ** 0,
    "reflected": lambda x, xp: 2 - x[0] + 3 / (x[1] + 9) - (1 - x[2]) / 2,
    "rotation": lambda x, xp: xp.rotate(xp.vector(1.0, 0.1 * x[0:2], 0.0), x)[1],
    "unrotation": lambda x, xp: xp.unrotate(xp.vector(1.0, 0.1 * x), ROW)[2],
    "plane": lambda x, xp: xp.rotate_plane(x[0], x[1:3])[0],
    "cross": lambda x, xp: xp.cross(x, ROW)[1] + xp.sumsqr(x),
    "turning": lambda x, xp: xp.quaternion_rate(xp.vector(1.0, x), ROW)[3],
}


@pytest.fixture(scope="module")
def path():
    """Three cubics of time, and casadi's values and derivatives of functions of them."""
    coefficients = 0.3 * np.random.default_rng(3).normal(size=(3, 4))
    t = ca.SX.sym("t")
    x = ca.vertcat(*(sum(c * t**j for j, c in enumerate(row)) for row in coefficients))
    return t, x


def derivatives(path, expression, times):
    t, _ = path
    orders = [expression]
    for _ in range(ORDER):
        orders.append(ca.jacobian(orders[-1], t))
    function = ca.Function("f", [t], orders)
    return np.array([[float(value) for value in function(time)] for time in times])


def enclosed(path, times, slack=1e-12):
    """The path over the span of dense ``times``, as a series."""
    _, x = path
    rows = np.array([derivatives(path, x[i], times) for i in range(3)])
    terms = []
    for k in range(ORDER + 1):
        low, high = rows[:, :, k].min(axis=1) - slack, rows[:, :, k].max(axis=1) + slack
        terms.append(Interval(low[:, None], high[:, None]).scaled(1 / math.factorial(k)))
    return Taylor(tuple(terms))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_derivative_is_enclosed(path, name):
    times = np.linspace(0.1, 0.13, 8)
    true = derivatives(path, FUNCTIONS[name](path[1], CASADI), times)
    found = FUNCTIONS[name](enclosed(path, times), TAYLOR)
    for k, term in enumerate(found.terms):
        low, high = (float(end[..., 0]) * math.factorial(k) for end in (term.low, term.high))
        assert low <= true[:, k].min() + 1e-9
        assert high >= true[:, k].max() - 1e-9
        assert high - low <= 8 * np.ptp(true[:, k]) + 1.0


@pytest.mark.parametrize("name", FUNCTIONS)
def test_at_an_instant_the_enclosure_is_the_value(path, name):
    when = np.array([0.37])
    true = derivatives(path, FUNCTIONS[name](path[1], CASADI), when)[0]
    x = enclosed(path, when, slack=0.0)
    found = FUNCTIONS[name](x, TAYLOR)
    said = [float(t.middle[..., 0]) * math.factorial(k) for k, t in enumerate(found.terms)]
    np.testing.assert_allclose(said, true, rtol=1e-10, atol=1e-12)
    number = FUNCTIONS[name](x.terms[0].middle[:, 0], NUMPY)
    assert number == pytest.approx(true[0], rel=1e-12, abs=1e-14)


def over(low, high, slope=1.0):
    """A scalar that runs from ``low`` to ``high``."""
    ends = [np.array([v]) for v in (low, high)]
    rest = [Interval.of(np.array([v])) for v in (slope, 0.0, 0.0)]
    return Taylor((Interval(*ends), *rest))


def test_what_is_not_smooth_has_no_second_derivative():
    for found in (TAYLOR.abs(over(-1, 1)), TAYLOR.maximum(over(-1, 1), 0.0)):
        assert found.terms[0].low[0] == 0.0
        assert found.terms[1].high[0] == 1.0
        assert found.terms[1].low[0] <= 0.0
        assert np.isinf(found.terms[2].size)


def test_a_jump_has_no_slope():
    found = TAYLOR.where(over(-1, 1) < 0.0, 3.0, over(5, 6))
    assert (found.terms[0].low[0], found.terms[0].high[0]) == (3.0, 6.0)
    assert np.isinf(found.terms[1].size)


def test_division_by_what_may_vanish_says_nothing():
    found = 1.0 / over(-1, 1)
    assert all(np.isinf(term.size) for term in found.terms)
    assert np.all(np.isinf((TAYLOR.sqrt(over(0, 1))).terms[1].size))


def test_cosine_and_angle_know_their_extremes():
    low, high = np.array([-0.1, 3.0, 0.2, -np.inf]), np.array([0.2, 3.3, 7.0, np.inf])
    found = cosine(Interval(low, high))
    np.testing.assert_allclose(found.low, [np.cos(0.2), -1, -1, -1])
    np.testing.assert_allclose(found.high, [1, np.cos(3.3), 1, 1])
    one = Interval(np.array([1.0]), np.array([2.0]))
    around = Interval(np.array([-1.0]), np.array([1.0]))
    assert angle(around, one).size == pytest.approx(np.pi / 4)
    assert angle(around, -one).size == np.pi


def test_powers_are_whole():
    with pytest.raises(InputError, match=r"0\.5"):
        over(1, 2) ** 0.5
