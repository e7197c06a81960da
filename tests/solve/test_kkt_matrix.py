"""The matrix of a step: what it holds, what its inertia says, and how well it is solved."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.solve.kkt_matrix import KktMatrix

RNG = np.random.default_rng(3)
H = np.diag([1.0, 2.0, 3.0]) + np.triu(0.1 * np.ones((3, 3)), 1)
J = np.array([[1.0, 0.0, 2.0], [0.0, 1.0, 0.0]])
E = np.array([1e-8, 0.5])


def matrix(hessian: Array) -> KktMatrix:
    made = KktMatrix(ca.triu(ca.DM.ones(3, 3)).sparsity(), ca.sparsify(ca.DM(J)).sparsity())
    upper = hessian.T[np.tril_indices(3)]  # column by column
    made.fill(upper, J.T[J.T != 0.0])
    return made


def dense(hessian: Array, shift: float) -> Array:
    whole = np.triu(hessian) + np.triu(hessian, 1).T + shift * np.eye(3)
    return np.block([[whole, J.T], [J, -np.diag(E)]])


def test_solves_the_system() -> None:
    made, right = matrix(H), RNG.normal(size=5)
    assert made.factorise(0.25, E)
    assert dense(H, 0.25) @ made.solve(right) == pytest.approx(right, abs=1e-12)
    v = RNG.normal(size=5)
    assert made.times(v) == pytest.approx(dense(H, 0.25) @ v, abs=1e-12)
    assert made.transposed_times(v[3:]) == pytest.approx(J.T @ v[3:], abs=1e-12)


def test_wrong_inertia_is_seen_and_mended() -> None:
    bent = H - 10.0 * np.eye(3)
    made = matrix(bent)
    assert np.count_nonzero(np.linalg.eigvalsh(dense(bent, 0.0)) < 0.0) > 2
    assert not made.factorise(0.0, E)
    assert made.factorise(20.0, E)


def test_a_vanishing_pivot_is_no_accident() -> None:
    made = matrix(np.zeros((3, 3)))
    assert not made.factorise(0.0, np.zeros(2))
    assert made.factorise(1.0, E)
