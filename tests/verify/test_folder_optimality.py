"""Residuals of the conditions of optimality from the files of a folder alone."""

from __future__ import annotations

import csv
import json
import re
import shutil
from copy import deepcopy
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

from berthing.cli import app
from berthing.errors import InputError
from berthing.report.verdict_table import CONDITIONS
from berthing.scenario.files import from_document
from berthing.verify import extremal
from berthing.verify.folder import verify_folder
from support import hand_made

DURATION_S, DISTANCE_M = 100.0, 10.0


@pytest.fixture(scope="module")
def template(tmp_path_factory) -> Path:
    """A glide straight ahead, the best that there is, past a block far away."""
    document = deepcopy(hand_made.DOCUMENT)
    del document["vehicles"][0]["goal"]["attitude"]
    document["structures"][0]["position_m"] = [0, 50, 0]
    whole = from_document(document)
    own = whole.phases[0].vehicles[0]
    glide = hand_made.glide(own, (0, 0, 0), (DISTANCE_M, 0, 0), duration_s=DURATION_S)
    made = hand_made.plan([glide], [hand_made.glide_nodes(glide)])
    least = 12.0 * (hand_made.MASS * DISTANCE_M) ** 2 / DURATION_S**3
    folder = tmp_path_factory.mktemp("optimal") / "plan"
    hand_made.write_folder(folder, whole, replace(made, cost=least))
    return folder


@pytest.fixture
def folder(template: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(template, tmp_path / "plan"))


def change_column(folder: Path, name: str, change) -> None:
    lines = (folder / "nodes.csv").read_text(encoding="utf-8").splitlines()
    rows = list(csv.DictReader(lines))
    with (folder / "nodes.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows([{**row, name: change(row[name])} for row in rows])


def negated(cell: str) -> str:
    return repr(-float(cell))


def test_a_true_extremal_is_found_to_be_one(folder: Path) -> None:
    found = verify_folder(folder)
    assert found.certified
    assert found.optimality.worst < 1e-6
    assert found.hamiltonian_relative_drift < 1e-6
    assert "optimality" not in found.to_json()


@pytest.mark.parametrize(
    ("column", "residual"), [("costate_vx_m_s", "stationarity"), ("costate_x_m", "adjoint")]
)
def test_a_costate_with_its_sign_changed_fails_its_row(folder, column: str, residual: str) -> None:
    change_column(folder, column, negated)
    found = verify_folder(folder)
    assert found.certified
    assert found.optimality.residuals[residual] > 0.1
    shown = CliRunner().invoke(app, ["verify", str(folder)]).output
    assert re.search(r"Pontryagin extremal +not: worst is", shown)


def test_verify_prints_every_condition(folder: Path) -> None:
    done = CliRunner().invoke(app, ["verify", str(folder)])
    assert done.exit_code == 0
    for label in CONDITIONS.values():
        (line,) = [line for line in done.output.splitlines() if line.startswith(label + "  ")]
        assert "of the cost" in line
    document = json.loads(CliRunner().invoke(app, ["verify", str(folder), "--json"]).output)
    assert document["optimality"]["digits"] >= 6.0


def test_without_costates_nothing_is_said(folder: Path) -> None:
    change_column(folder, "costate_qw", lambda _: "")
    assert verify_folder(folder).optimality is None
    done = CliRunner().invoke(app, ["verify", str(folder), "--json"])
    assert done.exit_code == 0
    assert json.loads(done.output)["optimality"] is None


def with_rows(folder: Path, rows) -> None:
    path = folder / "plan.json"
    document = json.loads(path.read_text(encoding="utf-8"))
    document["optimality"] = {"separation_costates": rows}
    path.write_text(json.dumps(document), encoding="utf-8")


def pair_of(folder: Path) -> str:
    pair = json.loads((folder / "certificate.json").read_text(encoding="utf-8"))
    return pair["phases"][0]["pairs"][0]["pair"]


def test_forged_multipliers_make_it_worse(folder: Path) -> None:
    """A row that pulls where nothing is near, or with the wrong sign."""
    row = {"phase": "main", "pair": pair_of(folder), "time_s": 40.0, "jumps": {}}
    with_rows(folder, [{**row, "multiplier": 0.01}])
    assert verify_folder(folder).optimality.complementarity > 1.0
    with_rows(folder, [{**row, "multiplier": -0.01}])
    assert verify_folder(folder).optimality.dual > 1.0
    jump = {"craft": [0.01] + [0.0] * 12}
    with_rows(folder, [{**row, "multiplier": 0.0, "jumps": jump}])
    assert verify_folder(folder).optimality.adjoint > 1.0


@pytest.mark.parametrize("rows", [3, [3], [{}], {"a": 1}])
def test_what_cannot_be_read_is_refused(folder: Path, rows) -> None:
    with_rows(folder, rows)
    with pytest.raises(InputError):
        verify_folder(folder)


@pytest.mark.parametrize("cell", ["1e300", "-1e160", "1e-300"])
def test_absurd_costates_do_not_crash(folder: Path, cell: str) -> None:
    change_column(folder, "costate_qz", lambda _: cell)
    change_column(folder, "costate_x_m", lambda _: cell)
    found = verify_folder(folder)
    assert found.optimality is None or found.optimality.worst > 0.1


def test_more_nodes_than_a_mesh_has_are_left_alone(folder: Path, monkeypatch) -> None:
    monkeypatch.setattr(extremal, "MOST_NODES", 5)
    assert verify_folder(folder).optimality is None
