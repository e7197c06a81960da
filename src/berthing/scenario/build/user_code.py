"""Code of the user's own: read, run where it is trusted, and kept with the scenario."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any, TypeVar

from berthing.scenario.build.names import check_exists, check_unique
from berthing.scenario.cost import RunningCost
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.schema.document import PhaseBlock, ScenarioFile
from berthing.scenario.schema.user import (
    PathConstraintBlock,
    RunningCostBlock,
    UserBlock,
    UserModelBlock,
)
from berthing.scenario.schema.vehicles import VehicleBlock
from berthing.scenario.source import Path, Source
from berthing.scenario.user_function import UserFunction, called
from berthing.scenario.user_model import UserModel
from berthing.scenario.vehicle import Vehicle

AnyBlock = TypeVar("AnyBlock", bound=UserBlock)


def with_code(file: ScenarioFile, source: Source) -> ScenarioFile:
    """The file with the text of every Python file that it names in it, so that it stands alone.

    Raises:
        InputError: a file that cannot be read.
    """
    phases = [_phase(p, source, ("phases", i)) for i, p in enumerate(file.phases)]
    return file.model_copy(update={"phases": phases})


def _phase(phase: PhaseBlock, source: Source, path: Path) -> PhaseBlock:
    running = _filled(phase.cost.running, source, (*path, "cost", "running"))
    vehicles = [_vehicle(v, source, (*path, "vehicles", i)) for i, v in enumerate(phase.vehicles)]
    cost = phase.cost.model_copy(update={"running": running})
    return phase.model_copy(update={"cost": cost, "vehicles": vehicles})


def _vehicle(block: VehicleBlock, source: Source, path: Path) -> VehicleBlock:
    constraints = _filled(block.path_constraints, source, (*path, "path_constraints"))
    dynamics = block.dynamics
    if isinstance(dynamics, UserModelBlock):
        dynamics = _with_text(dynamics, source, (*path, "dynamics"))
    return block.model_copy(update={"path_constraints": constraints, "dynamics": dynamics})


def _filled(blocks: Sequence[AnyBlock], source: Source, path: Path) -> list[AnyBlock]:
    return [_with_text(block, source, (*path, i)) for i, block in enumerate(blocks)]


def _with_text(block: AnyBlock, source: Source, path: Path) -> AnyBlock:
    if block.code is not None:
        return block
    where = FilePath(block.file) if source.folder is None else source.folder / block.file
    try:
        text = where.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise source.error((*path, "file"), f"is {block.file!r}, which is not UTF-8 text") from None
    except OSError as error:
        why = error.strerror or "no reason is told"
        raise source.error((*path, "file"), f"is {block.file!r}: {why}", "a Python file") from None
    return block.model_copy(update={"code": text})


def build_user_model(block: UserModelBlock, source: Source, path: Path) -> UserModel:
    """The model that a block names, with its parameters.

    Raises:
        InputError: code that is not trusted, that fails, or that has no such model.
    """
    found = _named(block, source, path)
    if not isinstance(found, UserModel):
        what = f"is {block.name!r}, in {block.file} {type(found).__name__}"
        raise source.error((*path, "name"), what, "a berthing.UserModel")
    parameters = {**found.parameters, **block.parameters}
    return UserModel(**{**vars(found), "parameters": parameters})


def build_path_constraints(
    blocks: Sequence[PathConstraintBlock], source: Source, path: Path
) -> tuple[PathConstraint, ...]:
    """The constraints of one vehicle, at ``path``.

    Raises:
        InputError: as for a model, or two of one name.
    """
    path = (*path, "path_constraints")
    names = [block.label or block.name for block in blocks]
    check_unique(names, source, path)
    return tuple(
        PathConstraint(
            name, _function(block, name, source, (*path, i)), block.tolerance, block.scale
        )
        for i, (name, block) in enumerate(zip(names, blocks, strict=True))
    )


def build_running_costs(
    blocks: Sequence[RunningCostBlock], vehicles: Sequence[Vehicle], source: Source, path: Path
) -> tuple[RunningCost, ...]:
    """The user's part of the cost at ``path``.

    Raises:
        InputError: as for a model, or a vehicle that does not exist.
    """
    out = []
    for i, block in enumerate(blocks):
        here: Path = (*path, "running", i)
        check_exists(
            block.vehicle, [v.name for v in vehicles], "vehicle", source, (*here, "vehicle")
        )
        function = _function(block, block.name, source, here)
        out.append(RunningCost(block.vehicle, function, block.scale))
    return tuple(out)


def _function(block: UserBlock, label: str, source: Source, path: Path) -> UserFunction:
    found = _named(block, source, path)
    if not callable(found):
        what = f"is {block.name!r}, in {block.file} {type(found).__name__}"
        raise source.error((*path, "name"), what, "a function f(t, x, u, p, xp)")
    function: Callable[..., Any] = found
    return UserFunction(label, function, block.parameters)


def _named(block: UserBlock, source: Source, path: Path) -> Any:
    """What the block names, its code having been run."""
    if not source.trusted:
        what = f"names code of the user's own, {block.file}, which is not run unasked"
        raise source.error((*path, "file"), what, "--trust, in Python trust=True, if you trust it")
    with source.at(*path, "file"):
        names = _run(block.file, block.code or "")
    if block.name not in names:
        own = sorted(name for name in names if not name.startswith("_"))
        check_exists(block.name, own, f"name in {block.file}", source, (*path, "name"))
    return names[block.name]


@lru_cache(maxsize=64)
def _run(file: str, text: str) -> dict[str, Any]:
    """The names that the text of a Python file binds; run once, however often it is named."""
    names: dict[str, Any] = {"__name__": "berthing_user_code", "__file__": file}

    def work() -> None:
        exec(compile(text, file, "exec"), names)

    called(file, work)
    return names
