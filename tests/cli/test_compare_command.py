import json

import pytest

from berthing.comparison import Comparison, Trial
from berthing.scenario.files import load


@pytest.fixture
def compared(monkeypatch):
    """A comparison that finds what it is told."""
    trials = (
        Trial("plane", "straight", "solved", 40, 0.5, 0.0033, 1e-9, -0.07),
        Trial("plane", "turned", "solved", 60, 0.7, 0.0032, 2e-9, -0.05),
        Trial("plane", "random 1", "locally_infeasible", 90, 1.5),
        Trial("bounding-sphere", "straight", "locally_infeasible", 90, 1.5),
    )
    asked = {}

    def compare(scenario, formulations, **options):
        asked.update(options, scenario=scenario.name, formulations=formulations)
        why = {"dual": "`dual` cannot take Capsule"}
        names = ("plane", "bounding-sphere", "dual")
        return Comparison(scenario.name, 40, 3, trials, why, names)

    monkeypatch.setattr("berthing.commands.comparing.compare", compare)
    return asked


def test_it_prints_the_cheapest_and_what_lies_between_the_nodes(run, compared):
    done = run("compare", "scenario-b-tight", "--formulation", "plane", "--guesses", "2")
    assert done.exit_code == 0, done.output
    line = next(line for line in done.stdout.splitlines() if line.startswith("plane"))
    assert line.split() == ["plane", "2", "of", "3", "0.0032", "50", "0.60", "+0.0000", "-0.0500"]
    assert "0 of 1" in done.stdout
    assert "cannot take Capsule" in done.stdout
    assert compared["scenario"] == "scenario-b-tight"
    assert (compared["formulations"], compared["guesses"]) == (("plane",), 2)


def test_it_writes_what_it_prints(run, compared, tmp_path):
    done = run("compare", "scenario-a", "--out", "found.md", "--json")
    assert done.exit_code == 0, done.output
    said = json.loads(done.stdout)
    assert [s["solved"] for s in said["summaries"]] == [2, 0, 0]
    assert len(said["trials"]) == 4
    text = (tmp_path / "found.md").read_text()
    assert "| plane | 2 of 3 | 0.0032 |" in text
    assert "cannot take it" in text
    assert run("compare", "scenario-a", "--out", "found.json").exit_code == 0
    assert json.loads((tmp_path / "found.json").read_text()) == said
    assert sorted(p.name for p in tmp_path.iterdir()) == ["found.json", "found.md"]


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("scenario-z",), "scenario-z"),
        (("scenario-a", "--guesses", "0"), "--guesses"),
        (("scenario-a", "--time-limit", "0"), "--time-limit"),
        (("scenario-a", "--out", "found.txt"), ".json or .md"),
        (("scenario-a", "--out", "absent/found.md"), "is no folder"),
    ],
)
def test_bad_usage_exits_2_and_writes_nothing(run, compared, tmp_path, words, says):
    done = run("compare", *words)
    assert done.exit_code == 2
    assert says in done.stderr
    assert not list(tmp_path.iterdir())


def test_what_is_there_to_be_compared_with_makes_no_plan(run):
    done = run("plan", "scenario-a", "--formulation", "signed-distance-sequential")
    assert done.exit_code == 2
    assert "to be compared with only" in done.stderr
    assert load("scenario-a").solver.formulation == "plane"
