"""On a smooth case every scheme converges spectrally, in cost and in defects between the nodes."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise

import numpy as np
import pytest

from support.smooth import EXACT, Found, found

FLOOR = 1e-8
"""Of costs: the solver's tolerance. Below it errors say nothing."""

FLAT = 1e-6
"""Of the lower Hamiltonian with Radau points."""

answer = lru_cache(maxsize=None)(found)

GLOBAL = "lgl-global", 1
RADAU = "lgr", 1


def cost_error(of: Found) -> float:
    return abs(of.cost / answer(*EXACT).cost - 1.0)


def rates(errors: list[float], degrees: list[int]) -> tuple[list[float], list[float]]:
    """Factor by which the error falls a degree, and the order of the power law between two."""
    factors, orders = [], []
    for (e0, d0), (e1, d1) in pairwise(zip(errors, degrees, strict=True)):
        factors.append((e0 / e1) ** (1 / (d1 - d0)))
        orders.append(np.log(e0 / e1) / np.log(d1 / d0))
    return factors, orders


def test_the_rates_tell_a_power_law_from_a_spectral_one() -> None:
    degrees = [4, 8, 16]
    factors, orders = rates([d**-4.0 for d in degrees], degrees)
    np.testing.assert_allclose(orders, 4.0)
    assert factors[1] < factors[0]
    factors, orders = rates([3.0**-d for d in degrees], degrees)
    np.testing.assert_allclose(factors, 3.0)
    assert orders[1] > 1.5 * orders[0]


@pytest.mark.slow
@pytest.mark.parametrize("scheme", [GLOBAL, RADAU], ids=lambda s: s[0])
def test_defects_of_one_segment_fall_faster_than_any_power(scheme) -> None:
    degrees = [6, 10, 14, 18, 22]
    errors = [answer(*scheme, d).defect for d in degrees]
    factors, orders = rates(errors, degrees)
    assert min(factors) > 2.0, errors
    # A power law would keep its order.
    assert all(b > a + 2.0 for a, b in pairwise(orders)), orders
    assert errors[-1] < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize(
    ("scheme", "degrees"), [(GLOBAL, [4, 6, 8, 10]), (RADAU, [3, 5, 7, 9])], ids=["lgl", "lgr"]
)
def test_costs_of_one_segment_fall_spectrally_to_the_solvers_tolerance(scheme, degrees) -> None:
    errors = [cost_error(answer(*scheme, d)) for d in degrees]
    factors, orders = rates(np.maximum(errors, FLOOR).tolist(), degrees)
    assert min(factors) > 2.5, errors
    assert orders[-1] > orders[0] + 2.0, orders
    assert cost_error(answer(*scheme, 20)) < FLOOR


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["lgr", "lgl"])
def test_in_two_segments_too(scheme) -> None:
    degrees = [3, 4, 5, 6, 7]
    answers = [answer(scheme, 2, d) for d in degrees]
    assert all(a.solved for a in answers)
    costs = [cost_error(a) for a in answers]
    assert costs[0] > 1e-5
    # A Radau segment is exact two degrees further than a Lobatto one of as many points.
    assert costs[-1] < {"lgr": 1e-8, "lgl": 1e-6}[scheme]
    # Two degrees on: with Lobatto points an even degree is luckier than an odd one here.
    assert all(costs[i + 2] < 0.05 * costs[i] for i in range(len(costs) - 2)), costs
    factors, _ = rates([a.defect for a in answers], degrees)
    assert min(factors) > 1.5, factors
    assert np.prod(factors) > 3.0 ** (degrees[-1] - degrees[0])


@pytest.mark.parametrize("mesh", [("lgr", 1, 14), ("lgr", 4, 10)], ids=str)
def test_with_radau_points_the_hamiltonian_is_flat(mesh) -> None:
    here = answer(*mesh)
    assert here.solved
    assert here.drift < FLAT
    # What a mesh that does not resolve the motion gives is not flat.
    assert answer("lgr", 1, 4).drift > 1e-3


def test_one_global_lobatto_segment_of_the_papers_nodes() -> None:
    """Where nothing is in the way its costates are as good as Radau's."""
    here = answer(*GLOBAL, 19)
    assert here.nodes == 20
    assert here.solved
    assert cost_error(here) < FLOOR
    assert here.drift < FLAT
