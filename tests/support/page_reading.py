"""What a page open in the browser shows, read as a person would: pixels, tables, cursors."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.image import imread

from support.chromium import Browser, Page

SIZES = {"desktop": (1280, 800), "phone": (390, 844)}


def at_size(browser: Browser, path: Path, size: str, **options: Any) -> Page:
    """A page on a screen of a size by name."""
    width, height = SIZES[size]
    return browser.open(path, width, height, phone=size == "phone", **options)


def pixels(page: Page, selector: str) -> np.ndarray:
    """An element as it is drawn, (height, width, 3)."""
    return np.asarray(imread(io.BytesIO(page.picture(selector)))[..., :3])


def is_drawn(image: np.ndarray) -> bool:
    """Whether there is a scene: many colours, and much that is not the background."""
    colours = np.unique((image * 32).astype(int).reshape(-1, 3), axis=0)
    background = np.median(image.reshape(-1, 3), axis=0)
    share = np.mean(np.any(np.abs(image - background) > 0.05, axis=-1))
    return len(colours) > 60 and bool(share > 0.03)


def seek(page: Page, share: float) -> float:
    """Put the slider there by the mouse; the time it is at then."""
    rect = page.rect("#time")
    # The thumb's middle runs between half its width from either end.
    x = rect["x"] + 8 + share * (rect["width"] - 16)
    page.click(x, rect["y"] + rect["height"] / 2)
    return time_of(page)


def time_of(page: Page) -> float:
    return float(str(page.run("document.getElementById('time').value")))


def positions(page: Page) -> dict[str, list[float]]:
    """Where the table says that each vehicle is."""
    rows = page.run(
        "[...document.querySelectorAll('#state tbody tr')].map(row =>"
        " [...row.children].map(cell => cell.textContent))"
    )
    assert isinstance(rows, list)
    return {row[0]: [float(v.replace("−", "-")) for v in row[1:4]] for row in rows}


def cursors(page: Page) -> dict[str, float]:
    """Where the cursor of each plot is, in parts of its width."""
    found = page.run(
        "Object.fromEntries([...document.querySelectorAll('#grid figure')].map(figure => {"
        " const c = figure.querySelector('.u-cursor-x'), o = figure.querySelector('.u-over');"
        " if (!c) return [figure.id, null];"
        " const at = c.getBoundingClientRect(), box = o.getBoundingClientRect();"
        " return [figure.id, (at.x - box.x) / box.width]; }))"
    )
    assert isinstance(found, dict)
    return {name: at for name, at in found.items() if at is not None}
