"""The scenario from its file."""

from __future__ import annotations

from collections.abc import Mapping

from berthing.scenario import reach
from berthing.scenario.build.models import with_default_model
from berthing.scenario.build.names import check_exists, check_overrides, check_unique
from berthing.scenario.build.structures import build_structure
from berthing.scenario.build.user_code import build_running_costs
from berthing.scenario.build.vehicles import build_vehicle
from berthing.scenario.cost import Cost
from berthing.scenario.goal import End
from berthing.scenario.horizon import Horizon
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.normal import normal_document
from berthing.scenario.options import SolverOptions
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.schema.document import (
    HorizonBlock,
    OverrideBlock,
    PhaseBlock,
    ScenarioFile,
)
from berthing.scenario.source import Path, Source

# LVLH has two opposite conventions; these names have one each.
ORBIT_FRAMES = ("RTN", "LVLH_CCSDS")


def build_scenario(file: ScenarioFile, source: Source) -> Scenario:
    """The scenario, all of it checked but for clearances, which need a collision library.

    Raises:
        InputError: anything that cannot be, a goal provably out of reach included.
    """
    dim = len(file.phases[0].vehicles[0].goal.position_m)
    _check_names(file, source)
    document = normal_document(file)
    file = with_default_model(file, source)
    structures = tuple(
        build_structure(s, dim, source, ("structures", i)) for i, s in enumerate(file.structures)
    )
    scenario = Scenario(
        file.name,
        file.description,
        _phases(file, dim, source),
        structures,
        _margins(file, source),
        SolverOptions(**file.solver.model_dump(exclude={"shape_model"})),
        file.meta,
        document,
    )
    _check_frames(file, source)
    _check_tables(scenario, source)
    check_overrides(scenario, source)
    _check_reach(scenario, source)
    return scenario


def _phases(file: ScenarioFile, dim: int, source: Source) -> tuple[Phase, ...]:
    goals: dict[str, End] = {}
    phases = []
    for i, block in enumerate(file.phases):
        phase = _phase(block, dim, goals, source, ("phases", i))
        goals = {v.name: v.goal for v in phase.vehicles}
        phases.append(phase)
    return tuple(phases)


def _phase(
    block: PhaseBlock, dim: int, goals: Mapping[str, End], source: Source, path: Path
) -> Phase:
    vehicles = tuple(
        build_vehicle(v, dim, goals.get(v.name), source, (*path, "vehicles", i))
        for i, v in enumerate(block.vehicles)
    )
    with source.at(*path, "horizon"):
        horizon = _horizon(block.horizon)
    running = build_running_costs(block.cost.running, vehicles, source, (*path, "cost"))
    with source.at(*path, "cost"):
        cost = Cost(block.cost.control_energy, block.cost.time, running)
    return Phase(block.name, vehicles, horizon, cost)


def _horizon(block: HorizonBlock) -> Horizon:
    if block.duration_s is not None:
        return Horizon.fixed(block.duration_s)
    return Horizon(block.min_s or 0.0, block.max_s or 0.0)


def _margins(file: ScenarioFile, source: Source) -> MarginPolicy:
    overrides = []
    for i, block in enumerate(file.margins.overrides):
        with source.at("margins", "overrides", i):
            overrides.append(_override(block))
    return MarginPolicy(file.margins.default_m, tuple(overrides))


def _override(block: OverrideBlock) -> MarginOverride:
    a, b = block.between
    window = None if block.window_s is None else (block.window_s[0], block.window_s[1])
    return MarginOverride(a, b, block.margin_m, window)


def _check_names(file: ScenarioFile, source: Source) -> None:
    structures = [s.name for s in file.structures]
    check_unique([p.name for p in file.phases], source, ("phases",))
    check_unique(structures, source, ("structures",))
    for i, phase in enumerate(file.phases):
        path: Path = ("phases", i, "vehicles")
        check_unique([v.name for v in phase.vehicles], source, path)
        for j, vehicle in enumerate(phase.vehicles):
            if vehicle.name in structures:
                what = f"is {vehicle.name!r}, as is that of a structure"
                raise source.error((*path, j, "name"), what, "a name of its own")
            for key in ("start", "goal"):
                frame = getattr(getattr(vehicle, key), "frame", None)
                if frame is not None:
                    check_exists(frame, structures, "structure", source, (*path, j, key, "frame"))


def _check_frames(file: ScenarioFile, source: Source) -> None:
    frame = file.meta.get("frame")
    if isinstance(frame, str) and frame.strip().upper() == "LVLH":
        what = f"is {frame!r}, which has two opposite conventions"
        raise source.error(("meta", "frame"), what, " or ".join(ORBIT_FRAMES))


def _check_tables(scenario: Scenario, source: Source) -> None:
    """A law must be known for as long as the scenario may last."""
    end = sum(phase.horizon.max_s for phase in scenario.phases)
    for i, structure in enumerate(scenario.structures):
        known = structure.motion.span_s
        if known[0] > 0.0 or known[1] < end:
            what = f"runs from {known[0]:g} to {known[1]:g} s"
            raise source.error(
                ("structures", i, "motion", "times_s"), what, f"all of 0 to {end:g} s"
            )


def _check_reach(scenario: Scenario, source: Source) -> None:
    for i, phase in enumerate(scenario.phases):
        for j, vehicle in enumerate(phase.vehicles):
            with source.at("phases", i, "vehicles", j, "goal"):
                reach.check(scenario, phase, vehicle)
