"""From solids to pieces with a certificate; and the certificate's check."""

from __future__ import annotations

import copy
import json

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.mesh import cache, coacd_run, from_file, optional
from berthing.mesh.certificate import SEAL, seal
from berthing.mesh.decompose import decompose
from berthing.mesh.decomposition import Decomposition
from berthing.mesh.from_file import decomposed
from berthing.mesh.mass import of_solid
from berthing.mesh.recheck import faults
from berthing.mesh.settings import DEFAULT, DecomposeSettings
from support import solids

# Shape, volume ratio allowed, and the push allowed in metres.
CASES = {
    "l": (solids.l_bracket, 1.05),
    "c": (solids.c_bracket, 1.05),
    "torus": (solids.torus, 1.15),
    "truss": (solids.truss, 1.45),
    "tube": (solids.tube, 1.25),
}
LARGEST_PUSH_M = 5e-4
slow = pytest.mark.slow


@pytest.fixture(scope="module")
def made(tmp_path_factory, pieces_cache):
    """A file of a shape, and its decomposition; each is made once."""
    folder = tmp_path_factory.mktemp("meshes")
    kept = {}

    def find(name):
        if name not in kept:
            path = solids.write_obj(folder / f"{name}.obj", CASES[name][0]())
            kept[name] = path, decomposed(path, units="m")
        return kept[name]

    return find


def parametrised():
    return pytest.mark.parametrize(
        "name", ["l", "c", *(pytest.param(n, marks=slow) for n in ("torus", "truss", "tube"))]
    )


@parametrised()
def test_the_certificate_keeps_what_was_asked(made, name):
    _, found = made(name)
    said = found.certificate
    assert said.push_m <= LARGEST_PUSH_M
    assert said.volume_ratio <= CASES[name][1]
    assert (said.uncovered_area_m2, said.voids) == (0.0, 0)
    assert said.pieces == len(found.pieces) == len(said.faces)
    solid = solids.solid(CASES[name][0]())
    assert said.volume_m3 == pytest.approx(solid.volume)
    assert said.triangles == len(solid.triangles)


@parametrised()
def test_a_hundred_thousand_points_of_the_surface_lie_inside(made, name):
    """By the shapes' own level functions, which the proof does not use."""
    points = solids.samples(CASES[name][0](), 100_000)
    _, found = made(name)
    levels = [p.shape.level(p.placement.inverse().apply(points)) for p in found.pieces]
    assert np.max(np.min(levels, axis=0)) < 0.0


@parametrised()
def test_the_proof_holds_again_from_the_files(made, name):
    path, found = made(name)
    assert faults(json.loads(json.dumps(found.to_json())), path) == []


@parametrised()
def test_a_piece_less_fails_sealed_again_or_not(made, name):
    path, found = made(name)
    for i in range(len(found.pieces)):
        block = copy.deepcopy(found.to_json())
        del block["pieces"][i]
        assert "seal" in faults(block, path)[0]
        (_, *_) = broken = faults(resealed(block), path)
        assert any("do not cover" in fault or "gaps" in fault for fault in broken), i
        if i == 2:  # the others are alike
            break


@parametrised()
def test_a_piece_smaller_by_a_millimetre_fails(made, name):
    path, found = made(name)
    block = copy.deepcopy(found.to_json())
    block["pieces"][0] = found.pieces[0].pushed(-1e-3).to_json()
    assert "seal" in faults(block, path)[0]
    assert any("do not cover" in fault for fault in faults(resealed(block), path))


EDITS = {
    "mesh_sha256": "0" * 64,
    "metres_per_unit": [0.001, 0.001, 0.001],
    "triangles": 21,
    "volume_m3": 0.0077,
    "centre_m": [0.0, 0.0, 0.0],
    "inertia_m5": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    "uncovered_area_m2": 1e-3,
    "volume_ratio": 1.0,
    "pieces": 1,
    "faces": [6],
}


@pytest.mark.parametrize("key", EDITS)
def test_an_edited_certificate_fails_even_with_a_new_seal(made, key):
    path, found = made("l")
    block = copy.deepcopy(found.to_json())
    block["certificate"][key] = EDITS[key]
    assert "seal" in faults(block, path)[0]
    assert faults(resealed(block), path) != []


@pytest.mark.parametrize("key", ["push_m", "threshold", "seed", "coacd"])
def test_what_was_done_cannot_be_edited_without_breaking_the_seal(made, key):
    path, found = made("l")
    block = copy.deepcopy(found.to_json())
    block["certificate"][key] = 7
    assert "seal" in faults(block, path)[0]


@pytest.mark.parametrize("change", ["drop", "add"])
def test_a_certificate_of_other_keys_is_none(made, change):
    path, found = made("l")
    block = copy.deepcopy(found.to_json())
    if change == "drop":
        del block["certificate"]["voids"]
    else:
        block["certificate"]["trust_me"] = True
    assert "keys of a certificate" in faults(block, path)[0]


