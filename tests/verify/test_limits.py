"""Limits hold between nodes, not only at them."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from berthing.geometry.box import Box
from berthing.scenario.limits import Limits
from berthing.scenario.point_mass import PointMass
from berthing.verify.limits import excesses, first_beyond

CUBE = Box(np.ones(3))


def with_limits(own, **changes):
    limits = own.limits
    for name, (index, value) in changes.items():
        bound = np.array(getattr(limits, name))
        bound[index] = value
        limits = replace(limits, **{name: bound})
    return replace(own, limits=limits)


def test_a_polynomial_that_overshoots_between_its_nodes() -> None:
    """Eight nodes at 1 or below, and 1.02 between two of them."""
    nodes = np.cos(np.pi * np.arange(8) / 7)
    values = np.array([1, 1, 0.2, -1, -1, 0.4, 1, 1.0])
    c = chebyshev.chebfit(nodes, values, 7)[None]
    grid = chebyshev.chebval(np.linspace(-1, 1, 2001), c[0])
    assert np.max(grid) > 1.01
    time, value = first_beyond(np.array([0.0, 1.0]), c, 1.0)
    assert 1.0 < value <= np.max(grid) + 1e-9
    assert 0.0 < time < 1.0
    assert first_beyond(np.array([0.0, 1.0]), c, float(np.max(grid)) + 1e-6) is None


def test_a_control_that_stays_at_its_limit_is_fine(make) -> None:
    own = with_limits(make.vehicle(CUBE), control_upper=(0, 0.2), control_lower=(0, -0.2))
    flown = make.trajectory(
        own, lambda t: np.zeros((len(t), 13)) + np.eye(13)[6], lambda t: 0.2 + np.zeros((len(t), 6))
    )
    assert excesses(own, flown) == []


@pytest.mark.parametrize("side", ["upper", "lower"])
def test_a_control_limit_tightened(make, side: str) -> None:
    own = make.vehicle(CUBE)
    flown = make.glide(own, (0, 0, 0), (3, 0, 0))
    peak = float(np.max(np.abs(flown.control(np.linspace(0, 10, 1001)))))
    bound = peak if side == "upper" else -peak
    assert excesses(with_limits(own, **{f"control_{side}": (0, 1.0000001 * bound)}), flown) == []
    (found,) = excesses(with_limits(own, **{f"control_{side}": (0, 0.9999 * bound)}), flown)
    assert (found.vehicle, found.component) == ("craft", "fx_n")
    assert found.limit == pytest.approx(0.9999 * bound)
    assert abs(found.value) > abs(found.limit)
    assert "limit[craft, fx_n, t = " in found.reason


def test_a_state_limit_broken_only_in_the_middle(make) -> None:
    """The speed peaks at 0.45 m/s half way, where there is no node."""
    own = make.vehicle(CUBE)
    flown = make.glide(own, (0, 0, 0), (3, 0, 0), segments=1)
    assert excesses(with_limits(own, state_upper=(3, 0.4500001)), flown) == []
    (found,) = excesses(with_limits(own, state_upper=(3, 0.4499)), flown)
    assert found.component == "vx_m_s"
    assert found.time_s == pytest.approx(5.0, abs=0.3)


def test_the_norm_of_the_quaternion(make) -> None:
    own = make.vehicle(CUBE)

    def states(t, error):
        q = np.zeros((len(t), 13))
        q[:, 6] = 1.0 + error * np.sin(3.0 * t)
        return q

    assert excesses(own, make.trajectory(own, lambda t: states(t, 1e-4))) == []
    found = excesses(own, make.trajectory(own, lambda t: states(t, 2e-3)))
    assert {e.component for e in found} == {"quaternion norm"}
    assert sorted(e.limit for e in found) == pytest.approx([0.999, 1.001])


def test_a_model_without_quaternion(make) -> None:
    own = make.vehicle(Box(np.ones(2)), model=PointMass(1.0, 2))
    own = replace(own, limits=Limits(*(s * np.full(n, 2.0) for n in (2, 4) for s in (-1, 1))))
    flown = make.trajectory(own, lambda t: np.stack([0.1 * t, 0 * t, 0 * t, 0 * t], axis=1))
    assert excesses(own, flown) == []


def test_not_a_number_is_beyond() -> None:
    assert first_beyond(np.array([0.0, 1.0]), np.array([[np.nan, 0.0]]), 1.0) is not None
