"""Clocks: when t = 0 is, in the time scale that was given and in those that formats want.

Stamps are kept to the microsecond, which is what ``datetime`` and most readers hold.
"""

from __future__ import annotations

import math
import re
from bisect import bisect_right
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from berthing.errors import InputError

SCALES = ("UTC", "TAI", "TT", "TDB", "GPS")
J2000 = datetime(2000, 1, 1, 12)
TT_MINUS_TAI_S = 32.184
TAI_MINUS_GPS_S = 19.0

# TAI − UTC in whole seconds from each of these days on (IERS Bulletin C; none has been announced
# since). Before 1972 the difference was not whole.
_LEAPS = (
    (1972, 1, 10), (1972, 7, 11), (1973, 1, 12), (1974, 1, 13), (1975, 1, 14), (1976, 1, 15),
    (1977, 1, 16), (1978, 1, 17), (1979, 1, 18), (1980, 1, 19), (1981, 7, 20), (1982, 7, 21),
    (1983, 7, 22), (1985, 7, 23), (1988, 1, 24), (1990, 1, 25), (1991, 1, 26), (1992, 7, 27),
    (1993, 7, 28), (1994, 7, 29), (1996, 1, 30), (1997, 7, 31), (1999, 1, 32), (2006, 1, 33),
    (2009, 1, 34), (2012, 7, 35), (2015, 7, 36), (2017, 1, 37),
)  # fmt: skip
LEAP_DAYS = tuple(datetime(year, month, 1) for year, month, _ in _LEAPS)

# TDB − TT = K sin E, E = M + EB sin M, M = M0 + M1 t: the periodic term of the Earth's orbit, good
# to 3e-5 s. Constants as in NAIF's leap second kernels, so that SPICE and we agree to rounding.
_K, _EB, _M0, _M1 = 1.657e-3, 1.671e-2, 6.239996, 1.99096871e-7

_STAMP = re.compile(r"\d{4}-\d{2}-\d{2}([T ]\d{2}:\d{2}(:\d{2}(\.\d{1,6})?)?(Z|[+-]\d{2}:\d{2})?)?")


@dataclass(frozen=True)
class Epoch:
    """The instant t = 0.

    Attributes:
        stamp: its date and time, without a zone.
        scale: one of ``SCALES``, in which ``stamp`` counts.
    """

    stamp: datetime
    scale: str

    def at(self, t_us: int) -> datetime:
        """The stamp of t in microseconds, in the same scale."""
        return self.stamp + timedelta(microseconds=int(t_us))

    def iso(self, t_us: int = 0) -> str:
        """``2026-01-01T00:00:00.000000``, in the epoch's own scale."""
        return self.at(t_us).isoformat(timespec="microseconds")

    @property
    def tdb_s(self) -> float:
        """Seconds of TDB past J2000 (SPICE's ET) of t = 0."""
        if self.scale == "TDB":
            return (self.stamp - J2000).total_seconds()
        tt = (self.stamp - J2000).total_seconds() + self._tai_offset_s() + TT_MINUS_TAI_S
        return tt + _tdb_minus_tt(tt)

    @property
    def utc(self) -> datetime:
        """The stamp of t = 0 in UTC, to the microsecond.

        Raises:
            InputError: before 1972.
        """
        if self.scale == "UTC":
            return self.stamp
        # TDB − TT changes by less than 1e-12 s over itself, so the first step is enough.
        tdb = self.tdb_s
        tai = J2000 + timedelta(seconds=tdb - _tdb_minus_tt(tdb) - TT_MINUS_TAI_S)
        guess = tai - timedelta(seconds=_leap_seconds(tai))
        return tai - timedelta(seconds=_leap_seconds(guess))

    def check_span(self, seconds: float) -> None:
        """InputError where a leap second falls into the plan: UTC stamps would jump there."""
        if self.scale != "UTC":
            return
        end = self.stamp + timedelta(seconds=seconds)
        if _leap_seconds(self.stamp) != _leap_seconds(end):
            what = "is in UTC, and a leap second falls into the plan"
            raise InputError("meta.epoch", what, "an epoch in TAI, with time_system: TAI")

    def _tai_offset_s(self) -> float:
        """TAI minus the epoch's scale, at t = 0; not for TDB."""
        fixed = {"TAI": 0.0, "TT": -TT_MINUS_TAI_S, "GPS": TAI_MINUS_GPS_S}
        return fixed[self.scale] if self.scale in fixed else _leap_seconds(self.stamp)


def parse_epoch(text: object, scale: object, where: str) -> Epoch:
    """An epoch from ``meta:``.

    Args:
        text: ISO 8601, to the microsecond at most. With a zone it is UTC.
        scale: one of ``SCALES``; None for UTC.
        where: for errors.

    Raises:
        InputError: another text, another scale, or a zone with a scale other than UTC.
    """
    expected = "ISO 8601 such as 2026-01-01T12:00:00.000000Z, as text"
    if not isinstance(text, str) or not _STAMP.fullmatch(text.strip()):
        raise InputError(f"{where}.epoch", f"is {text!r}", expected)
    try:
        stamp = datetime.fromisoformat(text.strip())
    except ValueError as error:
        raise InputError(f"{where}.epoch", f"is {text!r}: {error}", expected) from None
    named = "UTC" if scale is None else str(scale).upper()
    if named not in SCALES:
        raise InputError(f"{where}.time_system", f"is {scale!r}", f"one of: {', '.join(SCALES)}")
    if stamp.tzinfo is not None:
        if named != "UTC":
            what = f"is {text!r}, which has a zone, and time_system is {named}"
            raise InputError(f"{where}.epoch", what, "no zone, or UTC")
        stamp = stamp.astimezone(UTC).replace(tzinfo=None)
    return Epoch(stamp, named)


def _leap_seconds(utc: datetime) -> float:
    index = bisect_right(LEAP_DAYS, utc) - 1
    if index < 0:
        raise InputError("meta.epoch", f"is {utc.date()}, before UTC had whole seconds", "1972 on")
    return float(_LEAPS[index][2])


def _tdb_minus_tt(past_j2000_s: float) -> float:
    mean = _M0 + _M1 * past_j2000_s
    return _K * math.sin(mean + _EB * math.sin(mean))
