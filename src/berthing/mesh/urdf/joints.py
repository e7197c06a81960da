"""Joints, and where each link is for given joint positions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import norm
from berthing.geometry.pose import Pose
from berthing.mesh.urdf.xml import Element, attribute, child, number, numbers, origin

TURNING, SLIDING, FIXED = ("revolute", "continuous"), ("prismatic",), ("fixed",)
KINDS = (*TURNING, *SLIDING, *FIXED)


@dataclass(frozen=True, eq=False)
class Joint:
    """What joins a link to its parent.

    Attributes:
        name, kind: as in the file.
        parent, child: names of links.
        origin: of the joint in the parent's frame, at position 0.
        axis: unit vector (3,) in the joint's frame.
        limits: lowest and highest position in rad or m; infinite where there is none.
        mimics: another joint, factor and offset; None where it moves by itself.
    """

    name: str
    kind: str
    parent: str
    child: str
    origin: Pose
    axis: Array
    limits: tuple[float, float]
    mimics: tuple[str, float, float] | None

    @staticmethod
    def read(element: Element, where: str) -> Joint:
        """From a ``joint`` element; InputError for one of another kind, or an incomplete one."""
        kind = attribute(element, "type", where)
        if kind not in KINDS:
            raise InputError(where, f"is of type {kind!r}", f"one of: {', '.join(KINDS)}")
        axis, found = np.array([1.0, 0.0, 0.0]), element.find("axis")
        if found is not None and kind not in FIXED:
            axis = numbers(found, "xyz", 3, where)
            if not norm(axis) > 0.0:
                raise InputError(where, "has an axis of length zero")
            axis = axis / norm(axis)
        parent, joined = (
            attribute(child(element, tag, where), "link", where) for tag in ("parent", "child")
        )
        name = attribute(element, "name", where)
        at = origin(element, where)
        return Joint(
            name, kind, parent, joined, at, axis, _limits(element, kind, where),
            _mimics(element, where),
        )  # fmt: skip

    def pose(self, position: float) -> Pose:
        """Of the child in the parent's frame; the position in rad or m."""
        if self.kind in TURNING:
            turn = quaternion.from_axis_angle(self.axis, np.array(position))
            return self.origin.compose(Pose.from_quaternion(np.zeros(3), turn))
        if self.kind in SLIDING:
            return self.origin.compose(Pose(position * self.axis, np.eye(3)))
        return self.origin


def positions(
    joints: Mapping[str, Joint], given: Mapping[str, float], where: str
) -> dict[str, float]:
    """Position of each joint: as given, or mimicked, or 0.

    Raises:
        InputError: a name that is no joint that moves, or a position beyond the joint's limits.
    """
    free = [j.name for j in joints.values() if j.kind not in FIXED and j.mimics is None]
    for name in given:
        if name not in free:
            options = f"one of: {', '.join(free)}" if free else "none, for no joint moves"
            raise InputError(where, f"has no joint {name!r} to set", options)
    found = {joint.name: given.get(joint.name, 0.0) for joint in joints.values()}
    for joint in joints.values():
        if joint.mimics is not None:
            other, factor, offset = joint.mimics
            if other not in joints:
                raise InputError(where, f"joint {joint.name!r} mimics {other!r}, which is none")
            found[joint.name] = factor * found[other] + offset
    for name in free:
        low, high = joints[name].limits
        if not low <= found[name] <= high:
            what = f"puts joint {name!r} at {found[name]:g}"
            raise InputError(where, what, f"{low:g} to {high:g}, the joint's limits")
    return found


def _limits(element: Element, kind: str, where: str) -> tuple[float, float]:
    found = element.find("limit")
    if found is None or kind not in ("revolute", "prismatic"):
        return -np.inf, np.inf
    return number(found, "lower", where, 0.0), number(found, "upper", where, 0.0)


def _mimics(element: Element, where: str) -> tuple[str, float, float] | None:
    found = element.find("mimic")
    if found is None:
        return None
    factor, offset = number(found, "multiplier", where, 1.0), number(found, "offset", where, 0.0)
    return attribute(found, "joint", where), factor, offset
