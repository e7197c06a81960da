"""The links of a robot as parts of a scenario file."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.pose import Pose
from berthing.mesh.decomposition import Decomposition
from berthing.mesh.from_file import decomposed
from berthing.mesh.settings import DEFAULT, DecomposeSettings
from berthing.mesh.urdf.geometry import LinkShape
from berthing.mesh.urdf.robot import Robot

# What a name in a scenario may not have; it may not begin with a sign either.
FOREIGN = re.compile(r"[^A-Za-z0-9_-]|^[^A-Za-z0-9]")
# Keys of a part that follow from the robot description alone.
OUTLINE = ("name", "shape", "scale_m", "position_m", "attitude")


def robot_parts(
    robot: Robot, folder: Path, settings: DecomposeSettings = DEFAULT
) -> list[dict[str, Any]]:
    """A part for each shape of each link, in the root link's frame; meshes with their pieces.

    Parts are called as their links; the second and further ones of a link, ``link-2`` and so on.

    Args:
        folder: from which the paths of meshes are to lead.
        settings: how meshes are decomposed.

    Raises:
        InputError: a mesh that cannot be used.
    """
    outlined = zip(outlines(robot), robot.shapes, strict=True)
    return [
        part if shape.mesh is None else {**part, **_decomposed(shape, shape.mesh, folder, settings)}
        for part, (_, shape) in outlined
    ]


def outlines(robot: Robot) -> list[dict[str, Any]]:
    """The parts without what is made of meshes: the keys ``OUTLINE``, of those that are there."""
    made: dict[str, dict[str, Any]] = {}
    for link, shape in robot.shapes:
        base = name = part_name(link)
        count = 1
        while name in made:
            count += 1
            name = f"{base}-{count}"
        kind = {"scale_m": list(shape.scale)} if shape.shape is None else {"shape": shape.shape}
        made[name] = {"name": name, **kind, **_placed(shape.placement)}
    return list(made.values())


def part_name(text: str) -> str:
    """Text as a name of a part: letters, digits, - and _."""
    return FOREIGN.sub("-", text).lstrip("-_") or "part"


def mesh_part(path: Path, folder: Path, made: Decomposition) -> dict[str, Any]:
    """What a part from a mesh has beside its name and place."""
    scale = list(made.certificate.metres_per_unit)
    return {"mesh": os.path.relpath(path, folder), "scale_m": scale, **made.to_json()}


def _decomposed(
    shape: LinkShape, mesh: Path, folder: Path, settings: DecomposeSettings
) -> dict[str, Any]:
    made = decomposed(mesh, scale=shape.scale, settings=settings)
    return mesh_part(mesh, folder, made)


def _placed(pose: Pose) -> dict[str, Any]:
    q = quaternion.from_matrix(pose.rotation)
    return {"position_m": np.array(pose.position).tolist(), "attitude": q.tolist()}
