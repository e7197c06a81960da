import re

import numpy as np
import pytest
from brahe.ccsds import AEM, OEM
from scipy.spatial.transform import Rotation

from support.plan_folder import Truth, assert_rotations


def seconds(epochs, start):
    return np.array([epoch - start for epoch in epochs])


def check_aem(path, truth):
    """Reads with brahe: matrices from the frame's components to the body's."""
    message = AEM.from_file(str(path))
    (segment,) = message.segments
    epochs = [state.epoch for state in segment.states]
    t = seconds(epochs, segment.start_time)
    motion = message.segment_to_attitude_trajectory(0)
    matrices = np.array([motion.rotation_matrix(e).to_matrix() for e in epochs])
    assert_rotations(Rotation.from_matrix(matrices).inv(), truth.rotation(t))
    rates = np.array([motion.angular_velocity(e) for e in epochs])
    np.testing.assert_allclose(rates, truth.rate(t), atol=1e-9)
    return segment, motion


def test_oem_reads_back(to, truth):
    (segment,) = OEM.from_file(str(to("oem"))).segments
    t = seconds([s.epoch for s in segment.states], segment.start_time)
    assert (t[0], t[-1]) == (0.0, 100.0)
    assert len(t) >= 1001
    found = np.array([s.position for s in segment.states])
    np.testing.assert_allclose(found, truth.position(t), rtol=0, atol=1e-9)
    found = np.array([s.velocity for s in segment.states])
    np.testing.assert_allclose(found, truth.velocity(t), rtol=0, atol=1e-9)


def test_oem_says_what_it_is(to):
    path = to("oem")
    (segment,) = OEM.from_file(str(path)).segments
    assert segment.object_name == "MODULE CARRIER"
    assert segment.object_id == "2026-001A"
    assert segment.center_name == "EARTH"
    assert segment.ref_frame == "EME2000"
    assert segment.time_system == "UTC"
    assert str(segment.start_time).startswith("2026-03-01 12:34:56.789")
    text = path.read_text(encoding="ascii")
    for said in ("km and km/s", "polynomials of time", "Outcome: certified", "reference point"):
        assert said in text
    assert max(map(len, text.splitlines())) <= 254


def test_oem_is_in_kilometres(to, truth):
    """Read as metres, it would be a thousand times too small."""
    line = to("oem").read_text(encoding="ascii").splitlines()[-1]
    np.testing.assert_allclose(
        1e3 * np.array(line.split()[1:4], dtype=float), truth.position(np.array([100.0]))[0]
    )


def test_aem_reads_back(to, truth):
    segment, motion = check_aem(to("aem"), truth)
    assert (segment.ref_frame_a, segment.ref_frame_b) == ("EME2000", "SC_BODY_1")
    # Between samples as the file says to interpolate, 0.05 s from each.
    t = np.arange(0.15, 99.9, 0.7)
    found = [motion.rotation_matrix(segment.start_time + s).to_matrix() for s in t]
    assert_rotations(Rotation.from_matrix(np.array(found)).inv(), truth.rotation(t), 1e-8)


def test_aem_in_a_wrong_order_is_noticed(to, truth, wrong_order, monkeypatch):
    monkeypatch.setattr("berthing.export.aem.scalar_last", wrong_order)
    with pytest.raises(AssertionError, match="off by"):
        check_aem(to("aem"), truth)


def test_every_vehicle_has_a_segment(to, pair_folder):
    meta = {"object_ids": {"carrier": "A", "scout": "B", "puck": "C"}}
    found = OEM.from_file(str(to("oem", source=pair_folder, extra_meta=meta))).segments
    assert [s.object_id for s in found] == ["A", "B", "C"]
    t = np.array([state.epoch - found[1].start_time for state in found[1].states])
    positions = np.array([state.position for state in found[1].states])
    np.testing.assert_allclose(positions, Truth(pair_folder, "scout").position(t), atol=1e-9)


@pytest.mark.parametrize("scale", ["TAI", "TT", "TDB", "GPS"])
def test_other_time_systems_pass_as_they_are(to, scale):
    meta = {"epoch": "2026-03-01T12:34:56.789", "time_system": scale}
    text = to("oem", extra_meta=meta).read_text(encoding="ascii")
    assert f"TIME_SYSTEM = {scale}\n" in text
    assert re.search(r"^START_TIME = 2026-03-01T12:34:56.789000$", text, re.MULTILINE)


def test_a_long_comment_is_broken_at_spaces():
    from berthing.export.ccsds import LONGEST_LINE, comments

    lines = comments(["word " * 200])
    assert len(lines) > 1
    assert max(map(len, lines)) <= LONGEST_LINE
    assert " ".join(line.removeprefix("COMMENT ") for line in lines).split() == ["word"] * 200
