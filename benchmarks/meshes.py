"""A scene of meshes beside the same in primitives: certified from no guess, and how long it takes.

An L bracket of aluminium is carried into a bay of a truss with 20 struts, below the struts of the
middle frame, and into a C bracket there. Once all three are meshes, once boxes, cylinders and
balls. Decomposing is timed on its own, with an empty cache.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations, product
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from berthing.mesh import cache
from berthing.planner import plan
from berthing.scenario.files import from_document
from berthing.scenario.options import EFFORTS
from berthing.scenario.scenario import Scenario

MESHES = Path(__file__).parents[1] / "examples" / "meshes"
# The truss file has mm and is twice as large here.
TRUSS_SCALE_M, BRACKET_UNITS = [2e-3] * 3, "mm"
# Of the scaled truss.
BAY_M, STRUT_RADIUS_M = np.array([1.2, 1.2, 1.6]), 0.04
# A node is the hull of struts' ends at 2.5 radii from it, so this ball is around it.
NODE_RADIUS_M = STRUT_RADIUS_M * float(np.hypot(2.5, 1.0))
TRUSS_AT_M = [-0.35, -0.35, -0.675]
L_AT_M = np.array([-0.136, -0.086, -0.1])
DENSITY_KG_M3 = 2700.0
CLAIMS = (
    "mesh_sha256", "triangles", "pieces", "faces", "push_m", "uncovered_area_m2", "volume_ratio",
)  # fmt: skip


def scene(l_parts: list[dict], c_parts: list[dict], truss_parts: list[dict], **mass: Any) -> dict:
    """The document with those parts; ``mass`` of the carrier's dynamics."""
    return {
        "schema_version": 1,
        "name": "into-the-truss",
        "horizon": {"duration_s": 80},
        "margins": {"default_m": 0.01},
        "vehicles": [
            {
                "name": "carrier",
                "parts": l_parts,
                "dynamics": {"model": "rigid-body", **mass},
                "limits": {"max_force_n": 1, "max_torque_nm": 0.2},
                "start": {"position_m": [2.2, 0.9, 1.3], "attitude": [0.92388, 0, 0, 0.38268]},
                "goal": {"position_m": [0.256, 0.186, 0.125]},
            }
        ],
        "structures": [
            {"name": "c", "parts": c_parts},
            {"name": "truss", "position_m": TRUSS_AT_M, "parts": truss_parts},
        ],
    }


def of_meshes() -> dict:
    """The scene from three files."""

    def part(name: str, file: str, **more: Any) -> dict:
        return {"name": name, "mesh": str(MESHES / file), **more}

    return scene(
        [part("l", "l_bracket.obj", units=BRACKET_UNITS, position_m=L_AT_M.tolist())],
        [part("frame", "c_bracket.obj", units=BRACKET_UNITS)],
        [part("bays", "truss.obj", scale_m=TRUSS_SCALE_M)],
        density_kg_m3=DENSITY_KG_M3,
    )


def of_primitives(like: Scenario) -> dict:
    """The same by hand, with the masses of ``like``."""
    boxes_l = [box("l1", (0, 0, 0), (0.4, 0.06, 0.2)), box("l2", (0, 0.06, 0), (0.06, 0.3, 0.2))]
    for part in boxes_l:
        part["position_m"] = (np.array(part["position_m"]) + L_AT_M).tolist()
    boxes_c = [
        box("c1", (0, 0, 0), (0.5, 0.08, 0.25)),
        box("c2", (0, 0.08, 0), (0.08, 0.42, 0.25)),
        box("c3", (0, 0.42, 0), (0.5, 0.5, 0.25)),
    ]
    model = like.phases[0].vehicles[0].model
    return scene(
        boxes_l, boxes_c, list(struts()),
        mass_kg=float(model.mass_kg), inertia_kg_m2=model.inertia_kg_m2.tolist(),
        first_moment_kg_m=model.first_moment_kg_m.tolist(),
    )  # fmt: skip


def box(name: str, lower: tuple[float, ...], upper: tuple[float, ...]) -> dict:
    """A part between two corners."""
    a, b = np.array(lower), np.array(upper)
    shape = {"type": "box", "size_m": (b - a).tolist()}
    return {"name": name, "shape": shape, "position_m": (0.5 * (a + b)).tolist()}


