"""Each case has a solution, and the check of it can fail."""

import copy
import json

import numpy as np
import pytest
from benchmarks.tight3d import WITNESSES
from benchmarks.tight3d._export import export
from benchmarks.tight3d._families import FAMILIES, made
from benchmarks.tight3d._prove import proven

from berthing.scenario.files import from_document, load
from berthing.scenario.normal import document_sha256
from berthing.verify.folder import verify_folder
from berthing.verify.verification import verify

RECORDED = {(row["family"], row["seed"]): row for row in json.loads(WITNESSES.read_text())}


SLOW = {"clutter": pytest.mark.slow}


@pytest.mark.parametrize(
    "family", [pytest.param(name, marks=SLOW.get(name, ())) for name in FAMILIES]
)
def test_witness_is_certified_and_as_recorded(family):
    row = proven(made(family, 0))
    recorded = RECORDED[family, 0]
    assert row["certified"], row["reasons"]
    assert row["sha256"] == recorded["sha256"]
    assert row["cost"] == pytest.approx(recorded["cost"], rel=1e-5)


@pytest.mark.parametrize("family", [name for name in FAMILIES if name != "clutter"])
def test_cases_are_the_same_every_time(family):
    for seed in (1, 57):
        case = made(family, seed)
        assert document_sha256(case.document) == RECORDED[family, seed]["sha256"]
        assert case.document != made(family, seed + 1).document


def test_every_case_has_a_recorded_proof():
    assert set(RECORDED) == {(family, seed) for family in FAMILIES for seed in range(100)}
    assert all(row["certified"] for row in RECORDED.values())
    assert len({row["sha256"] for row in RECORDED.values()}) == len(RECORDED)


def _changed(case, change):
    document = copy.deepcopy(case.document)
    change(document)
    scenario = from_document(document, case.name)
    return verify(scenario, case.witness(scenario))


def test_witness_of_a_corridor_that_is_narrower_is_refused():
    case = made("corridor", 3)

    def narrower(document):
        for part in document["structures"][0]["parts"]:
            if part["name"].startswith("stave"):
                part["position_m"] = list(0.8 * np.array(part["position_m"]))

    found = _changed(case, narrower)
    assert not found.certified
    assert "corridor.stave" in found.reasons[0]
    assert "clearance" in found.reasons[0]


def test_witness_of_a_weaker_vehicle_is_refused():
    def weaker(document):
        document["vehicles"][0]["limits"]["max_force_n"] /= 2.0

    found = _changed(made("dock", 0), weaker)
    assert not found.limits_ok


def test_exported_case_and_witness_stand_alone(tmp_path):
    case = made("window", 0)
    export(case, tmp_path)
    assert load(tmp_path / "window-000.yaml").document == case.scenario().document
    assert verify_folder(tmp_path / "window-000.witness").certified
