"""Files: formats, units, and what is no mesh at all."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.mesh.from_file import decomposed
from berthing.mesh.reading import read_surface
from berthing.mesh.units import METRES, metres_per
from berthing.scenario.schema.meshes import MeshPartBlock
from support import solids

L = solids.l_bracket()
VOLUME = 0.00768


@pytest.fixture
def exported(tmp_path):
    """The bracket in a format, as trimesh writes it."""
    import trimesh

    def write(suffix):
        path = tmp_path / f"l.{suffix}"
        corners = L.reshape(-1, 3)
        faces = np.arange(len(corners)).reshape(-1, 3)
        trimesh.Trimesh(corners, faces, process=False).export(path)
        return path

    return write


@pytest.mark.parametrize("suffix", ["stl", "obj", "ply", "glb"])
def test_every_format_gives_the_same_solid(exported, suffix):
    surface, scale = read_surface(exported(suffix), units=None if suffix == "glb" else "m")
    assert surface.volume == pytest.approx(VOLUME, rel=1e-6)
    assert len(surface.vertices) == 12
    assert scale == (1.0, 1.0, 1.0)


def test_the_suffix_may_be_in_capitals(exported, tmp_path):
    path = exported("stl").rename(tmp_path / "L.STL")
    assert read_surface(path, units="m")[0].volume == pytest.approx(VOLUME, rel=1e-6)


@pytest.mark.parametrize(("units", "metres"), METRES.items())
def test_units_are_applied(tmp_path, units, metres):
    path = solids.write_stl(tmp_path / "l.stl", L)
    assert read_surface(path, units=units)[0].volume == pytest.approx(VOLUME * metres**3, rel=1e-6)


def test_units_stated_for_a_glb_win(exported):
    surface, _ = read_surface(exported("glb"), units="mm")
    assert surface.volume == pytest.approx(VOLUME * 1e-9, rel=1e-6)


def test_nobody_guesses_units(tmp_path):
    path = solids.write_stl(tmp_path / "l.stl", 1000 * L)
    with pytest.raises(InputError, match=r"400 m if m, 0\.4 m if mm, 10\.16 m if in.*--units"):
        decomposed(path)


def test_unknown_units_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"is 'parsec'.*one of: m, dm"):
        decomposed(solids.write_stl(tmp_path / "l.stl", L), units="parsec")


def test_scenarios_know_the_same_units():
    for unit in METRES:
        MeshPartBlock.model_validate({"name": "l", "mesh": "l.stl", "units": unit})
        assert metres_per(unit, "here") == METRES[unit]
    (options,) = [
        option["enum"]
        for option in MeshPartBlock.model_json_schema()["properties"]["units"]["anyOf"]
        if "enum" in option
    ]
    assert options == list(METRES)


def test_a_mirrored_mesh_faces_outward(tmp_path):
    path = solids.write_obj(tmp_path / "l.obj", L)
    surface, _ = read_surface(path, scale=(-1.0, 1.0, 2.0))
    assert surface.volume == pytest.approx(2 * VOLUME)


def test_the_nodes_of_a_glb_are_placed(tmp_path):
    import trimesh

    scene = trimesh.Scene()
    for x in (0.0, 5.0):
        matrix = np.eye(4)
        matrix[0, 3] = x
        scene.add_geometry(trimesh.creation.box((1, 1, 1)), transform=matrix)
    scene.export(tmp_path / "two.glb")
    surface, _ = read_surface(tmp_path / "two.glb")
    assert surface.volume == pytest.approx(2.0)
    assert np.ptp(surface.vertices[:, 0]) == pytest.approx(6.0)


BROKEN = {
    "text.stl": b"solid nothing\n hello\n",
    "empty.stl": b"",
    "binary.stl": bytes(range(256)) * 3,
    "short.glb": b"glTF",
    "head.ply": b"ply\nwhatever\n",
    "index.obj": b"v 0 0 0\nf 1 2 3\n",
    "nan.obj": b"v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "points.obj": b"v 0 0 0\nv 1 0 0\n",
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_file_is_one_clear_message(tmp_path, name):
    path = tmp_path / name
    path.write_bytes(BROKEN[name])
    with pytest.raises(InputError) as caught:
        decomposed(path, units="m")
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)
    assert "module" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "says"),
    [("part.step", "STL, OBJ, PLY, GLB"), ("part", "no suffix"), ("absent.stl", "does not exist")],
)
def test_what_is_no_mesh_file_is_refused(tmp_path, name, says):
    if not name.startswith("absent"):
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(InputError, match=says):
        decomposed(tmp_path / name, units="m")


def test_a_folder_is_no_file(tmp_path):
    (tmp_path / "dir.stl").mkdir()
    with pytest.raises(InputError, match="not a file"):
        decomposed(tmp_path / "dir.stl", units="m")


def test_nothing_heavy_is_loaded_before_it_is_needed():
    import subprocess

    code = (
        "import sys, berthing.scenario.files, berthing.mesh.from_file; "
        "print([m for m in ('trimesh', 'coacd', 'casadi', 'coal', 'matplotlib') "
        "if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"
