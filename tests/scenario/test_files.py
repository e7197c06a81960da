"""Reading: forms of the file, defaults, the normal form and its fingerprint, the library."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.sphere import Sphere
from berthing.scenario.attitude import AxisAttitude, FixedAttitude, FreeAttitude
from berthing.scenario.files import from_document, json_schema, load
from berthing.scenario.library import case_path, library
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed
from berthing.scenario.normal import document_sha256
from berthing.scenario.point_mass import PointMass
from berthing.scenario.reading import read
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.tabulated import Tabulated

Document = dict[str, Any]


def _write(path: Path, document: Document) -> Path:
    with path.open("w", encoding="utf-8") as stream:
        YAML(typ="safe", pure=True).dump(document, stream)
    return path


def test_defaults_of_a_short_file(document: Document) -> None:
    scenario = from_document(document)
    (phase,) = scenario.phases
    (vehicle,) = phase.vehicles
    assert (phase.name, scenario.dim, scenario.description) == ("main", 3, "")
    assert not phase.horizon.is_free
    assert (phase.cost.control_energy, phase.cost.time) == (1.0, 0.0)
    assert isinstance(vehicle.model, RigidBody)
    np.testing.assert_array_equal(vehicle.model.inertia_kg_m2, 5 * np.eye(3))
    for end in (vehicle.start, vehicle.goal):
        assert isinstance(end.attitude, FixedAttitude)
        np.testing.assert_array_equal(end.attitude.q, [1, 0, 0, 0])
        np.testing.assert_array_equal(end.velocity_m_s, np.zeros(3))
        np.testing.assert_array_equal(end.rate_rad_s, np.zeros(3))
        assert end.frame is None
    np.testing.assert_array_equal(vehicle.limits.control_upper, [0.02] * 3 + [0.01] * 3)
    assert np.isinf(vehicle.limits.state_lower).all()
    assert isinstance(scenario.structures[0].motion, Fixed)
    assert scenario.solver.formulation == "plane"
    assert scenario.solver.seed == 0


def test_yaml_json_and_dict_are_one_scenario(document: Document, tmp_path: Path) -> None:
    in_json = tmp_path / "case.json"
    in_json.write_text(json.dumps(document), encoding="utf-8")
    documents = [
        from_document(document).document,
        load(_write(tmp_path / "case.yaml", document)).document,
        load(str(in_json)).document,
    ]
    assert documents[0] == documents[1] == documents[2]


def test_yaml_is_1_2(tmp_path: Path, document: Document) -> None:
    """1e-3 is a number, ``no`` is a word, and a date stays text."""
    text = json.dumps(document).replace('"default_m": 0.1', '"default_m": 1e-3')
    text = text.replace('"name": "hull"', '"name": no')
    text = text.replace(
        '"schema_version"', '"meta": {"epoch": 2026-01-01T00:00:00Z}, "schema_version"'
    )
    path = tmp_path / "case.yaml"
    path.write_text(text, encoding="utf-8")
    scenario = load(path)
    assert scenario.margins.default_m == 0.001
    assert scenario.phases[0].vehicles[0].body.parts[0].name == "no"
    assert scenario.meta["epoch"] == "2026-01-01T00:00:00Z"


RICH = """
schema_version: 1
name: rich
description: Everything at once.
horizon: {min_s: 100, max_s: 200}
cost: {control_energy: 2, time: 0.001}
margins:
  default_m: 0.1
  overrides:
    - {between: [tug.nose, station.port], margin_m: 0.02, window_s: [150, 200]}
    - {between: [helper, tug], contact: allowed}
vehicles:
  - name: tug
    parts:
      - {name: hull, shape: {type: cylinder, radius_m: 1, length_m: 3, axis: z}}
      - name: nose
        position_m: [0, 0, 2]
        attitude: [0.6, 0.8, 0, 0]
        shape: {type: ellipsoid, semi_axes_m: [0.5, 0.5, 1]}
    dynamics:
      model: rigid-body
      mass_kg: 30
      inertia_kg_m2: [[40, 1, 0], [1, 45, 0], [0, 0, 25]]
      first_moment_kg_m: [0.3, 0, -1.5]
      wrenches:
        - {name: arm, point_m: [0, 1, 0], times_s: [0, 50], force_n: [[0, 0, 0], [0.1, 0, 0]],
           torque_nm: [[0, 0, 0.1], [0, 0, 0]]}
    limits:
      max_force_n: [1, 2, 3]
      max_torque_nm: 0.5
      max_speed_m_s: 0.4
      max_rate_rad_s: [0.1, 0.2, 0.3]
      position_m: {lower: [-20, null, -5], upper: [20, 30, null]}
    start:
      position_m: [0, 0, 0]
      attitude: free
      velocity_m_s: [0.1, 0, 0]
      rate_rad_s: free
    goal:
      position_m: [0, 0, -4]
      position_tolerance_m: 0.01
      attitude: {body_axis: [0, 0, 1], points_along: [0, 0, 2], tolerance_rad: 0.02}
      frame: station
  - name: helper
    parts: [{name: body, shape: {type: point}}]
    dynamics: {model: point-mass, mass_kg: 5}
    limits: {max_force_n: 0.3, max_speed_m_s: [1, 1, 1]}
    start: {position_m: [0, 9, 0], velocity_m_s: free}
    goal: {position_m: [0, 9, 5]}