@pytest.mark.parametrize(
    ("block", "says"),
    [
        ({}, "pieces"),
        ({"pieces": [], "certificate": 3}, "certificate"),
        ({"pieces": [3], "certificate": {}}, "pieces"),
    ],
)
def test_what_is_no_decomposition_is_a_fault(made, block, says):
    path, _ = made("l")
    assert says in faults(block, path)[0]


def test_another_file_is_a_fault(made, tmp_path):
    _, found = made("l")
    other = solids.write_obj(tmp_path / "other.obj", solids.c_bracket())
    assert "is not the file" in faults(found.to_json(), other)[0]


def resealed(block):
    said = {k: v for k, v in block["certificate"].items() if k != SEAL}
    block["certificate"][SEAL] = seal(said, block["pieces"])
    return block


def test_a_convex_solid_needs_no_cuts(monkeypatch):
    monkeypatch.setattr(coacd_run, "WORKER", "nowhere")
    cover = decompose(solids.solid(solids.box((1, 2, 3), (5, 5, 5))), DEFAULT)
    assert (len(cover.pieces), cover.threshold) == (1, 0.0)
    assert cover.volume == pytest.approx(6.0, rel=1e-5)


@slow
def test_a_hollow_is_covered_with_what_is_around_it():
    hollow = np.concatenate([solids.box((1, 1, 1)), solids.box((0.2, 0.2, 0.2))[:, ::-1]])
    cover = decompose(solids.solid(hollow), DEFAULT)
    assert cover.coverage.proven


def test_the_same_again(made, tmp_path, monkeypatch):
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(tmp_path / "empty"))
    path, found = made("l")
    assert decomposed(path, units="m").to_json() == found.to_json()


def test_masses_come_from_the_certificate(made):
    _, found = made("l")
    wanted = of_solid(solids.solid(solids.l_bracket()), 2700.0)
    mass = found.mass_properties(2700.0)
    assert mass.mass_kg == pytest.approx(wanted.mass_kg)
    np.testing.assert_allclose(mass.inertia_kg_m2, wanted.inertia_kg_m2, rtol=1e-9)
    np.testing.assert_allclose(mass.first_moment_kg_m, wanted.first_moment_kg_m, rtol=1e-9)


def test_what_was_made_is_kept_and_what_is_broken_is_made_again(tmp_path, monkeypatch):
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(tmp_path / "cache"))
    path = solids.write_obj(tmp_path / "box.obj", solids.box((1, 2, 3)))
    calls = []

    def counted(solid, settings):
        calls.append(1)
        return decompose(solid, settings)

    monkeypatch.setattr(from_file, "decompose", counted)
    first = decomposed(path, units="m")
    assert decomposed(path, units="m").to_json() == first.to_json()
    assert len(calls) == 1
    assert decomposed(path, units="mm").certificate.volume_m3 == pytest.approx(6e-9)
    decomposed(path, units="m", settings=DecomposeSettings(seed=1))
    assert len(calls) == 3
    for kept in (tmp_path / "cache" / "pieces").iterdir():
        kept.write_text(kept.read_text().replace('"voids": 0', '"voids": 1'))
    assert decomposed(path, units="m").to_json() == first.to_json()
    assert len(calls) == 4


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(tmp_path / "file"))
    path = solids.write_obj(tmp_path / "box.obj", solids.box((1, 2, 3)))
    assert decomposed(path, units="m").certificate.pieces == 1


def test_a_push_that_does_not_suffice_is_an_error():
    solid = solids.solid(solids.l_bracket(), "l.stl")
    with pytest.raises(InputError, match=r"l\.stl: could not be covered.*1e-06 mm"):
        decompose(solid, DecomposeSettings(largest_push_m=1e-9))


@pytest.mark.parametrize("settings", [{"volume_ratio": 1.0}, {"largest_push_m": 0.0}, {"seed": -1}])
def test_settings_out_of_range_are_refused(settings):
    with pytest.raises(InputError, match=next(iter(settings))):
        DecomposeSettings(**settings)


def test_a_library_that_fails_is_an_error_not_a_crash(monkeypatch, tmp_path):
    worker = tmp_path / "worker.py"
    worker.write_text("import os\nos.abort()\n")
    monkeypatch.setattr(coacd_run, "WORKER", worker)
    with pytest.raises(InputError, match="made CoACD fail"):
        decompose(solids.solid(solids.l_bracket()), DEFAULT)


@pytest.mark.parametrize("library", ["coacd", "trimesh"])
def test_a_missing_library_names_the_extra(monkeypatch, tmp_path, library):
    real = optional.find_spec
    monkeypatch.setattr(optional, "find_spec", lambda n: None if n == library else real(n))
    path = solids.write_obj(tmp_path / "l.obj", solids.l_bracket() * 1.01)
    with pytest.raises(InputError, match=rf"{library}.*berthing\[mesh\]"):
        decomposed(path, units="m")


def test_a_decomposition_is_read_as_it_was_written(made):
    _, found = made("c")
    again = Decomposition.from_json(json.loads(json.dumps(found.to_json())), "c")
    assert again.to_json() == found.to_json()
