"""Near matches for a name that does not exist."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

# difflib's own default of 0.6 misses "scenario-c" typed as "scenC"; below 0.5 it guesses wildly.
SIMILARITY = 0.5


def near(name: str, options: Iterable[str], count: int = 3) -> list[str]:
    """Up to ``count`` of the options that look like ``name``, best first; case is ignored."""
    by_folded = {option.casefold(): option for option in options}
    found = get_close_matches(name.casefold(), by_folded, n=count, cutoff=SIMILARITY)
    return [by_folded[f] for f in found]


def did_you_mean(name: str, options: Iterable[str]) -> str:
    """``; did you mean a or b?``, or nothing where no option is near."""
    found = near(name, options)
    return f"; did you mean {' or '.join(found)}?" if found else ""
