"""Each shape as smooth convex inequalities f(x) ≤ 0, for forms that differentiate them.

The paper's eq. (c-func), (d-func) and (d-func3), and what it builds of them: one function for an
ellipsoid, a superellipsoid or a smoothed polytope, m half-spaces for an exact polyhedron, two ends
and a quadratic for a true cylinder, all members' functions for an intersection.

Points are in units of the set's own size, x = centre_m + radius_m s, and every function is of
order one there: the closest points of a small and of a large set are then alike to the solver (the
paper's discussion of scaling).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import halfspaces
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.polytope import Polytope
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.sym import Sym

Functions = Callable[[Any, Sym, float], Sym]
"""(shape, x (d,) in metres, a length to divide functions in metres by) → casadi column (m,)."""


@dataclass(frozen=True)
class LevelFunctions:
    """{x : f(x) ≤ 0} in the set's own frame, x = centre_m + radius_m s.

    Attributes:
        dim: of s; 0 for a point, which needs no variables of its own.
        count: functions m; 0 for a point.
        centre_m: a member of the set (d,), where s is zero.
        radius_m: unit of s.
        first: casadi function s → f (m,), ∂f/∂s (m, d).
        second: casadi function (s, λ (m,)) → ∂²(λᵀf)/∂s² (d, d).
    """

    dim: int
    count: int
    centre_m: Array
    radius_m: float
    first: Any = field(repr=False)
    second: Any = field(repr=False)

    def at(self, s: Sym) -> tuple[Sym, Sym]:
        """f (m,) and its Jacobian (m, d) at s, a symbol or a number."""
        f, jacobian = self.first(s)
        return f, jacobian

    def values(self, s: Array) -> tuple[Array, Array]:
        """f (n, m) and Jacobians (n, m, d) at s (n, d)."""
        n = len(s)
        if not self.count:
            return np.zeros((n, 0)), np.zeros((n, 0, self.dim))
        f, jacobian = self.first.map(n)(s.T)
        blocks = np.asarray(jacobian).reshape(self.count, n, self.dim)
        return np.asarray(f).T, blocks.transpose(1, 0, 2)

    def curvature(self, s: Array, multipliers: Array) -> Array:
        """∂²(λᵀf)/∂s² (n, d, d) at s (n, d), λ (n, m)."""
        n = len(s)
        if not self.count:
            return np.zeros((n, self.dim, self.dim))
        hessian = np.asarray(self.second.map(n)(s.T, multipliers.T))
        return hessian.reshape(self.dim, n, self.dim).transpose(1, 0, 2)


def level_functions(shape: ConvexSet) -> LevelFunctions:
    """The smooth inequalities of ``shape``.

    Raises:
        CapabilityError: none are known; names the shapes that have them.
    """
    if isinstance(shape, Sphere) and shape.radius == 0.0:
        return LevelFunctions(0, 0, np.zeros(shape.dim), 1.0, None, None)
    functions = _entry(shape)
    centre, radius = _middle(shape)
    s = ca.SX.sym("s", shape.dim)
    f = ca.SX(ca.densify(functions(shape, ca.DM(centre) + radius * s, radius)))
    multipliers = ca.SX.sym("lam", f.numel())
    jacobian = ca.densify(ca.jacobian(f, s))
    hessian = ca.densify(ca.hessian(ca.dot(multipliers, f), s)[0])
    return LevelFunctions(
        shape.dim, f.numel(), centre, radius,
        ca.Function("first", [s], [f, jacobian]),
        ca.Function("second", [s, multipliers], [hessian]),
    )  # fmt: skip


def _middle(shape: ConvexSet) -> tuple[Array, float]:
    """A member of the set (d,), inside one that is not flat, and the set's size about it."""
    if isinstance(shape, HalfSpace):
        return (shape.offset - 1.0) * shape.normal, 1.0
    axes = np.concatenate([np.eye(shape.dim), -np.eye(shape.dim)])
    extent, points = shape.support(axes)
    widths = 0.5 * (extent[: shape.dim] + extent[shape.dim :])
    return points.mean(axis=0), min(shape.bounding_radius, float(np.linalg.norm(widths)))


def _entry(shape: ConvexSet) -> Functions:
    try:
        return FUNCTIONS[type(shape)]
    except KeyError:
        known = ", ".join(sorted(kind.__name__ for kind in FUNCTIONS))
        raise CapabilityError(
            f"no smooth inequalities for {type(shape).__name__}; `kkt` and `kkt-complementarity` "
            f"take {known}; `plane` takes any set with a conic form or vertices"
        ) from None


def _ball(shape: Sphere, x: Sym, unit_m: float) -> Sym:
    return ca.sumsqr(x / shape.radius) - 1


def _ellipsoid(shape: Ellipsoid, x: Sym, unit_m: float) -> Sym:
    return ca.sumsqr(x / ca.DM(shape.semi_axes)) - 1


def _halfspaces(shape: ConvexSet, x: Sym, unit_m: float) -> Sym:
    A, b = halfspaces(shape)
    return (ca.mtimes(ca.DM(A), x) - ca.DM(b)) / unit_m


def _cylinder(shape: Cylinder, x: Sym, unit_m: float) -> Sym:
    i = shape.axis_index
    across = ca.vertcat(*(x[j] for j in range(3) if j != i)) / shape.radius
    beyond = ca.vertcat(x[i], -x[i]) - shape.half_length
    return ca.vertcat(beyond / unit_m, ca.sumsqr(across) - 1)


def _superellipsoid(shape: Superellipsoid, x: Sym, unit_m: float) -> Sym:
    ratio = x / ca.DM(shape.semi_axes)
    powers = [ratio[i] ** int(p) for i, p in enumerate(shape.exponents)]
    return ca.sum1(ca.vertcat(*powers)) / shape.bound - 1


def _smoothed_polytope(shape: SmoothedPolytope, x: Sym, unit_m: float) -> Sym:
    natural = np.log(shape.base) * shape.exponents
    beyond = ca.mtimes(ca.DM(shape.A), x) - ca.DM(shape.b)
    divisor = np.log(shape.base) * shape.level_exponent
    return ca.logsumexp(ca.DM(natural) * beyond) / divisor / unit_m


def _intersection(shape: Intersection, x: Sym, unit_m: float) -> Sym:
    columns = []
    for member, placement in zip(shape.sets, shape.placements, strict=True):
        own = ca.mtimes(ca.DM(placement.rotation.T), x - ca.DM(placement.position))
        columns.append(_entry(member)(member, own, unit_m))
    return ca.vertcat(*columns)


FUNCTIONS: dict[type[ConvexSet], Functions] = {
    Box: _halfspaces,
    Polytope: _halfspaces,
    HalfSpace: _halfspaces,
    Sphere: _ball,
    Ellipsoid: _ellipsoid,
    Superellipsoid: _superellipsoid,
    SmoothedPolytope: _smoothed_polytope,
    Cylinder: _cylinder,
    Intersection: _intersection,
}
