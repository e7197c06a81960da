"""A plan with meshes in it: its folder stands alone, and tells when a piece was changed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from berthing.errors import InputError
from berthing.mesh import cache
from berthing.mesh.certificate import SEAL, seal
from berthing.mesh.decomposition import Decomposition
from berthing.planner import plan
from berthing.report.folder import write_result
from berthing.scenario.files import load
from berthing.verify.folder import verify_folder
from support import solids

SCENARIO = """
schema_version: 1
name: past-a-block
horizon: {duration_s: 60}
margins: {default_m: 0.02}
vehicles:
  - name: carrier
    parts: [{name: l, mesh: l.stl, units: m}]
    dynamics: {model: rigid-body, density_kg_m3: 2700}
    start: {position_m: [0, 0, 0]}
    goal: {position_m: [1.5, 0.1, 0]}
structures:
  - name: block
    position_m: [0.9, -0.4, 0]
    parts: [{name: core, mesh: block.stl, units: mm}]
"""
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def planned(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A plan folder; the scenario, the meshes and the cache of pieces that it was made of are
    gone."""
    with pytest.MonkeyPatch.context() as patch:
        made = tmp_path_factory.mktemp("made")
        patch.setenv(cache.FOLDER_VARIABLE, str(made / "cache"))
        solids.write_stl(made / "l.stl", solids.l_bracket())
        solids.write_stl(made / "block.stl", solids.box((500, 500, 500)))
        (made / "case.yaml").write_text(SCENARIO, encoding="utf-8")
        scenario = load(made / "case.yaml")
        result = plan(scenario)
        write_result(scenario, result, scenario.solver, made / "plan")
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "plan"
    shutil.move(made / "plan", elsewhere)
    shutil.rmtree(made)
    return elsewhere


@pytest.fixture
def folder(planned: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy that may be spoiled."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(tmp_path / "cache"))
    return Path(shutil.copytree(planned, tmp_path / "plan"))


def test_it_is_checked_where_no_mesh_is(folder):
    assert verify_folder(folder).certified
    assert not (folder.parent / "cache").exists()
    scenario = json.loads((folder / "plan.json").read_text())["scenario"]
    (part,) = scenario["structures"][0]["parts"]
    assert part["mesh"] == "block.stl"
    assert len(part["certificate"]["mesh_sha256"]) == 64


def edit(folder, change):
    """Change the block's only piece, or its certificate, in plan.json."""
    content = json.loads((folder / "plan.json").read_text())
    (part,) = content["scenario"]["structures"][0]["parts"]
    change(part)
    (folder / "plan.json").write_text(json.dumps(content))


def shrink(part):
    part["pieces"][0]["shape"]["size_m"][0] -= 1e-3


def shrink_and_seal(part):
    shrink(part)
    part["certificate"][SEAL] = seal(unsealed(part), part["pieces"])


def claim_another_push(part):
    part["certificate"]["push_m"] = 0.0


def remove(part):
    del part["pieces"][0]


def unsealed(part):
    return {key: value for key, value in part["certificate"].items() if key != SEAL}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (shrink, "does not fit its seal"),
        (remove, "does not fit its seal"),
        (claim_another_push, "does not fit its seal"),
        (shrink_and_seal, "does not fit its pieces: .*volume_ratio"),
    ],
)
def test_a_changed_piece_or_certificate_is_refused(folder, change, says):
    edit(folder, change)
    with pytest.raises(InputError, match=says):
        verify_folder(folder)


def test_a_piece_forged_with_all_that_is_said_of_it_is_not_certified(folder):
    """The trajectory and the proof of clearance belong to another scenario then."""

    def forge(part):
        shrink(part)
        pieces, said = part["pieces"], unsealed(part)
        part["certificate"] = {**said, SEAL: seal(said, pieces)}
        volume = sum(piece.volume for piece in Decomposition.from_json(part, "part").pieces)
        said["volume_ratio"] = volume / said["volume_m3"]
        part["certificate"] = {**said, SEAL: seal(said, pieces)}

    edit(folder, forge)
    found = verify_folder(folder)
    assert not found.certified
    assert any("scenario" in reason for reason in found.reasons)
