import os

import pytest

from berthing.errors import InputError
from berthing.report.fresh_folder import check_target, fresh_folder


def write_plan(target, text="{}", force=False):
    with fresh_folder(target, force=force) as folder:
        (folder / "plan.json").write_text(text)
        (folder / "figures").mkdir()
        (folder / "figures" / "states.png").write_bytes(b"png")


def everything_in(folder):
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*"))


def test_the_folder_appears_whole_with_its_parents(tmp_path):
    write_plan(tmp_path / "plans" / "deep" / "one")
    assert everything_in(tmp_path / "plans") == [
        "deep",
        "deep/one",
        "deep/one/figures",
        "deep/one/figures/states.png",
        "deep/one/plan.json",
    ]


def test_the_folder_is_as_readable_as_the_umask_says(tmp_path):
    mask = os.umask(0o022)
    try:
        write_plan(tmp_path / "one")
    finally:
        os.umask(mask)
    assert (tmp_path / "one").stat().st_mode & 0o777 == 0o755


@pytest.mark.parametrize("failure", [KeyboardInterrupt, OSError, SystemExit])
def test_an_interrupted_write_leaves_nothing(tmp_path, failure):
    def interrupted():
        with fresh_folder(tmp_path / "plans" / "one", force=False) as folder:
            (folder / "plan.json").write_text("{")
            raise failure

    with pytest.raises(failure):
        interrupted()
    assert everything_in(tmp_path) == []


def test_an_interrupted_replacement_leaves_the_old_folder(tmp_path):
    target = tmp_path / "one"
    write_plan(target, "old")

    def interrupted():
        with fresh_folder(target, force=True) as folder:
            (folder / "plan.json").write_text("new")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert everything_in(target) == ["figures", "figures/states.png", "plan.json"]
    assert os.listdir(tmp_path) == ["one"]
    assert (target / "plan.json").read_text() == "old"


def test_a_failed_rename_puts_the_old_folder_back(tmp_path, monkeypatch):
    target = tmp_path / "one"
    write_plan(target, "old")
    rename = type(target).rename

    def fails_for_the_new(path, to):
        if path.suffix == ".part":
            raise OSError("no")
        return rename(path, to)

    monkeypatch.setattr(type(target), "rename", fails_for_the_new)
    with pytest.raises(OSError, match="no"):
        write_plan(target, "new", force=True)
    assert (target / "plan.json").read_text() == "old"
    assert os.listdir(tmp_path) == ["one"]


def test_an_empty_folder_is_taken(tmp_path):
    target = tmp_path / "one"
    target.mkdir()
    write_plan(target)
    assert (target / "plan.json").exists()


def test_a_folder_with_something_in_it_is_refused(tmp_path):
    target = tmp_path / "one"
    write_plan(target, "old")
    with pytest.raises(InputError, match=r"is not empty.*--force"):
        check_target(target, force=False)


def test_force_replaces_a_plan_folder(tmp_path):
    target = tmp_path / "one"
    write_plan(target, "old")
    (target / "report.html").write_text("stale")
    write_plan(target, "new", force=True)
    assert (target / "plan.json").read_text() == "new"
    assert not (target / "report.html").exists()
    assert os.listdir(tmp_path) == ["one"]


@pytest.mark.parametrize(
    "stranger", ["notes.txt", ".git", "figures/mine.svg", "figures/old.png/x", "plan.json.bak"]
)
def test_force_never_deletes_files_of_the_users_own(tmp_path, stranger):
    target = tmp_path / "one"
    write_plan(target, "old")
    (target / stranger).parent.mkdir(parents=True, exist_ok=True)
    (target / stranger).write_text("mine")
    with pytest.raises(InputError, match="not of a plan"):
        write_plan(target, "new", force=True)
    assert (target / stranger).read_text() == "mine"
    assert (target / "plan.json").read_text() == "old"


def test_a_file_that_turns_up_while_planning_is_kept(tmp_path):
    target = tmp_path / "one"
    write_plan(target, "old")

    def slow():
        with fresh_folder(target, force=True):
            (target / "notes.txt").write_text("mine")

    with pytest.raises(InputError, match=r"notes\.txt"):
        slow()
    assert (target / "notes.txt").read_text() == "mine"


def test_force_leaves_a_folder_that_is_no_plan(tmp_path):
    (tmp_path / "trajectory.csv").write_text("mine")
    with pytest.raises(InputError, match="no plan folder"):
        check_target(tmp_path, force=True)


def test_a_file_in_the_way_is_refused(tmp_path):
    (tmp_path / "one").write_text("mine")
    with pytest.raises(InputError, match="is a file"):
        check_target(tmp_path / "one", force=True)
    with pytest.raises(InputError, match="which is a file"):
        check_target(tmp_path / "one" / "two", force=True)


def test_a_dangling_link_is_refused_and_a_link_to_a_folder_followed(tmp_path):
    link = tmp_path / "link"
    link.symlink_to(tmp_path / "absent")
    with pytest.raises(InputError, match="link to nothing"):
        check_target(link, force=False)
    (tmp_path / "absent").mkdir()
    write_plan(link)
    assert (tmp_path / "absent" / "plan.json").exists()
    assert link.is_symlink()


def test_a_read_only_place_is_refused(tmp_path, monkeypatch):
    # Asked through os.access, since the superuser may write to a folder of any mode.
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(InputError, match="cannot be written"):
        check_target(tmp_path / "plans" / "one", force=False)
