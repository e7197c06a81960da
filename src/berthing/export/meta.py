"""What ``meta:`` says of the world around the plan: clock, frame, centre and identities."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.export.epoch import Epoch, parse_epoch
from berthing.scenario.reading import read

# Longer names than this are refused by one format or another.
LONGEST_NAME = 80
LARGEST_NAIF_ID = 2**31 - 1

EXAMPLES = {
    "epoch": "epoch: 2026-01-01T12:00:00Z",
    "centre": "centre: EARTH",
    "frame": "frame: EME2000",
    "object_ids": "object_ids: {NAME: 2026-001A}",
    "naif_ids": "naif_ids: {NAME: -100001}",
}


@dataclass(frozen=True)
class Meta:
    """The block, read on demand: a format asks only for what it needs.

    Attributes:
        values: keys and values as in the file.
        where: for errors.
    """

    values: Mapping[str, Any]
    where: str = "meta"

    def require(self, needs: Sequence[str], vehicles: Sequence[str], format_name: str) -> None:
        """InputError that names everything missing at once, and how it is written."""
        missing = [key for key in needs if _MISSING[key](self.values, vehicles)]
        if missing:
            what = f"lacks {', '.join(missing)}, which --to {format_name} needs"
            lines = "; ".join(EXAMPLES[k].replace("NAME", vehicles[0]) for k in missing)
            raise InputError(
                self.where, what, f"{lines}; in the scenario's meta: or in a file given by --meta"
            )

    @property
    def epoch(self) -> Epoch | None:
        """When t = 0 is; None where it is not said."""
        if self.values.get("epoch") is None:
            return None
        return parse_epoch(self.values["epoch"], self.values.get("time_system"), self.where)

    @property
    def centre(self) -> str | None:
        """What stands at the origin of the frame: a celestial body or a spacecraft."""
        return self._text("centre")

    @property
    def frame(self) -> str | None:
        """The name of the axes.

        Raises:
            InputError: a bare LVLH, which has two opposite conventions.
        """
        frame = self._text("frame")
        if frame is not None and frame.upper() == "LVLH":
            what = f"is {frame!r}, which has two opposite conventions"
            raise InputError(f"{self.where}.frame", what, "RTN or LVLH_CCSDS")
        return frame

    def object_name(self, vehicle: str) -> str:
        """The name of a vehicle to the world; its own where none is given."""
        names = self._table("object_names")
        return _printable(names.get(vehicle, vehicle), f"{self.where}.object_names.{vehicle}")

    def object_id(self, vehicle: str) -> str:
        """The identifier of a vehicle, such as the international designator 2026-001A."""
        where = f"{self.where}.object_ids.{vehicle}"
        return _printable(self._table("object_ids").get(vehicle), where)

    def naif_id(self, name: str) -> int | None:
        """The NAIF integer of a vehicle or of the centre; a whole object id will do."""
        value = self._table("naif_ids").get(name, self._table("object_ids").get(name))
        if value is None:
            return None
        where = f"{self.where}.naif_ids.{name}"
        if not isinstance(value, int) or isinstance(value, bool) or abs(value) > LARGEST_NAIF_ID:
            raise InputError(where, f"is {value!r}", "a NAIF id, negative for spacecraft")
        return value

    def text(self, key: str) -> str | None:
        """A further key of one format's own."""
        return self._text(key)

    def _text(self, key: str) -> str | None:
        if self.values.get(key) is None:
            return None
        return _printable(self.values[key], f"{self.where}.{key}")

    def _table(self, key: str) -> Mapping[str, Any]:
        table = self.values.get(key, {})
        if not isinstance(table, Mapping):
            raise InputError(f"{self.where}.{key}", f"is {table!r}", "a value for each name")
        return table


def read_meta(path: Path) -> dict[str, Any]:
    """Keys and values of a YAML or JSON file; a ``meta:`` block in it is taken for the whole.

    Raises:
        InputError: unreadable, or no mapping.
    """
    raw = read(path).raw
    if isinstance(raw, Mapping) and isinstance(raw.get("meta"), Mapping):
        raw = raw["meta"]
    if not isinstance(raw, Mapping):
        raise InputError(str(path), "holds no keys and values", EXAMPLES["epoch"])
    return {str(key): value for key, value in raw.items()}


def _lacks_key(key: str) -> Callable[[Mapping[str, Any], Sequence[str]], bool]:
    return lambda values, vehicles: values.get(key) is None


def _lacks_names(*keys: str) -> Callable[[Mapping[str, Any], Sequence[str]], bool]:
    """Whether any vehicle is in none of the tables."""

    def lacks(values: Mapping[str, Any], vehicles: Sequence[str]) -> bool:
        tables = [values[k] for k in keys if isinstance(values.get(k), Mapping)]
        return any(all(table.get(v) is None for table in tables) for v in vehicles)

    return lacks


_MISSING: dict[str, Callable[[Mapping[str, Any], Sequence[str]], bool]] = {
    "epoch": _lacks_key("epoch"),
    "centre": _lacks_key("centre"),
    "frame": _lacks_key("frame"),
    "object_ids": _lacks_names("object_ids"),
    "naif_ids": _lacks_names("naif_ids", "object_ids"),
}


def _printable(value: object, where: str) -> str:
    """One line of printable ASCII, which is all that the older formats take."""
    text = str(value).strip() if isinstance(value, str | int) else ""
    if isinstance(value, bool) or not text or not text.isascii() or not text.isprintable():
        raise InputError(where, f"is {value!r}", "one line of ASCII text")
    if len(text) > LONGEST_NAME:
        raise InputError(where, f"has {len(text)} characters", f"at most {LONGEST_NAME}")
    return text
