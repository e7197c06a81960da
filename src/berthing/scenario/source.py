"""Where a scenario document came from, so that an error can point into it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any

from berthing.errors import InputError

Key = str | int
Path = tuple[Key, ...]
Lines = Callable[[Path], int | None]


class Absent(str):
    """A key that ought to be there."""


def no_lines(path: Path) -> int | None:
    """For documents that never were text."""
    return None


@dataclass(frozen=True)
class Source:
    """A document as the user wrote it.

    Attributes:
        name: the file, or whatever it came from.
        raw: the document before validation.
        lines: 1-based line of a key path in the text.
        shorthand: whether ``raw`` has the keys of its only phase at its top.
        folder: from which its paths lead; None for the working directory.
        trusted: whether code of the user's own may be run.
    """

    name: str
    raw: Any
    lines: Lines = no_lines
    shorthand: bool = False
    folder: FilePath | None = None
    trusted: bool = False

    def error(self, path: Sequence[Any], what: str, expected: str = "") -> InputError:
        """An error at a key path of the normal form, told in the keys that the user wrote."""
        written = self.written(path)
        line = self.lines(written)
        place = self.name if line is None else f"{self.name}:{line}"
        where = f"{place}: {as_text(written)}" if written else place
        return InputError(where, what, expected)

    @contextmanager
    def at(self, *path: Key) -> Iterator[None]:
        """Give errors raised inside the key path of what is being built there."""
        try:
            yield
        except InputError as error:
            raise self.error((*path, error.where), error.what, error.expected) from None

    def written(self, path: Sequence[Any]) -> Path:
        """The part of ``path`` that leads through the raw document, ``Absent`` keys included.

        What is not a key there, such as pydantic's tag of a union or a name of the code, is left
        out.
        """
        if self.shorthand and tuple(path[:2]) == ("phases", 0):
            path = path[2:]
        here, kept = self.raw, list[Key]()
        for key in path:
            if _leads_on(here, key):
                here = here[key]
                kept.append(key)
            elif isinstance(key, Absent):
                kept.append(key)
        return tuple(kept)


def as_text(path: Sequence[Any]) -> str:
    """``vehicles[0].dynamics.mass_kg``."""
    text = "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in path)
    return text.removeprefix(".")


def _leads_on(here: Any, key: Any) -> bool:
    if isinstance(here, Mapping):
        return key in here
    return isinstance(here, list | tuple) and isinstance(key, int) and key < len(here)
