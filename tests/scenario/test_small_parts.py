"""Limits, horizons, costs, options: ranges."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.cost import Cost
from berthing.scenario.horizon import Horizon
from berthing.scenario.limits import Limits
from berthing.scenario.options import SolverOptions


def test_horizons_fixed_and_free() -> None:
    assert not Horizon.fixed(150.0).is_free
    assert Horizon.fixed(150.0).nominal_s == 150.0
    assert Horizon(50.0, 200.0).is_free
    assert Horizon(50.0, 200.0).nominal_s == 100.0


def test_unbounded_limits_bound_nothing() -> None:
    limits = Limits.unbounded(13, 6)
    assert np.isinf(limits.state_upper).all()
    assert limits.control_lower.shape == (6,)


@pytest.mark.parametrize(
    "make",
    [
        lambda: Horizon(0.0, 1.0),
        lambda: Horizon(2.0, 1.0),
        lambda: Horizon(1.0, np.inf),
        lambda: Cost(-1.0),
        lambda: Cost(0.0, 0.0),
        lambda: Cost(1.0, np.nan),
        lambda: SolverOptions(nodes=1),
        lambda: SolverOptions(time_limit_s=0.0),
        lambda: SolverOptions(seed=-1),
        lambda: Limits(np.ones(2), np.zeros(2), np.zeros(1), np.ones(1)),
        lambda: Limits(np.ones(2), np.ones(3), np.zeros(1), np.ones(1)),
        lambda: Limits(np.zeros(1), np.array([np.nan]), np.zeros(1), np.ones(1)),
    ],
)
def test_values_out_of_range_are_refused(make: Callable[[], object]) -> None:
    with pytest.raises(InputError):
        make()
