"""Algebra of products of second-order cones {(a, v) : ‖v‖ ≤ a}, many at a time.

Vectors are arrays (..., p), the head first. The product, the determinant and the scaling point are
those of the Jordan algebra of the cone (Vandenberghe, *The CVXOPT linear and quadratic cone program
solvers*, 2010, sections 2 and 4).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array


def tail_length(a: Array) -> Array:
    """‖v‖ of (a, v)."""
    return np.asarray(np.sqrt(np.sum(a[..., 1:] ** 2, axis=-1)))


def root_determinant(a: Array) -> Array:
    """√(a² − ‖v‖²), factored so that nothing cancels twice; 0 outside the cone."""
    length = tail_length(a)
    return np.asarray(np.sqrt(np.maximum((a[..., 0] - length) * (a[..., 0] + length), 0.0)))


def product(a: Array, b: Array) -> Array:
    """a ∘ b = (a·b, a₀ b₁ + b₀ a₁)."""
    head = np.sum(a * b, axis=-1, keepdims=True)
    return np.concatenate([head, a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:]], axis=-1)


def quotient(a: Array, b: Array) -> Array:
    """The x with a ∘ x = b, a inside the cone."""
    head = a[..., 0] * b[..., 0] - np.sum(a[..., 1:] * b[..., 1:], axis=-1)
    head = (head / root_determinant(a) ** 2)[..., None]
    return np.concatenate([head, (b[..., 1:] - head * a[..., 1:]) / a[..., :1]], axis=-1)


def inverse_step(a: Array, d: Array) -> Array:
    """1 over the longest step t with a + t d in the cone, a inside it; ≤ 0 where none leaves it."""
    root = root_determinant(a)[..., None]
    unit = a / root
    along = unit[..., 0] * d[..., 0] - np.sum(unit[..., 1:] * d[..., 1:], axis=-1)
    pull = (along + d[..., 0]) / (unit[..., 0] + 1.0)
    tail = d[..., 1:] - pull[..., None] * unit[..., 1:]
    return np.asarray((np.sqrt(np.sum(tail**2, axis=-1)) - along) / root[..., 0])


@dataclass(frozen=True, eq=False)
class Scaling:
    """Nesterov and Todd's symmetric W with W z = W⁻¹ s, one a cone.

    W = size [[w₀, w₁ᵀ], [w₁, 1 + w₁ w₁ᵀ/(1 + w₀)]]; its inverse has −w₁ and 1/size.
    """

    w: Array
    size: Array

    @staticmethod
    def of(s: Array, z: Array) -> Scaling:
        """For s and z inside their cones."""
        root_s, root_z = root_determinant(s), root_determinant(z)
        s, z = s / root_s[..., None], z / root_z[..., None]
        gamma = np.sqrt(0.5 * (1.0 + np.sum(s * z, axis=-1)))
        mirrored = np.concatenate([z[..., :1], -z[..., 1:]], axis=-1)
        return Scaling((s + mirrored) / (2.0 * gamma)[..., None], np.sqrt(root_s / root_z))

    def apply(self, v: Array) -> Array:
        """W v."""
        return _scaled(self.w[..., :1], self.w[..., 1:], v) * self.size[..., None]

    def unapply(self, v: Array) -> Array:
        """W⁻¹ v."""
        return _scaled(self.w[..., :1], -self.w[..., 1:], v) / self.size[..., None]

    def unapply_columns(self, G: Array) -> Array:
        """W⁻¹ G for G (..., p, columns)."""
        columns = np.swapaxes(G, -1, -2)
        w, size = self.w[..., None, :], self.size[..., None, None]
        return np.swapaxes(_scaled(w[..., :1], -w[..., 1:], columns) / size, -1, -2)


def _scaled(head: Array, tail: Array, v: Array) -> Array:
    across = np.sum(tail * v[..., 1:], axis=-1, keepdims=True)
    top = head * v[..., :1] + across
    return np.concatenate([top, v[..., 1:] + tail * (v[..., :1] + across / (1.0 + head))], axis=-1)
