"""Files that are no scenario: malformed text, unknown names."""

from __future__ import annotations

from pathlib import Path

import pytest

from berthing.errors import InputError
from berthing.scenario.files import load
from berthing.scenario.library import CASES as LIBRARY

# Text that never becomes a document, and what is said of it.
TEXTS = [
    (
        "bad.yaml",
        "schema_version: 1\nname: [a\nhorizon: 3\n",
        "bad.yaml:3: is not well-formed YAML",
    ),
    ("bad.yaml", "a: 1\na: 2\n", 'bad.yaml:2: is not well-formed YAML: found duplicate key "a"'),
    ("bad.yaml", "a: !python/object:os.system x\n", "bad.yaml:1: is not well-formed YAML"),
    ("bad.yaml", "a: 1\n---\nb: 2\n", "is not well-formed YAML"),
    ("bad.yaml", "", "bad.yaml: is empty"),
    ("bad.yaml", "a: \x01\n", "is not well-formed YAML"),
    ("bad.yaml", "a: &x [*x]\nname: 3", "is not a known key"),
    ("bad.yaml", "[" * 1000, "nests too deeply"),
    ("bad.json", '{"a": 1,\n "b" 2}', "bad.json:2: is not well-formed JSON"),
    ("bad.json", '{"a": NaN}', "NaN is not a number"),
    ("bad.json", '{"a": 1, "a": 2}', "'a' stands twice"),
]


@pytest.mark.parametrize(("name", "text", "says"), TEXTS, ids=range(len(TEXTS)))
def test_malformed_text_names_file_and_line(
    tmp_path: Path, name: str, text: str, says: str
) -> None:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load(path)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_finding_in_yaml_names_its_line(tmp_path: Path) -> None:
    path = tmp_path / "case.yaml"
    text = (
        (LIBRARY / "scenario-a.yaml")
        .read_text(encoding="utf-8")
        .replace("{duration_s: 150}", "\n  # too short\n  {duration_s: -1}")
    )
    path.write_text(text, encoding="utf-8")
    line = text.splitlines().index("  {duration_s: -1}") + 1
    with pytest.raises(InputError, match=rf"case\.yaml:{line}: horizon\.duration_s: is -1"):
        load(path)


def test_text_that_is_not_utf8(tmp_path: Path) -> None:
    path = tmp_path / "case.yaml"
    path.write_bytes(b"name: \xff\xfe\n")
    with pytest.raises(InputError, match="not UTF-8 text at byte 6"):
        load(path)


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("scenari-a", "is not a scenario; did you mean scenario-a or"),
        ("Scenario-B-Tigth", "did you mean scenario-b-tight"),
        ("zzz", "expected a file, or one of: free-space, offset-mass-wrench"),
        ("cases/none.yaml", "is no file"),
        (".", "is a folder"),
        ("", "is a folder"),
        ("x" * 5000, "cannot be read"),
        ("x\0y", "is not a scenario"),
    ],
)
def test_unknown_scenarios_suggest_known_ones(name: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        load(name)
    assert says in str(caught.value)


def test_a_mistyped_file_suggests_its_neighbour(tmp_path: Path) -> None:
    (tmp_path / "mission.yaml").touch()
    with pytest.raises(InputError, match=r"did you mean .*mission\.yaml\?"):
        load(tmp_path / "mision.yaml")
