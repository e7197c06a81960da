"""Elements and attributes of a URDF file, with errors that name them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose

Element = ElementTree.Element


def root_of(path: Path) -> Element:
    """The ``robot`` element.

    Raises:
        InputError: no such file, not XML, or not a robot description.
    """
    where = str(path)
    if not path.is_file():
        raise InputError(where, "does not exist", "a URDF file")
    try:
        root = ElementTree.fromstring(path.read_bytes())
    except OSError as error:
        raise InputError(where, f"cannot be read: {error.strerror}") from None
    except ElementTree.ParseError as error:
        raise InputError(where, f"is not well-formed XML: {error}") from None
    if root.tag != "robot":
        what = f"begins with <{root.tag}>"
        raise InputError(where, what, "<robot>; expand a xacro file first (xacro FILE > x.urdf)")
    return root


def attribute(element: Element, name: str, where: str) -> str:
    """An attribute that must be there."""
    value = element.get(name)
    if value is None:
        raise InputError(where, f"<{element.tag}> lacks {name!r}")
    return value


def numbers(
    element: Element, name: str, count: int, where: str, default: Sequence[float] | None = None
) -> Array:
    """An attribute of so many finite numbers with blanks between; InputError for another."""
    text = element.get(name)
    if text is None and default is not None:
        return np.array(default, dtype=np.float64)
    words = attribute(element, name, where).split()
    try:
        values = np.array([float(word) for word in words])
    except ValueError:
        values = np.array([np.nan])
    if len(values) != count or not np.all(np.isfinite(values)):
        what = f"<{element.tag}> has {name}={text!r}"
        raise InputError(where, what, f"{count} finite number{'s' if count > 1 else ''}")
    return values


def number(element: Element, name: str, where: str, default: float | None = None) -> float:
    """An attribute of one finite number."""
    values = numbers(element, name, 1, where, None if default is None else [default])
    return float(values[0])


def child(element: Element, tag: str, where: str) -> Element:
    """A child that must be there."""
    found = element.find(tag)
    if found is None:
        raise InputError(where, f"<{element.tag}> lacks <{tag}>")
    return found


def origin(element: Element, where: str) -> Pose:
    """The pose in an element's ``origin``: the identity where there is none.

    Roll, pitch and yaw turn about the fixed axes x, y, z in this order: R = Rz(y) Ry(p) Rx(r).
    """
    found = element.find("origin")
    if found is None:
        return Pose.identity()
    position = numbers(found, "xyz", 3, where, (0.0, 0.0, 0.0))
    return Pose(position, rpy_matrix(numbers(found, "rpy", 3, where, (0.0, 0.0, 0.0))))


def rpy_matrix(rpy: Array) -> Array:
    """Rotation (3, 3) of roll, pitch and yaw (3,) in rad."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )
