"""What SPICE's binary kernels have in common: names, identities, comments."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from berthing.errors import InputError
from berthing.export.ccsds import epoch_of
from berthing.export.extras import extra
from berthing.export.handover import Handover

# SPICE does not tell these apart: its J2000 is the ICRF.
_FRAMES = dict.fromkeys(("EME2000", "J2000", "ICRF", "GCRF"), "J2000")
# Of a segment's name.
LONGEST_SEGMENT_NAME = 40


def toolkit() -> Any:
    """The module; InputError where it is not installed."""
    return extra("spiceypy")


def frame_of(handover: Handover) -> str:
    """The frame by the name that SPICE knows it by.

    Raises:
        InputError: SPICE has no such frame built in.
    """
    frame = handover.meta.frame or ""
    name = _FRAMES.get(frame.upper(), frame.upper())
    if not name or toolkit().namfrm(name) == 0:
        what = f"is {frame!r}, which SPICE has not built in"
        raise InputError(
            f"{handover.meta.where}.frame", what, "EME2000, ICRF, GCRF, ECLIPJ2000 or the like"
        )
    return name


def body_id(handover: Handover, vehicle: str) -> int:
    """The NAIF id of a vehicle; InputError where there is none or another has it too."""
    meta = handover.meta
    own = meta.naif_id(vehicle)
    if own is None:
        raise InputError(meta.where, f"lacks naif_ids.{vehicle}", "a NAIF id")
    for other in handover.vehicles:
        if other != vehicle and meta.naif_id(other) == own:
            raise InputError(
                f"{meta.where}.naif_ids", f"gives {own} to {other} and {vehicle}", "one id each"
            )
    return own


def centre_id(handover: Handover) -> int:
    """The NAIF id of the centre: from ``meta:``, or of a body that SPICE knows.

    Raises:
        InputError: neither.
    """
    centre = handover.meta.centre or ""
    given = handover.meta.naif_id(centre)
    if given is not None:
        return given
    spice = toolkit()
    try:
        return int(spice.bodn2c(centre))
    except spice.utils.exceptions.NotFoundError:
        what = f"is {centre!r}, whose NAIF id is not known"
        expected = f"a celestial body, or naif_ids: {{{centre}: ID}}"
        raise InputError(f"{handover.meta.where}.centre", what, expected) from None


def ephemeris_time(handover: Handover) -> float:
    """Seconds of TDB past J2000 at t = 0.

    A second of the plan counts as one of TDB: the scales drift by 3e-10, 5e-8 s in 150 s.
    """
    return epoch_of(handover).tdb_s


def segment_name(vehicle: str, phase: str) -> str:
    """At most as long as SPICE allows."""
    return f"{vehicle} {phase}"[:LONGEST_SEGMENT_NAME]


@contextmanager
def closing(close: Any, handle: int) -> Iterator[None]:
    """Close a kernel in any case, and pass on the first error.

    A kernel that got no segment cannot be closed properly; that error would hide the true one.
    """
    try:
        yield
    except BaseException:
        spice = toolkit()
        spice.dafcls(handle)
        raise
    close(handle)


def add_comments(handle: int, lines: Sequence[str]) -> None:
    """Write the comment area of a kernel."""
    toolkit().dafac(handle, list(lines))
