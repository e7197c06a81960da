"""The folder of a reproduction."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from typer.testing import CliRunner

from berthing.cli import app
from berthing.report.style import save
from berthing.reproduce.drawings import draw_error, draw_spacecraft
from berthing.reproduce.figures import LABELS, OF_A_PLAN, Drawn
from berthing.reproduce.finding import FAILS, HOLDS, MEASURED, PARTLY, Finding
from berthing.reproduce.writing import markdown

# Labels of the figures in the paper.
PAPER = {
    "robotic-sc", "trajA", "scenA-state", "scenA-controls", "lowhamA", "trajB", "scenB-state",
    "scenB-controls", "lowhamB", "err-analysis",
}  # fmt: skip


def test_every_figure_of_the_paper_has_one_of_ours() -> None:
    named = {label for labels in LABELS.values() for label in labels.values()}
    assert named | {"robotic-sc", "err-analysis"} == PAPER
    assert {key for labels in LABELS.values() for key in labels} == {k for k, _, _ in OF_A_PLAN}


@pytest.mark.parametrize("draw", [draw_error, draw_spacecraft])
def test_figures_without_a_plan(draw, tmp_path: Path) -> None:
    figure = draw()
    assert isinstance(figure, Figure)
    save(figure, tmp_path / "drawn.png")
    assert (tmp_path / "drawn.png").stat().st_size > 5000


def test_the_error_is_drawn_for_every_size_with_exponent_and_limit() -> None:
    left, right = draw_error().axes
    assert len(left.lines) == len(right.lines) + 1 >= 7
    assert left.get_xlabel() == "exponent [1/m]"


def test_the_table_says_what_was_found() -> None:
    findings = [Finding("here", "a | b", "1.0", FAILS, {"a": 1.0})]
    text = markdown(findings, [Drawn("trajA", "the way", "trajA.png")])
    assert "| here | a \\| b | 1.0 | does not hold |" in text
    assert "| [trajA](figures/trajA.png) | the way |" in text


def test_a_folder_with_something_in_it_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("kept")
    done = CliRunner().invoke(app, ["reproduce", "--out", str(tmp_path)])
    assert done.exit_code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]


@pytest.mark.slow
def test_the_whole(tmp_path: Path) -> None:
    folder = tmp_path / "again"
    done = CliRunner().invoke(app, ["reproduce", "--out", str(folder)])
    assert done.exit_code == 0, done.output
    document = json.loads((folder / "claims.json").read_text())
    assert {figure["label"] for figure in document["figures"]} == PAPER
    for figure in document["figures"]:
        assert (folder / "figures" / figure["file"]).stat().st_size > 5000
    found = {claim["claim"]: claim for claim in document["claims"]}
    assert {claim["verdict"] for claim in found.values()} == {HOLDS, PARTLY, FAILS, MEASURED}
    table = (folder / "claims.md").read_text()
    assert all(claim["found"].replace("|", "\\|") in table for claim in found.values())
    printed = next(c for c in found.values() if "never violated" in c["claim"])
    assert printed["verdict"] == FAILS
    assert 0.0081 <= printed["values"]["cost"] <= 0.0083
    assert printed["values"]["least_m"] < -0.1
    tight = next(c for c in found.values() if "tight environment" in c["claim"])
    assert tight["values"]["cost"] == pytest.approx(tight["values"]["cost_free"], rel=1e-6)
    for name, code in (("scenario-a", 0), ("scenario-b", 0), ("scenario-a-printed", 4)):
        checked = CliRunner().invoke(app, ["verify", str(folder / "plans" / name)])
        assert checked.exit_code == code, checked.output
