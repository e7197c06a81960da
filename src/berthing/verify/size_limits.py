"""What is too large to be a plan, refused before it takes memory or time.

Whoever checks a folder that somebody else has written must be able to do so without harm.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from berthing.errors import InputError
from berthing.trajectory import VehicleTrajectory

# Numbers, names and keys of a scenario: a structure of five hundred polytopes has some 60,000.
MOST_SCENARIO_VALUES = 300_000

# Pairs of parts in one phase: a hundred parts among two thousand have as many.
MOST_PAIRS = 200_000

# The float slack of the certificate holds up to this degree. More nodes go into more segments.
LARGEST_DEGREE = 90

# Segments of one vehicle: the replay takes a step of some 0.5 ms for each, or more. A day of
# commands held for five seconds has 17,280.
MOST_SEGMENTS = 20_000

# Coefficients of one vehicle, each segment counted with the highest degree of all.
MOST_COEFFICIENTS = 2_000_000


def require_modest_scenario(document: Mapping[str, Any], where: str) -> None:
    """Refuse a scenario document, however malformed, with too many values or pairs of parts.

    Raises:
        InputError: names the count and the limit.
    """
    for count, _ in enumerate(_values(document)):
        if count >= MOST_SCENARIO_VALUES:
            raise InputError(where, "holds too many values", f"at most {MOST_SCENARIO_VALUES}")
    structures = _parts(document, "structures")
    for phase in _blocks(document, "phases"):
        vehicles = _parts(phase, "vehicles")
        pairs = vehicles * structures + vehicles * (vehicles - 1) // 2
        if pairs > MOST_PAIRS:
            raise InputError(where, f"has {pairs} pairs of parts", f"at most {MOST_PAIRS}")


def require_modest_trajectory(trajectory: VehicleTrajectory, where: str) -> None:
    """Refuse segments of too high a degree, or too many of them.

    Raises:
        InputError: names the degree or the count.
    """
    if len(trajectory.segments) > MOST_SEGMENTS:
        found = f"has {len(trajectory.segments)} segments"
        raise InputError(where, found, f"at most {MOST_SEGMENTS}")
    rows = max((max(len(s.state), len(s.control)) for s in trajectory.segments), default=0)
    if rows > LARGEST_DEGREE + 1:
        raise InputError(where, f"has a segment of degree {rows - 1}", f"{LARGEST_DEGREE} at most")
    columns = len(trajectory.state_names) + len(trajectory.control_names)
    count = rows * columns * len(trajectory.segments)
    if count > MOST_COEFFICIENTS:
        raise InputError(where, f"has {count} coefficients", f"at most {MOST_COEFFICIENTS}")


def _values(value: Any) -> Iterator[None]:
    """One item for every value in a document, itself included."""
    stack = [value]
    while stack:
        here = stack.pop()
        yield None
        if isinstance(here, dict):
            stack.extend(here.values())
        elif isinstance(here, list):
            stack.extend(here)


def _blocks(parent: Any, key: str) -> list[Any]:
    found = parent.get(key) if isinstance(parent, dict) else None
    return found if isinstance(found, list) else []


def _parts(parent: Any, key: str) -> int:
    return sum(len(_blocks(block, "parts")) for block in _blocks(parent, key))
