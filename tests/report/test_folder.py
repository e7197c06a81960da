import json
import math
from dataclasses import replace

import pytest

from berthing.report.folder import write_result
from berthing.report.offline.page import shown_page
from berthing.report.offline.shown import shown_folder
from berthing.report.plan_json import to_text
from berthing.report.verdict_table import attempt_line, result_rows
from berthing.result import OUTCOMES, Attempt
from berthing.scenario.files import from_document, load
from berthing.verify.folder import read_plan, verify_folder
from support import synthetic

PLAN_KEYS = {
    "schema_version", "scenario", "outcome", "formulation", "scheme", "cost", "nodes",
    "iterations", "seed", "wall_time_s", "verification", "versions",
}  # fmt: skip
VERIFICATION_KEYS = {
    "clearance_lower_bound_m", "required_clearance_m", "backoff_m", "closest_pair",
    "closest_time_s", "replay_position_error_m", "replay_attitude_error_rad",
    "hamiltonian_relative_drift", "limits_ok", "model_check", "certified",
}  # fmt: skip


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The folder of a plan of scenario-a, made by hand, and what was returned."""
    scenario = load("scenario-a")
    folder = tmp_path_factory.mktemp("plans") / "scenario-a"
    return folder, write_result(scenario, synthetic.certified(scenario), scenario.solver, folder)


def test_plan_json_has_every_field(written):
    folder, returned = written
    document = json.loads((folder / "plan.json").read_text())
    assert document == json.loads(to_text(returned))
    assert set(document) >= PLAN_KEYS
    assert set(document["verification"]) >= VERIFICATION_KEYS
    assert document["outcome"] in OUTCOMES
    assert document["wall_time_s"]["total"] > 1.5
    assert document["versions"]["casadi"] != "absent"
    assert from_document(document["scenario"]).name == "scenario-a"


def test_the_folder_can_be_checked_from_its_files_alone(written):
    folder, _ = written
    scenario, plan = read_plan(folder)
    assert scenario.name == "scenario-a"
    assert plan.cost == synthetic.plan(scenario).cost
    # The plan is a bad one and nothing of it is proven, but its files agree with each other.
    reasons = [r for r in verify_folder(folder).reasons if "is not proven" not in r]
    assert reasons
    assert not [r for r in reasons if ".csv" in r or ".json" in r or "nodes" in r]


def test_the_page_has_the_times_that_plan_json_has(written):
    folder, returned = written
    text = (folder / "report.html").read_text()
    for name, seconds in returned["wall_time_s"].items():
        assert f'<th scope="row">{name}</th><td class="number">{seconds:.2f} s</td>' in text


def test_the_page_made_again_from_the_folder_is_the_same(written):
    folder, _ = written
    again = shown_page([shown_folder(folder, "scenario-a")])
    assert again == (folder / "report.html").read_text()


def test_json_has_null_for_what_is_not_finite():
    document = {"a": [math.inf, 1.0, {"b": math.nan}], "c": (-math.inf,), "d": "inf"}
    assert json.loads(to_text(document)) == {"a": [None, 1.0, {"b": None}], "c": [None], "d": "inf"}


def row(rows, label):
    return next(r for r in rows if r.label == label)


def test_the_table_judges_each_check():
    of = synthetic.scenario()
    good = result_rows(of, synthetic.certified(of))
    assert row(good, "verdict").value == "certified"
    assert not [r for r in good if r.good is False]
    bad = result_rows(of, synthetic.not_certified(of))
    assert row(bad, "verdict").value == "NOT certified"
    assert row(bad, "clearance at every instant").good is False
    assert "short of 0.1 m" in row(bad, "because").value


def test_the_table_says_when_limits_are_exceeded():
    of = synthetic.scenario()
    result = synthetic.certified(of)
    over = replace(result, verification=replace(result.verification, limits_ok=False))
    assert row(result_rows(of, over), "limits between nodes").good is False


def test_the_table_of_nothing_to_keep_clear_of():
    of = synthetic.scenario(structures=())
    rows = result_rows(of, synthetic.certified(of))
    assert row(rows, "clearance at every instant").value == "nothing to keep clear of"
    assert row(rows, "clearance at every instant").good is True


def test_the_table_of_a_failure_lists_attempts_and_advice():
    of = synthetic.scenario()
    rows = result_rows(of, synthetic.failed(of))
    assert row(rows, "verdict").value == "no plan found: locally infeasible"
    assert sum(r.label == "tried" for r in rows) == 2
    assert row(rows, "try next").value


def test_an_attempt_is_one_line_with_its_note():
    line = attempt_line(Attempt("straight", "time_limit", 40, 3, 1.0, note="row x"))
    assert line == "straight: time limit after 3 iterations, 1.0 s; row x"
