"""Meshes and robot descriptions: read, decomposed, and kept with the scenario as pieces."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import TypeVar

from berthing.errors import InputError
from berthing.mesh.certificate import Certificate
from berthing.mesh.decomposition import Decomposition
from berthing.mesh.from_file import decomposed
from berthing.mesh.piece import Piece
from berthing.mesh.recheck import faults_without_mesh
from berthing.mesh.settings import DEFAULT, DecomposeSettings
from berthing.mesh.urdf.parts import robot_parts
from berthing.mesh.urdf.robot import Robot, read_robot
from berthing.scenario.build.masses import with_masses
from berthing.scenario.schema.document import PhaseBlock, ScenarioFile
from berthing.scenario.schema.meshes import (
    AnyPart,
    Bodied,
    MeshPartBlock,
    PieceBlock,
    UrdfBlock,
)
from berthing.scenario.schema.shapes import PartBlock
from berthing.scenario.schema.vehicles import VehicleBlock
from berthing.scenario.source import Absent, Path, Source

AnyBodied = TypeVar("AnyBodied", bound=Bodied)


def with_meshes(file: ScenarioFile, source: Source) -> ScenarioFile:
    """The file with the pieces of every mesh in it, and masses, so that it stands alone.

    Pieces that it has already are taken as they are, if their certificate fits them; the mesh is
    then not looked for.

    Raises:
        InputError: a file that is missing or cannot be used, pieces that were edited, or a mesh
            in the plane.
    """
    planar = len(file.phases[0].vehicles[0].goal.position_m) == 2
    structures = [
        _bodied(s, planar, source, ("structures", i))[0] for i, s in enumerate(file.structures)
    ]
    phases = [_phase(p, planar, source, ("phases", i)) for i, p in enumerate(file.phases)]
    return file.model_copy(update={"structures": structures, "phases": phases})


def _phase(phase: PhaseBlock, planar: bool, source: Source, path: Path) -> PhaseBlock:
    vehicles = [
        _vehicle(v, planar, source, (*path, "vehicles", i)) for i, v in enumerate(phase.vehicles)
    ]
    return phase.model_copy(update={"vehicles": vehicles})


def _vehicle(block: VehicleBlock, planar: bool, source: Source, path: Path) -> VehicleBlock:
    given = len(block.parts or ())
    block, robot = _bodied(block, planar, source, path)
    mass = None if robot is None else robot.mass
    # What the robot description weighs needs no density.
    unweighed = (block.parts or ()) if mass is None else (block.parts or ())[:given]
    dynamics = with_masses(block.dynamics, unweighed, mass, source, path)
    return block.model_copy(update={"dynamics": dynamics})


def _bodied(
    block: AnyBodied, planar: bool, source: Source, path: Path
) -> tuple[AnyBodied, Robot | None]:
    """The block with all its parts in it, and the robot, if one was read."""
    parts = [_part(p, planar, source, (*path, "parts", i)) for i, p in enumerate(block.parts or ())]
    urdf, robot = block.urdf, None
    if urdf is not None:
        urdf = UrdfBlock(file=urdf) if isinstance(urdf, str) else urdf
        if urdf.sha256 is None:
            robot = _robot(urdf, planar, source, (*path, "urdf"))
            parts += _links(robot, source, (*path, "urdf"))
            urdf = urdf.model_copy(update={"sha256": robot.sha256})
    if not parts:
        raise source.error((*path, Absent("parts")), "is missing")
    return block.model_copy(update={"parts": parts, "urdf": urdf}), robot


def _part(block: AnyPart, planar: bool, source: Source, path: Path) -> AnyPart:
    if isinstance(block, PartBlock):
        return block
    if planar:
        raise source.error((*path, "mesh"), "is a mesh in a scenario of 2 dimensions", "a shape")
    if block.pieces is not None:
        _check_pieces(block, source, path)
        return block
    ratio = block.volume_ratio
    settings = DEFAULT if ratio is None else DecomposeSettings(volume_ratio=ratio)
    scale = None if block.scale_m is None else (*block.scale_m,)
    with source.at(*path, "mesh"):
        made = decomposed(
            _place(block.mesh, source),
            units=block.units,
            scale=None if scale is None else (scale[0], scale[1], scale[2]),
            settings=settings,
        )
    return filled(block, made.to_json())


def filled(block: MeshPartBlock, made: dict[str, object]) -> MeshPartBlock:
    """The part with what was made of its mesh: ``pieces`` and ``certificate``."""
    pieces = [PieceBlock.model_validate(p) for p in _list(made["pieces"])]
    return block.model_copy(update={"pieces": pieces, "certificate": made["certificate"]})


def _list(value: object) -> list[object]:
    return value if isinstance(value, list) else []


def _check_pieces(block: MeshPartBlock, source: Source, path: Path) -> None:
    pieces = [p.model_dump(mode="json", exclude_none=True) for p in block.pieces or ()]
    with source.at(*path):
        said = Certificate.from_json(block.certificate or {}, pieces, "certificate")
        read = [Piece.from_json(piece, f"pieces[{i}]") for i, piece in enumerate(pieces)]
        wrong = faults_without_mesh(Decomposition(tuple(read), said))
        if wrong:
            raise InputError("certificate", f"does not fit its pieces: {'; '.join(wrong)}")


def _robot(urdf: UrdfBlock, planar: bool, source: Source, path: Path) -> Robot:
    if planar:
        raise source.error(path, "is a robot in a scenario of 2 dimensions", "parts with shapes")
    with source.at(*path):
        return read_robot(_place(urdf.file, source), urdf.joints)


def _links(robot: Robot, source: Source, path: Path) -> Sequence[AnyPart]:
    """The links' shapes as parts."""
    found: list[AnyPart] = []
    with source.at(*path):
        for part in robot_parts(robot, source.folder or FilePath()):
            is_mesh = "mesh" in part
            found.append((MeshPartBlock if is_mesh else PartBlock).model_validate(part))
    return found


def _place(file: str, source: Source) -> FilePath:
    return FilePath(file) if source.folder is None else source.folder / file
