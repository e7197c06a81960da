"""Code of the user's own in files: found, run only where trusted, kept with the scenario."""

import copy
import json
import os

import pytest

from berthing.errors import InputError
from berthing.scenario.files import from_document, json_schema, load
from berthing.scenario.normal import document_sha256
from support import users


@pytest.fixture
def rover():
    """A scenario with a model, a constraint and a cost of the user's own."""
    return {
        "schema_version": 1,
        "name": "rover",
        "horizon": {"duration_s": 30},
        "cost": {
            "control_energy": 0,
            "running": [
                {"vehicle": "rover", "file": "rover.py", "name": "steering",
                 "parameters": {"weight": 0.1}, "scale": 0.01}
            ],
        },
        "margins": {"default_m": 0.1},
        "vehicles": [
            {
                "name": "rover",
                "parts": [{"name": "hull", "shape": {"type": "box", "size_m": [1.6, 0.8]}}],
                "dynamics": {"model": "user", "file": "rover.py", "name": "rover",
                             "parameters": {"wheelbase_m": 1.2}},
                "limits": {
                    "states": {"steering_rad": [-0.6, 0.6], "speed_m_s": [None, 1]},
                    "controls": {"steer_rad_s": [-0.3, 0.3]},
                },
                "start": {"position_m": [0, 0], "angle_rad": 0.5, "states": {"steering_rad": 0.1}},
                "goal": {"position_m": [8, 3], "rate_rad_s": "free"},
                "path_constraints": [
                    {"file": "rover.py", "name": "sideways", "label": "pull",
                     "parameters": {"most_m_s2": 0.05}, "tolerance": 1e-3}
                ],
            }
        ],
    }  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "rover.py").write_text(users.ROVER_CODE)
    return tmp_path


def written(folder, document):
    path = folder / "rover.json"
    path.write_text(json.dumps(document))
    return path


def refused(folder, document):
    with pytest.raises(InputError) as error:
        load(written(folder, document))
    return str(error.value)


def test_code_is_found_beside_the_scenario(folder, rover):
    scenario = load(written(folder, rover))
    (craft,) = scenario.phases[0].vehicles
    assert craft.model.state_names[4] == "steering_rad"
    assert craft.model.parameters == {"wheelbase_m": 1.2}
    assert craft.limits.state_upper[3:].tolist() == [1.0, 0.6]
    assert craft.limits.state_lower[3] == -float("inf")
    assert craft.limits.control_upper.tolist() == [float("inf"), 0.3]
    assert craft.start.states == {"steering_rad": 0.1}
    assert craft.start.attitude.q[3] == pytest.approx(0.2474039593)
    assert craft.goal.rate_rad_s is None
    (constraint,) = craft.path_constraints
    assert (constraint.name, constraint.tolerance) == ("pull", 1e-3)
    (running,) = scenario.phases[0].cost.running
    assert (running.vehicle, running.scale) == ("rover", 0.01)


def test_the_document_stands_alone_and_is_trusted_by_word_only(folder, rover):
    scenario = load(written(folder, rover))
    os.remove(folder / "rover.py")
    document = json.loads(json.dumps(scenario.document))
    again = from_document(document, trust=True)
    assert document_sha256(again.document) == document_sha256(document)
    assert again.phases[0].vehicles[0].model.parameters == {"wheelbase_m": 1.2}
    with pytest.raises(InputError, match=r"rover\.py, which is not run unasked.*--trust"):
        from_document(document)


def test_untrusted_code_does_not_run(folder, rover):
    (folder / "rover.py").write_text("raise SystemExit('it ran')")
    scenario = copy.deepcopy(rover)
    scenario["vehicles"][0]["dynamics"]["code"] = "raise SystemExit('it ran')"
    scenario["vehicles"][0]["path_constraints"] = []
    scenario["cost"] = {}
    with pytest.raises(InputError, match="not run unasked"):
        from_document(scenario)


def test_code_that_fails_is_told(folder, rover):
    (folder / "rover.py").write_text("a = 1\nb = a / 0\n")
    assert "raises ZeroDivisionError: division by zero (rover.py, line 2)" in refused(folder, rover)


CHANGES = {
    "dynamics.file: is 'no.py': No such file": ("dynamics", "file", "no.py"),
    "dynamics.name: names no name in rover.py: 'rovr'; did you mean rover?": (
        "dynamics",
        "name",
        "rovr",
    ),
    "dynamics.name: is 'number', in rover.py int (expected a berthing.UserModel)": (
        "dynamics",
        "name",
        "number",
    ),
    "dynamics.parameters: has null, NaN or an infinite number": (
        "dynamics",
        "parameters",
        {"a": [None]},
    ),
    "limits.states.speed: names no state: 'speed'; did you mean speed_m_s?": (
        "limits",
        "states",
        {"speed": [0, 1]},
    ),
    "limits.max_force_n: limits what user model rover does not have": ("limits", "max_force_n", 1),
    "goal.angle_rad: stands beside an attitude": (
        "goal",
        None,
        {"position_m": [8, 3], "attitude": [1, 0, 0, 0], "angle_rad": 0},
    ),
    "goal.states.speed: names no state: 'speed'": (
        "goal",
        None,
        {"position_m": [8, 3], "states": {"speed": 0}},
    ),
}


@pytest.mark.parametrize("message", CHANGES)
def test_mistakes_name_their_place(folder, rover, message):
    block, key, value = CHANGES[message]
    vehicle = rover["vehicles"][0]
    if key is None:
        vehicle[block] = value
    else:
        vehicle[block][key] = value
    assert f"vehicles[0].{message}" in refused(folder, rover)


def test_constraints_and_costs_are_functions_of_vehicles(folder, rover):
    rover["vehicles"][0]["path_constraints"][0]["name"] = "number"
    assert "path_constraints[0].name: is 'number', in rover.py int" in refused(folder, rover)
    rover["vehicles"][0]["path_constraints"] = []
    rover["cost"]["running"][0]["vehicle"] = "rovr"
    assert "cost.running[0].vehicle: names no vehicle: 'rovr'" in refused(folder, rover)


def test_two_constraints_have_two_names(folder, rover):
    rover["vehicles"][0]["path_constraints"] *= 2
    assert "path_constraints[1]" in refused(folder, rover)


def test_position_limits_need_positions_among_the_states(folder, rover):
    (folder / "rover.py").write_text(users.ROVER_CODE.replace('"x_m"', '"east_m"'))
    rover["vehicles"][0]["limits"]["position_m"] = {"lower": [0, 0]}
    assert "limits.position_m: limits what is no state of this model" in refused(folder, rover)


def test_what_does_not_turn_has_no_angle(planar):
    planar["vehicles"][0]["goal"]["angle_rad"] = 0.3
    with pytest.raises(InputError, match=r"angle_rad: is asked of a point mass"):
        from_document(planar)


def test_an_angle_is_for_the_plane(document):
    document["vehicles"][0]["goal"]["angle_rad"] = 0.3
    with pytest.raises(InputError, match=r"goal\.angle_rad: is a turn in the plane"):
        from_document(document)


def test_the_schema_has_the_users_blocks():
    assert {"UserModelBlock", "PathConstraintBlock", "RunningCostBlock"} <= set(
        json_schema()["$defs"]
    )
