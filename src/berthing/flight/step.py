"""One interval flown: the state as a polynomial, and how it depends on what goes in.

The equations are the solver's, so that the checks, which have their own, check these too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import casadi as ca
import numpy as np
from numpy.polynomial import chebyshev

from berthing.dynamics.models import symbolic
from berthing.errors import InputError
from berthing.flight.holds import Hold
from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_model import UserModel
from berthing.trajectory import Segment

DEGREE = 10
"""Of the state on an interval, which is short beside the motion."""

SWEEPS = 60
"""Of Picard's iteration: each gains the ratio of the interval to the motion's own time."""

SETTLED = 1e-14
"""Relative change of the last sweep."""

SUBSTEPS = 3
"""Of Runge and Kutta's method for the derivatives, which need no more than some digits."""


@dataclass(frozen=True)
class Stepper:
    """Flies a model from sample to sample."""

    model: Model

    def pieces(
        self, hold: Hold, t0_s: float, t1_s: float, x: Array, first: Array, second: Array
    ) -> list[Segment]:
        """From x (nx,) on, between the commands ``first`` and ``second`` (nu,).

        One segment, or more where the equations have kinks in between.
        """
        out = []
        inside = [t for t in self._kinks_s if t0_s < t < t1_s]
        for a, b in pairwise([t0_s, *inside, t1_s]):
            early, late = (first + (t - t0_s) / (t1_s - t0_s) * (second - first) for t in (a, b))
            control = hold.coefficients(early, late) if hold.ends else first[None]
            out.append(Segment(a, b, self.fly(a, b, x, control), control))
            x = out[-1].state.sum(axis=0)
        return out

    def fly(self, t0_s: float, t1_s: float, x: Array, control: Array) -> Array:
        """Chebyshev coefficients (DEGREE + 1, nx) of the state from x (nx,) on.

        x(s) = x₀ + h ∫ f is iterated at the Lobatto points: the limit solves the collocated
        equations of motion.

        Args:
            control: Chebyshev coefficients (k, nu) on the same interval.

        Raises:
            InputError: the interval is too long for it.
        """
        nodes, integrate = _COLLOCATION
        half = 0.5 * (t1_s - t0_s)
        t = 0.5 * (t0_s + t1_s) + half * nodes
        u = chebyshev.chebval(nodes, control)
        values = np.repeat(x[:, None], len(nodes), axis=1)
        for _ in range(SWEEPS):
            rates = self._rates(t[None], values, u).full()
            after = x[:, None] + half * rates @ integrate.T
            change = np.max(np.abs(after - values))
            values = after
            if not np.isfinite(change):
                break
            if change <= SETTLED * max(1.0, float(np.max(np.abs(values)))):
                return np.asarray(_to_coefficients(values.T))
        raise InputError(
            "sample_time_s", f"is too long for the motion at t = {t0_s:.6g} s", "a shorter one"
        )

    def derivatives(
        self, t0_s: float, t1_s: float, x: Array, first: Array, second: Array
    ) -> tuple[Array, Array, Array]:
        """Of the state at t1, control linear from ``first`` to ``second``: in x, first, second."""
        found = self._jacobians(t0_s, t1_s - t0_s, x, first, second)
        a, b, c = (np.asarray(matrix.full()) for matrix in found)
        return a, b, c

    @cached_property
    def _kinks_s(self) -> list[float]:
        """Where the equations are not smooth in time, rising."""
        model = self.model
        if isinstance(model, UserModel):
            return sorted(set(map(float, model.kinks_s)))
        wrenches = model.wrenches if isinstance(model, RigidBody) else ()
        return sorted({float(t) for wrench in wrenches for t in wrench.times_s})

    @cached_property
    def _rates(self) -> ca.Function:
        t, x, u = self._symbols()
        f = symbolic(self.model).derivative(self.model, t, x, u)
        return ca.Function("rates", [t, x, u], [f]).map(DEGREE + 1)

    @cached_property
    def _jacobians(self) -> ca.Function:
        t, x, first = self._symbols()
        h, second = ca.SX.sym("h"), ca.SX.sym("second", first.shape[0])
        derivative = symbolic(self.model).derivative
        step, end = h / SUBSTEPS, x
        for i in range(SUBSTEPS):

            def rate(share: float, state: ca.SX, i: int = i) -> ca.SX:
                s = (i + share) / SUBSTEPS
                u = (1 - s) * first + s * second
                return ca.SX(derivative(self.model, t + s * h, state, u))

            k1 = rate(0.0, end)
            k2 = rate(0.5, end + 0.5 * step * k1)
            k3 = rate(0.5, end + 0.5 * step * k2)
            k4 = rate(1.0, end + step * k3)
            end = end + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        out = [ca.jacobian(end, v) for v in (x, first, second)]
        return ca.Function("jacobians", [t, h, x, first, second], out)

    def _symbols(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        nx, nu = len(self.model.state_names), len(self.model.control_names)
        return ca.SX.sym("t"), ca.SX.sym("x", nx), ca.SX.sym("u", nu)


def _collocation() -> tuple[Array, Array]:
    """Lobatto points, and the matrix from values there to integrals from −1 to each."""
    nodes = -np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)
    unit = chebyshev.chebint(np.linalg.inv(chebyshev.chebvander(nodes, DEGREE)), lbnd=-1)
    return nodes, np.asarray(chebyshev.chebvander(nodes, DEGREE + 1) @ unit, dtype=np.float64)


_COLLOCATION = _collocation()
_INVERSE = np.linalg.inv(chebyshev.chebvander(_COLLOCATION[0], DEGREE))


def _to_coefficients(values: Array) -> Array:
    return np.asarray(_INVERSE @ values)
