"""JSON that is what it says: an object, finite numbers, keys that must be there."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array

# What is read takes up to thirty times its size in memory. The trajectory.csv of sixty vehicles,
# the largest file that there is, stays below.
LARGEST_FILE_BYTES = 1 << 25

# Values in one file: those of fifty vehicles with a thousand segments each stay below. At some 70
# bytes each they take 300 MB.
MOST_VALUES = 4_000_000


def read_text(path: Path) -> str:
    """The text of a UTF-8 file.

    Raises:
        InputError: the file is missing, unreadable, too large, not a file or not UTF-8.
    """
    where = str(path)
    try:
        if path.exists() and not path.is_file():
            raise InputError(where, "is not a file")
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE_BYTES + 1)
        if len(content) > LARGEST_FILE_BYTES:
            raise InputError(where, "is too large", f"at most {LARGEST_FILE_BYTES >> 20} MiB")
        return content.decode("utf-8")
    except FileNotFoundError:
        raise InputError(where, "is missing") from None
    except OSError as error:
        raise InputError(where, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(where, "is not UTF-8 text") from None


def read_object(path: Path) -> dict[str, Any]:
    """The JSON object in a file; NaN and infinities, which JSON has not, are refused.

    Raises:
        InputError: anything else.
    """
    where, content = str(path), read_text(path)
    if sum(map(content.count, ",[{")) > MOST_VALUES:
        raise InputError(where, "holds too many values", f"at most {MOST_VALUES}")
    try:
        value = json.loads(content, parse_constant=lambda name: _refuse(where, name))
    except json.JSONDecodeError as error:
        raise InputError(where, f"is not JSON: {error.msg}, line {error.lineno}") from None
    except RecursionError:
        raise InputError(where, "is nested too deeply") from None
    except ValueError:
        # An integer of more digits than Python converts.
        raise InputError(where, "contains a number that cannot be read") from None
    if not isinstance(value, dict):
        raise InputError(where, "is not a JSON object")
    return value


def read_versioned(path: Path, version: int) -> dict[str, Any]:
    """As ``read_object``, with this ``schema_version``.

    Raises:
        InputError: also where it has another one or none.
    """
    document, where = read_object(path), str(path)
    found = whole(document, "schema_version", where)
    if found != version:
        raise InputError(f"{where}.schema_version", f"is {found}", str(version))
    return document


def _refuse(where: str, name: str) -> NoReturn:
    raise InputError(where, f"contains {name}", "finite numbers")


def text(parent: Mapping[str, Any], key: str, where: str) -> str:
    """The string under ``key``; InputError where it is missing or another thing."""
    value = _present(parent, key, where)
    if not isinstance(value, str):
        raise InputError(f"{where}.{key}", "is not a string")
    return value


def names(parent: Mapping[str, Any], key: str, where: str) -> tuple[str, ...]:
    """The list of strings under ``key``."""
    value = _present(parent, key, where)
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise InputError(f"{where}.{key}", "is not a list of names")
    return tuple(value)


def objects(
    parent: Mapping[str, Any], key: str, where: str, *, empty: bool = False
) -> list[dict[str, Any]]:
    """The list of objects under ``key``, which may be ``empty`` or not."""
    value = _present(parent, key, where)
    if not isinstance(value, list) or not all(isinstance(v, dict) for v in value):
        raise InputError(f"{where}.{key}", "is not a list of objects")
    if not value and not empty:
        raise InputError(f"{where}.{key}", "is empty", "one or more objects")
    return value


def number(parent: Mapping[str, Any], key: str, where: str) -> float:
    """The finite number under ``key``."""
    return float(array(parent, key, 0, where))


def whole(parent: Mapping[str, Any], key: str, where: str) -> int:
    """The integer under ``key``."""
    value = _present(parent, key, where)
    if not isinstance(value, int) or isinstance(value, bool):
        raise InputError(f"{where}.{key}", "is not a whole number")
    return value


def array(parent: Mapping[str, Any], key: str, ndim: int, where: str) -> Array:
    """The finite numbers under ``key``, nested ``ndim`` deep and not ragged."""
    place = f"{where}.{key}"
    value = _present(parent, key, where)
    # Looked at first: NumPy would make every entry as long as the longest text among them.
    if not _holds_numbers(value, ndim):
        raise InputError(place, "is not of the right kind", _kind(ndim))
    try:
        numbers = np.array(value, dtype=np.float64)
    except ValueError:
        raise InputError(place, "is ragged") from None
    except OverflowError:
        raise InputError(place, "contains a huge number", "finite numbers") from None
    if numbers.size == 0:
        raise InputError(place, "is empty", _kind(ndim))
    if not np.all(np.isfinite(numbers)):
        raise InputError(place, "contains an infinite value", "finite numbers")
    return numbers


def _holds_numbers(value: Any, ndim: int) -> bool:
    """Whether it is lists nested ``ndim`` deep with nothing but numbers inside."""
    if ndim == 0:
        return type(value) in (int, float)
    if not isinstance(value, list):
        return False
    if ndim == 1:
        return {int, float}.issuperset(map(type, value))
    return all(_holds_numbers(item, ndim - 1) for item in value)


def _kind(ndim: int) -> str:
    return ("a number", "a list of numbers", "a list of lists of numbers")[ndim]


def _present(parent: Mapping[str, Any], key: str, where: str) -> Any:
    if key not in parent:
        raise InputError(where, f"lacks {key!r}")
    return parent[key]
