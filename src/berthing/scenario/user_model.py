"""Dynamics of the user's own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.native_state import Model
from berthing.scenario.user_function import Parameters, UserFunction, called, sized
from berthing.xp import NUMPY, Namespace, Scalar, Vector

NO_ATTITUDE, ANGLE, QUATERNION = "none", "angle", "quaternion"

# Entries that an attitude has, and those of its rate, by kind.
ATTITUDE_SIZE = {NO_ATTITUDE: 0, ANGLE: 1, QUATERNION: 4}
RATE_SIZE = {NO_ATTITUDE: 0, ANGLE: 1, QUATERNION: 3}

# What a guess can fill in where a state is called so, in the order in which poses and rates come.
_AXES = "xyz"


@dataclass(frozen=True, eq=False)
class UserModel(Model):
    """ẋ = f(t, x, u, p, xp) with a map from the state to a pose.

    All functions are written once, in the vocabulary of ``berthing.xp``; they are called with
    expressions to be solved, with numbers to be flown, and with enclosures to be proven.

    Attributes:
        name: what errors call it.
        workspace_dim: 2 or 3.
        states, controls: names of the native components, units in the names (``x_m``,
            ``speed_m_s``, ``steering_rad``); units that are known scale the solver's variables.
        derivative: f(t, x, u, p, xp) → ẋ (nx,).
        place: (x, p, xp) → position (dim,); with an attitude, (position, attitude).
        attitude: ``none``; in the plane ``angle``, from x to y; in space ``quaternion`` q_IB
            (4,), scalar first, kept near unit norm by f.
        rates: (x, p, xp) → inertial velocity (dim,); with an attitude, (velocity, rate), the rate
            a scalar in the plane and in body axes (3,) in space. None where the state alone does
            not tell them; ends can then ask for neither.
        assemble_state: (r (dim,), attitude, v (dim,), rate, p) → x, for guesses, in numbers;
            attitude and rate are an angle and its rate in the plane, q_IB and body rates in
            space. None fills in by name: x_m, vx_m_s, qw, wx_rad_s, angle_rad; the rest zero.
        parameters: p.
        kinks_s: times at which f is not smooth in t.

    Raises:
        InputError: names that repeat, an attitude that the dimension does not have.
    """

    name: str
    workspace_dim: int
    states: tuple[str, ...]
    controls: tuple[str, ...]
    derivative: Callable[[Scalar, Vector, Vector, Any, Namespace], Vector]
    place: Callable[[Vector, Any, Namespace], Any]
    attitude: str = NO_ATTITUDE
    rates: Callable[[Vector, Any, Namespace], Any] | None = None
    assemble_state: Callable[[Array, Any, Array, Any, Any], Any] | None = None
    parameters: Parameters = field(default_factory=dict)
    kinks_s: tuple[float, ...] = ()

    kind: ClassVar[str] = "user"

    def __post_init__(self) -> None:
        object.__setattr__(self, "states", tuple(self.states))
        object.__setattr__(self, "controls", tuple(self.controls))
        if self.workspace_dim not in (2, 3):
            raise InputError(f"{self.label}.workspace_dim", f"is {self.workspace_dim}", "2 or 3")
        allowed = (NO_ATTITUDE, ANGLE if self.workspace_dim == 2 else QUATERNION)
        if self.attitude not in allowed:
            raise InputError(
                f"{self.label}.attitude", f"is {self.attitude!r}", " or ".join(allowed)
            )
        names = (*self.states, *self.controls)
        if not self.states or len(set(names)) < len(names):
            raise InputError(self.label, "repeats a name, or has no states", "names of their own")

    @property
    def label(self) -> str:
        """The model in messages."""
        return f"user model {self.name}"

    @property
    def noun(self) -> str:
        return self.label

    @property
    def dim(self) -> int:
        return self.workspace_dim

    @property
    def state_names(self) -> tuple[str, ...]:
        return self.states

    @property
    def control_names(self) -> tuple[str, ...]:
        return self.controls

    @property
    def turns(self) -> bool:
        return self.attitude != NO_ATTITUDE

    @property
    def tells_rates(self) -> bool:
        return self.rates is not None

    def f(self, t: Scalar, x: Vector, u: Vector, xp: Namespace) -> Vector:
        """ẋ (nx,); InputError where the user's function fails."""
        function = UserFunction(f"{self.label}.derivative", self.derivative, self.parameters)
        return function(t, x, u, xp, len(self.states))

    def placement(self, x: Vector, xp: Namespace) -> tuple[Vector, Vector | None]:
        """Position (dim,) and attitude (its size,), None for none; InputError likewise."""
        label = f"{self.label}.place"
        found = called(label, self.place, x, self.parameters, xp)
        return self._parts(label, found, ATTITUDE_SIZE[self.attitude], xp)

    def motion(self, x: Vector, xp: Namespace) -> tuple[Vector, Vector | None]:
        """Velocity (dim,) and rate (its size,), None for none; asked only if ``tells_rates``."""
        label = f"{self.label}.rates"
        assert self.rates is not None
        found = called(label, self.rates, x, self.parameters, xp)
        return self._parts(label, found, RATE_SIZE[self.attitude], xp)

    def _parts(
        self, label: str, found: Any, size: int, xp: Namespace
    ) -> tuple[Vector, Vector | None]:
        if not self.turns:
            return sized(label, found, self.dim, xp), None
        if not (isinstance(found, tuple | list) and len(found) == 2):
            raise InputError(label, "gives one thing", "two: one of place, one of turning")
        return sized(label, found[0], self.dim, xp), sized(label, found[1], size, xp)

    def pose(self, x: Array) -> Pose:
        return _poses([self.placement(row, NUMPY) for row in _rows(x)], self.dim, x.shape[:-1])

    def velocity(self, x: Array) -> tuple[Array, Array]:
        shape = x.shape[:-1]
        if not self.tells_rates:
            return np.full((*shape, self.dim), np.nan), np.full((*shape, 3), np.nan)
        found = [self.motion(row, NUMPY) for row in _rows(x)]
        velocity = np.array([v for v, _ in found]).reshape(*shape, self.dim)
        rate = np.zeros((len(found), 3))
        if self.attitude == ANGLE:
            rate[:, 2] = [w[0] for _, w in found if w is not None]
        elif self.attitude == QUATERNION:
            rate[:] = [w for _, w in found if w is not None]
            rotation = self.pose(x).rotation.reshape(-1, 3, 3)
            rate = np.einsum("kij,kj->ki", rotation, rate)
        return velocity, rate.reshape(*shape, 3)

    def assemble(self, r_m: Array, q_IB: Array, v_m_s: Array, w_body_rad_s: Array) -> Array:
        shape = r_m.shape[:-1]
        q, w = (np.broadcast_to(a, (*shape, a.shape[-1])) for a in (q_IB, w_body_rad_s))
        if self.assemble_state is None:
            return self._by_name(r_m, q, v_m_s, w)
        make = self.assemble_state
        columns = map(_rows, (r_m, q, v_m_s, w))
        rows = [self._assembled(make, *row) for row in zip(*columns, strict=True)]
        return np.array(rows).reshape(*shape, len(self.states))

    def _assembled(
        self, make: Callable[..., Any], r: Array, q: Array, v: Array, w: Array
    ) -> Vector:
        turned: Any = q if self.attitude == QUATERNION else float(angle_of(q))
        turning: Any = w if self.attitude == QUATERNION else float(w[2])
        label = f"{self.label}.assemble_state"
        found = called(label, make, r, turned, v, turning, self.parameters)
        return sized(label, found, len(self.states), NUMPY)

    def _by_name(self, r: Array, q: Array, v: Array, w: Array) -> Array:
        known: dict[str, Array] = {"angle_rad": angle_of(q)}
        for i, axis in enumerate(_AXES):
            known[f"w{axis}_rad_s"] = w[..., i]
            if i < self.dim:
                known |= {f"{axis}_m": r[..., i], f"v{axis}_m_s": v[..., i]}
        known |= {f"q{c}": q[..., i] for i, c in enumerate("wxyz")}
        zero = np.zeros(r.shape[:-1])
        return np.stack([known.get(name, zero) for name in self.states], axis=-1)


def _rows(x: Array) -> Array:
    return x.reshape(-1, x.shape[-1])


def _poses(found: list[tuple[Any, Any]], dim: int, shape: tuple[int, ...]) -> Pose:
    position = np.array([r for r, _ in found]).reshape(*shape, dim)
    attitudes = [a for _, a in found]
    if attitudes[0] is None:
        return Pose(position, np.broadcast_to(np.eye(dim), (*shape, dim, dim)))
    turned = np.array(attitudes)
    if dim == 3:
        return Pose.from_quaternion(position, turned.reshape(*shape, 4))
    return Pose.planar(position, turned[:, 0].reshape(shape))


def angle_of(q: Array) -> Array:
    """The turn (...) about z of attitudes in the plane, q_IB (..., 4)."""
    return np.asarray(2.0 * np.arctan2(q[..., 3], q[..., 0]))
