"""Raw data to the file's blocks; pydantic's findings to one error that says where and what."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from berthing.errors import InputError
from berthing.scenario.schema.document import SHORTHAND_KEYS, ScenarioFile
from berthing.scenario.source import Absent, Source
from berthing.scenario.suggest import did_you_mean

MAIN = "main"
# An error quotes what it found; a long list would bury the message.
QUOTE_LENGTH = 60


def validated(source: Source) -> tuple[ScenarioFile, Source]:
    """The file in its blocks, and the source as it is to be used from here on.

    Raises:
        InputError: at the first finding, with the count of the others.
    """
    if not isinstance(source.raw, Mapping):
        found = "is empty" if source.raw is None else f"is {quoted(source.raw)}"
        raise InputError(source.name, found, "a block of keys")
    document, source = _normal_form(source)
    try:
        return ScenarioFile.model_validate(document), source
    except ValidationError as error:
        findings = error.errors(include_url=False)
    except RecursionError:
        raise InputError(source.name, "nests too deeply") from None
    raise _told(source, findings[0], len(findings) - 1)


def quoted(value: Any) -> str:
    """``value`` as an error shows it."""
    text = repr(value)
    return text if len(text) <= QUOTE_LENGTH else f"{text[: QUOTE_LENGTH - 1]}…"


def _normal_form(source: Source) -> tuple[dict[str, Any], Source]:
    """Move the keys of a single phase under ``phases``."""
    document = dict(source.raw)
    given = [key for key in SHORTHAND_KEYS if key in document]
    if "phases" in document and given:
        raise source.error((given[0],), "stands beside phases", "it inside each phase")
    if "phases" in document:
        return document, source
    phase = {key: document.pop(key) for key in given}
    document["phases"] = [{"name": MAIN, **phase}]
    return document, replace(source, shorthand=True)


def _told(source: Source, finding: ErrorDetails, others: int) -> InputError:
    tell = _TELLERS.get(finding["type"], _plain)
    path, what, expected = tell(finding)
    if others:
        what += f" [and {others} more {'problem' if others == 1 else 'problems'}]"
    return source.error(path, what, expected)


Told = tuple[tuple[Any, ...], str, str]


def _plain(finding: ErrorDetails) -> Told:
    return finding["loc"], finding["msg"], ""


def _expecting(expected: str) -> Callable[[ErrorDetails], Told]:
    """Tell what was found, and that something else was expected; filled in from the context."""

    def tell(finding: ErrorDetails) -> Told:
        context = finding.get("ctx", {})
        return finding["loc"], f"is {quoted(finding['input'])}", expected.format(**context)

    return tell


def _missing(finding: ErrorDetails) -> Told:
    *block, key = finding["loc"]
    return (*block, Absent(key)), "is missing", ""


def _unknown_key(finding: ErrorDetails) -> Told:
    context = finding.get("ctx", {})
    listed = "" if context.get("hint") else f"one of: {', '.join(context['known'])}"
    return (*finding["loc"], Absent(context["key"])), finding["msg"], listed


def _unknown_tag(finding: ErrorDetails) -> Told:
    context = finding.get("ctx", {})
    key = str(context["discriminator"]).strip("'")
    if not key.isidentifier():  # told apart by kind, not by a key
        tags = str(context["expected_tags"]).split(",")
        kinds = [_KINDS.get(tag.strip(" '"), "another value") for tag in tags]
        return finding["loc"], f"is {quoted(finding['input'])}", " or ".join(kinds)
    options = [tag.strip(" '") for tag in str(context["expected_tags"]).split(",")]
    what = f"is {quoted(context['tag'])}{did_you_mean(str(context['tag']), options)}"
    return (*finding["loc"], key), what, f"one of: {', '.join(options)}"


_KINDS = {"list": "a list", "block": "a block of keys", "word": "free", "number": "a number"}


def _missing_tag(finding: ErrorDetails) -> Told:
    if not isinstance(finding["input"], Mapping):
        return finding["loc"], f"is {quoted(finding['input'])}", "a block of keys"
    key = str(finding.get("ctx", {})["discriminator"]).strip("'")
    return (*finding["loc"], Absent(key)), "is missing", ""


def _length(finding: ErrorDetails) -> Told:
    context = finding.get("ctx", {})
    bound = (
        f"at least {context['min_length']}"
        if "min_length" in context
        else f"at most {context['max_length']}"
    )
    return finding["loc"], f"has {context['actual_length']} entries", bound


_TELLERS: dict[str, Callable[[ErrorDetails], Told]] = {
    "missing": _missing,
    "unknown_key": _unknown_key,
    "union_tag_invalid": _unknown_tag,
    "union_tag_not_found": _missing_tag,
    "too_short": _length,
    "too_long": _length,
    "greater_than": _expecting("a number above {gt:g}"),
    "greater_than_equal": _expecting("{ge:g} or more"),
    "float_type": _expecting("a number"),
    "int_type": _expecting("a whole number"),
    "finite_number": _expecting("a finite number"),
    "string_type": _expecting("text"),
    "string_too_long": _expecting("at most {max_length} characters"),
    "string_pattern_mismatch": _expecting("letters, digits, - and _, the first not a sign"),
    "list_type": _expecting("a list"),
    "dict_type": _expecting("a block of keys"),
    "model_type": _expecting("a block of keys"),
    "model_attributes_type": _expecting("a block of keys"),
    "literal_error": _expecting("{expected}"),
}
