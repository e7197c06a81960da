"""The lower Hamiltonian is constant on a true extremal, and not on another."""

from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.scenario.cost import Cost
from berthing.verify.optimality import hamiltonian, relative_drift

CUBE = Box(np.ones(3))


def extremal(make):
    own = make.vehicle(CUBE)
    phase = make.scenario([own], []).phases[0]
    return phase, make.glide_nodes(make.glide(own, (0, 0, 0), (3, 1, -2)))


def test_the_double_integrator(make) -> None:
    phase, nodes = extremal(make)
    times, values = hamiltonian(phase, [nodes])
    assert relative_drift(values) < 1e-10
    # H = −‖f‖² − 2m ḟ·v at any time; at the start v = 0 and f = 6 m d / T².
    force = 6.0 * 3.0 * np.array([3.0, 1.0, -2.0]) / 100.0
    np.testing.assert_allclose(values, -force @ force, rtol=1e-10)
    np.testing.assert_array_equal(times, nodes.times_s)


@pytest.mark.parametrize("scale", [-1.0, 0.5, 1.001])
def test_other_costates_drift(make, scale: float) -> None:
    phase, nodes = extremal(make)
    _, values = hamiltonian(phase, [replace(nodes, costates=scale * nodes.costates)])
    assert relative_drift(values) > 5e-4


def test_weights_of_the_cost(make) -> None:
    phase, nodes = extremal(make)
    _, plain = hamiltonian(phase, [nodes])
    _, timed = hamiltonian(replace(phase, cost=Cost(1.0, 2.5)), [nodes])
    np.testing.assert_allclose(timed - plain, 2.5, rtol=1e-12)


def test_nodes_without_control_are_left_out(make) -> None:
    phase, nodes = extremal(make)
    controls = nodes.controls.copy()
    controls[-1] = np.nan
    times, values = hamiltonian(phase, [replace(nodes, controls=controls)])
    assert len(times) == len(values) == len(nodes.times_s) - 1
    assert relative_drift(values) < 1e-10


def test_nothing_to_compare(make) -> None:
    phase, nodes = extremal(make)
    blank = replace(nodes, costates=np.full_like(nodes.costates, np.nan))
    for given in ([], [blank], [nodes, replace(nodes, times_s=nodes.times_s + 1.0)]):
        assert relative_drift(hamiltonian(phase, given)[1]) is None
    assert relative_drift(np.zeros(5)) == 0.0