structures:
  - name: station
    position_m: [10, 0, 0]
    attitude: [0, 1, 0, 0]
    parts:
      - {name: port, shape: {type: box, size_m: [1, 1, 1]}}
      - name: roof
        shape: {type: polytope, normals: [[1, 1, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]],
                offsets_m: [1, 0, 0, 0]}
    motion: {type: spin, axis: [0, 0, 1], rate_rad_s: 0.01, velocity_m_s: [0, 0.01, 0]}
  - name: ferry
    parts: [{name: ball, shape: {type: sphere, radius_m: 0.5}}]
    position_m: [0, -20, 0]
    motion: {type: constant-velocity, velocity_m_s: [0.1, 0, 0]}
  - name: crane
    parts: [{name: hook, shape: {type: sphere, radius_m: 0.5}}]
    motion:
      type: tabulated
      times_s: [0, 100, 200]
      positions_m: [[0, 20, 0], [5, 20, 0], [5, 25, 0]]
      attitudes: [[1, 0, 0, 0], [0.8, 0, 0.6, 0], [0.8, 0, 0.6, 0]]
solver: {formulation: dual, scheme: lgl, nodes: 30, time_limit_s: 20, seed: 3}
meta: {frame: RTN, object_ids: {tug: null, station: 25544}}
"""


@pytest.fixture
def rich(tmp_path: Path) -> Scenario:
    path = tmp_path / "rich.yaml"
    path.write_text(RICH, encoding="utf-8")
    return load(path)


def test_a_rich_file_is_read_in_full(rich: Scenario) -> None:
    tug, helper = rich.phases[0].vehicles
    assert rich.phases[0].horizon.is_free
    assert isinstance(tug.body.part("nose").shape, Ellipsoid)
    assert isinstance(tug.model, RigidBody)
    assert tug.model.wrenches[0].name == "arm"
    np.testing.assert_array_equal(tug.limits.control_upper, [1, 2, 3, 0.5, 0.5, 0.5])
    np.testing.assert_array_equal(tug.limits.state_lower[:3], [-20, -np.inf, -5])
    np.testing.assert_array_equal(tug.limits.state_upper[:6], [20, 30, np.inf, 0.4, 0.4, 0.4])
    assert np.isinf(tug.limits.state_upper[6:10]).all()
    np.testing.assert_array_equal(tug.limits.state_lower[10:], [-0.1, -0.2, -0.3])
    assert isinstance(tug.start.attitude, FreeAttitude)
    assert tug.start.rate_rad_s is None
    assert isinstance(tug.goal.attitude, AxisAttitude)
    assert tug.goal.frame == "station"
    assert isinstance(helper.model, PointMass)
    assert helper.start.velocity_m_s is None
    assert helper.goal.rate_rad_s is None
    shape = helper.body.parts[0].shape
    assert isinstance(shape, Sphere)
    assert shape.radius == 0.0
    motions = [type(s.motion) for s in rich.structures]
    assert motions == [ConstantSpin, ConstantVelocity, Tabulated]
    assert rich.margins.margin("station.port", "tug.nose", 180.0) == 0.02
    assert rich.margins.margin("helper.body", "tug.hull", 180.0) is None
    assert (rich.solver.nodes, rich.solver.seed, rich.solver.scheme) == (30, 3, "lgl")


def test_pairs_are_vehicle_structure_then_vehicle_vehicle(rich: Scenario) -> None:
    names = [p.name for p in rich.pairs(rich.phases[0])]
    assert len(names) == 2 * 4 + 1 * 4 + 2
    assert names[:3] == ["tug.hull|station.port", "tug.hull|station.roof", "tug.hull|ferry.ball"]
    assert names[-2:] == ["tug.hull|helper.body", "tug.nose|helper.body"]
    assert len(set(names)) == len(names)
    first = rich.pairs(rich.phases[0])[0]
    assert first.label == "tug.hull, station.port"
    assert first == rich.pairs(rich.phases[0])[0]


def test_the_normal_form_reloads_to_itself(rich: Scenario) -> None:
    through_json = json.loads(json.dumps(rich.document, allow_nan=False))
    again = from_document(through_json)
    assert again.document == rich.document
    assert document_sha256(again.document) == document_sha256(rich.document)
    assert again.meta["object_ids"] == {"tug": None, "station": 25544}
    a, b = (s.phases[0].vehicles[0] for s in (rich, again))
    np.testing.assert_array_equal(
        a.body.part("nose").placement.rotation, b.body.part("nose").placement.rotation
    )
    np.testing.assert_array_equal(a.limits.state_lower, b.limits.state_lower)


def test_the_fingerprint_ignores_order_and_sees_every_change(document: Document) -> None:
    fingerprint = document_sha256(from_document(document).document)
    reordered = dict(reversed(document.items()))
    assert document_sha256(from_document(reordered).document) == fingerprint
    document["vehicles"][0]["dynamics"]["mass_kg"] = 3.0000001
    assert document_sha256(from_document(document).document) != fingerprint


def test_phases_as_a_list(document: Document) -> None:
    whole = copy.deepcopy(document)
    first = {key: document.pop(key) for key in ("horizon", "vehicles")}
    second = copy.deepcopy(first)
    del second["vehicles"][0]["start"]
    second["vehicles"][0]["goal"]["position_m"] = [12, 4, 0]
    document["phases"] = [{"name": "out", **first}, {"name": "on", **second}]
    scenario = from_document(document)
    assert [p.name for p in scenario.phases] == ["out", "on"]
    on = scenario.phase("on").vehicle("spacecraft")
    assert on.start is scenario.phase("out").vehicle("spacecraft").goal
    assert from_document(scenario.document).document == scenario.document
    document["phases"] = [{"name": "main", **first}]
    assert from_document(document).document == from_document(whole).document


def test_a_planar_scenario(planar: Document) -> None:
    planar["structures"].append(
        {
            "name": "gate",
            "parts": [{"name": "bar", "shape": {"type": "ellipsoid", "semi_axes_m": [1, 0.2]}}],
            "motion": {
                "type": "tabulated",
                "times_s": [0, 50, 100],
                "positions_m": [[0, 9], [1, 9], [2, 9]],
                "angles_rad": [0, 0.5, 1.2],
            },
        }
    )
    scenario = from_document(planar)
    assert scenario.dim == 2
    vehicle = scenario.phases[0].vehicles[0]
    np.testing.assert_array_equal(vehicle.limits.control_upper, [0.1, 0.2])
    assert vehicle.body.parts[0].shape.dim == 2
    wall = scenario.structure("wall").motion.pose(np.zeros(1))[0]
    np.testing.assert_allclose(wall.rotation[0], [np.cos(0.5), -np.sin(0.5)])
    gate = scenario.structure("gate").motion.pose(np.array([50.0]))[0]
    np.testing.assert_allclose(gate.rotation[0], [np.cos(0.5), -np.sin(0.5)])
    assert from_document(scenario.document).document == scenario.document


def test_the_schema_describes_both_forms() -> None:
    schema = json_schema()
    json.dumps(schema)
    defined = schema["$defs"]
    assert {"SinglePhaseFile", "ScenarioFile", "BoxShape", "RigidBodyBlock"} <= set(defined)
    assert "phases" in defined["ScenarioFile"]["required"]
    assert "horizon" in defined["SinglePhaseFile"]["required"]
    assert defined["RigidBodyBlock"]["additionalProperties"] is False
    assert defined["PointMassBlock"]["properties"]["mass_kg"]["exclusiveMinimum"] == 0


def test_every_case_of_the_library_loads_under_its_name() -> None:
    cases = library()
    assert list(cases) == sorted(cases)
    assert {"free-space", "scenario-a", "scenario-b", "scenario-b-tight"} <= set(cases)
    for name, headline in cases.items():
        scenario = load(name)
        assert scenario.name == name
        assert scenario.description.startswith(headline)
        assert 20 < len(headline) < 100
        assert from_document(scenario.document).document == scenario.document


def test_a_document_that_is_changed_is_read_again_as_it_was() -> None:
    path = case_path("scenario-b")
    assert path is not None
    first = read(path).raw
    first["horizon"].clear()
    first["name"] = "spoilt"
    again = read(path).raw
    assert again["name"] == "scenario-b"
    assert again["horizon"]
