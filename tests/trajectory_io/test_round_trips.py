"""What is written reads back the same, to the last bit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.files import from_document
from berthing.scenario.scenario import Scenario
from berthing.trajectory import (
    PhaseTrajectory,
    Segment,
    VehicleNodes,
    VehicleTrajectory,
)
from berthing.trajectory_io import (
    HEADER,
    read_interpolant,
    read_nodes,
    read_object,
    read_trajectory,
    write_interpolant,
    write_nodes,
    write_trajectory,
)
from berthing.trajectory_io.separation_costates import (
    KEY,
    MOST_ROWS,
    read_separations,
    separations_document,
)
from berthing.trajectory_io.tables import read_table

BALL = [{"name": "ball", "shape": {"type": "sphere", "radius_m": 0.5}}]
DISC = [{"name": "disc", "shape": {"type": "box", "size_m": [1, 1]}}]


def document(vehicle: dict) -> dict:
    return {
        "schema_version": 1,
        "name": "io",
        "description": "Files.",
        "horizon": {"duration_s": 10},
        "margins": {"default_m": 0.1},
        "vehicles": [vehicle],
    }


RIGID = document(
    {
        "name": "craft",
        "parts": BALL,
        "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
        "start": {"position_m": [0, 0, 0]},
        "goal": {"position_m": [1, 0, 0]},
    }
)
POINT = document(
    {
        "name": "puck",
        "parts": DISC,
        "dynamics": {"model": "point-mass", "mass_kg": 3},
        "start": {"position_m": [0, 0]},
        "goal": {"position_m": [1, 0]},
    }
)


def random_plan(whole: Scenario, seed: int = 0) -> tuple[PhaseTrajectory, VehicleNodes]:
    rng = np.random.default_rng(seed)
    own = whole.phases[0].vehicles[0]
    nx, nu = len(own.model.state_names), len(own.model.control_names)
    segments = tuple(
        Segment(
            10.0 * i / 3, 10.0 * (i + 1) / 3, rng.normal(size=(5, nx)), rng.normal(size=(4, nu))
        )
        for i in range(3)
    )
    flown = VehicleTrajectory(
        own.name, own.model.kind, own.model.state_names, own.model.control_names, segments
    )
    controls = rng.normal(size=(7, nu))
    controls[-1] = np.nan
    times = np.linspace(0.0, 10.0, 7)
    nodes = VehicleNodes(
        "main", own.name, times, rng.normal(size=(7, nx)), controls, 1e-9 * rng.normal(size=(7, nx))
    )
    return PhaseTrajectory("main", (flown,)), nodes


@pytest.mark.parametrize("given", [RIGID, POINT], ids=["rigid", "point"])
def test_interpolant(tmp_path: Path, given: dict) -> None:
    phase, _ = random_plan(from_document(given))
    write_interpolant(tmp_path / "i.json", [phase], "abc")
    read = read_interpolant(tmp_path / "i.json")
    assert read.scenario_sha256 == "abc"
    (own,), (back,) = phase.vehicles, read.phases[0].vehicles
    assert read.phases[0].phase == "main"
    assert back.state_names == own.state_names
    assert back.control_names == own.control_names
    assert (back.vehicle, back.model) == (own.vehicle, own.model)
    assert back.control_interpolation == own.control_interpolation
    for one, other in zip(own.segments, back.segments, strict=True):
        assert (one.t0_s, one.t1_s) == (other.t0_s, other.t1_s)
        np.testing.assert_array_equal(one.state, other.state)
        np.testing.assert_array_equal(one.control, other.control)


@pytest.mark.parametrize("given", [RIGID, POINT], ids=["rigid", "point"])
def test_nodes(tmp_path: Path, given: dict) -> None:
    whole = from_document(given)
    _, nodes = random_plan(whole)
    write_nodes(tmp_path / "n.csv", whole, [nodes])
    (back,) = read_nodes(tmp_path / "n.csv", whole)
    assert (back.phase, back.vehicle) == (nodes.phase, nodes.vehicle)
    for name in ("times_s", "states", "controls", "costates"):
        np.testing.assert_array_equal(getattr(back, name), getattr(nodes, name))
    header = (tmp_path / "n.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    assert tuple(header[: len(HEADER)]) == HEADER
    assert "costate_x_m" in header


def test_the_header_is_the_one_promised() -> None:
    assert ",".join(HEADER) == (
        "t_s,vehicle,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,"
        "fx_n,fy_n,fz_n,gx_nm,gy_nm,gz_nm"
    )


def test_trajectory_of_a_rigid_body(tmp_path: Path) -> None:
    whole = from_document(RIGID)
    phase, _ = random_plan(whole)
    write_trajectory(tmp_path / "t.csv", whole, [phase])
    first = (tmp_path / "t.csv").read_text(encoding="utf-8").splitlines()[0]
    assert first == ",".join(HEADER)
    columns = read_trajectory(tmp_path / "t.csv").vehicles["craft"]
    own = phase.vehicles[0]
    np.testing.assert_array_equal(columns["t_s"], np.linspace(0.0, 10.0, 1001))
    x, u = own.state(columns["t_s"]), own.control(columns["t_s"])
    for i, name in enumerate(own.state_names):
        if not name.startswith("q"):
            np.testing.assert_array_equal(columns[name], x[:, i])
    for i, name in enumerate(own.control_names):
        np.testing.assert_array_equal(columns[name], u[:, i])
    q = np.stack([columns[name] for name in ("qw", "qx", "qy", "qz")], axis=1)
    np.testing.assert_allclose(q, x[:, 6:10] / np.linalg.norm(x[:, 6:10], axis=1)[:, None])


def test_trajectory_of_a_planar_point(tmp_path: Path) -> None:
    whole = from_document(POINT)
    phase, _ = random_plan(whole)
    write_trajectory(tmp_path / "t.csv", whole, [phase], samples=2001)
    columns = read_trajectory(tmp_path / "t.csv").vehicles["puck"]
    assert len(columns["t_s"]) == 2001
    assert not np.any(columns["z_m"])
    assert np.all(columns["qw"] == 1.0)
    for missing in ("wx_rad_s", "fz_n", "gx_nm"):
        assert np.all(np.isnan(columns[missing]))
    assert not np.any(np.isnan(columns["fx_n"]))


def test_several_vehicles_and_an_empty_cell(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    row = ",".join(["1.5", "{}", *["0.25"] * 19])
    path.write_text(
        "\n".join([",".join(HEADER), row.format("a"), row.format("b").replace("0.25", "", 1)])
    )
    table = read_trajectory(path).vehicles
    assert list(table) == ["a", "b"]
    assert np.isnan(table["b"]["x_m"][0])
    assert table["a"]["x_m"][0] == 0.25


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "is empty"),
        ("a,b\n1,2\n", "another header"),
        (",".join(HEADER) + "\n1,2\n", "line 2: has 2 cells"),
        (",".join((*HEADER, "x_m")) + "\n", "names a column twice"),
        (",".join(HEADER) + "\n" + ",".join(["0", "a", "two", *["0"] * 18]) + "\n", "holds 'two'"),
        ('"' + ",".join(HEADER), "is not a table"),
    ],
)
def test_a_table_of_another_form(tmp_path: Path, content: str, said: str) -> None:
    path = tmp_path / "t.csv"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(InputError, match=said):
        read_trajectory(path)


def test_nodes_of_another_scenario(tmp_path: Path) -> None:
    whole, other = from_document(RIGID), from_document(POINT)
    write_nodes(tmp_path / "n.csv", whole, [random_plan(whole)[1]])
    with pytest.raises(InputError, match="craft"):
        read_nodes(tmp_path / "n.csv", other)


def test_nan_and_lists_are_not_objects(tmp_path: Path) -> None:
    path = tmp_path / "o.json"
    for content, said in (('{"a": NaN}', "contains NaN"), ("[1]", "not a JSON object")):
        path.write_text(content)
        with pytest.raises(InputError, match=said):
            read_object(path)


PAIRED = {
    **RIGID,
    "structures": [{"name": "rock", "position_m": [9, 0, 0], "parts": BALL}],
}
ROW = {"phase": "main", "pair": "craft.ball|rock.ball", "time_s": 4.0, "multiplier": 0.25,
       "jumps": {"craft": [0.1 * i for i in range(13)]}}  # fmt: skip


def test_multipliers_of_limits_and_paths_come_back(tmp_path: Path) -> None:
    whole = from_document(RIGID)
    _, nodes = random_plan(whole)
    pulls = {"limit_fx_n": np.linspace(-1.0, 1.0, 7), "path_cone_0": np.arange(7.0)}
    pulls["limit_fx_n"][-1] = np.nan
    write_nodes(tmp_path / "n.csv", whole, [replace(nodes, multipliers=pulls)])
    (back,) = read_nodes(tmp_path / "n.csv", whole)
    assert set(back.multipliers) == set(pulls)
    for name, values in pulls.items():
        np.testing.assert_array_equal(back.multipliers[name], values)


def test_nodes_say_what_separation_rows_pull_until_the_next(tmp_path: Path) -> None:
    whole = from_document(PAIRED)
    _, nodes = random_plan(whole)
    rows = read_separations({KEY: [ROW, {**ROW, "time_s": 4.9}, {**ROW, "time_s": 5.0}]}, whole, "")
    write_nodes(tmp_path / "n.csv", whole, [nodes], rows)
    table = read_table(tmp_path / "n.csv")
    column = table.numbers("separation_craft.ball|rock.ball", range(7))
    np.testing.assert_array_equal(column, [0.0, 0.0, 0.5, 0.25, 0.0, 0.0, 0.0])


def test_separation_rows_come_back() -> None:
    whole = from_document(PAIRED)
    rows = read_separations({KEY: [ROW]}, whole, "plan.json")
    assert separations_document(rows) == [ROW]


@pytest.mark.parametrize(
    "change",
    [
        {"pair": "craft.ball|moon.ball"}, {"phase": "other"}, {"pair": 3}, {"time_s": None},
        {"multiplier": "much"}, {"jumps": []}, {"jumps": {"tug": [0.0] * 13}},
        {"jumps": {"craft": [0.0] * 12}}, {"jumps": {"craft": [[0.0]] * 13}},
    ],
)  # fmt: skip
def test_rows_of_something_else_are_refused(change: dict) -> None:
    whole = from_document(PAIRED)
    with pytest.raises(InputError):
        read_separations({KEY: [{**ROW, **change}]}, whole, "plan.json")


def test_too_many_rows_are_refused() -> None:
    with pytest.raises(InputError, match="at most"):
        read_separations({KEY: [ROW] * (MOST_ROWS + 1)}, from_document(PAIRED), "plan.json")
