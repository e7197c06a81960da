from datetime import datetime

import pytest
import spiceypy

from berthing.errors import InputError
from berthing.export.epoch import SCALES, Epoch, parse_epoch
from support.leap_seconds import leap_seconds_loaded


@pytest.fixture
def leap_seconds(tmp_path):
    with leap_seconds_loaded(tmp_path):
        yield


def epoch(text, scale=None):
    return parse_epoch(text, scale, "meta")


@pytest.mark.parametrize(
    "date", ["1999-06-30", "2008-12-31", "2016-12-31", "2017-01-01", "2031-07-01"]
)
def test_utc_is_as_spice_counts_it(leap_seconds, date):
    text = f"{date}T12:34:56.789012"
    assert epoch(text).tdb_s == pytest.approx(spiceypy.str2et(text), abs=2e-7)


@pytest.mark.parametrize("scale", ["TT", "TDB"])
def test_uniform_scales_are_as_spice_counts_them(leap_seconds, scale):
    text = "2026-03-01 12:34:56.789012"
    said = {"TT": "TDT"}.get(scale, scale)
    assert epoch(text, scale).tdb_s == pytest.approx(spiceypy.str2et(f"{text} {said}"), abs=2e-7)


@pytest.mark.parametrize(
    ("scale", "text"),
    [
        ("UTC", "2026-01-01T00:00:00"),
        ("TAI", "2026-01-01T00:00:37"),
        ("TT", "2026-01-01T00:01:09.184"),
        ("GPS", "2026-01-01T00:00:18"),
    ],
)
def test_one_instant_in_every_scale(scale, text):
    assert epoch(text, scale).utc == datetime(2026, 1, 1)
    assert epoch(text, scale).tdb_s == pytest.approx(epoch("2026-01-01T00:00:00Z").tdb_s)


def test_tdb_is_turned_to_utc_and_back():
    start = epoch("2026-05-01T00:00:00Z")
    stamp = datetime(2000, 1, 1, 12).timestamp() + start.tdb_s
    tdb = Epoch(datetime.fromtimestamp(stamp), "TDB")
    assert abs((tdb.utc - start.stamp).total_seconds()) <= 1e-6


def test_a_zone_is_turned_to_utc():
    assert epoch("2026-03-01T14:00:00+02:00").iso() == "2026-03-01T12:00:00.000000"
    assert epoch("2026-03-01").iso(1_500_000) == "2026-03-01T00:00:01.500000"


@pytest.mark.parametrize(
    ("text", "scale"),
    [
        (2026, None),
        ("tomorrow", None),
        ("2026-13-01T00:00:00Z", None),
        ("2026-03-01T12:00:00.1234567Z", None),
        ("2026-03-01T12:00:00Z", "TAI"),
        ("2026-03-01T12:00:00", "LOCAL"),
    ],
)
def test_what_is_no_epoch_is_refused(text, scale):
    with pytest.raises(InputError, match="meta"):
        epoch(text, scale)


def test_utc_before_1972_is_refused():
    with pytest.raises(InputError, match="1972"):
        _ = epoch("1969-07-20T20:17:40Z").tdb_s


def test_a_leap_second_in_the_plan_is_refused():
    late = epoch("2016-12-31T23:59:00Z")
    late.check_span(30.0)
    with pytest.raises(InputError, match="leap second"):
        late.check_span(100.0)
    epoch("2016-12-31T23:59:00", "TAI").check_span(100.0)


def test_there_are_five_scales():
    assert SCALES == ("UTC", "TAI", "TT", "TDB", "GPS")
