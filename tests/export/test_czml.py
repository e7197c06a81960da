"""Read with czml3; where the Earth is turned to, with SPICE."""

import json

import czml3
import numpy as np
import pytest
import spiceypy
from scipy.spatial.transform import Rotation

from berthing.errors import InputError
from support.plan_folder import Truth, assert_rotations

SITE = {"longitude_deg": 12.5, "latitude_deg": -33.0, "height_m": 400e3}
# pck00011.tpc's model of the Earth, which is the IAU's.
EARTH = """KPL/PCK
\\begindata
BODY399_POLE_RA = ( 0. -0.641 0. )
BODY399_POLE_DEC = ( 90. -0.557 0. )
BODY399_PM = ( 190.147 360.9856235 0. )
BODY399_RADII = ( 6378.137 6378.137 6356.752314245 )
\\begintext
"""


@pytest.fixture
def earth(tmp_path):
    kernel = tmp_path / "earth.tpc"
    kernel.write_text(EARTH)
    with spiceypy.KernelPool([str(kernel)]):
        yield
    spiceypy.kclear()


def read(path):
    """Packets by id, checked by czml3 against the format."""
    packets = czml3.Document.load(str(path)).packets
    return {packet.id: packet for packet in packets}


def values(thing, key, width):
    """Times (k,) and rows (k, width); None and one row for a value that does not change."""
    found = np.array(getattr(thing, key).values, dtype=float)
    if len(found) == width:
        return None, found[None]
    rows = found.reshape(-1, width + 1)
    return rows[:, 0], rows[:, 1:]


def position(packet):
    """Times (k,), None for one that stays, and Earth-fixed positions (k, 3)."""
    assert packet.position.referenceFrame == "FIXED"
    return values(packet.position, "cartesian", 3)


def attitude(packet):
    """Times (k,), None for one that stays, and rotations from body to Earth-fixed components."""
    t, q = values(packet.orientation, "unitQuaternion", 4)
    return t, Rotation.from_quat(q)


def site_frame():
    """East, north, up as columns, and the site; by SPICE's geodesy."""
    lon, lat = np.radians([SITE["longitude_deg"], SITE["latitude_deg"]])
    at = spiceypy.georec(lon, lat, SITE["height_m"] / 1e3, 6378.137, 1 / 298.257223563)
    up = spiceypy.surfnm(6378.137, 6378.137, 6378.137 * (1 - 1 / 298.257223563), spiceypy.georec(
        lon, lat, 0.0, 6378.137, 1 / 298.257223563
    ))  # fmt: skip
    east = np.cross([0.0, 0.0, 1.0], up)
    east /= np.linalg.norm(east)
    return Rotation.from_matrix(np.column_stack([east, np.cross(up, east), up])), 1e3 * at


def check_at_site(path, truth):
    packet = read(path)["carrier"]
    t, r = position(packet)
    turn, origin = site_frame()
    # Doubles of the Earth's radius are 1e-9 m apart.
    np.testing.assert_allclose(r, origin + turn.apply(truth.position(t)), rtol=0, atol=5e-9)
    t, q = attitude(packet)
    assert (t[0], t[-1]) == (0.0, 100.0)
    assert_rotations(q, turn * truth.rotation(t))
    return q


def test_a_scene_at_a_site_reads_back(to, truth):
    check_at_site(to("czml", extra_meta={"site": SITE, "frame": "RTN", "centre": "STATION"}), truth)


def test_attitudes_are_far_enough_apart_for_cesium(to, truth):
    q = check_at_site(to("czml", extra_meta={"site": SITE}), truth)
    steps = (q[:-1].inv() * q[1:]).magnitude()
    # 1 − cos(θ/2) below 1e-6 is no turn to Cesium.
    assert np.min(1.0 - np.cos(steps / 2)) > 1e-6
    assert np.max(steps) < 0.02


def test_a_wrong_order_is_noticed(to, truth, wrong_order, monkeypatch):
    monkeypatch.setattr("berthing.export.czml.scalar_last", wrong_order)
    with pytest.raises(AssertionError, match="off by"):
        check_at_site(to("czml", extra_meta={"site": SITE}), truth)


