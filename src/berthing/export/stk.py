"""What STK's ephemeris and attitude files have in common."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from berthing.errors import InputError
from berthing.export.ccsds import epoch_of
from berthing.export.handover import Handover
from berthing.geometry.arrays import Array

_MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
_AXES = {
    "EME2000": "J2000", "J2000": "J2000", "ICRF": "ICRF", "GCRF": "ICRF", "FIXED": "Fixed",
    "ITRF": "Fixed", "ITRF2000": "Fixed", "ITRF2008": "Fixed", "ITRF2014": "Fixed",
    "ITRF2020": "Fixed",
}  # fmt: skip
_BODIES = {
    name.upper(): name
    for name in (
        "Sun", "Mercury", "Venus", "Earth", "Moon", "Mars", "Phobos", "Deimos", "Jupiter", "Saturn",
        "Titan", "Uranus", "Neptune", "Pluto",
    )
}  # fmt: skip


def reference(handover: Handover, keyword: str, own_key: str) -> list[str]:
    """The lines that give central body and axes.

    A plan about a spacecraft needs a system of STK's own, which ``meta:`` gives under ``own_key``
    as STK writes it, such as ``Custom RIC Satellite/Station``; the body then is the Earth, or
    ``centre`` where that is a celestial body.

    Raises:
        InputError: neither a frame and a body that STK has built in, nor ``own_key``.
    """
    meta = handover.meta
    body = _BODIES.get((meta.centre or "").upper())
    given = meta.text(own_key)
    if given is not None:
        return [f"CentralBody {body or 'Earth'}", f"{keyword} {given}"]
    if body is None:
        raise InputError(
            f"{meta.where}.centre", f"is {meta.centre!r}, which is no celestial body of STK",
            f"a celestial body, or {own_key}: Custom NAME OBJECT",
        )  # fmt: skip
    axes = _AXES.get((meta.frame or "").upper())
    if axes is None:
        raise InputError(
            f"{meta.where}.frame", f"is {meta.frame!r}, which STK has not built in",
            f"one of: {', '.join(_AXES)}; or {own_key}: Custom NAME OBJECT",
        )  # fmt: skip
    return [f"CentralBody {body}", f"{keyword} {axes}"]


def _scenario_epoch(handover: Handover) -> str:
    """``ScenarioEpoch 1 Jan 2026 00:00:00.000000``, in UTC."""
    return f"ScenarioEpoch {_utcg(epoch_of(handover).utc)}"


def write_table(
    path: Path,
    handover: Handover,
    told: Sequence[str],
    kind: str,
    head: Sequence[str],
    columns: str,
    times_s: Array,
    rows: Array,
) -> None:
    """A file of one block: version, comments, and a table over time.

    Args:
        told: comments.
        kind: ``Ephemeris`` or ``Attitude``.
        head: lines of this kind alone, above the table.
        columns: what STK calls a table of these columns.
        times_s, rows: (k,) and (k, m), written to their last digit.
    """
    pairs = zip(times_s, rows.tolist(), strict=True)
    lines = [
        "stk.v.11.0", "", *(f"# {line}" for line in told), "", f"BEGIN {kind}", "",
        f"NumberOf{kind}Points {len(times_s)}", _scenario_epoch(handover), *head, "", columns, "",
        *(" ".join([f"{t:.6f}", *(f"{v:.16e}" for v in row)]) for t, row in pairs),
        "", f"END {kind}",
    ]  # fmt: skip
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def _utcg(stamp: datetime) -> str:
    clock = stamp.time().isoformat(timespec="microseconds")
    return f"{stamp.day} {_MONTHS[stamp.month - 1]} {stamp.year} {clock}"
