import json
import shutil
import webbrowser
from pathlib import Path

import pytest

from berthing.report.folder import write_result
from berthing.scenario.files import load
from support import synthetic


@pytest.fixture(scope="module")
def template(tmp_path_factory):
    """The folder of a plan made by hand; not to be changed."""
    scenario = load("scenario-a")
    place = tmp_path_factory.mktemp("template") / "plan"
    write_result(scenario, synthetic.certified(scenario), scenario.solver, place)
    return place


@pytest.fixture
def folder(template, tmp_path):
    """Puts a copy of it at a name."""
    return lambda name: Path(shutil.copytree(template, tmp_path / name))


def test_a_folder_gets_its_page_anew(run, folder):
    place = folder("one")
    before = (place / "report.html").read_text()
    (place / "report.html").unlink()
    done = run("view", "one", "--no-open")
    assert (done.exit_code, done.stdout) == (0, "one/report.html\n")
    # Only the plan's name differs: the folder's instead of the scenario's.
    assert (place / "report.html").read_text() == before.replace(
        '"label":"scenario-a"', '"label":"one"'
    )
    assert run("view", "one", "--no-open").exit_code == 0


@pytest.mark.slow
def test_several_folders_are_compared_in_one_page(run, folder, tmp_path):
    folder("one")
    folder("two")
    done = run("view", "one", "two", "--no-open")
    assert (done.exit_code, done.stdout) == (0, "compare.html\n")
    text = (tmp_path / "compare.html").read_text()
    data = json.loads(text.split('id="data">')[1].split("</script>")[0])
    assert [plan["label"] for plan in data["plans"]] == ["one", "two"]
    assert run("view", "two", "one", "--no-open", "--out", "both.html").exit_code == 0
    assert (tmp_path / "both.html").exists()


def test_a_file_of_the_users_own_is_left_alone(run, folder, tmp_path):
    folder("one")
    (tmp_path / "mine.html").write_text("<html>mine")
    done = run("view", "one", "--out", "mine.html", "--no-open")
    assert done.exit_code == 2
    assert "is no page of berthing's" in done.stderr
    assert (tmp_path / "mine.html").read_text() == "<html>mine"


@pytest.mark.parametrize("out", ["one", "absent/page.html"])
def test_a_place_that_cannot_be_written_exits_2(run, folder, out):
    folder("one")
    done = run("view", "one", "--out", out, "--no-open")
    assert done.exit_code == 2
    assert out in done.stderr


def break_json(change):
    def broken(place):
        path = place / "plan.json"
        document = json.loads(path.read_text())
        change(document)
        path.write_text(json.dumps(document))

    return broken


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda d: d.update(outcome="perfect"), "outcome: is 'perfect'"),
        (lambda d: d.update(wall_time_s=3), "wall_time_s: is not"),
        (lambda d: d.update(attempts="many"), "attempts: is not"),
        (lambda d: d["verification"].pop("limits_ok"), "limits_ok: is missing"),
    ],
)
def test_a_folder_that_says_nonsense_exits_2(run, folder, change, message):
    break_json(change)(folder("one"))
    done = run("view", "one", "--no-open")
    assert done.exit_code == 2
    assert message in done.stderr


def test_what_is_no_plan_exits_2(run, tmp_path):
    (tmp_path / "empty").mkdir()
    for name in ("absent", "empty"):
        done = run("view", name)
        assert done.exit_code == 2
        assert name in done.stderr


def test_it_is_opened_where_there_is_a_display(run, folder, monkeypatch):
    folder("one")
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(name, raising=False)
    run("view", "one")
    assert opened == []
    monkeypatch.setenv("DISPLAY", ":0")
    run("view", "one", "--no-open")
    assert opened == []
    run("view", "one")
    (address,) = opened
    assert address.startswith("file:///")
    assert address.endswith("/one/report.html")
