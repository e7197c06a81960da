"""Files that somebody else has written, by chance or with intent: no crash, no false certificate.

What is changed at random may by chance be harmless, and then the plan may be certified: it must
really keep its distance, by a checker that shares no code with the package.
"""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from berthing.verify.size_limits import LARGEST_DEGREE, MOST_PAIRS, MOST_SEGMENTS
from support import outside
from support.attacks import certified, reseal

JSON_FILES = ("plan.json", "interpolant.json", "certificate.json")
FILES = (*JSON_FILES, "nodes.csv", "trajectory.csv")
MARGIN_M = 0.1
OUTSIDE_SAMPLES = 201
# Of outside.py: its prisms are a little larger than the cylinders.
OUTSIDE_M = 1e-3
NASTY: tuple[Any, ...] = (
    float("nan"), float("inf"), 1e308, -1e308, 1e-320, -1, 0, 10**400, 2**63, True, None, "", "0",
    "\ud800", [], {}, [[]], [0.0] * 999, {"a": {}}, "x" * 10_000,
)  # fmt: skip
MEMORY_BYTES, SECONDS = 4 << 30, 90


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where values are in a document."""
    children: Any = ()
    if isinstance(value, dict):
        children = value.items()
    elif isinstance(value, list):
        children = enumerate(value)
    for key, child in children:
        yield (*path, key)
        yield from places(child, (*path, key))


def damaged(document: Any, rng: np.random.Generator) -> None:
    """Replace, remove, double or move a value anywhere."""
    found = list(places(document))
    # Keys near the top are as likely as the many numbers below.
    depth = rng.integers(1, 1 + max(map(len, found)))
    here = [path for path in found if len(path) == depth]
    *way, last = here[rng.integers(len(here))]
    parent = document
    for key in way:
        parent = parent[key]
    action = rng.integers(4)
    if action == 0:
        del parent[last]
    elif action == 1 and isinstance(parent[last], int | float):
        parent[last] *= -1 + 2 * rng.random() if rng.random() < 0.5 else 1 + 1e-6
    elif action == 2 and isinstance(parent, list):
        parent.insert(last, parent[rng.integers(len(parent))])
    else:
        parent[last] = NASTY[rng.integers(len(NASTY))]


def garbled(content: bytes, rng: np.random.Generator) -> bytes:
    """Cut short, or with some bytes changed."""
    if rng.random() < 0.3:
        return content[: rng.integers(len(content))]
    broken = bytearray(content)
    for place in rng.integers(0, len(content), rng.integers(1, 5)):
        broken[place] = rng.integers(256)
    return bytes(broken)


def spoil(folder: Path, seed: int) -> None:
    """One file damaged at random; half of the forgers seal the folder again."""
    rng = np.random.default_rng(seed)
    name = FILES[rng.integers(len(FILES))]
    path = folder / name
    if name in JSON_FILES and rng.random() < 0.7:
        document = json.loads(path.read_text(encoding="utf-8"))
        for _ in range(rng.integers(1, 4)):
            damaged(document, rng)
        path.write_text(json.dumps(document), encoding="utf-8")
    else:
        path.write_bytes(garbled(path.read_bytes(), rng))
    if rng.random() < 0.5:
        try:
            reseal(folder)
        except (ValueError, LookupError, TypeError, AttributeError):
            return


def judge(folder: Path) -> None:
    """Any exception but those for bad input is a failure, and so is a false certificate."""
    with np.errstate(all="ignore"):
        proven, why = certified(folder)
    assert proven or why
    if proven:
        assert outside.least_distance(folder, OUTSIDE_SAMPLES) >= MARGIN_M - OUTSIDE_M


@pytest.mark.parametrize("seed", range(6))
def test_damage_never_crashes(folder: Path, seed: int) -> None:
    spoil(folder, seed)
    judge(folder)


@pytest.mark.slow
@pytest.mark.parametrize("block", range(10))
def test_much_damage_never_crashes(hand_made_folder: Path, tmp_path: Path, block: int) -> None:
    for seed in range(1000 + 40 * block, 1040 + 40 * block):
        folder = Path(shutil.copytree(hand_made_folder, tmp_path / str(seed)))
        spoil(folder, seed)
        judge(folder)
        shutil.rmtree(folder)


def one_vehicle(document: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = document["phases"][0]["vehicles"][0]
    return found


def many_segments(document: dict[str, Any]) -> None:
    own = one_vehicle(document)
    first = own["segments"][0]
    own["segments"] = [
        {
            "t0_s": i * 1e-3,
            "t1_s": (i + 1) * 1e-3,
            "state": first["state"][:1],
            "control": [[0] * 6],
        }
        for i in range(MOST_SEGMENTS)
    ]


def many_intervals(document: dict[str, Any]) -> None:
    row = document["phases"][0]["pairs"][0]["intervals"][0]
    document["phases"][0]["pairs"][0]["intervals"] = [row] * 200_000


def wide_intervals(document: dict[str, Any]) -> None:
    normals = document["phases"][0]["pairs"][0]["intervals"][0][3:]
    row = [0.0, 100.0, 0.1, *normals]
    document["phases"][0]["pairs"][0]["intervals"] = [row] * 100_000


def many_parts(document: dict[str, Any]) -> None:
    vehicle = document["scenario"]["phases"][0]["vehicles"][0]
    part = vehicle["parts"][0]
    vehicle["parts"] = [{**part, "name": f"p{i}"} for i in range(MOST_PAIRS)]


def high_degree(document: dict[str, Any]) -> None:
    segment = one_vehicle(document)["segments"][0]
    segment["state"] += [[0.0] * 13] * (LARGEST_DEGREE + 1)


def wild_oscillation(document: dict[str, Any]) -> None:
    for segment in one_vehicle(document)["segments"]:
        segment["state"] += [[1e3] * 13] * (LARGEST_DEGREE - len(segment["state"]))


def fast_spin(document: dict[str, Any]) -> None:
    document["scenario"]["structures"][0]["motion"] = {
        "type": "spin", "axis": [0, 0, 1], "rate_rad_s": 1e9,
    }  # fmt: skip


def stiff(document: dict[str, Any]) -> None:
    dynamics = document["scenario"]["phases"][0]["vehicles"][0]["dynamics"]
    dynamics.update(mass_kg=1e-12, inertia_kg_m2=[1e-12, 1e-12, 1e-12])


HOSTILE: dict[str, tuple[str, Callable[[dict[str, Any]], object]]] = {
    "many segments": ("interpolant.json", many_segments),
    "many intervals": ("certificate.json", many_intervals),
    "wide intervals": ("certificate.json", wide_intervals),
    "many parts": ("plan.json", many_parts),
    "high degree": ("interpolant.json", high_degree),
    "wild oscillation": ("interpolant.json", wild_oscillation),
    "fast spin": ("plan.json", fast_spin),
    "stiff": ("plan.json", stiff),
}


def limited() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


@pytest.mark.slow
@pytest.mark.parametrize("search", [False, True])
@pytest.mark.parametrize("name", HOSTILE)
def test_within_memory_and_time(folder: Path, name: str, search: bool) -> None:
    """As a process with bounds: an answer, and no traceback."""
    file, change = HOSTILE[name]
    document = json.loads((folder / file).read_text(encoding="utf-8"))
    change(document)
    (folder / file).write_text(json.dumps(document), encoding="utf-8")
    reseal(folder)
    command = [sys.executable, "-m", "berthing", "verify", str(folder), "--json"]
    done = subprocess.run(
        [*command, *(["--search"] if search else [])],
        capture_output=True, text=True, check=False, preexec_fn=limited,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
    )  # fmt: skip
    sound = name == "many intervals" and not search
    assert done.returncode in ((0, 2, 4) if search or sound else (2, 4)), done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("text", ["[" * 300_000, '{"a":' * 100_000, "9" * 100_000, '"' + "\\" * 9])
@pytest.mark.parametrize("name", JSON_FILES)
def test_no_json_at_all(folder: Path, name: str, text: str) -> None:
    (folder / name).write_text(text, encoding="utf-8")
    proven, why = certified(folder)
    assert not proven
    assert name in why
