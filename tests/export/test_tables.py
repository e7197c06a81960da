"""MATLAB files by SciPy; Parquet by polars, which has nothing in common with pyarrow."""

import json

import numpy as np
import polars
import pyarrow.parquet
import pytest
from scipy.io import loadmat
from scipy.spatial.transform import Rotation

from support.plan_folder import Truth, assert_rotations

SCALAR_FIRST = ("qw", "qx", "qy", "qz")


def read_mat(path):
    return loadmat(path, squeeze_me=True, struct_as_record=False)["plan"]


def check_mat(path, truth):
    own = read_mat(path).vehicles
    assert_rotations(Rotation.from_quat(own.q_IB, scalar_first=True), truth.rotation(own.t_s))
    return own


def check_parquet(path, truth):
    table = polars.read_parquet(path)
    t = table["t_s"].to_numpy()
    q = table.select(SCALAR_FIRST).to_numpy()
    assert_rotations(Rotation.from_quat(q, scalar_first=True), truth.rotation(t))
    return table


def test_mat_reads_back(to, truth):
    own = check_mat(to("mat"), truth)
    t = own.t_s
    assert len(t) >= 1001
    for found, true in (
        (own.position_m, truth.position(t)),
        (own.velocity_m_s, truth.velocity(t)),
        (own.rate_rad_s, truth.rate(t)),
        (own.control, truth.control(t)),
    ):
        np.testing.assert_allclose(found, true, rtol=0, atol=1e-9)
    assert list(own.control_names) == ["fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm"]
    assert own.control_interpolation == "polynomial"


def test_mat_has_the_polynomials(to, truth):
    own = read_mat(to("mat")).vehicles
    piece = own.segments[3]
    t = 0.3 * piece.t0_s + 0.7 * piece.t1_s
    s = (2 * t - piece.t0_s - piece.t1_s) / (piece.t1_s - piece.t0_s)
    basis = np.cos(np.arange(len(piece.state)) * np.arccos(s))
    np.testing.assert_allclose(basis @ piece.state[:, :3], truth.position(np.array([t]))[0])


def test_mat_says_what_it_is(to):
    plan = read_mat(to("mat"))
    assert (plan.epoch, plan.time_system) == ("2026-03-01T12:34:56.789000", "UTC")
    assert (plan.frame, plan.centre, plan.outcome) == ("EME2000", "EARTH", "certified")
    for said in ("scalar first", "EME2000", "polynomials of time", "reference point", "T_k(s)"):
        assert said in plan.notes


def test_mat_has_every_vehicle(to, pair_folder):
    vehicles = read_mat(to("mat", source=pair_folder)).vehicles
    assert [v.name for v in vehicles] == ["carrier", "scout", "puck"]
    truth = Truth(pair_folder, "puck")
    np.testing.assert_allclose(vehicles[2].position_m, truth.position(vehicles[2].t_s), atol=1e-9)


def test_parquet_reads_back(to, truth):
    table = check_parquet(to("parquet"), truth)
    t = table["t_s"].to_numpy()
    for names, true in (
        (("x_m", "y_m", "z_m"), truth.position(t)),
        (("vx_m_s", "vy_m_s", "vz_m_s"), truth.velocity(t)),
        (("wx_rad_s", "wy_rad_s", "wz_rad_s"), truth.rate(t)),
        (("fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm"), truth.control(t)),
    ):
        np.testing.assert_allclose(table.select(names).to_numpy(), true, rtol=0, atol=1e-9)
    assert set(table["vehicle"]) == {"carrier"}


def test_parquet_says_what_it_is(to):
    told = {
        key.decode(): value.decode()
        for key, value in pyarrow.parquet.read_schema(to("parquet")).metadata.items()
    }
    assert told["berthing.epoch"] == "2026-03-01T12:34:56.789000 UTC"
    assert told["berthing.frame"] == "EME2000"
    assert told["berthing.quaternion"] == "q_IB, scalar first"
    assert json.loads(told["berthing.control_interpolation"]) == {"carrier": "polynomial"}
    assert "reference point" in told["berthing"]


def test_what_a_vehicle_lacks_is_null(to, pair_folder):
    table = polars.read_parquet(to("parquet", source=pair_folder))
    puck = table.filter(polars.col("vehicle") == "puck")
    assert puck["gx_nm"].null_count() == len(puck) > 0
    assert puck["x_m"].null_count() == 0
    assert table.filter(polars.col("vehicle") == "scout")["gx_nm"].null_count() == 0


@pytest.mark.parametrize(("name", "check"), [("mat", check_mat), ("parquet", check_parquet)])
@pytest.mark.parametrize(
    "mistake",
    [lambda q: np.roll(q, -1, axis=-1), lambda q: q * [1, -1, -1, -1]],
    ids=["scalar last", "conjugate"],
)
def test_a_wrong_order_is_noticed(to, truth, name, check, mistake, monkeypatch):
    monkeypatch.setattr("berthing.export.samples.continuous", mistake)
    with pytest.raises(AssertionError, match="off by"):
        check(to(name), truth)
