import csv
import json

import numpy as np
import pytest

import berthing as bt
from berthing.routes import seeking


def test_a_route_is_written_with_its_bounds(run, tmp_path):
    done = run("route", "scenario-b-tight", "--seed", "2")
    assert done.exit_code == 0, done.output
    assert "certified" in done.stdout
    folder = tmp_path / "routes" / "scenario-b-tight"
    assert sorted(p.name for p in folder.iterdir()) == ["route.csv", "route.json"]
    document = json.loads((folder / "route.json").read_text())
    (own,) = document["routes"]
    states = np.array([[state["spacecraft"]] for state in own["states"]])
    proven = bt.Checker(bt.from_document(document["scenario"], "route.json")).legs(states)
    assert proven.certified
    assert [leg["bound_m"] for leg in own["legs"]] == proven.bound_m.tolist()
    assert own["clearance_lower_bound_m"] == min(proven.bound_m)
    with (folder / "route.csv").open() as file:
        rows = list(csv.DictReader(file))
    read = [[float(row[c]) for c in ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")] for row in rows]
    assert read == states[:, 0].tolist()
    assert [row["bound_m"] for row in rows] == [*map(repr, proven.bound_m.tolist()), ""]


def test_a_way_past_nothing_is_straight_and_json_is_only_that(run):
    done = run("route", "free-space", "--json", "--classes", "2", "--out", "found")
    assert done.exit_code == 0, done.output
    said = json.loads(done.stdout)
    assert "scenario" not in said
    assert said["folder"] == "found"
    assert [len(own["states"]) for own in said["routes"]] == [2]
    assert said["routes"][0]["clearance_lower_bound_m"] is None


def test_a_folder_in_use_wants_force(run, tmp_path):
    assert run("route", "scenario-b").exit_code == 0
    again = run("route", "scenario-b")
    assert again.exit_code == 2
    assert "not empty" in again.stderr
    assert run("route", "scenario-b", "--force", "--seed", "1").exit_code == 0
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").touch()
    assert run("route", "scenario-b", "--force", "--out", "mine").exit_code == 2


def test_none_found_exits_3_and_says_what_was_tried(run, tmp_path, monkeypatch):
    monkeypatch.setattr(seeking, "LADDER", ((0, 1.0, 1),))
    done = run("route", "scenario-a", "--seed", "7")
    assert done.exit_code == 3
    (file,) = (tmp_path / "routes" / "scenario-a").iterdir()
    assert file.name == "failure.json"
    failure = json.loads(file.read_text())
    assert failure["outcome"] == "iteration_limit"
    assert failure["searches"][0]["found"] == "nothing"
    assert failure["options"]["seed"] == 7


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("scenario-z",), "scenario-z"),
        (("scenario-a", "--classes", "0"), "classes"),
        (("scenario-a", "--seed", "-1"), "--seed"),
        (("scenario-a", "--time-limit", "0"), "time_limit_s"),
    ],
)
def test_bad_usage_exits_2_and_writes_nothing(run, tmp_path, words, says):
    done = run("route", *words)
    assert done.exit_code == 2
    assert says in done.stderr
    assert not list(tmp_path.iterdir())


def test_an_interrupt_exits_130_and_writes_nothing(run, tmp_path, monkeypatch):
    def interrupted(*args, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr("berthing.commands.finding_routes.route", interrupted)
    done = run("route", "scenario-a")
    assert done.exit_code == 130
    assert not list(tmp_path.iterdir())


def test_a_shape_of_no_size_is_one_clear_error(run, tmp_path):
    flat = json.loads(json.dumps(bt.load("scenario-b").document))
    flat["phases"][0]["vehicles"][0]["parts"][0]["shape"]["size_m"] = [4, 0, 2]
    (tmp_path / "flat.json").write_text(json.dumps(flat))
    done = run("route", "flat.json")
    assert done.exit_code == 2
    assert "size_m" in done.stderr
    assert len(done.stderr.strip().splitlines()) <= 2


@pytest.mark.slow
@pytest.mark.parametrize("name", ["spinning-structure", "point-mass-2d"])
def test_figures_are_drawn_on_demand(run, tmp_path, name):
    done = run("route", name, "--figures", "--out", "drawn")
    assert done.exit_code == 0, done.output
    (figure,) = (tmp_path / "drawn" / "figures").iterdir()
    assert figure.name == "route-0.png"
    assert figure.read_bytes().startswith(b"\x89PNG")
    assert run("route", name, "--force", "--out", "drawn").exit_code == 0
    assert not (tmp_path / "drawn" / "figures").exists()
