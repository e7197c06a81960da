"""Meshes and robots in scenario files: pieces, masses, and a document that stands alone."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.pose import Pose
from berthing.mesh import cache
from berthing.mesh.certificate import SEAL, seal
from berthing.mesh.mass import of_solid
from berthing.mesh.recheck import faults
from berthing.scenario.files import from_document, load
from berthing.scenario.normal import document_sha256
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from support import solids
from support.robots import write_probe

Document = dict[str, Any]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, tmp_path_factory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a bracket, a block and a robot."""
    write_probe(tmp_path, "l.obj", tmp_path_factory, monkeypatch)
    solids.write_stl(tmp_path / "block.stl", solids.box((500, 500, 500)))
    return tmp_path


@pytest.fixture
def meshes(document: Document) -> Document:
    """The bracket flies past the block."""
    vehicle, block = document["vehicles"][0], document["structures"][0]
    vehicle["parts"] = [{"name": "l", "mesh": "l.obj", "units": "m", "position_m": [0, 0, 1]}]
    vehicle["dynamics"] = {"model": "rigid-body", "density_kg_m3": 2700}
    vehicle["goal"]["position_m"] = [1, 0, 0]
    del vehicle["limits"]
    block["parts"] = [{"name": "core", "mesh": "block.stl", "units": "mm"}]
    return document


@pytest.fixture
def loaded(folder: Path):
    """The scenario of a document, read from a file in the folder."""

    def from_file(document: Document) -> Scenario:
        path = folder / "case.json"
        path.write_text(json.dumps(document), encoding="utf-8")
        return load(path)

    return from_file


def test_pieces_become_parts(meshes, loaded):
    scenario = loaded(meshes)
    (vehicle,), (block,) = scenario.phases[0].vehicles, scenario.structures
    assert [part.name for part in vehicle.body.parts] == ["l.1", "l.2"]
    assert [part.name for part in block.body.parts] == ["core"]
    points = solids.moved(solids.samples(solids.l_bracket(), 500), 0, 0, 1)
    levels = [p.shape.level(p.placement.inverse().apply(points)) for p in vehicle.body.parts]
    assert np.max(np.min(levels, axis=0)) < 0.0
    assert block.body.bounding_radius == pytest.approx(0.25 * np.sqrt(3), rel=1e-5)


def test_masses_follow_from_a_density(meshes, loaded):
    model = loaded(meshes).phases[0].vehicles[0].model
    assert isinstance(model, RigidBody)
    solid = solids.solid(solids.l_bracket())
    wanted = of_solid(solid, 2700).seen_from(Pose(np.array([0.0, 0, 1]), np.eye(3)))
    assert model.mass_kg == pytest.approx(wanted.mass_kg)
    np.testing.assert_allclose(model.first_moment_kg_m, wanted.first_moment_kg_m)
    np.testing.assert_allclose(model.inertia_kg_m2, wanted.inertia_kg_m2)


def test_a_mass_alone_is_spread_evenly(meshes, loaded):
    by_density = loaded(meshes).phases[0].vehicles[0].model
    meshes["vehicles"][0]["dynamics"] = {"model": "rigid-body", "mass_kg": 3}
    model = loaded(meshes).phases[0].vehicles[0].model
    assert model.mass_kg == pytest.approx(3.0)
    scale = 3.0 / by_density.mass_kg
    np.testing.assert_allclose(model.inertia_kg_m2, scale * by_density.inertia_kg_m2)


def test_masses_that_are_given_stay(meshes, loaded):
    given = {"model": "rigid-body", "mass_kg": 7, "inertia_kg_m2": [9, 9, 9]}
    meshes["vehicles"][0]["dynamics"] = given
    model = loaded(meshes).phases[0].vehicles[0].model
    assert model.mass_kg == 7
    np.testing.assert_array_equal(model.first_moment_kg_m, np.zeros(3))


def test_the_document_stands_alone(meshes, loaded, folder, monkeypatch):
    scenario = loaded(meshes)
    text = json.dumps(scenario.document)
    for path in folder.iterdir():
        if path.is_file():
            path.unlink()
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(folder / "nothing"))
    again = from_document(json.loads(text))
    assert again.document == scenario.document
    part = scenario.document["phases"][0]["vehicles"][0]["parts"][0]
    assert len(part["certificate"]["mesh_sha256"]) == 64
    assert {piece["shape"]["type"] for piece in part["pieces"]} <= {"box", "polytope", "cylinder"}


