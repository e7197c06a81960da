import numpy as np
import pytest
import spiceypy
from scipy.spatial.transform import Rotation

from berthing.errors import InputError
from support.leap_seconds import leap_seconds_loaded
from support.plan_folder import assert_rotations

CARRIER, FRAME = -100001, -100001000


@pytest.fixture
def kernels(tmp_path):
    """Loads kernels, for one test only."""
    with leap_seconds_loaded(tmp_path):
        yield lambda *paths: [spiceypy.furnsh(str(path)) for path in paths]


def start():
    return spiceypy.str2et("2026-03-01T12:34:56.789")


def check_ck(path, kernels, truth):
    kernels(path, f"{path}.tf")
    matrices, rates, times = [], [], np.linspace(0.0, 100.0, 1001)
    for t in times:
        matrix, rate, stamp = spiceypy.ckgpav(FRAME, 1e6 * t, 0.0, "J2000")
        assert stamp == pytest.approx(1e6 * t)
        matrices.append(matrix)
        rates.append(rate)
    # The C-matrix takes components of the frame to those of the instrument.
    found = Rotation.from_matrix(np.array(matrices)).inv()
    assert_rotations(found, truth.rotation(times))
    np.testing.assert_allclose(
        found.inv().apply(np.array(rates)), truth.rate(times), rtol=0, atol=1e-9
    )


def test_spk_reads_back(to, kernels, truth):
    path = to("spk")
    kernels(path)
    first, last = spiceypy.wnfetd(spiceypy.spkcov(str(path), CARRIER), 0)
    assert first == pytest.approx(start(), abs=2e-7)
    assert last - first == pytest.approx(100.0, abs=1e-6)
    times = first + np.linspace(0.0, 100.0, 1001)
    times[-1] = last
    states = np.array([spiceypy.spkgeo(CARRIER, t, "J2000", 399)[0] for t in times])
    t = times - first
    # Cubics between samples; and the start is known to 1e-7 s, at 0.2 m/s.
    np.testing.assert_allclose(1e3 * states[:, :3], truth.position(t), rtol=0, atol=3e-8)
    np.testing.assert_allclose(1e3 * states[:, 3:], truth.velocity(t), rtol=0, atol=1e-9)


def test_spk_holds_its_own_samples_to_the_nanometre(to, kernels, truth):
    from berthing.export.epoch import parse_epoch

    path = to("spk")
    kernels(path)
    begin = parse_epoch("2026-03-01T12:34:56.789Z", None, "").tdb_s
    t = np.array([0.0, 12.5, 37.5, 62.5, 100.0])
    exact = (begin + t) - begin
    states = np.array([spiceypy.spkgeo(CARRIER, x, "J2000", 399)[0] for x in begin + t])
    np.testing.assert_allclose(1e3 * states[:, :3], truth.position(exact), rtol=0, atol=1e-9)


def test_spk_may_be_about_a_spacecraft(to, kernels):
    meta = {"centre": "STATION", "naif_ids": {"carrier": CARRIER, "STATION": -25544}}
    path = to("spk", extra_meta=meta)
    kernels(path)
    assert spiceypy.spkgeo(CARRIER, start() + 50.0, "J2000", -25544)[0][0] > 0.0


def test_ck_reads_back(to, kernels, truth):
    check_ck(to("ck"), kernels, truth)


@pytest.mark.parametrize(
    "mistake", [lambda q: q, lambda q: np.roll(q, -1, axis=-1)], ids=["not conjugate", "last"]
)
def test_ck_in_a_wrong_order_is_noticed(to, kernels, truth, mistake, monkeypatch):
    monkeypatch.setattr("berthing.export.ck.spice_quaternion", mistake)
    with pytest.raises(AssertionError):
        check_ck(to("ck"), kernels, truth)


def test_ck_brings_clock_and_frame(to, kernels, truth):
    path = to("ck")
    kernels(path, f"{path}.tf")
    # By name and ephemeris time, as it is used: from the body's components to J2000's.
    t = np.linspace(1.0, 99.0, 50)
    found = [spiceypy.pxform("BERTHING_CARRIER", "J2000", start() + s) for s in t]
    assert_rotations(Rotation.from_matrix(np.array(found)), truth.rotation(t), 1e-8)


@pytest.mark.parametrize(("name", "opened"), [("spk", "dafopr"), ("ck", "dafopr")])
def test_kernels_have_comments(to, name, opened):
    handle = getattr(spiceypy, opened)(str(to(name)))
    _, lines, done = spiceypy.dafec(handle, 100, 300)
    spiceypy.dafcls(handle)
    text = " ".join(lines)
    assert done
    for said in ("EME2000", "2026-03-01T12:34:56.789000 UTC", "polynomials of time", "Outcome"):
        assert said in text
    assert ("conjugate" in text) == (name == "ck")


@pytest.mark.parametrize(
    ("meta", "said"),
    [
        ({"frame": "RTN"}, "SPICE has not built in"),
        ({"centre": "STATION"}, "NAIF id is not known"),
        ({"naif_ids": {"carrier": "minus one"}}, "a NAIF id"),
        ({"naif_ids": {}}, "a NAIF id"),
    ],
)
def test_spk_refuses_what_spice_does_not_know(to, tmp_path, meta, said):
    with pytest.raises(InputError, match=said):
        to("spk", extra_meta=meta)
    assert list(tmp_path.iterdir()) == []


def test_ck_refuses_the_id_of_no_spacecraft(to):
    with pytest.raises(InputError, match="no spacecraft"):
        to("ck", extra_meta={"naif_ids": {"carrier": 399}})


def test_one_id_for_two_is_refused(to, pair_folder):
    meta = {"naif_ids": {"carrier": -5, "scout": -5, "puck": -6}}
    with pytest.raises(InputError, match="one id each"):
        to("spk", source=pair_folder, extra_meta=meta)
