"""The file of pieces that ``berthing decompose`` writes, and its check."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.mesh import recheck
from berthing.mesh.decomposition import Decomposition
from berthing.mesh.from_file import decomposed
from berthing.mesh.mass import MassProperties
from berthing.mesh.reading import FORMATS
from berthing.mesh.settings import DecomposeSettings
from berthing.mesh.urdf.parts import OUTLINE, mesh_part, outlines, part_name, robot_parts
from berthing.mesh.urdf.robot import read_robot

SCHEMA_VERSION = 1
URDF = ".urdf"


@dataclass(frozen=True, eq=False)
class Described:
    """A mesh, or all links of a robot, as parts of a scenario file.

    Attributes:
        source: the file's name.
        sha256: of its bytes, in hex.
        joints: positions by name, of a robot.
        parts: as a scenario has them; paths of meshes lead from the folder to be written.
        made: what became of each part that is a mesh, by the part's name.
        files: of those meshes, likewise.
        mass: of the whole about the origin; None where it is not known.
    """

    source: str
    sha256: str
    joints: Mapping[str, float]
    parts: Sequence[Mapping[str, Any]]
    made: Mapping[str, Decomposition]
    files: Mapping[str, Path]
    mass: MassProperties | None

    def to_json(self) -> dict[str, Any]:
        """The content of pieces.json."""
        content: dict[str, Any] = {
            "schema_version": SCHEMA_VERSION,
            "source": self.source,
            "sha256": self.sha256,
            "joints": dict(self.joints),
        }
        if self.mass is not None:
            content["mass"] = {
                "mass_kg": self.mass.mass_kg,
                "first_moment_kg_m": self.mass.first_moment_kg_m.tolist(),
                "inertia_kg_m2": self.mass.inertia_kg_m2.tolist(),
            }
        return {**content, "parts": [dict(part) for part in self.parts]}

    def summary(self) -> dict[str, Any]:
        """The same without the pieces themselves."""
        whole = self.to_json()
        kept = [{k: v for k, v in part.items() if k != "pieces"} for part in self.parts]
        return {**whole, "parts": kept}


def described(
    file: Path,
    folder: Path,
    settings: DecomposeSettings,
    *,
    units: str | None = None,
    density_kg_m3: float | None = None,
    joints: Mapping[str, float] | None = None,
) -> Described:
    """The parts of a mesh file or of a URDF.

    Args:
        file: STL, OBJ, PLY, GLB or URDF.
        folder: from which the paths of meshes are to lead.
        settings: how meshes are decomposed.
        units: of a mesh's numbers; None for what its format says.
        density_kg_m3: for the mass; None for that of the URDF, or none.
        joints: positions by name, of a URDF.

    Raises:
        InputError: anything wrong with a file, or an option that says nothing about this one.
    """
    reader = _robot if file.suffix.lower() == URDF else _mesh
    if reader is _robot and units is not None:
        raise InputError("--units", "says nothing of a URDF", "none: a URDF has metres")
    if reader is _mesh and joints:
        raise InputError("--joint", f"says nothing of {file.name}", "a URDF")
    if density_kg_m3 is not None and not 0.0 < density_kg_m3 < float("inf"):
        raise InputError("--density", f"is {density_kg_m3:g}", "a number above 0, in kg/m³")
    return reader(file, folder, settings, units, density_kg_m3, joints or {})


def _mesh(
    file: Path,
    folder: Path,
    settings: DecomposeSettings,
    units: str | None,
    density: float | None,
    joints: Mapping[str, float],
) -> Described:
    if file.suffix.lower() not in FORMATS:
        known = ", ".join(suffix[1:].upper() for suffix in (*FORMATS, URDF))
        found = f"has the suffix {file.suffix!r}" if file.suffix else "has no suffix"
        raise InputError(str(file), found, f"{known}; export one from CAD")
    made = decomposed(file, units=units, settings=settings)
    name = part_name(file.stem)
    part = {"name": name, **mesh_part(file, folder, made)}
    mass = None if density is None else made.mass_properties(density)
    sha256 = made.certificate.mesh_sha256
    return Described(file.name, sha256, {}, [part], {name: made}, {name: file}, mass)


def _robot(
    file: Path,
    folder: Path,
    settings: DecomposeSettings,
    units: str | None,
    density: float | None,
    joints: Mapping[str, float],
) -> Described:
    robot = read_robot(file, joints)
    if density is not None:
        raise InputError("--density", "says nothing of a URDF", "masses in the URDF itself")
    parts = robot_parts(robot, folder, settings)
    made = {p["name"]: Decomposition.from_json(p, p["name"]) for p in parts if "mesh" in p}
    meshes = [shape.mesh for _, shape in robot.shapes]
    files = {p["name"]: mesh for p, mesh in zip(parts, meshes, strict=True) if mesh is not None}
    return Described(file.name, robot.sha256, joints, parts, made, files, robot.mass)


def faults_of(content: Mapping[str, Any], folder: Path, file: Path) -> list[str]:
    """What does not hold of a file of pieces; empty where everything is proven again.

    Args:
        content: of the file of pieces.
        folder: in which it lies.
        file: the mesh or URDF that it was made of.

    Raises:
        InputError: a mesh that is missing or cannot be read.
    """
    parts = content.get("parts")
    if not isinstance(parts, list) or not all(isinstance(part, dict) for part in parts):
        return ["it holds no list of parts"]
    is_robot = file.suffix.lower() == URDF
    found = _robot_faults(content, parts, file) if is_robot else _one_mesh(parts)
    for part in parts:
        if "mesh" in part:
            mesh = folder / str(part["mesh"]) if is_robot else file
            found += [f"{part.get('name')}: {fault}" for fault in recheck.faults(part, mesh)]
    return found


def _one_mesh(parts: Sequence[Mapping[str, Any]]) -> list[str]:
    alone = len(parts) == 1 and "mesh" in parts[0]
    moved = [key for part in parts for key in ("position_m", "attitude") if key in part]
    return [] if alone and not moved else ["it is not of one mesh, in the frame of that mesh"]


def _robot_faults(
    content: Mapping[str, Any], parts: Sequence[Mapping[str, Any]], file: Path
) -> list[str]:
    """Where the parts are not the links of the robot, each in its place."""
    joints = content.get("joints")
    robot = read_robot(file, joints if isinstance(joints, dict) else {})
    if content.get("sha256") != robot.sha256:
        return [f"{file} is not the file that was described: its SHA-256 is {robot.sha256}"]
    wanted = outlines(robot)
    found = [{k: v for k, v in part.items() if k in OUTLINE} for part in parts]
    return [] if found == wanted else ["its parts are not the links of the robot in their places"]
