"""Names: each stands once, and every name used exists."""

from __future__ import annotations

from collections.abc import Sequence

from berthing.geometry.body import Part
from berthing.scenario.scenario import Scenario
from berthing.scenario.source import Path, Source
from berthing.scenario.structure import Structure
from berthing.scenario.suggest import did_you_mean
from berthing.scenario.vehicle import Vehicle


def check_unique(names: Sequence[str], source: Source, path: Path) -> None:
    """Refuse a list of blocks at ``path`` of which two have one name; InputError at the second."""
    for i, name in enumerate(names):
        if name in names[:i]:
            what = f"is {name!r}, as is that of entry {names.index(name)}"
            raise source.error((*path, i, "name"), what, "a name of its own")


def check_exists(name: str, options: Sequence[str], kind: str, source: Source, path: Path) -> None:
    """Refuse a name that is not among the options; InputError with near matches, or all."""
    if name not in options:
        listed = f"one of: {', '.join(options)}" if options else f"no name, there being no {kind}"
        hint = did_you_mean(name, options)
        raise source.error(path, f"names no {kind}: {name!r}{hint}", "" if hint else listed)


def _names(part: Part) -> tuple[str, ...]:
    """What a part answers to: its name, and for a piece of a mesh also the mesh's."""
    mesh, dot, _ = part.name.partition(".")
    return (mesh, part.name) if dot else (part.name,)


def check_overrides(scenario: Scenario, source: Source) -> None:
    """Refuse overrides whose selectors do not exist, or that no pair of parts answers to."""
    pairs = [pair for phase in scenario.phases for pair in scenario.pairs(phase)]
    owners: list[Structure | Vehicle] = [
        *scenario.structures,
        *(v for p in scenario.phases for v in p.vehicles),
    ]
    selectors = [o.name for o in owners]
    selectors += [f"{o.name}.{name}" for o in owners for p in o.body.parts for name in _names(p)]
    selectors = list(dict.fromkeys(selectors))
    for i, override in enumerate(scenario.margins.overrides):
        path: Path = ("margins", "overrides", i, "between")
        for side, selector in enumerate((override.a, override.b)):
            check_exists(selector, selectors, "vehicle, structure or part", source, (*path, side))
        if not any(override.concerns(pair.ref_a, pair.ref_b) for pair in pairs):
            what = f"is [{override.a}, {override.b}], which are not kept apart in any case"
            raise source.error(path, what, "a vehicle, and a structure or another vehicle")
