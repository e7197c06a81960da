"""A verification as plan.json records it, for showing it again without checking again."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import MISSING, fields
from typing import Any, TypeVar

from berthing.errors import InputError
from berthing.verify.boundary import EndErrors
from berthing.verify.replay import Replay
from berthing.verify.verdict import CERTIFIED, EXEMPT, UNDECIDED, VIOLATED, PairVerdict
from berthing.verify.verification import Verification

T = TypeVar("T", EndErrors, Replay, PairVerdict, Verification)

# What JSON has for a field of each declared type; anything else is an error of the file.
KINDS: Mapping[str, tuple[type, ...]] = {
    "float": (int, float),
    "float | None": (int, float, type(None)),
    "str": (str,),
    "str | None": (str, type(None)),
    "bool": (bool,),
    "tuple[str, ...]": (list,),
    "tuple[float, ...]": (list,),
}
VERDICTS = (CERTIFIED, VIOLATED, UNDECIDED, EXEMPT)


def recorded_verification(document: Mapping[str, Any], where: str) -> Verification:
    """The verification in plan.json, infinities restored; values of the Hamiltonian are not in it.

    Args:
        document: the content of plan.json.
        where: its path, for messages.

    Raises:
        InputError: something is missing or of another kind.
    """
    place = f"{where}.verification"
    record = dict(_object(document.get("verification"), place))
    pairs = tuple(_pair(row, at) for row, at in _rows(record, "pairs", place))
    # plan.json has null for both infinities.
    if record.get("clearance_lower_bound_m") is None:
        held = any(pair.verdict != EXEMPT for pair in pairs)
        record["clearance_lower_bound_m"] = -math.inf if held else math.inf
    record.setdefault("tube_m", 0.0)
    for name in ("replay_position_error_m", "replay_attitude_error_rad", "tube_m"):
        record[name] = math.inf if record.get(name) is None else record[name]
    ends = tuple(_record(EndErrors, row, at) for row, at in _rows(record, "ends", place))
    replays = tuple(_record(Replay, row, at) for row, at in _rows(record, "replays", place))
    return _record(
        Verification, record, place, pairs=pairs, ends=ends, replays=replays, hamiltonian=()
    )


def _pair(row: Mapping[str, Any], where: str) -> PairVerdict:
    nothing = math.inf if row.get("verdict") == EXEMPT else -math.inf
    infinite = {name: nothing for name in ("lower_bound_m", "excess_m") if row.get(name) is None}
    pair = _record(PairVerdict, {**row, **infinite}, where)
    if pair.verdict not in VERDICTS:
        raise InputError(f"{where}.verdict", f"is {pair.verdict!r}", ", ".join(VERDICTS))
    return pair


def _rows(parent: Mapping[str, Any], key: str, where: str) -> list[tuple[Mapping[str, Any], str]]:
    place = f"{where}.{key}"
    rows = parent.get(key)
    if not isinstance(rows, list):
        raise InputError(place, "is not a list of objects")
    return [(_object(row, f"{place}[{i}]"), f"{place}[{i}]") for i, row in enumerate(rows)]


def _object(value: Any, where: str) -> Mapping[str, Any]:
    if not isinstance(value, dict):
        raise InputError(where, "is not an object")
    return value


def _record(kind: type[T], row: Mapping[str, Any], where: str, **given: Any) -> T:
    """A frozen record from the members of an object, each of the kind that it is declared as."""
    values = dict(given)
    for field in fields(kind):
        if field.name in given:
            continue
        if field.name not in row and field.default is not MISSING:
            continue
        value = row.get(field.name)
        allowed = KINDS.get(str(field.type), (object,))
        if not isinstance(value, allowed) or (isinstance(value, bool) and float in allowed):
            found = f"is {value!r}" if field.name in row else "is missing"
            raise InputError(f"{where}.{field.name}", found, str(field.type))
        values[field.name] = tuple(value) if isinstance(value, list) else value
    return kind(**values)
