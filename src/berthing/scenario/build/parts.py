"""Shapes, placements and bodies."""

from __future__ import annotations

from collections.abc import Sequence

from berthing.geometry.body import Body, Part
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.geometry.shape_model import EXACT, ShapeModel
from berthing.scenario.build.names import check_unique
from berthing.scenario.build.poses import build_pose
from berthing.scenario.build.shapes import build_shape
from berthing.scenario.schema.meshes import AnyPart
from berthing.scenario.schema.shapes import PartBlock
from berthing.scenario.source import Path, Source


def build_body(parts: Sequence[AnyPart], dim: int, source: Source, path: Path) -> Body:
    """A body of the scenario's dimension.

    Raises:
        InputError: a shape that is none, one of another dimension, or a name used twice.
    """
    check_unique([part.name for part in parts], source, path)
    found = [part for i, p in enumerate(parts) for part in _parts(p, dim, source, (*path, i))]
    return Body(tuple(found))


def _parts(block: AnyPart, dim: int, source: Source, path: Path) -> list[Part]:
    """One part, or of a mesh its pieces: ``name.1``, ``name.2`` and so on, where it has several."""
    outer = build_pose(block, dim, source, path)
    if isinstance(block, PartBlock):
        shape = build_shape(block.shape, dim, source, (*path, "shape"))
        return [_part(block.name, shape, outer, block, source, path)]
    pieces = block.pieces or []
    found = []
    for i, piece in enumerate(pieces):
        name = f"{block.name}.{i + 1}" if len(pieces) > 1 else block.name
        inner = (*path, "pieces", i)
        shape = build_shape(piece.shape, dim, source, (*inner, "shape"))
        placement = outer.compose(build_pose(piece, dim, source, inner))
        found.append(_part(name, shape, placement, block, source, path))
    return found


def _part(
    name: str, shape: ConvexSet, placement: Pose, block: AnyPart, source: Source, path: Path
) -> Part:
    """The part, its model for planning made at once, so that one that cannot be is refused here."""
    model = EXACT
    if block.shape_model is not None:
        with source.at(*path, "shape_model"):
            model = ShapeModel(**block.shape_model.model_dump())
    part = Part(name, shape, placement, model)
    with source.at(*path):
        _ = part.planning_shape
    return part
