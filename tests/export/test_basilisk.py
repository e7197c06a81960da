"""Read as Basilisk's waypointReference does: eleven numbers of each line below the header."""

import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from support.plan_folder import assert_rotations


def read(path):
    text = path.read_text(encoding="ascii")
    skip = int(re.search(r"headerLines = (\d+)", text)[1])
    assert "attitudeType = 1, useReferenceFrame = True" in text
    rows = np.loadtxt(path, delimiter=",", skiprows=skip, comments=None, ndmin=2)
    names = text.splitlines()[skip - 1].split(",")
    assert len(names) == rows.shape[1]
    return rows, names


def check(path, truth):
    rows, _ = read(path)
    t = rows[:, 0]
    # Type 1 is (q0, q1, q2, q3); EP2C gives [RN], from inertial components to the body's.
    q0, q1, q2, q3 = rows[:, 1:5].T
    RN = np.array(
        [
            [q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 + q0 * q3), 2 * (q1 * q3 - q0 * q2)],
            [2 * (q1 * q2 - q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 + q0 * q1)],
            [2 * (q1 * q3 + q0 * q2), 2 * (q2 * q3 - q0 * q1), q0**2 - q1**2 - q2**2 + q3**2],
        ]
    )
    found = Rotation.from_matrix(np.moveaxis(RN, -1, 0)).inv()
    assert_rotations(found, truth.rotation(t))
    np.testing.assert_allclose(rows[:, 5:8], truth.rate(t), rtol=0, atol=1e-9)
    return rows


def test_waypoints_read_back(to, truth):
    rows = check(to("basilisk"), truth)
    t = rows[:, 0]
    assert (t[0], t[-1]) == (0.0, 100.0)
    # Accelerations against differences of the true rates, 0.1 s to either side.
    inside = t[(t > 1.0) & (t < 99.0)][::50]
    differences = (truth.rate(inside + 0.1) - truth.rate(inside - 0.1)) / 0.2
    found = rows[np.isin(t, inside), 8:11]
    np.testing.assert_allclose(found, differences, rtol=0, atol=1e-8)


def test_what_follows_is_position_velocity_and_control(to, truth):
    rows, names = read(to("basilisk"))
    t = rows[:, 0]
    assert names[11:17] == ["x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s"]
    np.testing.assert_allclose(rows[:, 11:14], truth.position(t), rtol=0, atol=1e-9)
    np.testing.assert_allclose(rows[:, 14:17], truth.velocity(t), rtol=0, atol=1e-9)
    assert names[17:] == ["fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm"]
    np.testing.assert_allclose(rows[:, 17:], truth.control(t), rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    "mistake",
    [lambda q: np.roll(q, -1, axis=-1), lambda q: q * [1, -1, -1, -1]],
    ids=["scalar last", "conjugate"],
)
def test_a_wrong_order_is_noticed(to, truth, mistake, monkeypatch):
    monkeypatch.setattr("berthing.export.samples.continuous", mistake)
    with pytest.raises(AssertionError, match="off by"):
        check(to("basilisk"), truth)


def test_no_meta_is_needed_and_the_file_says_so(to, pair_folder):
    meta = {"epoch": None, "frame": None, "centre": None}
    text = to("basilisk", source=pair_folder, vehicle="scout", extra_meta=meta).read_text()
    assert "Epoch: not given" in text
    assert "Frame: not named" in text
