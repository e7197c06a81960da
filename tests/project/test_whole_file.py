"""A file is there whole, or what stood there stands as before."""

from __future__ import annotations

import pytest

from berthing.whole_file import write_whole


def test_it_replaces_what_stood_there(tmp_path):
    write_whole(tmp_path / "plan.md", "one")
    write_whole(tmp_path / "plan.md", "two × 2")
    assert (tmp_path / "plan.md").read_text(encoding="utf-8") == "two × 2"
    assert [p.name for p in tmp_path.iterdir()] == ["plan.md"]


def test_nothing_stays_behind_where_it_fails(tmp_path):
    (tmp_path / "plan.md").write_text("one")
    with pytest.raises(UnicodeEncodeError):
        write_whole(tmp_path / "plan.md", "two\ud800")
    assert (tmp_path / "plan.md").read_text() == "one"
    assert [p.name for p in tmp_path.iterdir()] == ["plan.md"]
    with pytest.raises(OSError, match="directory"):
        write_whole(tmp_path / "none" / "plan.md", "one")
