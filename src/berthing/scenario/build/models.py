"""The default shape model, given to the parts that have none of their own."""

from __future__ import annotations

from typing import TypeVar

from berthing.geometry.shape_model import ShapeModel
from berthing.scenario.schema.document import PhaseBlock, ScenarioFile
from berthing.scenario.schema.meshes import Bodied
from berthing.scenario.schema.shapes import ShapeModelBlock
from berthing.scenario.source import Source

AnyBodied = TypeVar("AnyBodied", bound=Bodied)


def with_default_model(file: ScenarioFile, source: Source) -> ScenarioFile:
    """The file with ``solver.shape_model`` written to every part that is silent.

    Raises:
        InputError: a default that is no model, whatever the shapes.
    """
    default = file.solver.shape_model
    if default is None:
        return file
    with source.at("solver", "shape_model"):
        ShapeModel(**default.model_dump())
    structures = [_bodied(structure, default) for structure in file.structures]
    phases = [_phase(phase, default) for phase in file.phases]
    return file.model_copy(update={"structures": structures, "phases": phases})


def _phase(phase: PhaseBlock, default: ShapeModelBlock) -> PhaseBlock:
    vehicles = [_bodied(vehicle, default) for vehicle in phase.vehicles]
    return phase.model_copy(update={"vehicles": vehicles})


def _bodied(block: AnyBodied, default: ShapeModelBlock) -> AnyBodied:
    parts = [
        part if part.shape_model else part.model_copy(update={"shape_model": default})
        for part in block.parts or ()
    ]
    return block.model_copy(update={"parts": parts})
