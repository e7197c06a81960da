"""Text to plain data: YAML 1.2 or JSON, with line numbers for errors."""

from __future__ import annotations

import json
from copy import deepcopy
from functools import lru_cache
from io import StringIO
from pathlib import Path as FilePath
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.constructor import SafeConstructor
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.nodes import MappingNode, Node, SequenceNode

from berthing.errors import InputError
from berthing.scenario.source import Path, Source, no_lines

# Documents not parsed again while their text stays the same: more than the cases that ship.
KEPT = 64


class _PlainConstructor(SafeConstructor):
    """YAML 1.2 has no dates: an epoch stays the text that it is."""


_PlainConstructor.add_constructor("tag:yaml.org,2002:timestamp", SafeConstructor.construct_yaml_str)


def read(path: FilePath, name: str | None = None) -> Source:
    """The document in the file ``path``, called ``name`` in errors (the path, if None).

    Raises:
        InputError: unreadable, not UTF-8, or not well-formed; with the line.
    """
    name = str(path) if name is None else name
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise InputError(name, f"is not UTF-8 text at byte {error.start}") from None
    except OSError as error:
        raise InputError(name, f"cannot be read: {error.strerror}") from None
    parse = _parse_json if path.suffix == ".json" else _parse_yaml
    try:
        return parse(text, name)
    except RecursionError:
        raise InputError(name, "nests too deeply") from None


def _parse_yaml(text: str, name: str) -> Source:
    try:
        raw = deepcopy(_loaded(text))
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = f"{name}:{mark.line + 1}" if mark else name
        problem = " ".join(str(error.problem or error.context).split())
        problem = problem.split(" with value ")[0]  # a key that stands twice, quoted at length
        raise InputError(where, f"is not well-formed YAML: {problem}") from None
    except (YAMLError, ValueError) as error:
        problem = " ".join(str(error).split())
        raise InputError(name, f"is not well-formed YAML: {problem}") from None
    return Source(name, raw, lambda path: _line(text, path))


@lru_cache(maxsize=KEPT)
def _loaded(text: str) -> Any:
    """To be copied before it is changed."""
    return _yaml().load(text)


def _parse_json(text: str, name: str) -> Source:
    try:
        raw = json.loads(text, object_pairs_hook=_unique_keys, parse_constant=_refuse_constant)
    except json.JSONDecodeError as error:
        where = f"{name}:{error.lineno}"
        raise InputError(where, f"is not well-formed JSON: {error.msg}") from None
    except ValueError as error:
        raise InputError(name, f"is not well-formed JSON: {error}") from None
    return Source(name, raw, no_lines)


def _yaml() -> YAML:
    yaml = YAML(typ="safe", pure=True)
    yaml.Constructor = _PlainConstructor
    return yaml


def _unique_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    keys = [key for key, _ in pairs]
    twice = sorted({key for key in keys if keys.count(key) > 1})
    if twice:
        raise ValueError(f"the key {twice[0]!r} stands twice in one object")
    return dict(pairs)


def _refuse_constant(word: str) -> Any:
    raise ValueError(f"{word} is not a number")


def _line(text: str, path: Path) -> int | None:
    """1-based line of a key path; of the nearest block that exists, where the key is missing."""
    node = _yaml().compose(StringIO(text))
    line: int | None = None
    for key in path:
        found = _child(node, key)
        if found is None:
            break
        line, node = found
    return line


def _child(node: Node | None, key: str | int) -> tuple[int, Node] | None:
    if isinstance(node, MappingNode):
        for name, value in node.value:
            if str(name.value) == str(key):
                return int(name.start_mark.line) + 1, value
    if isinstance(node, SequenceNode) and isinstance(key, int) and key < len(node.value):
        value = node.value[key]
        return int(value.start_mark.line) + 1, value
    return None
