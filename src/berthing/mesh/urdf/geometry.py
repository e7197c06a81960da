"""Shapes of links: box, cylinder, sphere and mesh."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.geometry.pose import Pose
from berthing.mesh.reading import Scale
from berthing.mesh.urdf.xml import Element, attribute, child, number, numbers, origin

PACKAGE, FILE = "package://", "file://"


@dataclass(frozen=True, eq=False)
class LinkShape:
    """A shape of a link.

    Attributes:
        placement: of the shape in its link's frame.
        shape: as in a scenario file; None of a mesh.
        mesh: its file; None of another shape.
        scale: metres in one of the mesh's numbers along each axis.
    """

    placement: Pose
    shape: dict[str, Any] | None = None
    mesh: Path | None = None
    scale: Scale = (1.0, 1.0, 1.0)


def link_shape(element: Element, folder: Path, where: str) -> LinkShape:
    """From a ``collision`` or ``visual`` element.

    Args:
        folder: that of the URDF file, from which meshes are found.

    Raises:
        InputError: a shape that is unknown or incomplete, or a mesh that is missing.
    """
    geometry = child(element, "geometry", where)
    placement = origin(element, where)
    for tag, read in _SHAPES.items():
        found = geometry.find(tag)
        if found is not None:
            return LinkShape(placement, read(found, where))
    found = geometry.find("mesh")
    if found is None:
        inside = ", ".join(f"<{e.tag}>" for e in geometry) or "nothing"
        known = ", ".join(f"<{tag}>" for tag in (*_SHAPES, "mesh"))
        raise InputError(where, f"<geometry> holds {inside}", f"one of: {known}")
    x, y, z = numbers(found, "scale", 3, where, (1.0, 1.0, 1.0)).tolist()
    if 0.0 in (x, y, z):
        raise InputError(where, "<mesh> has a scale of zero", "three numbers that are not 0")
    mesh = mesh_path(attribute(found, "filename", where), folder, where)
    return LinkShape(placement, None, mesh, (x, y, z))


def mesh_path(name: str, folder: Path, where: str) -> Path:
    """The file of a mesh.

    ``package://NAME/rest`` is looked for in the URDF's folder and those around it: NAME/rest, and
    rest where such a folder is itself called NAME, as ROS lays packages out.

    Raises:
        InputError: it is nowhere.
    """
    places = list(_places(name, folder))
    for place in places:
        if place.is_file():
            return place
    looked = ", ".join(dict.fromkeys(map(str, places[:3])))
    raise InputError(where, f"names a mesh that is missing: {name!r}", f"one at {looked}")


def _places(name: str, folder: Path) -> list[Path]:
    if not name.startswith(PACKAGE):
        return [folder / name.removeprefix(FILE)]
    package, _, rest = name.removeprefix(PACKAGE).partition("/")
    above = [folder, *folder.absolute().parents]
    inside = [around / rest for around in above if around.absolute().name == package]
    return [folder / rest, *inside, *(around / package / rest for around in above)]


def _size(element: Element, name: str, where: str) -> float:
    value = number(element, name, where)
    if value <= 0.0:
        raise InputError(where, f"<{element.tag}> has {name}={value:g}", "a number above 0")
    return value


def _box(element: Element, where: str) -> dict[str, Any]:
    sizes = numbers(element, "size", 3, where)
    if min(sizes) <= 0.0:
        raise InputError(where, f"<box> has size={element.get('size')!r}", "numbers above 0")
    return {"type": "box", "size_m": sizes.tolist()}


def _cylinder(element: Element, where: str) -> dict[str, Any]:
    radius, length = (_size(element, key, where) for key in ("radius", "length"))
    return {"type": "cylinder", "radius_m": radius, "length_m": length, "axis": "z"}


def _sphere(element: Element, where: str) -> dict[str, Any]:
    return {"type": "sphere", "radius_m": _size(element, "radius", where)}


_SHAPES: dict[str, Callable[[Element, str], dict[str, Any]]] = {
    "box": _box,
    "cylinder": _cylinder,
    "sphere": _sphere,
}
