"""``berthing decompose``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import typer

from berthing.commands.console import print_rows
from berthing.commands.exit_codes import CERTIFIED, NOT_CERTIFIED
from berthing.errors import InputError
from berthing.mesh.pieces_file import Described, described, faults_of
from berthing.mesh.settings import DecomposeSettings
from berthing.report.mesh_folder import check_folder, write_folder
from berthing.report.plan_json import to_text
from berthing.report.verdict_table import Row
from berthing.trajectory_io.strict_json import read_object

DEFAULT_FOLDER = Path("pieces")


def run(
    file: Path,
    how: Mapping[str, Any],
    stated: Mapping[str, Any],
    joints: Sequence[str],
    out: Path | None,
    *,
    force: bool,
    as_json: bool,
) -> int:
    """Decompose a mesh or a robot description and write a folder; the exit code.

    Args:
        file: the mesh or the URDF.
        how: settings of ``DecomposeSettings`` by name.
        stated: what the file does not say: ``units`` and ``density_kg_m3`` of ``described``.
        joints: ``NAME=POSITION`` each.
        out: the folder; None for the default.
        force: write into a folder in use.
        as_json: print JSON only.

    Raises:
        InputError: anything wrong with the input or with the folder; nothing is written.
    """
    target = DEFAULT_FOLDER / file.stem if out is None else out
    check_folder(target, force=force)
    settings = DecomposeSettings(**how)
    found = described(file, target, settings, joints=_positions(joints), **stated)
    write_folder(found, target)
    if as_json:
        typer.echo(to_text({**found.summary(), "folder": str(target)}), nl=False)
    else:
        print_rows([*rows(found), Row("written to", str(target))])
    return CERTIFIED


def check(file: Path, pieces: Path, *, as_json: bool) -> int:
    """Prove again, from the mesh and the file of its pieces, that these contain it.

    Raises:
        InputError: a file that is missing or cannot be read.
    """
    faults = faults_of(read_object(pieces), pieces.parent, file)
    if as_json:
        typer.echo(to_text({"holds": not faults, "faults": faults}), nl=False)
    else:
        verdict = Row("proof", "holds" if not faults else "DOES NOT HOLD", not faults)
        print_rows([verdict, *(Row("because", fault) for fault in faults)])
    return NOT_CERTIFIED if faults else CERTIFIED


def rows(found: Described) -> list[Row]:
    """What was made, as a table."""
    lines = [Row("source", found.source)]
    for part in found.parts:
        made = found.made.get(part["name"])
        if made is None:
            lines.append(Row(f"part {part['name']}", f"a {part['shape']['type']}, as it is"))
            continue
        said = made.certificate
        kinds = [piece.to_json()["shape"]["type"] for piece in made.pieces]
        listed = ", ".join(f"{kinds.count(kind)} {kind}" for kind in sorted(set(kinds)))
        lines += [
            Row(f"part {part['name']}", f"{said.triangles:,} triangles, {said.volume_m3:.6g} m³"),
            Row("pieces", f"{said.pieces} ({listed}), {sum(said.faces)} faces"),
            Row(
                "contain the mesh", f"proven, faces pushed out by {1e3 * said.push_m:.3g} mm", True
            ),
            Row("volume ratio", f"{said.volume_ratio:.4f}"),
        ]
    if found.mass is not None:
        lines.append(Row("mass", f"{found.mass.mass_kg:.6g} kg"))
    return lines


def _positions(joints: Sequence[str]) -> Mapping[str, float]:
    found: dict[str, float] = {}
    for text in joints:
        name, equals, value = text.rpartition("=")
        try:
            found[name] = float(value) if equals else float("nan")
        except ValueError:
            found[name] = float("nan")
        if not abs(found[name]) < float("inf"):
            raise InputError("--joint", f"is {text!r}", "NAME=POSITION, in rad or m")
    return found
