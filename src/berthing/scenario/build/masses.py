"""Mass, first moment and inertia from meshes and robot descriptions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from berthing.mesh.decomposition import Decomposition
from berthing.mesh.mass import NOTHING, MassProperties
from berthing.scenario.build.poses import build_pose
from berthing.scenario.schema.meshes import AnyPart, MeshPartBlock
from berthing.scenario.schema.vehicles import Dynamics, RigidBodyBlock
from berthing.scenario.source import Path, Source


def with_masses(
    block: Dynamics,
    parts: Sequence[AnyPart],
    robot: MassProperties | None,
    source: Source,
    path: Path,
) -> Dynamics:
    """The dynamics with mass, first moment and inertia in them, where they can be worked out.

    What is given stays. With a density, meshes weigh by their volume and a robot as its
    description says. With a mass alone, it is spread evenly over the meshes, or as in the robot's
    description. With neither, the robot's description must account for everything.

    Args:
        parts: those that ``robot`` does not weigh.
        robot: of a robot description; None where there is none, or none with masses.

    Raises:
        InputError: a density beside a mass or an inertia, or for a shape that is no mesh.
    """
    if not isinstance(block, RigidBodyBlock):
        return block
    here = (*path, "dynamics")
    if block.density_kg_m3 is not None:
        for key in ("mass_kg", "inertia_kg_m2"):
            if getattr(block, key) is not None:
                raise source.error((*here, "density_kg_m3"), f"stands beside {key}", "one of them")
        _check_all_meshes(parts, source, (*here, "density_kg_m3"))
        return _filled(block, (robot or NOTHING) + _of(parts, block.density_kg_m3, source, path))
    if block.inertia_kg_m2 is not None or not _is_known(block, parts, robot):
        return block
    whole = _of(parts, 1.0, source, path) if robot is None else robot
    return _filled(block, whole.scaled((block.mass_kg or whole.mass_kg) / whole.mass_kg))


def _is_known(
    block: RigidBodyBlock, parts: Sequence[AnyPart], robot: MassProperties | None
) -> bool:
    """Whether a distribution of mass follows without a density."""
    if robot is not None:
        return not parts
    return block.mass_kg is not None and all(isinstance(p, MeshPartBlock) for p in parts)


def _check_all_meshes(parts: Sequence[AnyPart], source: Source, path: Path) -> None:
    shapes = [part.name for part in parts if not isinstance(part, MeshPartBlock)]
    if shapes:
        what = f"says nothing of the part {shapes[0]!r}, which is no mesh"
        raise source.error(path, what, "mass_kg, inertia_kg_m2 and first_moment_kg_m")


def _of(parts: Sequence[AnyPart], density: float, source: Source, path: Path) -> MassProperties:
    """Of mesh parts, about the reference point."""
    total = NOTHING
    for i, part in enumerate(parts):
        made = Decomposition.from_json(part.model_dump(mode="json", exclude_none=True), part.name)
        pose = build_pose(part, 3, source, (*path, "parts", i))
        total = total + made.mass_properties(density).seen_from(pose)
    return total


def _filled(block: RigidBodyBlock, mass: MassProperties) -> RigidBodyBlock:
    update: dict[str, Any] = {
        "mass_kg": mass.mass_kg,
        "inertia_kg_m2": mass.inertia_kg_m2.tolist(),
        "first_moment_kg_m": mass.first_moment_kg_m.tolist(),
        "density_kg_m3": None,
    }
    return block.model_copy(update=update)
