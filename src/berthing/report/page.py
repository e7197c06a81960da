"""report.html: the verdict and the figures in one file that needs nothing else."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from html import escape
from pathlib import Path

from berthing.report.verdict_table import Row

STYLE = """
:root { color-scheme: light dark; --ink: #263238; --paper: #fff; --line: #dfe4e8; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6eaed; --paper: #15191c; --line: #37424a; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 80rem; margin: 0 auto; padding: 1.5rem; }
h1 { margin: 0; } h1 + p { margin-top: .25rem; white-space: pre-line; }
table { border-collapse: collapse; }
th, td { text-align: left; padding: .3rem 1.5rem .3rem 0; border-bottom: 1px solid var(--line);
  font-weight: normal; vertical-align: top; }
td { font-variant-numeric: tabular-nums; }
.good { color: #2e7d32; font-weight: 600; } .bad { color: #c62828; font-weight: 600; }
@media (prefers-color-scheme: dark) { .good { color: #81c784; } .bad { color: #ef9a9a; } }
.banner { border-left: .4rem solid #c62828; padding: .5rem 1rem; }
figure { margin: 1.5rem 0; } figcaption { font-size: .9rem; }
img { max-width: 100%; height: auto; background: #fff; border-radius: .3rem; }
"""


def page(
    title: str, description: str, rows: Sequence[Row], reasons: Sequence[str],
    figures: Sequence[tuple[str, Path]],
) -> str:  # fmt: skip
    """The page as text.

    Args:
        title, description: of the scenario.
        rows: the verdict, its headline first.
        reasons: why the plan is not certified; empty where it is.
        figures: captions and PNG files, which are embedded.
    """
    body = "\n".join(
        [
            f"<h1>{escape(title)}</h1>",
            f"<p>{escape(description.strip())}</p>",
            _banner(reasons),
            _table(rows),
            *(_figure(caption, path) for caption, path in figures),
        ]
    )
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)} – berthing</title>\n<style>{STYLE}</style>\n</head>\n"
        f"<body>\n{body}\n</body>\n</html>\n"
    )


def _banner(reasons: Sequence[str]) -> str:
    if not reasons:
        return ""
    items = "\n".join(f"<li>{escape(reason)}</li>" for reason in reasons)
    return f'<div class="banner"><strong>Not certified.</strong><ul>\n{items}\n</ul></div>'


def _table(rows: Sequence[Row]) -> str:
    return "<table>\n" + "\n".join(_row(row) for row in rows) + "\n</table>"


def _row(row: Row) -> str:
    mark = {None: "", True: ' class="good"', False: ' class="bad"'}[row.good]
    label = escape(row.label.strip())
    return f'<tr><th scope="row">{label}</th><td{mark}>{escape(row.value)}</td></tr>'


def _figure(caption: str, path: Path) -> str:
    data = base64.b64encode(path.read_bytes()).decode("ascii")
    text = escape(caption)
    return (
        f'<figure><img alt="{text}" src="data:image/png;base64,{data}">'
        f"<figcaption>{text}</figcaption></figure>"
    )
