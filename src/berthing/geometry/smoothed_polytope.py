"""The paper's smoothed polytope: one smooth function in place of many half-spaces."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import e, log
from typing import Literal, final

import numpy as np

from berthing.errors import InputError
from berthing.geometry import direction_cover, polytope_smoothing
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.boundary_climb import Hill
from berthing.geometry.capability import halfspaces
from berthing.geometry.convex_set import ConvexSet, finite, last_axis, norm, positive, unit
from berthing.geometry.hulls import unit_rows
from berthing.geometry.log_sum_exp import LogSumExp
from berthing.geometry.mesh import Mesh, support_mesh
from berthing.geometry.smoothed_support import SmoothedSupport

WHERE = "SmoothedPolytope"


@final
@dataclass(frozen=True, eq=False, init=False)
class SmoothedPolytope(ConvexSet):
    """{x : Σ_j base^(Q_j (a_j·x − b_j)) ≤ 1}, the paper's eq. (d-func3); a_j are unit rows.

    No term of the sum exceeds 1, so the set lies inside the polytope {A x ≤ b}. Where all of
    a_j·x ≤ b_j − ln(m)/Q_min hold, m the number of rows, each of the m terms is at most 1/m
    (base e), so the set contains those points: no face recedes by more than ln(m)/Q_min along its
    normal. Where k faces of equal Q meet and the others are far, it is ln(k)/Q.

    Attributes:
        A: outward unit rows (m, dim); redundant ones count too.
        b: (m,) in metres.
        exponents: Q_j (m,), per metre.
        level_exponent: Q_{m+1} of the paper, per metre. It scales the level and moves nothing.
        base: of the powers. Another one does what another scale of all exponents does.
        shift_m: the set is a model of the polytope {A x ≤ b − shift_m}; 0 for an inner model.
    """

    A: Array
    b: Array
    exponents: Array
    level_exponent: float
    base: float
    shift_m: float

    def __init__(
        self,
        A: Array,
        b: Array,
        exponents: Array | float,
        level_exponent: float | None = None,
        base: float = e,
        shift_m: float = 0.0,
    ) -> None:
        """From half-spaces A x ≤ b, rows of any length but zero, and exponents, (m,) or one.

        Exponents are those of unit rows: what the paper writes for a row is to be multiplied by
        the row's length.

        Raises:
            InputError: shapes that do not fit, numbers out of range, half-spaces that enclose
                nothing or no bounded set, or exponents so small that nothing is left.
        """
        A = as_array(A, (None, None), f"{WHERE}.A")
        A, b = unit_rows(A, as_array(b, (len(A),), f"{WHERE}.b"), WHERE)
        Q = _exponents(exponents, len(A))
        level_exponent = float(np.max(Q)) if level_exponent is None else level_exponent
        if not finite(base, f"{WHERE}.base") > 1.0:
            raise InputError(f"{WHERE}.base", f"is {base:g}", "a number above one")
        for name, value in (("A", A), ("b", b), ("exponents", Q)):
            value = np.ascontiguousarray(value)
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        scale = positive(level_exponent, f"{WHERE}.level_exponent")
        object.__setattr__(self, "level_exponent", scale)
        object.__setattr__(self, "base", float(base))
        object.__setattr__(self, "shift_m", finite(shift_m, f"{WHERE}.shift_m"))
        self._refuse_empty()

    @staticmethod
    def inner(
        polytope: ConvexSet,
        exponent: Array | float,
        level_exponent: float | None = None,
        base: float = e,
    ) -> SmoothedPolytope:
        """The paper's model: inside the box or polytope.

        Raises:
            CapabilityError: a set without finitely many half-spaces.
            InputError: an exponent so small that nothing is left, as of a cube of half-size below
                ln(6)/exponent.
        """
        return SmoothedPolytope(*halfspaces(polytope), exponent, level_exponent, base)

    @staticmethod
    def outer(
        polytope: ConvexSet,
        exponent: Array | float,
        level_exponent: float | None = None,
        base: float = e,
    ) -> SmoothedPolytope:
        """Around the box or polytope: the inner model of one whose faces are moved out.

        By the least distance, the same for all, that brings the sum to at most 1 at every vertex.
        The sum is convex, so it is then at most 1 in the whole polytope. Faces bulge by no more
        than that distance, which is about ln(k)/Q where k faces meet and at most ln(m)/Q_min.

        Raises:
            CapabilityError: a set without finitely many half-spaces.
        """
        A, b = halfspaces(polytope)
        natural = log(base) * _exponents(exponent, len(b))
        shift = polytope_smoothing.outward_shift(A, b, natural)
        return SmoothedPolytope(A, b + shift, exponent, level_exponent, base, shift)

    @staticmethod
    def for_error(
        polytope: ConvexSet, error_m: float, side: Literal["inner", "outer"]
    ) -> SmoothedPolytope:
        """The model with about the smallest exponent, one for all faces, and no larger an error.

        Args:
            polytope: a box or polytope.
            error_m: allowed distance from any point of either set to the other.
            side: ``inner`` or ``outer``.

        Raises:
            CapabilityError: a set without finitely many half-spaces.
            InputError: an error that is not above zero, or another side.
        """
        builders = {"inner": SmoothedPolytope.inner, "outer": SmoothedPolytope.outer}
        if side not in builders:
            raise InputError("side", f"is {side!r}", "inner or outer")
        allowed = positive(error_m, "error_m")
        build = builders[side]
        return polytope_smoothing.coarsest_allowed(
            lambda exponent: build(polytope, exponent),
            len(halfspaces(polytope)[1]),
            polytope.bounding_radius,
            allowed,
        )

    @property
    def side(self) -> Literal["inner", "outer"]:
        """Whether the set lies inside the polytope that it models, or around it."""
        return "outer" if self.shift_m > 0.0 else "inner"

    @cached_property
    def error_m(self) -> float:
        """A proven bound on the Hausdorff distance to the polytope {A x ≤ b − shift_m}, in metres.

        No point of one is farther than this from the other. Exact for an inner model, and at most
        0.1% too large for an outer one: see ``polytope_smoothing``.
        """
        if self.side == "inner":
            return polytope_smoothing.inner_error(self._finder)
        return polytope_smoothing.outer_error(self._finder, self.shift_m)

    @property
    def dim(self) -> int:
        return int(self.A.shape[1])

    @property
    def centre(self) -> Array:
        """The point (dim,) at which the level is lowest, in metres."""
        return self._finder.centre

    @property
    def hill(self) -> Hill:
        """What finds support points and nearest points on the boundary."""
        return self._finder.hill

    @cached_property
    def bounding_radius(self) -> float:
        """sup |x|, at most 0.1% too large."""
        cones = direction_cover.orthants(self.dim)
        proven = direction_cover.largest(lambda u: self.support(u)[0], cones)
        return min(proven, float(np.max(norm(self._finder.corners))))

    def support(self, n: Array) -> tuple[Array, Array]:
        """The value is an upper bound: n·point, and what the point's residual leaves open."""
        n = last_axis(n, self.dim, f"{WHERE}.support: n")
        rays = unit(n).reshape(-1, self.dim)
        some = np.flatnonzero(np.any(rays != 0.0, axis=-1))
        value, point = np.zeros(len(rays)), np.tile(self.centre, (len(rays), 1))
        if len(some):
            point[some], residual = self._finder.points(rays[some])
            value[some] = np.sum(rays * point, axis=-1)[some] + residual * self._finder.hill.size
        return norm(n) * value.reshape(n.shape[:-1]), point.reshape(n.shape)

    def level(self, x: Array) -> Array:
        """(1/Q_{m+1}) log Σ base^(Q_j f_j), in metres."""
        return self._function.value(last_axis(x, self.dim, f"{WHERE}.level: x"))

    def level_gradient(self, x: Array) -> Array:
        """(..., dim), without unit; Σ w_j Q_j a_j / Q_{m+1} with weights w that sum to 1."""
        return self._function.gradient(last_axis(x, self.dim, f"{WHERE}.level_gradient: x"))

    def level_hessian(self, x: Array) -> Array:
        """(..., dim, dim), per metre."""
        return self._function.hessian(last_axis(x, self.dim, f"{WHERE}.level_hessian: x"))

    def mesh(self) -> Mesh:
        return support_mesh(self.support, self.dim)

    @cached_property
    def _function(self) -> LogSumExp:
        natural = log(self.base) * self.exponents
        divisor = log(self.base) * self.level_exponent
        return LogSumExp(natural[:, None] * self.A, natural * self.b, divisor)

    @cached_property
    def _finder(self) -> SmoothedSupport:
        return SmoothedSupport(self.A, self.b, log(self.base) * self.exponents, WHERE)

    def _refuse_empty(self) -> None:
        if not self._finder.is_empty:
            return
        largest = float(np.max(self.exponents))
        # At this multiple of the exponents, no term at the centre exceeds 1/m.
        slack = log(self.base) * self.exponents * (self.b - self.A @ self.centre)
        enough = log(len(self.b)) / float(np.min(slack))
        raise InputError(
            WHERE,
            f"is empty: the polytope is too small for an exponent of {largest:.6g} per metre",
            f"a larger exponent, such as {1.01 * enough * largest:.3g} per metre",
        )


def _exponents(values: Array | float, rows: int) -> Array:
    where = f"{WHERE}.exponents"
    try:
        exponents = np.atleast_1d(np.array(values, dtype=np.float64))
    except (TypeError, ValueError):
        raise InputError(where, f"is {values!r}", "one number, or one for each row") from None
    if exponents.shape not in ((1,), (rows,)):
        found = f"has the shape {exponents.shape}"
        raise InputError(where, found, f"one number, or one for each of {rows} rows")
    for i, exponent in enumerate(exponents):
        positive(float(exponent), where if len(exponents) == 1 else f"{where}[{i}]")
    return np.broadcast_to(exponents, (rows,)).copy()