def test_the_pieces_in_a_document_can_be_proven_again(meshes, loaded, folder):
    scenario = loaded(meshes)
    for part, mesh in (
        (scenario.document["phases"][0]["vehicles"][0]["parts"][0], "l.obj"),
        (scenario.document["structures"][0]["parts"][0], "block.stl"),
    ):
        assert faults(part, folder / mesh) == []


def test_from_the_cache_the_document_is_the_same(meshes, loaded):
    assert document_sha256(loaded(meshes).document) == document_sha256(loaded(meshes).document)


def test_pieces_of_every_kind_are_kept_to_the_last_digit(meshes, loaded, folder):
    """Struts at odd angles."""
    nodes = np.array([[0, 0, 0], [0.9, 0.2, 0.3], [1.0, 1.1, 0.2]])
    solids.write_obj(folder / "wire.obj", solids.wire(nodes, [(0, 1), (1, 2)], 0.02, 12))
    meshes["structures"][0]["parts"].append({"name": "wire", "mesh": "wire.obj", "units": "m"})
    scenario = loaded(meshes)
    part = scenario.document["structures"][0]["parts"][1]
    assert len(part["pieces"]) >= 2
    assert faults(part, folder / "wire.obj") == []
    assert from_document(scenario.document).document == scenario.document


@pytest.mark.parametrize("selector", ["spacecraft.l", "spacecraft.l.2", "spacecraft"])
def test_margins_speak_of_a_mesh_or_of_a_piece(meshes, loaded, selector):
    override = {"between": [selector, "block.core"], "margin_m": 0.02}
    meshes["margins"]["overrides"] = [override]
    policy = loaded(meshes).margins
    assert policy.margin("spacecraft.l.2", "block.core", 0.0) == 0.02
    assert policy.margin("block.core", "spacecraft.l.1", 0.0) == (
        0.1 if selector.endswith("2") else 0.02
    )
    meshes["margins"]["overrides"][0]["between"][0] = "spacecraft.m"
    with pytest.raises(InputError, match=r"spacecraft\.m"):
        loaded(meshes)


def test_a_robot_gives_its_links_and_its_mass(meshes, loaded):
    vehicle = meshes["vehicles"][0]
    del vehicle["parts"]
    vehicle["urdf"] = {"file": "probe.urdf", "joints": {"wrist": 0.5}}
    vehicle["dynamics"] = {"model": "rigid-body"}
    scenario = loaded(meshes)
    (found,) = scenario.phases[0].vehicles
    assert [part.name for part in found.body.parts] == ["bus", "hand.1", "hand.2"]
    assert found.model.mass_kg == 8.0
    np.testing.assert_array_equal(found.model.inertia_kg_m2, np.eye(3))
    block = scenario.document["phases"][0]["vehicles"][0]
    assert len(block["urdf"]["sha256"]) == 64
    assert block["parts"][1]["mesh"] == "l.obj"
    assert from_document(scenario.document).document == scenario.document


def test_a_robot_named_by_its_path_alone(meshes, loaded):
    meshes["structures"][0]["urdf"] = "probe.urdf"
    del meshes["structures"][0]["parts"]
    names = [part.name for part in loaded(meshes).structures[0].body.parts]
    assert names == ["bus", "hand.1", "hand.2"]


def test_a_robot_with_a_tool(meshes, loaded):
    """The robot weighs what its description says, the tool what its volume does."""
    meshes["vehicles"][0]["urdf"] = "probe.urdf"
    model = loaded(meshes).phases[0].vehicles[0].model
    assert model.mass_kg == pytest.approx(8 + 2700 * 0.00768)


def edit(path: str, value: Any):
    def change(document: Document) -> None:
        here: Any = document
        *way, last = [int(k) if k.isdigit() else k for k in path.split("/")]
        for key in way:
            here = here[key]
        here[last] = value

    return change


BOX = {"name": "box", "shape": {"type": "box", "size_m": [1, 1, 1]}}
PART, VEHICLE = "vehicles/0/parts/0", "vehicles/0"
BAD = {
    "no units": (edit(f"{PART}/units", None), "parts[0].mesh: does not say its units"),
    "units": (edit(f"{PART}/units", "parsec"), "units: is 'parsec'"),
    "both": (edit(f"{PART}/scale_m", [1, 1, 1]), "has both units and scale_m"),
    "missing": (edit(f"{PART}/mesh", "m.obj"), "parts[0].mesh: does not exist"),
    "suffix": (edit(f"{PART}/mesh", "probe.urdf"), "parts[0].mesh: has the suffix '.urdf'"),
    "ratio": (edit(f"{PART}/volume_ratio", 1.0), "volume_ratio: is 1.0"),
    "pieces": (edit(f"{PART}/pieces", []), "needs pieces and certificate together"),
    "key": (edit(f"{PART}/unit", "m"), "unit: is not a known key; did you mean units?"),
    "two masses": (edit(f"{VEHICLE}/dynamics/mass_kg", 3), "stands beside mass_kg"),
    "no mass": (edit(f"{VEHICLE}/dynamics", {"model": "rigid-body"}), "mass_kg: is missing"),
    "shape": (edit(f"{VEHICLE}/parts", [BOX]), "says nothing of the part 'box'"),
    "no parts": (edit(f"{VEHICLE}/parts", None), "vehicles[0].parts: is missing"),
    "robot": (edit(f"{VEHICLE}/urdf", "r.urdf"), "urdf: does not exist"),
    "joint": (
        edit(f"{VEHICLE}/urdf", {"file": "probe.urdf", "joints": {"elbow": 1}}),
        "no joint 'elbow'",
    ),
    "twice": (edit(f"{VEHICLE}/parts/0/name", "bus"), None),
}


@pytest.mark.parametrize("case", BAD)
def test_a_bad_mesh_is_told_where_it_stands(meshes, loaded, case):
    change, says = BAD[case]
    change(meshes)
    if says is None:
        meshes["vehicles"][0]["urdf"] = "probe.urdf"
        says = "is 'bus', as is that of entry 0"
    with pytest.raises(InputError) as caught:
        loaded(meshes)
    message = str(caught.value)
    assert "case.json: " in message
    assert says in message


def test_a_mesh_that_is_no_solid_is_told_with_advice(meshes, loaded, folder):
    solids.write_obj(folder / "l.obj", solids.l_bracket()[1:])
    with pytest.raises(InputError, match=r"parts\[0\]\.mesh: is not closed.*watertight"):
        loaded(meshes)


def test_meshes_have_no_place_in_the_plane(planar, loaded):
    planar["structures"][0]["parts"] = [{"name": "l", "mesh": "l.obj", "units": "m"}]
    with pytest.raises(InputError, match="is a mesh in a scenario of 2 dimensions"):
        loaded(planar)
    planar["structures"][0] = {"name": "wall", "urdf": "probe.urdf"}
    with pytest.raises(InputError, match="is a robot in a scenario of 2 dimensions"):
        loaded(planar)


@pytest.mark.parametrize("what", ["piece", "certificate"])
def test_an_edited_document_is_refused(meshes, loaded, what):
    document = copy.deepcopy(dict(loaded(meshes).document))
    part = document["structures"][0]["parts"][0]
    if what == "piece":
        part["pieces"][0]["shape"]["size_m"][0] -= 1e-3
    else:
        part["certificate"]["push_m"] = 0.0
    with pytest.raises(InputError, match=r"parts\[0\]\.certificate: does not fit its seal"):
        from_document(document)


def test_pieces_that_contradict_their_certificate_are_refused_with_a_new_seal_too(meshes, loaded):
    """The mesh may be gone, but its volume stands in the certificate."""
    document = copy.deepcopy(dict(loaded(meshes).document))
    part = document["structures"][0]["parts"][0]
    part["pieces"][0]["shape"]["size_m"] = [s - 2e-3 for s in part["pieces"][0]["shape"]["size_m"]]
    said = {k: v for k, v in part["certificate"].items() if k != SEAL}
    part["certificate"][SEAL] = seal(said, part["pieces"])
    with pytest.raises(InputError, match=r"parts\[0\]\.certificate: does not fit .*volume_ratio"):
        from_document(document)