@pytest.mark.parametrize("frame", ["EME2000", "ICRF", "GCRF"])
def test_inertial_frames_are_turned_as_spice_does(to, truth, earth, frame):
    meta = {"frame": frame, "epoch": "2026-03-01T12:34:56.789", "time_system": "TDB"}
    packet = read(to("czml", extra_meta=meta))["carrier"]
    start = spiceypy.tparse("2026-03-01 12:34:56.789")[0]

    def turn(times):
        found = [spiceypy.pxform("J2000", "IAU_EARTH", start + s) for s in times]
        return Rotation.from_matrix(np.array(found))

    t, r = position(packet)
    np.testing.assert_allclose(r, turn(t).apply(truth.position(t)), rtol=0, atol=1e-9)
    t, q = attitude(packet)
    assert_rotations(q, turn(t) * truth.rotation(t))


def test_an_earth_fixed_frame_stays_as_it_is(to, truth):
    packet = read(to("czml", extra_meta={"frame": "ITRF2020"}))["carrier"]
    t, r = position(packet)
    np.testing.assert_allclose(r, truth.position(t), rtol=0, atol=1e-9)
    t, q = attitude(packet)
    assert_rotations(q, truth.rotation(t))


@pytest.mark.parametrize("meta", [{"centre": "STATION"}, {"frame": "RTN"}])
def test_a_frame_that_is_not_the_earths_needs_a_site(to, meta):
    with pytest.raises(InputError, match="longitude_deg"):
        to("czml", extra_meta=meta)


@pytest.mark.parametrize(
    "site", [3, {}, {**SITE, "latitude_deg": 91}, {**SITE, "height_m": "high"}]
)
def test_a_bad_site_is_refused(to, site):
    with pytest.raises(InputError, match="site"):
        to("czml", extra_meta={"site": site})


def test_structures_and_parts_are_there(to):
    found = read(to("czml", extra_meta={"site": SITE}))
    turn, origin = site_frame()
    block = found["block/core"]
    assert block.box.dimensions.cartesian.values == [1.0, 2.0, 3.0]
    _, r = position(block)
    np.testing.assert_allclose(r[0], origin + turn.apply([40.0, 0.0, 0.0]), rtol=0, atol=5e-9)
    assert_rotations(attitude(block)[1], turn)
    # A beam along its own y that turns about z; CZML's cylinders lie along z.
    beam = found["spinner/core"]
    assert (beam.cylinder.length, beam.cylinder.topRadius) == (4.0, 0.3)
    t, q = attitude(beam)
    angle = 0.01 * t
    along = np.stack([-np.sin(angle), np.cos(angle), 0.0 * angle], axis=-1)
    np.testing.assert_allclose(q.apply([0, 0, 1]), turn.apply(along), atol=1e-9)
    assert "rock/core" not in found


def test_a_vehicles_parts_go_with_it(to):
    found = read(to("czml", extra_meta={"site": SITE}))
    hull = found["carrier/hull"]
    assert hull.box.dimensions.cartesian.values == [4.0, 2.0, 2.0]
    for own, whole in zip(position(hull), position(found["carrier"]), strict=True):
        np.testing.assert_array_equal(own, whole)
    assert_rotations(attitude(hull)[1], attitude(found["carrier"])[1])


def test_phases_show_their_own_parts(to, phases_folder):
    found = read(to("czml", source=phases_folder, extra_meta={"site": SITE}))
    assert found["carrier/hull (out)"].availability != found["carrier/hull (on)"].availability
    t, r = position(found["carrier"])
    assert np.all(np.diff(t) > 0)
    assert (t[0], t[-1]) == (0.0, 200.0)
    turn, origin = site_frame()
    true = Truth(phases_folder).position(t)
    np.testing.assert_allclose(r, origin + turn.apply(true), rtol=0, atol=5e-9)


def test_the_file_says_what_it_is(to):
    document = json.loads(to("czml", extra_meta={"site": SITE}).read_text())[0]
    assert document["clock"]["currentTime"] == "2026-03-01T12:34:56.789000Z"
    for said in ("scalar last", "EME2000", "polynomials of time", "meta.site", "Outcome"):
        assert said in document["description"]
