"""Support points and nearest points of a set with one smooth level function, by Newton's method.

Both maximise q(x) = n·x − (pull/2) |x|² on the boundary {f = 0}: pull = 0 for the support point in
the direction n, pull = 1 for the member nearest to the point n outside. The optimum is where
r = n − pull x equals λ ∇f with λ > 0.

Every iterate lies on the boundary: a step along the tangent plane is pulled back along the ray
from an inner point (f is convex on the ray, so Newton's method in one variable converges from
anywhere). The step is Newton's for the Lagrangian and always an ascent direction, and is halved
until q grows, so the method cannot fail to converge, and it converges quadratically. By convexity
the tangent plane bounds the set, and what is left to gain is at most |r − λ ∇f| times the set's
width: the residual is the proof.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import norm

# Of the residual: what rounding leaves of it in sets that are not nearly polytopes.
RESIDUAL_TOLERANCE = 2e-14
# Steps without halving the residual, once below SMALL_RESIDUAL, after which rounding is to blame.
STALLED_STEPS, SMALL_RESIDUAL = 3, 1e-9
# Ten are usual. Whoever needs more had better start elsewhere.
MAX_STEPS = 40
# Of q, in terms of the set's size: a step that seems to lose less may have lost nothing.
ROUNDING = 1e-15
# Of the predicted gain, which a step must reach (Armijo).
SUFFICIENT_GAIN = 1e-4
SHORTEST_STEP = 1e-7
# Added to the curvature matrix, in terms of its trace: flat faces have none of their own.
REGULARISER = 1e-14
# Newton's method on a ray: a handful near the boundary, more from afar.
MAX_RAY_STEPS = 60
RAY_TOLERANCE = 4e-15


class LevelFunction(Protocol):
    """A convex f, below 0 inside."""

    def all(self, x: Array) -> tuple[Array, Array, Array]:
        """Value (k,), gradient (k, d), Hessian (k, d, d)."""

    def along(self, x: Array, d: Array) -> tuple[Array, Array]:
        """Value and slope in the direction d, both (k,)."""


@dataclass(frozen=True, eq=False)
class Hill:
    """A set to climb on.

    Attributes:
        f: its level function.
        inside: a point (d,) well inside.
        size: no two of its points are farther apart, in metres.
    """

    f: LevelFunction
    inside: Array
    size: float

    def boundary(self, x: Array) -> Array:
        """Where the rays from ``inside`` through x (k, d), which differ from it, leave the set."""
        ray = x - self.inside
        length = np.ones(len(x))
        for _ in range(MAX_RAY_STEPS):
            value, slope = self.f.along(self.inside + length[:, None] * ray, ray)
            # A slope not above zero is seen at points further in than ``inside`` is deep.
            step = np.where(slope > 0.0, -value / np.where(slope > 0.0, slope, 1.0), length)
            length = length + step
            if np.all(np.abs(step) <= RAY_TOLERANCE * length):
                break
        return np.asarray(self.inside + length[:, None] * ray)

    def climb(self, n: Array, start: Array, pull: float = 0.0) -> tuple[Array, Array]:
        """Boundary points (k, d) that maximise n·x − (pull/2) |x|², and residuals (k,).

        Args:
            n: (k, d); unit vectors for pull = 0, points outside the set for pull = 1.
            start: (k, d), points other than ``inside``; those that do not look n's way are not
                used.
            pull: 0 or 1.
        """
        best, residual = np.empty_like(n), np.full(len(n), np.inf)
        stalled, at = np.zeros(len(n), dtype=int), np.arange(len(n))
        x, moved = self._start(n, start, pull), np.ones(len(n), dtype=bool)
        for _ in range(MAX_STEPS):
            _, g, hessian = self.f.all(x)
            uphill = n[at] - pull * x
            multiplier = np.sum(uphill * g, axis=-1) / np.sum(g * g, axis=-1)
            tangent = uphill - multiplier[:, None] * g
            left = norm(tangent)
            stalled = np.where(left < 0.5 * residual[at], 0, stalled + 1)
            better = left < residual[at]
            best[at[better]], residual[at[better]] = x[better], left[better]
            hopeless = (stalled >= STALLED_STEPS) & (residual[at] < SMALL_RESIDUAL) | ~moved
            going = (residual[at] > RESIDUAL_TOLERANCE) & ~hopeless
            if not going.any():
                break
            at, x, stalled, tangent = at[going], x[going], stalled[going], tangent[going]
            d = self._direction(g[going], hessian[going], multiplier[going], tangent, pull)
            x, moved = self._advanced(n[at], x, d, np.sum(tangent * d, axis=-1), pull)
        return best, residual

    def _start(self, n: Array, start: Array, pull: float) -> Array:
        """On the boundary, the ground rising towards n; from straight above it always does."""
        x = self.boundary(start)
        rise = np.sum((n - pull * x) * self.f.all(x)[1], axis=-1)
        falls = ~(rise > 0.0)
        if falls.any():
            ahead = n[falls] - pull * self.inside
            straight = self.inside + self.size * ahead / norm(ahead)[:, None]
            x[falls] = self.boundary(straight)
        return x

    def _direction(
        self, g: Array, hessian: Array, multiplier: Array, tangent: Array, pull: float
    ) -> Array:
        """Newton's step in the tangent plane: (λ ∇²f + pull) d = tangent − μ g, g·d = 0.

        A multiple of g gᵀ in the matrix changes nothing but its condition.
        """
        dim = g.shape[-1]
        trace = np.trace(hessian, axis1=-2, axis2=-1) + ROUNDING / self.size
        weight = trace / np.sum(g * g, axis=-1)
        matrix = hessian + weight[:, None, None] * g[:, :, None] * g[:, None, :]
        matrix = np.maximum(multiplier, ROUNDING)[:, None, None] * matrix + pull * np.eye(dim)
        scale = np.trace(matrix, axis1=-2, axis2=-1)
        matrix += (REGULARISER * scale)[:, None, None] * np.eye(dim)
        solved = np.linalg.solve(matrix, np.stack([tangent, g], axis=-1))
        slope = np.sum(g * solved[..., 0], axis=-1) / np.sum(g * solved[..., 1], axis=-1)
        d = solved[..., 0] - slope[:, None] * solved[..., 1]
        return np.asarray(d * (self.size / np.maximum(norm(d), self.size))[:, None])

    def _advanced(
        self, n: Array, x: Array, d: Array, gain: Array, pull: float
    ) -> tuple[Array, npt.NDArray[np.bool_]]:
        """x moved along d, as far as it pays, and back to the boundary; and whether it moved."""

        def height(n: Array, x: Array) -> Array:
            return np.asarray(np.sum(n * x, axis=-1) - 0.5 * pull * np.sum(x * x, axis=-1))

        before = height(n, x)
        noise = ROUNDING * (self.size + np.abs(before))
        moved, waiting, length = x.copy(), np.arange(len(x)), 1.0
        while len(waiting) and length > SHORTEST_STEP:
            tried = self.boundary(x[waiting] + length * d[waiting])
            needed = before + SUFFICIENT_GAIN * length * gain - noise
            pays = height(n[waiting], tried) >= needed[waiting]
            moved[waiting[pays]] = tried[pays]
            waiting, length = waiting[~pays], 0.5 * length
        stays = np.zeros(len(x), dtype=bool)
        stays[waiting] = True
        return moved, ~stays
