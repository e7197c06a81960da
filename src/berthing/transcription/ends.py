"""Start and goal as rows, in the inertial frame or in a structure's, moving as it does."""

from __future__ import annotations

from functools import partial

import casadi as ca
import numpy as np

from berthing.dynamics.kinematics import Kinematics
from berthing.dynamics.motion import Frame
from berthing.dynamics.rotation import quaternion_product
from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.attitude import AxisAttitude, FixedAttitude
from berthing.scenario.goal import End
from berthing.sym import Sym
from berthing.transcription.elements import Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout, VehicleLayout


def add_ends(layout: PhaseLayout) -> None:
    """Append start and goal of every vehicle; their numbers are parameters."""
    for owner in layout.vehicles.values():
        last = owner.state.shape[1] - 1
        _EndRows(layout, owner, "start", 0, 0.0).add(owner.vehicle.start)
        _EndRows(layout, owner, "goal", last, 1.0).add(owner.vehicle.goal)


class _EndRows:
    """Writes the rows of one end into one kernel."""

    def __init__(
        self, layout: PhaseLayout, owner: VehicleLayout, kind: str, column: int, fraction: float
    ) -> None:
        self.layout, self.owner, self.kind = layout, owner, kind
        self.column, self.fraction = column, fraction
        self.key = f"{layout.phase.name}/{owner.vehicle.name}/{kind}"
        self.length, self.time = layout.scale.length_m, layout.scale.time_s
        self.inputs = Inputs()
        self.expressions: list[Sym] = []
        self.rows: list[Index] = []
        self.indices: dict[str, Index] = {}

    def add(self, end: End) -> None:
        x = self.owner.declare_state(self.inputs, "x")
        body = self.owner.kinematics(x)
        t = self.layout.t0_s + self.layout.declare_duration(self.inputs) * self.fraction
        frame = self._frame(end, t)
        self._place(end, body, frame)
        self._attitude(end, body, frame)
        self._native(end, x)
        kernel = self.inputs.kernel(ca.vertcat(*self.expressions))
        values = self.layout.shared_indices(1) | self.indices
        values["x"] = self.owner.state.indices[:, self.column]
        self.inputs.add(self.layout.elements, kernel, values, np.concatenate(self.rows))

    def _place(self, end: End, body: Kinematics, frame: Frame) -> None:
        target = self._parameter("position", end.dim)
        arm = ca.mtimes(frame.rotation, target)
        offset = (body.position - frame.position - arm) / self.length
        self._position(end, offset)
        if end.velocity_m_s is not None and body.velocity is not None:
            relative = ca.mtimes(frame.rotation, self._parameter("velocity", end.dim))
            swept = _cross(frame.rate, arm, end.dim)
            gap = body.velocity - frame.velocity - swept - relative
            self._equal(gap * self.time / self.length, "velocity")
        if end.rate_rad_s is not None and body.rate_body is not None:
            relative = self._parameter("rate", 3)
            if end.dim == 2:
                gap = body.rate_body - relative[2] - frame.rate[2]
            else:
                gap = body.rate_body - relative - ca.mtimes(body.rotation.T, frame.rate)
            self._equal(gap * self.time / np.pi, "rate")

    def _frame(self, end: End, t: Sym) -> Frame:
        if end.frame is not None:
            return self.layout.declare_frame(self.inputs, end.frame, t)
        zero = ca.DM.zeros
        return Frame(zero(end.dim), ca.DM.eye(end.dim), zero(end.dim), zero(3))

    def _position(self, end: End, offset: Sym) -> None:
        if end.position_tolerance_m == 0.0:
            self._equal(offset, "position")
        else:
            radius = end.position_tolerance_m / self.length
            self._between(ca.sumsqr(offset) / radius**2, 0.0, 1.0, "position")

    def _attitude(self, end: End, body: Kinematics, frame: Frame) -> None:
        if body.attitude_error is not None and isinstance(end.attitude, FixedAttitude):
            self._fixed(end.attitude, end, body, frame)
        elif body.attitude_error is not None and isinstance(end.attitude, AxisAttitude):
            self._axis(end.attitude, body, frame)
        self._fix_norm(body)

    def _native(self, end: End, x: Sym) -> None:
        """Components of the state that are given by name."""
        names = list(end.states)
        if names:
            columns = [self.owner.vehicle.model.state_names.index(name) for name in names]
            gap = x[columns] - self._parameter("states", len(names))
            self._equal(gap / ca.DM(self.owner.scale.state[columns]), ", ".join(names))

    def _fixed(self, wanted: FixedAttitude, end: End, body: Kinematics, frame: Frame) -> None:
        assert body.attitude_error is not None
        q_FB = self._parameter("attitude", 4)
        q_IB = q_FB if end.frame is None else quaternion_product(self._q_frame(frame), q_FB)
        error = body.attitude_error(q_IB)
        if wanted.tolerance_rad == 0.0:
            self._equal(error, "attitude")
        else:
            reach = np.sin(0.5 * wanted.tolerance_rad) ** 2
            self._between(ca.sumsqr(error) / reach, 0.0, 1.0, "attitude")

    def _axis(self, wanted: AxisAttitude, body: Kinematics, frame: Frame) -> None:
        axis = ca.mtimes(body.rotation, ca.DM(wanted.body_axis))
        world = ca.mtimes(frame.rotation, ca.DM(wanted.world_axis))
        if wanted.tolerance_rad == 0.0:
            across = _perpendicular(wanted.world_axis)
            turned = ca.mtimes(frame.rotation, ca.DM(across.T))
            self._equal(ca.mtimes(turned.T, axis), "axis")
            self._between(ca.dot(axis, world), 0.0, np.inf, "axis direction")
        else:
            floor = float(np.cos(wanted.tolerance_rad))
            self._between(ca.dot(axis, world), floor, np.inf, "axis")

    def _fix_norm(self, body: Kinematics) -> None:
        """‖q‖ = 1 at the start; the kinematics conserve it, so that a second row would depend."""
        if self.kind == "start" and body.quaternion is not None:
            self._between(ca.sumsqr(body.quaternion), 1.0, 1.0, "quaternion norm")

    def _q_frame(self, frame: Frame) -> Sym:
        """A quaternion of the frame's rotation, sign and norm immaterial.

        Columns of qqᵀ are multiples of q; the one with the largest diagonal at the nominal time
        is away from zero there.
        """
        R = ca.diagcat(frame.rotation, 1) if frame.rotation.shape[0] == 2 else frame.rotation
        columns = [
            ca.vertcat(1 + R[0, 0] + R[1, 1] + R[2, 2],
                       R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]),
            ca.vertcat(R[2, 1] - R[1, 2], 1 + R[0, 0] - R[1, 1] - R[2, 2],
                       R[0, 1] + R[1, 0], R[0, 2] + R[2, 0]),
            ca.vertcat(R[0, 2] - R[2, 0], R[0, 1] + R[1, 0],
                       1 - R[0, 0] + R[1, 1] - R[2, 2], R[1, 2] + R[2, 1]),
            ca.vertcat(R[1, 0] - R[0, 1], R[0, 2] + R[2, 0], R[1, 2] + R[2, 1],
                       1 - R[0, 0] - R[1, 1] + R[2, 2]),
        ]  # fmt: skip
        best = columns[3]
        size = columns[3][3]
        for i in (2, 1, 0):
            larger = columns[i][i] > size
            best = ca.if_else(larger, columns[i], best)
            size = ca.if_else(larger, columns[i][i], size)
        return best / ca.norm_2(best)

    def _parameter(self, name: str, size: int) -> Sym:
        block = self.layout.parameters.add(f"{self.key}/{name}", (size, 1))
        self.indices[name] = block.indices.ravel()
        return self.inputs.parameter(name, size)

    def _equal(self, expression: Sym, what: str) -> None:
        self._between(expression, 0.0, 0.0, what)

    def _between(self, expression: Sym, lower: float, upper: float, what: str) -> None:
        label = partial(_end_label, f"{self.kind}[{self.owner.vehicle.name}, {what}]")
        self.rows.append(self.layout.rows.add(expression.numel(), lower, upper, label))
        self.expressions.append(expression)


def end_parameters(key: str, end: End) -> dict[str, Array]:
    """The numbers behind the parameters of one end; more than its rows ask for."""
    attitude = end.attitude.q if isinstance(end.attitude, FixedAttitude) else np.eye(4)[0]
    return {
        f"{key}/position": end.position_m,
        f"{key}/velocity": np.zeros(end.dim) if end.velocity_m_s is None else end.velocity_m_s,
        f"{key}/rate": np.zeros(3) if end.rate_rad_s is None else end.rate_rad_s,
        f"{key}/attitude": quaternion.normalise(attitude),
        f"{key}/states": np.array(list(end.states.values())),
    }


def _end_label(text: str, _: int) -> str:
    return text


def _cross(rate: Sym, arm: Sym, dim: int) -> Sym:
    if dim == 3:
        return ca.cross(rate, arm)
    if dim == 2:
        return ca.vertcat(-rate[2] * arm[1], rate[2] * arm[0])
    raise InputError("dimension", f"is {dim}", "2 or 3")


def _perpendicular(axis: Array) -> Array:
    """Two unit rows (2, 3) across ``axis`` and each other."""
    first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    first = first / np.linalg.norm(first)
    return np.stack([first, np.cross(axis, first)])
