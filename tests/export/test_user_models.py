"""Plans of vehicles with dynamics of the user's own: their poses come from their code."""

import numpy as np
import pytest
from brahe.ccsds import AEM, OEM
from scipy.spatial.transform import Rotation

from berthing.errors import InputError
from berthing.export.exporting import export
from berthing.export.formats import FORMATS
from berthing.scenario.files import load
from support import documents, plan_folder, users
from support.plan_folder import assert_rotations

SPEED_M_S, STEERING_RAD = 0.1, 0.2
META = {**plan_folder.META, "object_ids": {"rover": "R"}}
ROVER = """
schema_version: 1
name: rover
horizon: {duration_s: 100}
margins: {default_m: 0.1}
vehicles:
  - name: rover
    parts: [{name: hull, shape: {type: box, size_m: [1.6, 0.8]}}]
    dynamics: {model: user, file: rover.py, name: rover}
    start: {position_m: [0, 0]}
    goal: {position_m: [8, 3], rate_rad_s: free}
"""


def heading(t):
    return 0.5 + SPEED_M_S * np.tan(STEERING_RAD) * t


def round_the_bend(t, shift_m):
    radius = 1.0 / np.tan(STEERING_RAD)
    turned = heading(t)
    still = np.ones_like(t)
    return np.stack(
        [
            radius * np.sin(turned), -radius * np.cos(turned), turned, SPEED_M_S * still,
            STEERING_RAD * still,
        ],
        axis=-1,
    )  # fmt: skip


@pytest.fixture
def rover(tmp_path):
    (tmp_path / "rover.py").write_text(users.ROVER_CODE)
    (tmp_path / "rover.yaml").write_text(ROVER)
    scenario = load(tmp_path / "rover.yaml")
    return plan_folder.write(tmp_path / "plan", scenario, along=round_the_bend)


def test_code_is_not_run_unasked(rover, tmp_path):
    with pytest.raises(InputError, match="--trust"):
        export(rover, FORMATS["mat"], tmp_path / "out.mat")


def test_a_planar_pose_and_its_rates_read_back(rover, tmp_path):
    options = {"extra_meta": META, "trust": True}
    (oem,) = export(rover, FORMATS["oem"], tmp_path / "out.oem", **options)
    (segment,) = OEM.from_file(str(oem)).segments
    t = np.array([s.epoch - segment.start_time for s in segment.states])
    velocities = np.array([s.velocity for s in segment.states])
    along = np.stack([np.cos(heading(t)), np.sin(heading(t)), 0 * t], axis=-1)
    np.testing.assert_allclose(velocities, SPEED_M_S * along, rtol=0, atol=1e-9)
    assert t[-1] == documents.DURATION_S
    (aem,) = export(rover, FORMATS["aem"], tmp_path / "out.aem", **options)
    message = AEM.from_file(str(aem))
    motion = message.segment_to_attitude_trajectory(0)
    epochs = [s.epoch for s in message.segments[0].states]
    found = Rotation.from_matrix([motion.rotation_matrix(e).to_matrix() for e in epochs]).inv()
    assert_rotations(found, Rotation.from_rotvec(np.outer(heading(t), [0, 0, 1])), 1e-8)
    rates = np.array([motion.angular_velocity(e) for e in epochs])
    expected = [0.0, 0.0, SPEED_M_S * np.tan(STEERING_RAD)]
    np.testing.assert_allclose(rates, np.tile(expected, (len(t), 1)), rtol=0, atol=1e-9)


def test_basilisk_wants_a_derivative_that_the_state_does_not_have(rover, tmp_path):
    with pytest.raises(InputError, match="no body rates"):
        export(rover, FORMATS["basilisk"], tmp_path / "out.csv", trust=True)
