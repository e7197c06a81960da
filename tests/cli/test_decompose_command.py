import json

import numpy as np
import pytest

from support import solids
from support.robots import write_probe


@pytest.fixture(autouse=True)
def files(run, tmp_path, tmp_path_factory, monkeypatch):
    """A bracket, a box and a robot in the working folder, and a cache of the tests' own."""
    write_probe(tmp_path, "box.stl", tmp_path_factory, monkeypatch)
    solids.write_stl(tmp_path / "box.stl", solids.box((1, 2, 3)))
    return tmp_path


def test_a_mesh_becomes_a_folder(run, files):
    done = run("decompose", "l.obj", "--units", "m", "--density", "2700")
    assert done.exit_code == 0, done.stderr
    assert "contain the mesh" in done.stdout
    assert "20.736 kg" in done.stdout
    folder = files / "pieces" / "l"
    assert sorted(p.name for p in folder.iterdir()) == [
        "l-pieces.png", "l-protrusion.png", "pieces.json",
    ]  # fmt: skip
    content = json.loads((folder / "pieces.json").read_text())
    (part,) = content["parts"]
    assert part["mesh"] == "../../l.obj"
    assert part["certificate"]["uncovered_area_m2"] == 0.0
    for picture in folder.glob("*.png"):
        assert picture.read_bytes().startswith(b"\x89PNG")


def test_json_is_the_file_without_the_pieces(run):
    done = run("decompose", "box.stl", "--units", "mm", "--out", "out", "--json")
    said = json.loads(done.stdout)
    assert said["folder"] == "out"
    assert said["parts"][0]["certificate"]["volume_m3"] == pytest.approx(6e-9)
    assert "pieces" not in said["parts"][0]


def test_the_parts_are_those_of_a_scenario(run, files):
    """They may be copied as they are; the mesh is then not looked for."""
    from berthing.scenario.files import from_document
    from support import documents

    run("decompose", "probe.urdf", "--out", "out")
    parts = json.loads((files / "out" / "pieces.json").read_text())["parts"]
    document = dict(documents.scenario().document)
    document["structures"] = [{"name": "probe", "position_m": [5, 9, 0], "parts": parts}]
    (structure,) = from_document(document).structures
    assert [part.name for part in structure.body.parts] == ["bus", "hand"]


def test_a_check_holds_until_something_is_changed(run, files):
    run("decompose", "l.obj", "--units", "m", "--out", "out")
    pieces = files / "out" / "pieces.json"
    assert run("decompose", "l.obj", "--check", str(pieces)).exit_code == 0
    content = json.loads(pieces.read_text())
    del content["parts"][0]["pieces"][0]
    pieces.write_text(json.dumps(content))
    done = run("decompose", "l.obj", "--check", str(pieces))
    assert done.exit_code == 4
    assert "DOES NOT HOLD" in done.stdout
    said = json.loads(run("decompose", "l.obj", "--check", str(pieces), "--json").stdout)
    assert said["holds"] is False
    assert "seal" in said["faults"][0]


def test_a_robot_is_described_and_checked(run, files):
    done = run("decompose", "probe.urdf", "--joint", "wrist=0.5", "--out", "out")
    assert done.exit_code == 0, done.stderr
    assert "8 kg" in done.stdout
    pieces = files / "out" / "pieces.json"
    content = json.loads(pieces.read_text())
    assert [part["name"] for part in content["parts"]] == ["bus", "hand"]
    assert run("decompose", "probe.urdf", "--check", str(pieces)).exit_code == 0
    content["parts"][0]["position_m"][0] += 0.1
    pieces.write_text(json.dumps(content))
    done = run("decompose", "probe.urdf", "--check", str(pieces))
    assert done.exit_code == 4
    assert "in their places" in done.stdout


BAD = {
    "units": (("l.obj",), "does not say its units"),
    "unknown units": (("l.obj", "--units", "yd"), "is 'yd'"),
    "missing": (("absent.stl", "--units", "m"), "does not exist"),
    "suffix": (("l.step",), "STL, OBJ, PLY, GLB, URDF"),
    "ratio": (("l.obj", "--units", "m", "--volume-ratio", "1"), "volume_ratio: is 1"),
    "density": (("l.obj", "--units", "m", "--density", "0"), "--density: is 0"),
    "joint": (("l.obj", "--units", "m", "--joint", "a=1"), "--joint: says nothing"),
    "joint form": (("probe.urdf", "--joint", "a"), "NAME=POSITION"),
    "joint name": (("probe.urdf", "--joint", "a=1"), "no joint 'a'"),
    "robot units": (("probe.urdf", "--units", "m"), "says nothing of a URDF"),
    "robot density": (("probe.urdf", "--density", "3"), "says nothing of a URDF"),
    "check": (("l.obj", "--check", "absent.json"), "is missing"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_exits_2_with_one_line_and_nothing_written(run, files, case):
    words, says = BAD[case]
    before = sorted(files.rglob("*"))
    done = run("decompose", *words)
    assert done.exit_code == 2
    assert says in done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stdout == ""
    assert sorted(files.rglob("*")) == before


L = solids.l_bracket()
NO_SOLIDS = {
    "hole": (L[1:], "watertight"),
    "turned over": (np.concatenate([L[:1, ::-1], L[1:]]), "turned over"),
    "inside out": (L[:, ::-1], "inside out"),
    "flat": (L * [1, 1, 0], "encloses no volume"),
    "crossing": (np.concatenate([L, solids.moved(L, 0.2, 0.03, 0.1)]), "crosses itself"),
    "no triangles": (L[:0], "no triangles"),
}


@pytest.mark.parametrize("case", NO_SOLIDS)
def test_what_is_no_solid_exits_2_with_one_line_and_nothing_written(run, files, case):
    corners, says = NO_SOLIDS[case]
    solids.write_stl(files / "bad.stl", corners)
    before = sorted(files.rglob("*"))
    done = run("decompose", "bad.stl", "--units", "m")
    assert done.exit_code == 2
    assert says in done.stderr
    assert done.stderr.count("\n") == 1
    assert sorted(files.rglob("*")) == before


@pytest.mark.slow
def test_a_million_triangles_exit_2_and_say_how_to_have_fewer(run, files):
    solids.write_stl(files / "fine.stl", solids.torus(1000, 501))
    before = sorted(files.rglob("*"))
    done = run("decompose", "fine.stl", "--units", "m")
    assert done.exit_code == 2
    assert "1,002,000 triangles" in done.stderr
    assert "Decimat" in done.stderr
    assert done.stderr.count("\n") == 1
    assert sorted(files.rglob("*")) == before


def test_a_robot_whose_mesh_is_missing_exits_2(run, files):
    (files / "box.stl").unlink()
    done = run("decompose", "probe.urdf")
    assert done.exit_code == 2
    assert "names a mesh that is missing: 'box.stl'" in done.stderr


def test_a_folder_in_use_needs_force(run, files):
    (files / "out").mkdir()
    (files / "out" / "mine.txt").write_text("mine")
    words = ("decompose", "box.stl", "--units", "m", "--out", "out")
    assert run(*words).exit_code == 2
    assert run(*words, "--force").exit_code == 0
    assert (files / "out" / "mine.txt").read_text() == "mine"
    assert run("decompose", "box.stl", "--units", "m", "--out", "l.obj").exit_code == 2


def test_help_has_examples(run):
    done = run("decompose", "--help")
    assert done.exit_code == 0
    assert "Examples" in done.stdout
