"""What the checker in NumPy alone says of random passes, beside what ``berthing verify`` says.

Each pass, drawn as for the certificate's benchmark, is asked for with a margin that it keeps; its
certificate is written as a file and read by both: as it is, against a margin that is violated, and
forged.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import runpy
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks._passes import DURATION_S, Mover, Pass, random_pass
from benchmarks.certificate import NEAREST_M, amount, scenario_of
from berthing.geometry.quaternion import from_matrix
from berthing.scenario.normal import document_sha256
from berthing.trajectory_io import write_interpolant
from berthing.verify.certificate import certify
from berthing.verify.claims import claims_of, read_claims, write_claims
from berthing.verify.recheck import check_claims
from berthing.verify.tube import EXACT, Tube
from berthing.verify.verdict import CERTIFIED

CHECK: Callable[[str], None] = runpy.run_path(
    str(Path(__file__).parents[1] / "examples" / "09_check_certificate.py"), run_name="example"
)["main"]
REFUSALS = (ArithmeticError, LookupError, OSError, StopIteration, TypeError, ValueError)
MISSED_M = 1e-5
# How far a forged normal is turned (rad), and a forged bound raised (m).
TURNED_RAD, RAISED_M = 0.05, 1e-4


def part_of(own: Mover) -> dict[str, Any]:
    """The solid as scenario files have it."""
    numbers = [float(v) for v in np.ravel(own.solid.numbers)]
    shapes: dict[str, dict[str, Any]] = {
        "box": {"type": "box", "size_m": [2.0 * v for v in numbers]},
        "sphere": {"type": "sphere", "radius_m": numbers[0]},
        "ellipsoid": {"type": "ellipsoid", "semi_axes_m": numbers},
        "cylinder": {"type": "cylinder", "radius_m": numbers[0], "length_m": 2.0 * numbers[-1],
                     "axis": "z"},
        "polytope": {"type": "polytope"},
    }  # fmt: skip
    shape = shapes[own.solid.kind]
    if own.solid.kind == "polytope":
        shape["vertices_m"] = own.solid.shape.corners.tolist()
    (part,) = own.owner.body.parts
    return {
        "name": part.name,
        "shape": shape,
        "position_m": own.solid.offset.tolist(),
        "attitude": from_matrix(own.solid.turn).tolist(),
    }


def document_of(case: Pass, margin_m: float) -> dict[str, Any]:
    """As much of a scenario as clearance takes."""
    vehicles, structures = [], []
    for own in (case.craft, case.other):
        body = {"name": own.owner.name, "parts": [part_of(own)]}
        if own.flown is not None:
            vehicles.append(body)
            continue
        law = own.owner.motion
        motion = {"type": "spin", "axis": law.axis_body.tolist(), "rate_rad_s": law.rate_rad_s,
                  "velocity_m_s": law.velocity_m_s.tolist()}  # fmt: skip
        placed = {"position_m": law.pose0.position.tolist(),
                  "attitude": from_matrix(law.pose0.rotation).tolist()}  # fmt: skip
        structures.append({**body, **placed, "motion": motion})
    phase = {"name": "main", "horizon": {"duration_s": DURATION_S}, "vehicles": vehicles}
    margins = {"default_m": margin_m, "overrides": []}
    return {"phases": [phase], "structures": structures, "margins": margins}


@dataclass(frozen=True)
class Files:
    """A pass in a folder with the certificate of one margin."""

    case: Pass
    folder: Path

    @property
    def tubes(self) -> dict[str, Tube]:
        """What flies is the polynomials themselves here."""
        return {own.vehicle: EXACT for own in self.case.trajectory.vehicles}

    @staticmethod
    def write(case: Pass, folder: Path, margin_m: float) -> Files:
        files = Files(case, folder)
        whole = scenario_of(case, margin_m)
        found = certify(whole, whole.phases[0], case.trajectory, tubes=files.tubes)
        write_claims(folder / "certificate.json", claims_of([found], ""))
        return files

    def agree(self, margin_m: float) -> tuple[bool, bool]:
        """Whether the margin is proven, by the checker and by the check of ``berthing verify``."""
        document = document_of(self.case, margin_m)
        sha = document_sha256(document)
        path = self.folder / "certificate.json"
        proof = json.loads(path.read_text(encoding="utf-8"))
        path.write_text(json.dumps({**proof, "scenario_sha256": sha}), encoding="utf-8")
        record = json.dumps({"scenario": document})
        (self.folder / "plan.json").write_text(record, encoding="utf-8")
        write_interpolant(self.folder / "interpolant.json", [self.case.trajectory], sha)
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                CHECK(str(self.folder))
            small = True
        except REFUSALS:
            small = False
        whole = scenario_of(self.case, margin_m)
        claims = read_claims(path).phase("main")
        found = check_claims(whole, whole.phases[0], self.case.trajectory, claims, self.tubes)
        sound = all(v.verdict == CERTIFIED for v in found.verdicts)
        return small, sound and not found.notes

    def forge(self, how: str, rng: np.random.Generator) -> None:
        """Change one interval of the certificate."""
        path = self.folder / "certificate.json"
        proof = json.loads(path.read_text(encoding="utf-8"))
        rows = proof["phases"][0]["pairs"][0]["intervals"]
        i = int(rng.integers(len(rows)))
        if how == "an interval missing":
            del rows[i]
        elif how == "a bound raised":
            rows[i][2] += RAISED_M
        elif how == "a normal turned":
            normal = np.array(rows[i][3:6])
            across = np.cross(normal, rng.normal(size=3))
            rows[i][3:6] = (normal + TURNED_RAD * across / np.linalg.norm(across)).tolist()
        else:
            rows[i][0], rows[i][1] = rows[i][0] + 1e-3, rows[i][1] + 1e-3
        path.write_text(json.dumps(proof), encoding="utf-8")


FORGERIES = ("an interval missing", "a bound raised", "a normal turned", "an interval shifted")


def compared(seed: int) -> list[dict[str, Any]]:
    """One pass: what both say of its certificate, of a margin it violates, and of a forgery."""
    rng = np.random.default_rng([seed, 21])
    case, by = random_pass(rng, NEAREST_M), amount("clear", rng)
    with tempfile.TemporaryDirectory() as name:
        files = Files.write(case, Path(name), case.least_m - by)
        how = FORGERIES[seed % len(FORGERIES)]
        said = {
            "as it is": files.agree(case.least_m - by),
            "a margin violated": files.agree(case.least_m + MISSED_M),
        }
        files.forge(how, rng)
        said[how] = files.agree(case.least_m - by)
    rows = said.items()
    return [{"seed": seed, "what": w, "checker": bool(a), "verify": bool(b)} for w, (a, b) in rows]


def table(rows: list[dict[str, Any]]) -> str:
    """A line a kind."""
    lines = [
        "| certificate | count | both accept | both refuse | they differ |",
        "|---|---|---|---|---|",
    ]
    for what in ("as it is", "a margin violated", *FORGERIES):
        mine = Counter((row["checker"], row["verify"]) for row in rows if row["what"] == what)
        differ = mine[True, False] + mine[False, True]
        count = sum(mine.values())
        lines.append(f"| {what} | {count} | {mine[True, True]} | {mine[False, False]} | {differ} |")
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Compare on random passes and print the table.

    Returns:
        1 where they differ on what is not forged, or accept a violation. Of a forged bound one may
        prove enough that the other, with wider suprema, does not.
    """
    parser = argparse.ArgumentParser(prog="python -m benchmarks checker")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--count", type=int, default=300)
    options = parser.parse_args(arguments)
    rows = [row for seed in range(options.count) for row in compared(seed)]
    if options.json:
        lines = ",\n".join(json.dumps(row) for row in rows)
        options.json.write_text(f"[\n{lines}\n]\n", encoding="utf-8")
    print(table(rows))
    sure = [r for r in rows if r["what"] not in FORGERIES]
    wrong = [r for r in sure if r["checker"] != r["verify"]]
    wrong += [r for r in sure if r["what"] == "a margin violated" and r["checker"]]
    return int(bool(wrong))
