"""Scenarios from files, from dicts and from the library."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from berthing.errors import InputError
from berthing.scenario.build.meshes import with_meshes
from berthing.scenario.build.user_code import with_code
from berthing.scenario.build.whole import build_scenario
from berthing.scenario.library import case_path, library
from berthing.scenario.reading import read
from berthing.scenario.scenario import Scenario
from berthing.scenario.schema.document import ScenarioFile, SinglePhaseFile
from berthing.scenario.source import Source
from berthing.scenario.suggest import did_you_mean
from berthing.scenario.validate import quoted, validated

SUFFIXES = (".yaml", ".yml", ".json")


def load(name_or_path: str | Path) -> Scenario:
    """The scenario of that name in the library, or in that file.

    A name of the library wins; write ``./name`` for a file of the same name. Python files that a
    scenario's file names as the user's own code are run.

    Raises:
        InputError: no such scenario, or anything wrong in it, with file, line and key path.
    """
    given = str(name_or_path)
    case = case_path(given)
    if case is not None:
        return _build(read(case, given))
    path = Path(name_or_path)
    try:
        is_file = path.is_file()
    except OSError as error:
        raise InputError(quoted(given), f"cannot be read: {error.strerror}") from None
    if is_file:
        return _build(replace(read(path), folder=path.parent, trusted=True))
    raise _unknown(given, path)


def from_document(
    document: Mapping[str, Any], source: str = "scenario", *, trust: bool = False
) -> Scenario:
    """The scenario in a dict, such as the ``document`` of another; ``source`` is for errors.

    Args:
        trust: run the user's own code that the document holds or names.

    Raises:
        InputError: anything wrong in it, with the key path; code that is not to be run.
    """
    return _build(Source(source, document, trusted=trust))


def json_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of the scenario file, in both of its forms."""
    adapter: TypeAdapter[Any] = TypeAdapter(SinglePhaseFile | ScenarioFile)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "berthing scenario",
        **adapter.json_schema(),
    }


def _build(source: Source) -> Scenario:
    file, source = validated(source)
    return build_scenario(with_meshes(with_code(file, source), source), source)


def _unknown(given: str, path: Path) -> InputError:
    if path.is_dir():
        return InputError(given, "is a folder", "a scenario's name or file")
    if path.suffix in SUFFIXES or len(path.parts) > 1:
        beside = [str(p) for s in SUFFIXES for p in sorted(path.parent.glob(f"*{s}"))]
        return InputError(given, f"is no file{did_you_mean(given, beside)}")
    names = list(library())
    hint = did_you_mean(given, names)
    expected = "" if hint else f"a file, or one of: {', '.join(names)}"
    return InputError(given, f"is not a scenario{hint}", expected)
