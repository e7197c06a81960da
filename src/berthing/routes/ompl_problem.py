"""A scenario as OMPL sees it: its space, and checkers of states and motions.

OMPL interpolates positions linearly and attitudes by slerp, all subspaces in step: the legs that
are certified.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.ends import ends_of
from berthing.routes.legs import LegProver
from berthing.routes.region import Region
from berthing.routes.space import between
from berthing.scenario.scenario import Scenario

# Samples of a motion that are looked at before it is certified: most bad ones show there, in a
# tenth of the time.
LOOKS = np.linspace(0.0, 1.0, 17)[1:-1]


class Answers:
    """Whether OMPL states and motions are valid; knows nothing of who asks.

    Args:
        checker: of a scenario at rest.
    """

    def __init__(self, checker: Checker) -> None:
        self.checker = checker
        self._prover = LegProver(checker.scenario, checker.phase)
        self.kinds = [_kind(free) for free in checker.space.free]

    def valid(self, state: Any) -> bool:
        """Whether a state keeps margins and limits: a state validity checker."""
        return self.checker.valid_state(self.rows(state))

    def moves(self, one: Any, other: Any) -> bool:
        """Whether the motion between two states is certified: a motion validator."""
        a, b = self.rows(one), self.rows(other)
        if not np.all(self.checker.valid_states(between(a, b, LOOKS))):
            return False
        return self._prover.clear(a, b)

    def rows(self, state: Any) -> Array:
        """An OMPL state as rows (V, 7): position in m, and q_IB, scalar first."""
        parts = [state] if len(self.kinds) == 1 else [state[i] for i in range(len(self.kinds))]
        return np.array([_READ[kind](part) for kind, part in zip(self.kinds, parts, strict=True)])


class OmplProblem:
    """What OMPL's planners need of a scenario at rest.

    States are those of ``SE3StateSpace``, in the plane of ``SE2StateSpace``, of vehicles that do
    not turn of ``RealVectorStateSpace``; of several vehicles a compound of these, in their order.
    Turns weigh as much as the way that the reach of the body moves. Bounds are those of the region
    that ``berthing.route`` looks at.

    Attributes:
        checker: of the scenario.
        space, information: OMPL's ``StateSpace`` and ``SpaceInformation``; the latter has both
            checkers.
        start, goal: (V, 7), members of the sets.

    Args:
        certified: prove motions; else OMPL looks at samples of them.
        seed: of members of the sets of ends; OMPL's own is ``ompl.util.RNG.setSeed``.

    Raises:
        InputError: OMPL is not installed; structures that move; an end that is too near something.
    """

    def __init__(self, scenario: Scenario, *, certified: bool = True, seed: int = 0) -> None:
        base = ompl("base")
        self.checker = Checker(scenario)
        self.start, self.goal = ends_of(self.checker, np.random.default_rng(seed))
        region = Region.of(self.checker, self.start, self.goal)
        self._answers = Answers(self.checker)
        self.space = self._space(base, region)
        self.information = base.SpaceInformation(self.space)
        self.information.setStateValidityChecker(self._answers.valid)
        if certified:
            self.information.setMotionValidator(self._validator(base))
        self.information.setup()

    def setup(self) -> Any:
        """A ``SimpleSetup`` with start and goal, for any planner of ``ompl.geometric``."""
        found = ompl("geometric").SimpleSetup(self.information)
        found.setStartAndGoalStates(self.state(self.start), self.state(self.goal))
        return found

    def path(self, found: Any) -> Array:
        """The states (n + 1, V, 7) of a ``PathGeometric``, for ``Checker.legs``."""
        return np.array([self._answers.rows(state) for state in found.getStates()])

    def state(self, rows: Array) -> Any:
        """The OMPL state of rows (V, 7): position in m, and q_IB, scalar first."""
        found, kinds = self.space.allocState(), self._answers.kinds
        for i, (kind, row) in enumerate(zip(kinds, rows.tolist(), strict=True)):
            _WRITE[kind](found if len(kinds) == 1 else found[i], row)
        return found

    def _validator(self, base: Any) -> Any:
        """A ``MotionValidator`` that certifies every motion."""
        answers = self._answers
        members = {"checkMotion": lambda _, one, other: answers.moves(one, other)}
        made = type("CertifiedMotionValidator", (base.MotionValidator,), members)
        return made(self.information)

    def _space(self, base: Any, region: Region) -> Any:
        parts = [self._subspace(base, i, region) for i in range(len(self._answers.kinds))]
        if len(parts) == 1:
            return parts[0]
        whole = base.CompoundStateSpace()
        for part in parts:
            whole.addSubspace(part, 1.0)
        return whole

    def _subspace(self, base: Any, vehicle: int, region: Region) -> Any:
        space, kind = self.checker.space, self._answers.kinds[vehicle]
        dims = int(np.sum(space.free[vehicle, :3]))
        bounds = base.RealVectorBounds(dims)
        low = np.maximum(region.lower_m, space.lower_m[vehicle])
        high = np.minimum(region.upper_m, space.upper_m[vehicle])
        for axis in range(dims):
            bounds.setLow(axis, float(low[axis]))
            bounds.setHigh(axis, float(high[axis]))
        if kind.startswith("R"):
            found = base.RealVectorStateSpace(dims)
        else:
            found = getattr(base, f"{kind}StateSpace")()
            # OMPL takes half the angle for the distance of two attitudes in space.
            arm = float(space.arm_m[vehicle])
            found.setSubspaceWeight(1, arm if kind == "SE2" else 2.0 * arm)
        found.setBounds(bounds)
        return found


def ompl(module: str) -> Any:
    """``ompl.base``, ``ompl.geometric`` or ``ompl.util``; InputError where OMPL is missing."""
    try:
        return import_module(f"ompl.{module}")
    except ModuleNotFoundError as error:
        if error.name != "ompl":
            raise
        how = "pip install 'berthing[ompl]'"
        raise InputError("ompl", "is not installed, and its planners need it", how) from None


def _kind(free: Array) -> str:
    planar, turns = not free[2], bool(free[5])
    if not turns:
        return "R2" if planar else "R3"
    return "SE2" if planar else "SE3"


def _read_se3(state: Any) -> list[float]:
    q = state.rotation()
    return [state.getX(), state.getY(), state.getZ(), q.w, q.x, q.y, q.z]


def _read_se2(state: Any) -> list[float]:
    half = 0.5 * state.getYaw()
    return [state.getX(), state.getY(), 0.0, math.cos(half), 0.0, 0.0, math.sin(half)]


def _write_se3(state: Any, row: list[float]) -> None:
    state.setXYZ(*row[:3])
    q = state.rotation()
    q.w, q.x, q.y, q.z = row[3:]


def _write_se2(state: Any, row: list[float]) -> None:
    state.setX(row[0])
    state.setY(row[1])
    yaw = 2.0 * math.atan2(row[6], row[3])
    state.setYaw(math.remainder(yaw, 2.0 * math.pi))


def _write_vector(state: Any, row: list[float], dims: int) -> None:
    for axis in range(dims):
        state[axis] = row[axis]


_READ: Mapping[str, Callable[[Any], list[float]]] = {
    "SE3": _read_se3,
    "SE2": _read_se2,
    "R3": lambda state: [state[0], state[1], state[2], 1.0, 0.0, 0.0, 0.0],
    "R2": lambda state: [state[0], state[1], 0.0, 1.0, 0.0, 0.0, 0.0],
}
_WRITE: Mapping[str, Callable[[Any, list[float]], None]] = {
    "SE3": _write_se3,
    "SE2": _write_se2,
    "R3": lambda state, row: _write_vector(state, row, 3),
    "R2": lambda state, row: _write_vector(state, row, 2),
}
