"""The whole page: one file that asks nothing of any network, and may not."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Sequence
from functools import cache
from html import escape
from importlib.resources import files
from string import Template

from berthing._version import __version__
from berthing.report.offline.content import Content
from berthing.report.offline.shown import Shown
from berthing.report.offline.tables import (
    attempts_table,
    badges,
    banner,
    pairs_table,
    stages_table,
    verdict_table,
    versions_text,
)

# Any page of ours says so in its head; nothing else is overwritten by it.
GENERATOR = "berthing"


def shown_page(plans: Sequence[Shown]) -> str:
    """The page of plans that have their times already."""
    content = Content()
    for shown in plans:
        content.add(shown.label, shown.scenario, shown.plan, shown.verification, shown.claims)
    return page(plans, content)


def page(plans: Sequence[Shown], content: Content) -> str:
    """The page as text.

    A content security policy forbids every request and every script but the bundle, whatever a
    scenario has in its names.

    Args:
        plans: one or more.
        content: of the same plans, in their order.
    """
    script = asset("viewer.js")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii")
    return Template(asset("page.html")).substitute(
        title=escape(_title(plans)),
        generator=f"{GENERATOR} {__version__}",
        script_hash=f"'sha256-{digest}'",
        style=asset("viewer.css"),
        script=script,
        data=_embedded(content),
        badges=badges(plans),
        description=_description(plans),
        layout="" if len(plans) == 1 else "compared",
        banner=banner(plans),
        verdict=verdict_table(plans),
        pairs=pairs_table(plans),
        stages=stages_table(plans),
        attempts=attempts_table(plans),
        versions=versions_text(plans),
        licences=escape(asset("LICENCES.txt")),
    )


@cache
def asset(name: str) -> str:
    """The text of a file that ships with the page."""
    return files(__package__).joinpath("assets", name).read_text(encoding="utf-8")


def _title(plans: Sequence[Shown]) -> str:
    names = list(dict.fromkeys(shown.scenario.name for shown in plans))
    if len(plans) == 1:
        return names[0]
    return f"{names[0]}, {len(plans)} plans" if len(names) == 1 else ", ".join(names)


def _description(plans: Sequence[Shown]) -> str:
    """The first line of each scenario's description, and the rest as a paragraph."""
    paragraphs = []
    for text in dict.fromkeys(shown.scenario.description.strip() for shown in plans):
        first, _, rest = text.partition("\n")
        paragraphs += [first, *rest.split("\n\n")]
    return "\n".join(f"<p>{escape(p)}</p>" for p in paragraphs if p.strip())


def _embedded(content: Content) -> str:
    """JSON for a script element: no ``<``, so that nothing in it can end the element."""
    text = json.dumps(content.to_json(), separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")
