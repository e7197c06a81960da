import json

import pytest

from berthing.result import Result
from support import synthetic

WHOLE_FOLDER = {
    "plan.json", "interpolant.json", "certificate.json", "trajectory.csv", "nodes.csv",
    "report.html", "figures",
}  # fmt: skip


def entries(folder):
    return {path.name for path in folder.iterdir()}


def interrupted(scenario):
    raise KeyboardInterrupt


@pytest.fixture
def no_pictures(monkeypatch):
    """Leaves out what takes most of the time of writing."""
    monkeypatch.setattr("berthing.report.folder.draw_figures", lambda *args: [])


def test_a_certified_plan_exits_0_and_is_written(run, answer, tmp_path):
    done = run("plan", "scenario-a")
    assert done.exit_code == 0, done.output
    assert entries(tmp_path / "plans") == {"scenario-a"}
    assert entries(tmp_path / "plans" / "scenario-a") == WHOLE_FOLDER
    figures = entries(tmp_path / "plans" / "scenario-a" / "figures")
    assert figures == {
        "trajectory.png", "states.png", "controls.png", "clearance.png", "hamiltonian.png"
    }  # fmt: skip
    assert "certified" in done.stdout
    assert "at least 0.10040 m" in done.stdout
    assert done.stderr == ""


@pytest.mark.usefixtures("no_pictures")
def test_a_plan_that_is_not_certified_exits_4_and_is_marked(run, answer, tmp_path):
    answer.answer = synthetic.not_certified
    done = run("plan", "scenario-a", "--out", "here")
    assert done.exit_code == 4
    assert "NOT certified" in done.stdout
    assert "short of 0.1 m by 0.08 m" in done.stdout
    assert "--nodes 80" in done.stdout
    assert json.loads((tmp_path / "here" / "plan.json").read_text())["outcome"] == "not_certified"
    page = (tmp_path / "here" / "report.html").read_text()
    assert "Not certified" in page


@pytest.mark.parametrize("outcome", ["locally_infeasible", "iteration_limit", "time_limit"])
def test_no_plan_exits_3_and_says_what_was_tried(run, answer, tmp_path, outcome):
    answer.answer = lambda scenario: synthetic.failed(scenario, outcome)
    done = run("plan", "scenario-a")
    assert done.exit_code == 3
    folder = tmp_path / "plans" / "scenario-a"
    assert entries(folder) == {"failure.json"}
    failure = json.loads((folder / "failure.json").read_text())
    assert failure["outcome"] == outcome
    assert failure["attempts"][0]["guess"] == "straight"
    assert failure["advice"]
    assert "separation[a, b] short by 1 m" in done.stdout
    assert "another --seed" in done.stdout


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["scenario-z"], "did you mean"),
        (["absent.yaml"], "is no file"),
        (["scenario-a", "--nodes", "1"], "nodes: is 1"),
        (["scenario-a", "--seed", "-1"], "seed: is -1"),
        (["scenario-a", "--time-limit", "0"], "time_limit_s: is 0"),
        (["scenario-a", "--time-limit", "nan"], "time_limit_s: is nan"),
        (["scenario-a", "--effort", "lazy"], "effort: is 'lazy'"),
    ],
)
def test_bad_input_exits_2_with_one_line_and_writes_nothing(run, answer, tmp_path, words, message):
    done = run("plan", *words)
    assert done.exit_code == 2
    assert message in done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stdout == ""
    assert entries(tmp_path) == set()
    assert answer.calls == 0


@pytest.mark.parametrize(
    "words", [[], ["scenario-a", "--nodes", "many"], ["scenario-a", "--colour"], ["a", "b"]]
)
def test_bad_usage_exits_2(run, answer, tmp_path, words):
    done = run("plan", *words)
    assert done.exit_code == 2
    assert entries(tmp_path) == set()


def test_bad_input_found_while_planning_exits_2_and_writes_nothing(run, answer, tmp_path):
    from berthing.errors import InputError

    def refuse(scenario):
        raise InputError("start", "is 0.02 m from T1.plate", "at least 0.1 m")

    answer.answer = refuse
    done = run("plan", "scenario-a")
    assert (done.exit_code, entries(tmp_path)) == (2, set())
    assert "start: is 0.02 m from T1.plate (expected at least 0.1 m)" in done.stderr


@pytest.mark.parametrize("answered", [interrupted, lambda s: Result("interrupted", None, None)])
def test_an_interrupt_exits_130_and_leaves_nothing(run, answer, tmp_path, answered):
    answer.answer = answered
    done = run("plan", "scenario-a")
    assert done.exit_code == 130
    assert entries(tmp_path) == set()


def test_an_interrupt_while_writing_leaves_nothing(run, answer, tmp_path, monkeypatch):
    monkeypatch.setattr("berthing.report.folder.draw_figures", lambda *args: interrupted(args))
    done = run("plan", "scenario-a")
    assert done.exit_code == 130
    assert entries(tmp_path) == set()


def test_a_full_disk_is_one_message(run, answer, tmp_path, monkeypatch):
    def full(*args):
        raise OSError(28, "No space left on device", "figures/states.png")

    monkeypatch.setattr("berthing.report.folder.draw_figures", full)
    done = run("plan", "scenario-a")
    assert done.exit_code == 2
    assert "cannot be written: No space left on device" in done.stderr
    assert entries(tmp_path) == set()


def test_a_folder_in_use_is_refused_before_any_work(run, answer, tmp_path):
    (tmp_path / "here").mkdir()
    (tmp_path / "here" / "notes.txt").write_text("mine")
    for words in ([], ["--force"]):
        done = run("plan", "scenario-a", "--out", "here", *words)
        assert done.exit_code == 2
        assert answer.calls == 0
    assert (tmp_path / "here" / "notes.txt").read_text() == "mine"


@pytest.mark.usefixtures("no_pictures")
def test_force_replaces_an_older_plan(run, answer, tmp_path):
    answer.answer = synthetic.failed
    assert run("plan", "scenario-a").exit_code == 3
    assert run("plan", "scenario-a").exit_code == 2
    answer.answer = synthetic.certified
    assert run("plan", "scenario-a", "--force").exit_code == 0
    assert "failure.json" not in entries(tmp_path / "plans" / "scenario-a")


@pytest.mark.usefixtures("no_pictures")
def test_json_is_the_summary_and_nothing_else(run, answer, tmp_path):
    done = run("plan", "scenario-a", "--json", "--seed", "7")
    said = json.loads(done.stdout)
    written = json.loads((tmp_path / "plans" / "scenario-a" / "plan.json").read_text())
    assert said.pop("folder") == "plans/scenario-a"
    written.pop("scenario")
    assert said == written
    assert done.stderr == ""


def test_json_of_a_failure(run, answer):
    answer.answer = synthetic.failed
    done = run("plan", "scenario-a", "--json")
    assert done.exit_code == 3
    assert json.loads(done.stdout)["outcome"] == "locally_infeasible"


@pytest.mark.usefixtures("no_pictures")
def test_the_command_line_wins_over_the_file(run, answer, tmp_path):
    from berthing.scenario.library import case_path

    text = case_path("scenario-a").read_text() + "solver: {nodes: 30, seed: 5}\n"
    (tmp_path / "mine.yaml").write_text(text)
    words = ["--seed", "9", "--formulation", "dual", "--scheme", "lgl", "--time-limit", "8"]
    assert run("plan", "mine.yaml", *words).exit_code == 0
    chosen = answer.options
    assert (chosen.nodes, chosen.seed) == (30, 9)
    assert (chosen.formulation, chosen.scheme, chosen.time_limit_s) == ("dual", "lgl", 8.0)
