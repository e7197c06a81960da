"""What CCSDS messages in keyword-value notation have in common (502.0-B-2, 504.0-B-2)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path

from berthing.errors import InputError
from berthing.export.epoch import Epoch
from berthing.export.handover import Handover, Track
from berthing.geometry.arrays import Array

# 502.0-B-2, 7.3: lines of at most 254 characters, end excluded.
LONGEST_LINE = 254
# The standard's names of frames that go by others too.
_FRAMES = {"J2000": "EME2000", "ICRF": "ICRF", "GCRF": "GCRF"}


def header(version_keyword: str, handover: Handover, lines: Iterable[str]) -> list[str]:
    """The message's head, with comments where the standard has them: below the version."""
    now = datetime.now(UTC).replace(tzinfo=None).isoformat(timespec="seconds")
    return [
        f"{version_keyword} = 2.0",
        *comments(lines),
        f"CREATION_DATE = {now}",
        f"ORIGINATOR = {handover.meta.text('originator') or 'BERTHING'}",
    ]


def write_message(
    path: Path,
    version_keyword: str,
    handover: Handover,
    told: Iterable[str],
    segment: Callable[[Handover, Track], Iterable[str]],
) -> None:
    """A whole message: its head, and a segment for each vehicle and phase."""
    lines = header(version_keyword, handover, told)
    for track in handover.tracks:
        lines += ["", *segment(handover, track)]
    write_lines(path, lines)


def metadata(
    handover: Handover, track: Track, frames: Sequence[str], rest: Sequence[str]
) -> list[str]:
    """A segment's metadata block.

    Args:
        frames, rest: the lines of one kind of message alone: about frames, and at the end.

    Raises:
        InputError: ``meta:`` lacks the epoch, the centre or the object's id.
    """
    epoch, times = epoch_of(handover), track.samples.t_us
    return [
        "META_START",
        f"OBJECT_NAME = {handover.meta.object_name(track.name)}",
        f"OBJECT_ID = {handover.meta.object_id(track.name)}",
        f"CENTER_NAME = {centre_of(handover)}",
        *frames,
        f"TIME_SYSTEM = {epoch.scale}",
        f"START_TIME = {epoch.iso(times[0])}",
        f"STOP_TIME = {epoch.iso(times[-1])}",
        *rest,
        "META_STOP",
    ]


def data(handover: Handover, track: Track, rows: Array) -> Iterator[str]:
    """Lines of time and numbers, of ``rows`` (k, m) at the track's samples."""
    epoch = epoch_of(handover)
    for t_us, row in zip(track.samples.t_us, rows, strict=True):
        yield " ".join([epoch.iso(t_us), *(number(v) for v in row)])


def comments(lines: Iterable[str]) -> list[str]:
    """Each line as a comment, broken at spaces where it is too long."""
    return [f"COMMENT {piece}" for line in lines for piece in _broken(line)]


def epoch_of(handover: Handover) -> Epoch:
    """The epoch; InputError without one."""
    epoch = handover.meta.epoch
    if epoch is None:
        raise InputError(handover.meta.where, "lacks epoch")
    return epoch


def frame_of(handover: Handover) -> str:
    """The frame in the standard's spelling; another name passes as it is, for an agreement of use.

    Raises:
        InputError: not given.
    """
    frame = handover.meta.frame
    if frame is None:
        raise InputError(handover.meta.where, "lacks frame")
    return _FRAMES.get(frame.upper(), frame.upper())


def centre_of(handover: Handover) -> str:
    """The centre in capitals; InputError without one."""
    centre = handover.meta.centre
    if centre is None:
        raise InputError(handover.meta.where, "lacks centre")
    return centre.upper()


def number(value: float) -> str:
    """Sixteen significant digits, the most that the standard allows (502.0-B-2, 7.5)."""
    return f"{value:.15e}"


def write_lines(path: Path, lines: Iterable[str]) -> None:
    """Write ASCII lines."""
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def _broken(line: str) -> list[str]:
    words, pieces = line.split(" "), [""]
    for word in words:
        longer = f"{pieces[-1]} {word}".strip()
        if len(longer) > LONGEST_LINE - len("COMMENT ") and pieces[-1]:
            pieces.append(word)
        else:
            pieces[-1] = longer
    return pieces
