"""Whether vehicles may be where they are: for planners of every kind."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from berthing.clearance.given_poses import GivenPoses, read_poses
from berthing.clearance.signed_distance import Flags
from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.routes.legs import Legs, certify_legs, require_rest, strictest
from berthing.routes.parts import Found, Parts
from berthing.routes.space import Space, state_of
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.verify.frames import lifted

# A route, and its checks, can be given for a vehicle alone or for all of them by name.
Poses = GivenPoses | Mapping[str, GivenPoses]

# The first reach of a search for the closest pair, and by how much it grows, in sizes of bodies.
FIRST_REACH = 0.5
GROWTH = 4.0


@dataclass(frozen=True)
class Clearance:
    """The pair that keeps least of what is asked of it.

    Attributes:
        pair: ``owner.part|owner.part``; None where no margin concerns any.
        distance_m: of its parts, negative where they overlap.
        required_m: its margin.
        excess_m: distance less margin; a state is clear where it is 0 or more.
    """

    pair: str | None
    distance_m: float
    required_m: float
    excess_m: float


class Checker:
    """States of the vehicles of a phase at a time: valid or not, how clear, and which pair.

    Pairs that may touch do not count. Pairs whose balls are far from each other are not asked:
    found by k-d trees where structures have many parts. Not for two threads at a time.

    Args:
        scenario: what to keep clear of, by which margins.
        phase: of it; the first one if not given.
        time_s: on its clock, for structures that move and margins that change. Where it is not
            given, a valid state is one that is valid at all times: structures have to rest, and a
            pair keeps the largest margin that it ever has.

    Raises:
        InputError: a time that is no number; none, and a structure that moves.
    """

    def __init__(
        self, scenario: Scenario, phase: Phase | None = None, time_s: float | None = None
    ) -> None:
        self.scenario, self.phase = scenario, phase or scenario.phases[0]
        self.vehicles = self.phase.vehicles
        self.space = Space.of(self.vehicles)
        self.time_s = time_s
        if time_s is None:
            require_rest(scenario)
            self._prepare(strictest(scenario, self.phase), 0.0)
        else:
            self._prepare(self._margins_at(time_s), time_s)

    def _margins_at(self, time_s: float) -> dict[Pair, float]:
        if not np.isfinite(time_s):
            raise InputError("Checker: time_s", f"is {time_s}", "a time in s")
        policy = self.scenario.margins
        found = {
            p: policy.margin(p.ref_a, p.ref_b, time_s) for p in self.scenario.pairs(self.phase)
        }
        return {pair: margin for pair, margin in found.items() if margin is not None}

    def _prepare(self, margins: Mapping[Pair, float], time_s: float) -> None:
        self.pairs = tuple(margins)
        self.margins_m = np.array(list(margins.values()))
        self._widest_m = float(np.max(self.margins_m, initial=0.0))
        self.parts = Parts(self.pairs, [own.name for own in self.vehicles], time_s)
        self.compiled = self.parts.compiled(self.space, self.margins_m)

    def valid(self, poses: Poses) -> bool | Flags:
        """Whether every pair keeps its margin, and positions their limits.

        Args:
            poses: of the vehicle, as ``berthing.distance`` takes them: a ``Pose``, or numbers
                (..., 7) of position and quaternion q_IB, in the plane (..., 3) of position and
                angle. Of several vehicles, a mapping from their names. One pose or a batch.

        Returns:
            A bool, or bools (...) of a batch.

        Raises:
            InputError: a vehicle that is missing or unknown, dimensions or batches that do not
                fit, numbers that are not finite, quaternions that are not of length 1.
        """
        states = self.states(poses)
        flat = self.valid_states(states.reshape(-1, *states.shape[-2:]))
        return bool(flat[0]) if states.ndim == 2 else flat.reshape(states.shape[:-2])

    def clearance(self, poses: Poses) -> Clearance:
        """The pair that keeps least beyond its margin, at one pose of each vehicle.

        Raises:
            InputError: as ``valid``, or a batch.
        """
        states = self.states(poses)
        if states.ndim != 2:
            raise InputError("Checker.clearance", "was given a batch of poses", "one of each")
        return self.clearance_of(states)

    def clearance_of(self, state: Array) -> Clearance:
        """That at a state (V, 7)."""
        if not self.pairs:
            return Clearance(None, np.inf, 0.0, np.inf)
        placed = self.parts.place(state[None])
        reach = self._widest_m + FIRST_REACH * float(np.max(self.space.arm_m))
        while True:
            found = self.parts.found(placed, reach)
            excess = found.distance - self.margins_m[found.pair]
            # What is not among them keeps more than the reach.
            if len(excess) == len(self.pairs) or np.min(excess, initial=np.inf) <= (
                reach - self._widest_m
            ):
                break
            reach = GROWTH * reach if reach > 0.0 else 1.0
        least = int(np.argmin(excess))
        pair, required = self.pairs[found.pair[least]], self.margins_m[found.pair[least]]
        return Clearance(
            pair.name, float(found.distance[least]), float(required), float(excess[least])
        )

    def motion(self, start: Poses, end: Poses) -> Legs:
        """What is proven of the straight motion between two poses of each vehicle, or of many.

        Reference points move straight on while attitudes turn the shorter way at a constant rate,
        all in step: the motion of SE(3) that most planners take. It is certified as a plan is, for
        every instant of it and not for samples. Batches (n,) of poses are many motions in one call,
        which take far less time each.

        Raises:
            InputError: as ``valid``; batches of more than one axis, a checker of one instant, or
                half a turn.
        """
        one, other = (self.states(poses) for poses in (start, end))
        if max(one.ndim, other.ndim) > 3 or 0 in (*one.shape, *other.shape):
            found = f"was given batches {one.shape[:-2]} and {other.shape[:-2]}"
            raise InputError("Checker.motion", found, "(n,) or one of each")
        try:
            one, other = np.broadcast_arrays(one, other)
        except ValueError:
            found = f"was given batches {one.shape[:-2]} and {other.shape[:-2]}"
            raise InputError("Checker.motion", found, "batches of one length") from None
        shape = (-1, len(self.vehicles), 7)
        return self._certified(one.reshape(shape), other.reshape(shape))

    def legs(self, states: Array) -> Legs:
        """What is proven of the legs between states (n + 1, V, 7), n ≥ 1; errors as ``motion``."""
        return self._certified(states[:-1], states[1:])

    def _certified(self, starts: Array, ends: Array) -> Legs:
        if self.time_s is not None:
            what = f"is asked of a motion, but knows the time {self.time_s:g} s only"
            raise InputError("Checker", what, "a checker without time_s")
        return certify_legs(self.scenario, self.phase, starts, ends)

    def states(self, poses: Poses) -> Array:
        """The poses as states (..., V, 7) of ``routes.space``; errors as ``valid``."""
        if isinstance(poses, Mapping):
            names = [own.name for own in self.vehicles]
            if sorted(poses) != sorted(names):
                raise InputError("poses", f"are of {', '.join(poses) or 'nobody'}", f"of {names}")
            given = [poses[name] for name in names]
        elif len(self.vehicles) > 1:
            raise InputError("poses", f"are of one of {len(self.vehicles)} vehicles", "a mapping")
        else:
            given = [poses]
        rows = [
            _rows(one, own.dim, f"poses of {own.name}")
            for one, own in zip(given, self.vehicles, strict=True)
        ]
        try:
            batch = np.broadcast_shapes(*(row.shape[:-1] for row in rows))
        except ValueError:
            shapes = ", ".join(str(row.shape[:-1]) for row in rows)
            raise InputError("poses", f"have the batches {shapes}", "one of all") from None
        return np.stack([np.broadcast_to(row, (*batch, 7)) for row in rows], axis=-2)

    def valid_state(self, state: Array, pad_m: float = 0.0) -> bool:
        """That of one state (V, 7)."""
        return bool(self.valid_states(state[None], pad_m)[0])

    def short_of(self, state: Array, pad_m: float) -> tuple[Array, Array]:
        """Of the pairs nearer than margin and pad at a state (V, 7): by how much (m,), in metres,
        and how the distance grows by a stride (m, V, 6)."""
        found = self.near(state[None], pad_m, gradients=True)
        missing = self.margins_m[found.pair] + pad_m - found.distance
        short = missing > 0.0
        assert found.gradient is not None
        return missing[short], found.gradient[short]

    def valid_states(self, states: Array, pad_m: float = 0.0) -> Flags:
        """Flags (k,) of states (k, V, 7); with ``pad_m`` more than the margins."""
        if self.compiled is not None:
            return self.compiled.valid(states, pad_m)
        good = self.space.within(states)
        if np.any(good) and self.pairs:
            found = self.near(states, pad_m)
            short = found.distance < self.margins_m[found.pair] + pad_m
            good[found.state[short]] = False
        return good

    def near(self, states: Array, pad_m: float, *, gradients: bool = False) -> Found:
        """Distances, at states (k, V, 7), of all pairs nearer than margin and pad, and of more."""
        placed = self.parts.place(states)
        return self.parts.found(placed, self._widest_m + pad_m, gradients=gradients)


def _rows(given: GivenPoses, dim: int, where: str) -> Array:
    """Rows (..., 7) of a vehicle's poses."""
    pose = read_poses(given, dim, where)
    if isinstance(given, Pose) or dim == 2:
        return state_of(pose)
    rows = np.asarray(given, dtype=np.float64)
    return np.concatenate([lifted(rows[..., :3]), quaternion.normalise(rows[..., 3:])], axis=-1)
