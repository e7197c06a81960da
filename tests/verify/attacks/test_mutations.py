"""True plans that something was done to: the body, the clock, the attitude, the proof.

Whoever forges a folder seals it again, with matching fingerprints in all files; what is refused
here is refused for what it says, not for its seal. The small checkers refuse all of it too.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from support.attacks import accepted, certified, edit, reseal

Document = dict[str, Any]
Change = Callable[[Document], object]


def craft(document: Document) -> Document:
    found: Document = document["scenario"]["phases"][0]["vehicles"][0]
    return found


def block(document: Document) -> Document:
    found: Document = document["scenario"]["structures"][0]
    return found


def segments(document: Document) -> list[Document]:
    found: list[Document] = document["phases"][0]["vehicles"][0]["segments"]
    return found


def every_row(change: Callable[[list[float]], object]) -> Change:
    return lambda d: [change(row) for s in segments(d) for row in s["state"]]


def swap(row: list[float]) -> None:
    """Scalar first is read as scalar last."""
    row[6:10] = [row[9], *row[6:9]]


def shifted(seconds: float) -> Change:
    def change(document: Document) -> None:
        for s in segments(document):
            s.update(t0_s=s["t0_s"] + seconds, t1_s=s["t1_s"] + seconds)

    return change


def pairs(document: Document) -> list[Document]:
    found: list[Document] = document["phases"][0]["pairs"]
    return found


def rows(document: Document) -> list[list[float]]:
    return [row for pair in pairs(document) for row in pair["intervals"]]


# The true body, margin or obstacle is larger than the one that was planned for.
SHRUNK: dict[str, Change] = {
    "the body was shrunk": lambda d: craft(d)["parts"][0]["shape"].update(size_m=[2, 3.0, 1]),
    "the margin was lowered": lambda d: d["scenario"]["margins"].update(default_m=0.9),
    "the block was moved away": lambda d: block(d).update(position_m=[5, 1.6, 0]),
    "the block was turned": lambda d: block(d).update(attitude=[0.8, 0, 0, 0.6]),
    "the block was at rest": lambda d: block(d).update(
        motion={"type": "constant-velocity", "velocity_m_s": [0, -0.03, 0]}
    ),
    "a structure was dropped": lambda d: d["scenario"]["structures"].append(
        {**block(d), "name": "another", "position_m": [5, -1.5, 0]}
    ),
    "a part was dropped": lambda d: craft(d)["parts"].append(
        {**craft(d)["parts"][0], "name": "arm", "position_m": [0, 1.5, 0]}
    ),
}
FLOWN: dict[str, Change] = {
    "the clock is shifted": shifted(1.0),
    "the order of the quaternion is swapped": every_row(swap),
    "a sign is flipped": every_row(lambda row: row.__setitem__(9, -row[9])),
    "the path is mirrored": every_row(lambda row: row.__setitem__(0, -row[0])),
    "the path is moved": lambda d: [
        s["state"][0].__setitem__(1, s["state"][0][1] + 0.9) for s in segments(d)
    ],
    "the controls are another's": lambda d: [
        row.__setitem__(0, -row[0]) for s in segments(d) for row in s["control"]
    ],
    "a segment is missing": lambda d: segments(d).pop(7),
    "the end is missing": lambda d: segments(d).pop(),
    "segments are in another order": lambda d: segments(d).reverse(),
}
FORGED: dict[str, Change] = {
    "normals are flipped": lambda d: [
        row.__setitem__(slice(3, 9), [-x for x in row[3:]]) for row in rows(d)
    ],
    "normals are another's": lambda d: [
        row.__setitem__(slice(3, 9), [0, 0, 1] * 2) for row in rows(d)
    ],
    "normals are long": lambda d: [
        row.__setitem__(slice(2, 9), [3 * row[2], *(3 * x for x in row[3:])]) for row in rows(d)
    ],
    "bounds are raised": lambda d: [row.__setitem__(2, row[2] + 1e-6) for row in rows(d)],
    "an interval is missing": lambda d: pairs(d)[0]["intervals"].pop(3),
    "an interval is empty": lambda d: pairs(d)[0]["intervals"][3].__setitem__(
        1, pairs(d)[0]["intervals"][3][0]
    ),
    "an interval runs backwards": lambda d: pairs(d)[0]["intervals"][3].__setitem__(
        slice(0, 2), pairs(d)[0]["intervals"][3][1::-1]
    ),
    "all in one interval": lambda d: pairs(d)[0].update(
        intervals=[[0.0, 100.0, 0.1, *pairs(d)[0]["intervals"][0][3:]]]
    ),
    "intervals beyond the end": lambda d: pairs(d)[0]["intervals"][-1].__setitem__(1, 101.0),
    "a pair is missing": lambda d: pairs(d).pop(),
    "a pair has another name": lambda d: pairs(d)[0].update(pair="craft.hull|block.back"),
    "pairs are exchanged": lambda d: [
        pair.update(pair=name)
        for pair, name in zip(pairs(d), [p["pair"] for p in pairs(d)][::-1], strict=True)
    ],
    "the tube is too narrow": lambda d: d["phases"][0]["tubes"][0].update(
        position_m=0.0, attitude_rad=0.0
    ),
    "the tube is missing": lambda d: d["phases"][0]["tubes"].pop(),
    "the phase has another name": lambda d: d["phases"][0].update(phase="other"),
    "there is nothing": lambda d: d.update(phases=[]),
}
ATTACKS = {
    **{name: ("plan.json", change) for name, change in SHRUNK.items()},
    **{name: ("interpolant.json", change) for name, change in FLOWN.items()},
    **{name: ("certificate.json", change) for name, change in FORGED.items()},
}


def test_untouched(folder: Path) -> None:
    reseal(folder)
    assert certified(folder) == (True, "")
    assert accepted(folder) == (True, "")


@pytest.mark.parametrize("name", ATTACKS)
def test_nothing_passes(name: str, folder: Path) -> None:
    file, change = ATTACKS[name]
    edit(folder / file, change)
    reseal(folder)
    proven, why = certified(folder)
    assert not proven
    assert why
    assert not accepted(folder)[0]


@pytest.mark.parametrize("name", [*SHRUNK])
def test_a_search_names_the_violation(name: str, folder: Path) -> None:
    edit(folder / "plan.json", SHRUNK[name])
    reseal(folder)
    assert "is short of" in certified(folder, search=True)[1]


def test_an_attitude_and_its_negative_are_one(folder: Path) -> None:
    """No attack: q and −q turn alike. The proof holds."""

    def negated(row: list[float]) -> None:
        row[6:10] = [-x for x in row[6:10]]

    edit(folder / "interpolant.json", every_row(negated))
    for name in ("trajectory.csv", "nodes.csv"):
        path = folder / name
        lines = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()]
        first = lines[0].index("qw")
        for cells in lines[1:]:
            cells[first : first + 4] = [repr(-float(x)) for x in cells[first : first + 4]]
        path.write_text("\n".join(map(",".join, lines)) + "\n", encoding="utf-8")
    assert certified(folder) == (True, "")
    assert accepted(folder)[0]


def test_a_random_normal_never_proves_more(folder: Path) -> None:
    """Whatever normals say, no bound exceeds what the search has proven by more than its sag."""
    rng = np.random.default_rng(3)

    def scrambled(document: Document) -> None:
        for row in rows(document):
            row[3:9] = rng.normal(size=6).tolist()
            row[2] = -100.0

    edit(folder / "certificate.json", scrambled)
    assert "not proven" in certified(folder)[1]
    assert not accepted(folder)[0]