def struts() -> Iterator[dict]:
    """Cylinders along the 20 struts, and balls at the 12 nodes."""
    grid = [(x, y, z) for z in range(3) for y in range(2) for x in range(2)]
    for i, j in combinations(range(len(grid)), 2):
        apart = np.abs(np.array(grid[i]) - np.array(grid[j]))
        if apart.sum() == 1:
            axis = int(np.argmax(apart))
            middle = 0.5 * (np.array(grid[i]) + np.array(grid[j])) * BAY_M
            shape = {
                "type": "cylinder", "radius_m": STRUT_RADIUS_M,
                "length_m": float(BAY_M[axis]), "axis": "xyz"[axis],
            }  # fmt: skip
            yield {"name": f"strut{i}-{j}", "shape": shape, "position_m": middle.tolist()}
    for i, at in enumerate(grid):
        ball = {"type": "sphere", "radius_m": NODE_RADIUS_M}
        yield {"name": f"node{i}", "shape": ball, "position_m": (np.array(at) * BAY_M).tolist()}


def with_certificates(scenario: Scenario) -> list[dict]:
    """What was made of each mesh."""
    owners = [*scenario.document["structures"], *scenario.document["phases"][0]["vehicles"]]
    return [
        {
            "mesh": Path(part["mesh"]).name,
            "kinds": Counter(piece["shape"]["type"] for piece in part["pieces"]),
            **{key: part["certificate"][key] for key in CLAIMS},
        }
        for owner in owners
        for part in owner["parts"]
    ]


def measured(name: str, scenario: Scenario, effort: str, round_: int) -> dict:
    """One plan from no guess."""
    result = plan(scenario, options=replace(scenario.solver, effort=effort))
    made, found = result.plan, result.verification
    if made is None or found is None:
        return {"scene": name, "effort": effort, "round": round_, "outcome": result.outcome}
    return {
        "scene": name,
        "effort": effort,
        "round": round_,
        "outcome": result.outcome,
        "pairs": len(scenario.pairs(scenario.phases[0])),
        "seconds": {stage: round(spent, 2) for stage, spent in made.wall_time_s.items()},
        "iterations": sum(a.iterations for a in result.attempts),
        "seconds_per_iteration": round(
            sum(a.wall_time_s for a in result.attempts)
            / sum(a.iterations for a in result.attempts), 3,
        ),
        "cost": made.cost,
        "bound_m": found.clearance_lower_bound_m,
    }  # fmt: skip


def table(rows: list[dict], seconds_to_read: float) -> str:
    """A line a scene and effort."""
    lines = [
        "| scene | effort | pairs | certified | s, median | iterations | s each | cost | bound m |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for name, effort in dict.fromkeys((row["scene"], row["effort"]) for row in rows):
        mine = [row for row in rows if (row["scene"], row["effort"]) == (name, effort)]
        good = [row for row in mine if row["outcome"] == "certified"]
        first = f"| {name} | {effort} | {mine[0].get('pairs', '')} | {len(good)} of {len(mine)} "
        if good:
            first += (
                f"| {median(row['seconds']['total'] for row in good):.1f} "
                f"| {median(row['iterations'] for row in good):.0f} "
                f"| {median(row['seconds_per_iteration'] for row in good):.3f} "
                f"| {median(row['cost'] for row in good):.6f} "
                f"| {min(row['bound_m'] for row in good):.5f} "
            )
        lines.append(first + "|")
    return "\n".join([*lines, "", f"Meshes read, decomposed and proven in {seconds_to_read:.1f} s"])


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks meshes")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--effort", action="append", choices=EFFORTS)
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as empty:
        os.environ[cache.FOLDER_VARIABLE] = empty
        began = time.perf_counter()
        meshes = from_document(of_meshes())
        seconds = time.perf_counter() - began
    scenes = {"meshes": meshes, "primitives": from_document(of_primitives(meshes))}
    rows = []
    # In turns, so that what else the machine does falls on both.
    for round_ in range(options.rounds):
        for effort, (name, scenario) in product(options.effort or ["normal"], scenes.items()):
            rows.append(measured(name, scenario, effort, round_))
            print(rows[-1], flush=True)
    print(table(rows, seconds))
    if options.json:
        made = with_certificates(meshes)
        content = {"seconds_to_decompose": round(seconds, 1), "meshes": made, "plans": rows}
        options.json.write_text(json.dumps(content, indent=1) + "\n")
    return 0
