"""A robot description as one rigid body in the frame of its root link."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.pose import Pose
from berthing.mesh.mass import NOTHING, MassProperties
from berthing.mesh.urdf.geometry import LinkShape, link_shape
from berthing.mesh.urdf.joints import Joint, positions
from berthing.mesh.urdf.xml import Element, attribute, child, number, origin, root_of


@dataclass(frozen=True, eq=False)
class Robot:
    """Links, frozen at given joint positions.

    Attributes:
        name: of the robot.
        sha256: of the file's bytes, in hex.
        shapes: of all links by the link's name, placed in the root link's frame.
        mass: of all links about the root link's origin; None where the file gives no mass.
    """

    name: str
    sha256: str
    shapes: tuple[tuple[str, LinkShape], ...]
    mass: MassProperties | None


def read_robot(path: Path, joints: Mapping[str, float] | None = None) -> Robot:
    """The robot in a URDF file.

    A link's collision geometry counts; where it has none, its visual geometry, so that nothing is
    forgotten.

    Args:
        joints: positions by name, in rad or m; 0 for the others.

    Raises:
        InputError: the file is missing or malformed, its links form no tree, a joint position is
            out of range, a mesh is missing, or no link has a shape.
    """
    root, where = root_of(path), str(path)
    links = {attribute(e, "name", where): e for e in root.findall("link")}
    poses = _link_poses(root, links, joints or {}, where)
    shapes, mass = list[tuple[str, LinkShape]](), NOTHING
    for name, element in links.items():
        place = f"{where}: link {name!r}"
        drawn = element.findall("collision") or element.findall("visual")
        for shape in (link_shape(e, path.parent, place) for e in drawn):
            placed = poses[name].compose(shape.placement)
            shapes.append((name, LinkShape(placed, shape.shape, shape.mesh, shape.scale)))
        mass = mass + _inertial(element, place).seen_from(poses[name])
    if not shapes:
        raise InputError(where, "has no link with a shape", "collision geometry")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    whole = mass if mass.mass_kg > 0.0 else None
    return Robot(root.get("name", path.stem), digest, tuple(shapes), whole)


def _link_poses(
    root: Element, links: Mapping[str, Element], given: Mapping[str, float], where: str
) -> dict[str, Pose]:
    """Pose of each link in the root link's frame."""
    found = [Joint.read(e, f"{where}: joint {e.get('name')!r}") for e in root.findall("joint")]
    joints = {joint.name: joint for joint in found}
    at = positions(joints, given, where)
    above: dict[str, Joint] = {}
    for joint in found:
        for link in (joint.parent, joint.child):
            if link not in links:
                raise InputError(where, f"joint {joint.name!r} names no link: {link!r}")
        if joint.child in above:
            raise InputError(where, f"link {joint.child!r} has two parents", "a tree of links")
        above[joint.child] = joint
    roots = [name for name in links if name not in above]
    if len(roots) != 1:
        named = f": {', '.join(roots)}" if roots else ""
        what = f"has {len(roots)} links without a parent{named}"
        raise InputError(where, what, "a tree of links, hence one")
    poses = {roots[0]: Pose.identity()}
    waiting = list(found)
    while waiting:
        ready = [joint for joint in waiting if joint.parent in poses]
        if not ready:
            names = ", ".join(joint.name for joint in waiting)
            raise InputError(where, f"joins links in a circle: {names}", "a tree of links")
        for joint in ready:
            poses[joint.child] = poses[joint.parent].compose(joint.pose(at[joint.name]))
        waiting = [joint for joint in waiting if joint.child not in poses]
    return poses


def _inertial(link: Element, where: str) -> MassProperties:
    """Mass properties of a link about its frame's origin; nothing where it has none."""
    element = link.find("inertial")
    if element is None:
        return NOTHING
    mass = number(child(element, "mass", where), "value", where)
    if mass < 0.0:
        raise InputError(where, f"has a mass of {mass:g} kg", "0 or more")
    found = child(element, "inertia", where)
    xx, yy, zz, xy, xz, yz = (
        number(found, key, where, 0.0) for key in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
    )
    inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    return MassProperties.of_inertia(mass, inertia).seen_from(origin(element, where))
