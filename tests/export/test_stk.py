"""There is no reader of STK's files in Python; this one is of the manual's description."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from berthing.errors import InputError
from support.plan_folder import assert_rotations


def read(path, table):
    lines = [line.split("#")[0].strip() for line in path.read_text(encoding="ascii").splitlines()]
    lines = [line for line in lines if line]
    assert lines[0].startswith("stk.v.")
    block = lines[1].removeprefix("BEGIN ")
    assert lines[-1] == f"END {block}"
    split = lines.index(table)
    keys = dict(line.split(maxsplit=1) for line in lines[2:split])
    rows = np.array([line.split() for line in lines[split + 1 : -1]], dtype=float)
    return SimpleNamespace(block=block, keys=keys, t=rows[:, 0], values=rows[:, 1:])


def check_attitude(path, truth):
    """STK: (n sin A/2, cos A/2) of the rotation by A about n from the axes to the body's."""
    found = read(path, "AttitudeTimeQuaternions")
    n, c = found.values[:, :3], found.values[:, 3]
    assert_rotations(Rotation.from_quat(np.column_stack([n, c])), truth.rotation(found.t))
    return found


def test_ephemeris_reads_back(to, truth):
    found = read(to("stk-e"), "EphemerisTimePosVel")
    assert found.block == "Ephemeris"
    assert int(found.keys["NumberOfEphemerisPoints"]) == len(found.t) >= 1001
    assert found.keys["ScenarioEpoch"] == "1 Mar 2026 12:34:56.789000"
    assert found.keys["DistanceUnit"] == "Meters"
    assert (found.keys["CentralBody"], found.keys["CoordinateSystem"]) == ("Earth", "J2000")
    np.testing.assert_allclose(found.values[:, :3], truth.position(found.t), rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.values[:, 3:], truth.velocity(found.t), rtol=0, atol=1e-9)


def test_attitude_reads_back(to, truth):
    found = check_attitude(to("stk-a"), truth)
    assert int(found.keys["NumberOfAttitudePoints"]) == len(found.t)
    assert found.keys["CoordinateAxes"] == "J2000"


def test_attitude_in_a_wrong_order_is_noticed(to, truth, wrong_order, monkeypatch):
    monkeypatch.setattr("berthing.export.stk_attitude.scalar_last", wrong_order)
    with pytest.raises(AssertionError, match="off by"):
        check_attitude(to("stk-a"), truth)


def test_the_epoch_is_utc_whatever_the_scale(to):
    meta = {"epoch": "2026-03-01T12:00:37", "time_system": "TAI"}
    found = read(to("stk-e", extra_meta=meta), "EphemerisTimePosVel")
    assert found.keys["ScenarioEpoch"] == "1 Mar 2026 12:00:00.000000"


def test_a_system_of_stk_serves_a_plan_about_a_spacecraft(to):
    meta = {"centre": "STATION", "frame": "RTN", "stk_system": "Custom RIC Satellite/Station"}
    keys = read(to("stk-e", extra_meta=meta), "EphemerisTimePosVel").keys
    assert keys["CoordinateSystem"] == "Custom RIC Satellite/Station"
    with pytest.raises(InputError, match="stk_axes"):
        to("stk-a", extra_meta=meta)


@pytest.mark.parametrize("meta", [{"centre": "STATION"}, {"frame": "RTN"}], ids=["centre", "frame"])
def test_what_stk_has_not_is_refused(to, meta):
    with pytest.raises(InputError, match="stk_system: Custom"):
        to("stk-e", extra_meta=meta)


def test_the_file_says_what_it_is(to):
    text = to("stk-a").read_text(encoding="ascii")
    for said in ("scalar last", "EME2000", "UTC", "polynomials of time", "Outcome: certified"):
        assert any(said in line for line in text.splitlines() if line.startswith("# "))
