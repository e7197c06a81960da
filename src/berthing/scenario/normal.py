"""The normal form of a scenario document, and its fingerprint."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from typing import Any

from berthing.scenario.schema.document import ScenarioFile


def normal_document(file: ScenarioFile) -> dict[str, Any]:
    """The JSON-able dict with every default written out; reading it again gives the same."""
    document = file.model_dump(mode="json", exclude_none=True)
    # exclude_none reaches into free-form blocks too, where null may mean something.
    document["meta"] = file.model_dump(mode="json")["meta"]
    return document


def document_sha256(document: Mapping[str, Any]) -> str:
    """SHA-256, in hex, of the canonical JSON: sorted keys, no spaces, UTF-8."""
    text = json.dumps(
        document, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False
    )
    return hashlib.sha256(text.encode("utf-8")).hexdigest()
