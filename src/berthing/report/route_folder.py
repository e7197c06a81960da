"""The folder of routes: route.json and route.csv, or failure.json."""

from __future__ import annotations

import csv
import dataclasses
import io
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.report.fresh_folder import (
    FAILURE_JSON,
    FIGURES,
    ROUTE_CSV,
    ROUTE_JSON,
    fresh_folder,
)
from berthing.report.plan_json import to_text, versions
from berthing.routes.routing import Route, Routes
from berthing.scenario.normal import document_sha256
from berthing.scenario.scenario import Scenario

SCHEMA_VERSION = 1
POSE = ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")
HEADER = ("route", "state", "vehicle", *POSE, "bound_m")

HOW_TO_READ = (
    "states: for each vehicle x_m, y_m, z_m, qw, qx, qy, qz, body to frame. From each state to the "
    "next all reference points move straight and all attitudes turn the shorter way at a constant "
    "rate, in step. bound_m of a leg lies below the clearance of every pair at every instant of it."
)


def write_routes(
    scenario: Scenario, found: Routes, options: Mapping[str, Any], target: Path, *, force: bool,
    figures: bool = False,
) -> dict[str, Any]:  # fmt: skip
    """Write the folder, whole or not at all; return its JSON.

    Args:
        scenario: what was asked.
        found: the answer.
        options: those of the command, for a failure.
        target: the folder.
        force: replace an older folder of a route or a plan.
        figures: draw each route too.

    Raises:
        InputError: the folder may not or cannot be written.
    """
    try:
        with fresh_folder(target, force=force) as folder:
            if found.routes:
                document = route_document(scenario, found)
                (folder / ROUTE_JSON).write_text(to_text(document), encoding="utf-8")
                (folder / ROUTE_CSV).write_text(table(found), encoding="utf-8")
                if figures:
                    _draw(scenario, found, folder / FIGURES)
            else:
                document = _failure(scenario, found, options)
                (folder / FAILURE_JSON).write_text(to_text(document), encoding="utf-8")
    except OSError as error:
        where = str(error.filename or target)
        raise InputError(where, f"cannot be written: {error.strerror or error}") from None
    return document


def _draw(scenario: Scenario, found: Routes, folder: Path) -> None:
    # Loaded when wanted: it takes longer than most routes.
    from berthing.report.route_figure import draw_route
    from berthing.report.style import save

    folder.mkdir()
    for number, own in enumerate(found.routes):
        save(draw_route(scenario, own), folder / f"route-{number}.png")


def route_document(scenario: Scenario, found: Routes) -> dict[str, Any]:
    """The content of route.json."""
    return {
        "schema_version": SCHEMA_VERSION,
        "name": scenario.name,
        "scenario_sha256": document_sha256(scenario.document),
        "outcome": found.outcome,
        "seed": found.seed,
        "wall_time_s": found.wall_time_s,
        "frame": found.frame,
        "vehicles": list(found.vehicles),
        "how_to_read": HOW_TO_READ,
        "routes": [_route(own, found.vehicles) for own in found.routes],
        "searches": [dataclasses.asdict(own) for own in found.searches],
        "versions": versions(),
        "scenario": dict(scenario.document),
    }


def table(found: Routes) -> str:
    """The states as CSV; bound_m is that of the leg which begins there, empty at the last."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    writer.writerows(_rows(found))
    return text.getvalue()


def _rows(found: Routes) -> Iterator[tuple[object, ...]]:
    for number, own in enumerate(found.routes):
        bounds = [*map(repr, own.legs.bound_m.tolist()), ""]
        for i, (state, bound) in enumerate(zip(own.states.tolist(), bounds, strict=True)):
            for vehicle, row in zip(found.vehicles, state, strict=True):
                yield number, i, vehicle, *map(repr, row), bound


def _route(own: Route, vehicles: tuple[str, ...]) -> dict[str, Any]:
    legs, closest = own.legs, own.legs.closest
    return {
        "length_m": own.length_m,
        "clearance_lower_bound_m": own.clearance_m,
        "certified": legs.certified,
        "closest": None
        if closest is None
        else {"pair": closest[0], "leg": closest[1], "distance_m": closest[2]},
        "legs": [
            {"bound_m": bound, "excess_m": excess}
            for bound, excess in zip(legs.bound_m.tolist(), legs.excess_m.tolist(), strict=True)
        ],
        "states": [dict(zip(vehicles, state, strict=True)) for state in own.states.tolist()],
    }


def _failure(scenario: Scenario, found: Routes, options: Mapping[str, Any]) -> dict[str, Any]:
    return {
        "schema_version": SCHEMA_VERSION,
        "name": scenario.name,
        "outcome": found.outcome,
        "advice": "another --seed, a larger --time-limit, or a smaller margin: no search says "
        "that there is no way",
        "searches": [dataclasses.asdict(own) for own in found.searches],
        "options": dict(options),
        "versions": versions(),
        "scenario": dict(scenario.document),
    }
