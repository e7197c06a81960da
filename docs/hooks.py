"""What the site's builder does beside: equations, the examples' page, nothing from any network."""

from __future__ import annotations

import re
from html import unescape
from os.path import dirname, join, normpath
from pathlib import Path
from typing import Any

import yaml
from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

ROOT = Path(__file__).parent.parent
CASES = sorted((ROOT / "src/berthing/scenario/cases").glob("*.yaml"))
LANGUAGES = {".py": "python", ".yaml": "yaml"}
MATH = re.compile(r'<(span|div) class="arithmatex">\s*\\[(\[](.*?)\\[)\]]\s*</\1>', re.DOTALL)
# A link upwards, its text and its target.
LINK = re.compile(r"\[([^\]]*)\]\((\.\./[^)#]*)\)")
# A link that a browser follows by itself to show the page.
FETCHED = re.compile(
    r"""<(?:script|img|iframe|source)\b[^>]*\bsrc=["']?(https?:|//)|"""
    r"""<link\b[^>]*rel=["']?(?:stylesheet|preload|preconnect)[^>]*href=["']?(https?:|//)""",
    re.IGNORECASE,
)


def on_files(files: Any, config: Any) -> Any:
    """Add a page with every example, from its own file."""
    parts = ["# Examples\n\nEach is run by the tests.\n"]
    for path in sorted((ROOT / "examples").rglob("*")):
        if path.suffix in LANGUAGES:
            name = str(path.relative_to(ROOT / "examples"))
            code = path.read_text(encoding="utf-8")
            parts.append(
                f"\n## {name} {{ #{anchor(name)} }}\n\n```{LANGUAGES[path.suffix]}\n{code}```\n"
            )
    files.append(File.generated(config, "examples.md", content="".join(parts)))
    named = set(_pages(config.nav))
    others = sorted({file.src_uri for file in files.documentation_pages()} - named)
    if others:
        config.nav.append({"More": others})
    return files


def _named(link: re.Match[str], page_uri: str) -> str:
    """A link out of docs/ as text and path: that file is in the repository, not on the site."""
    place = normpath(join("docs", dirname(page_uri), link[2]))
    if place.startswith(("docs/", "examples/")) or not (ROOT / place).exists():
        return link[0]
    return f"{link[1]} (`{place}`)"


def _section(case: Path) -> str:
    """Of a case that the gallery's page says nothing of."""
    text = yaml.safe_load(case.read_text(encoding="utf-8"))["description"]
    picture = ROOT / "docs" / "images" / f"{case.stem}.png"
    shown = f"![{case.stem}](images/{picture.name})\n" if picture.exists() else ""
    return f"\n## {case.stem}\n\n{text}\n\n{shown}"


def _pages(nav: Any) -> list[str]:
    """Every page that the navigation names."""
    if isinstance(nav, str):
        return [nav]
    parts = nav.values() if isinstance(nav, dict) else nav
    return [page for part in parts for page in _pages(part)]


def anchor(name: str) -> str:
    """Of an example on that page."""
    return re.sub(r"\W+", "-", name)


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Links to examples in the repository lead to that page here; the gallery has every case."""
    if page.file.src_uri == "gallery.md":
        markdown += "".join(_section(path) for path in CASES if f"## {path.stem}\n" not in markdown)
    markdown = LINK.sub(lambda found: _named(found, page.file.src_uri), markdown)
    up = "../" * page.file.src_uri.count("/")
    return re.sub(
        r"\]\((?:\.\./)+examples/([^)]*)\)",
        lambda found: f"]({up}examples.md#{anchor(found[1])})",
        markdown,
    )


def on_page_content(html: str, **_: Any) -> str:
    """Equations as MathML, which browsers draw themselves."""

    def drawn(found: re.Match[str]) -> str:
        display = "block" if found[1] == "div" else "inline"
        return convert(unescape(found[2]).strip(), display=display)

    return MATH.sub(drawn, html)


def on_post_build(config: Any) -> None:
    """Refuse a site that needs a network, or has an equation left in TeX."""
    for path in Path(config.site_dir).rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        if found := FETCHED.search(text):
            raise PluginError(f"{path.name} fetches {text[found.start() : found.start() + 120]}")
        if 'class="arithmatex"' in text:
            raise PluginError(f"{path.name} has an equation that was not drawn")
