"""certificate.json is read back to the last bit, and refused where it is anything else."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.verify.claims import Claims, PairClaim, PhaseClaims, read_claims, write_claims
from berthing.verify.tube import Tube

ROWS = 3


@pytest.fixture
def claims() -> Claims:
    rng = np.random.default_rng(2)
    t = np.sort(rng.random(ROWS + 1))
    pair = PairClaim("a.x|b.y", t[:-1], t[1:], rng.random(ROWS), rng.normal(size=(ROWS, 2, 3)))
    nothing = PairClaim("a.x|b.z", *(np.empty(0),) * 3, np.empty((0, 2, 3)))
    phase = PhaseClaims("main", {"a": Tube(1e-5 / 3, 2e-6 / 7)}, (pair, nothing))
    return Claims("f" * 64, (phase,))


@pytest.fixture
def path(claims: Claims, tmp_path: Path) -> Path:
    write_claims(tmp_path / "certificate.json", claims)
    return tmp_path / "certificate.json"


def test_round_trip(claims: Claims, path: Path) -> None:
    found = read_claims(path)
    assert found.scenario_sha256 == claims.scenario_sha256
    (phase,), (own,) = found.phases, claims.phases
    assert phase.tubes == own.tubes
    for read, written in zip(phase.pairs, own.pairs, strict=True):
        assert read.pair == written.pair
        for name in ("t0", "t1", "bound", "normals"):
            np.testing.assert_array_equal(getattr(read, name), getattr(written, name))


def test_a_tube_that_is_not_finite_is_left_out(tmp_path: Path) -> None:
    """A replay that failed: the file claims no tube, and nothing is certified."""
    phase = PhaseClaims("main", {"a": Tube(np.inf, 0.0), "b": Tube(0.0, 0.0)}, ())
    write_claims(tmp_path / "c.json", Claims("", (phase,)))
    assert set(read_claims(tmp_path / "c.json").phases[0].tubes) == {"b"}


def first(d: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = d["phases"][0]["pairs"][0]
    return found


def tube(d: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = d["phases"][0]["tubes"][0]
    return found


BROKEN: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    "schema": (lambda d: d.update(schema_version=2), "schema_version"),
    "no fingerprint": (lambda d: d.pop("scenario_sha256"), "scenario_sha256"),
    "no phases": (lambda d: d.pop("phases"), "phases"),
    "phases text": (lambda d: d.update(phases="main"), "phases"),
    "no tubes": (lambda d: d["phases"][0].pop("tubes"), "tubes"),
    "tube negative": (lambda d: tube(d).update(position_m=-1e-9), "position_m"),
    "tube text": (lambda d: tube(d).update(attitude_rad="0"), "attitude_rad"),
    "pair a number": (lambda d: first(d).update(pair=3), "pair"),
    "columns": (lambda d: [row.pop() for row in first(d)["intervals"]], "columns"),
    "ragged": (lambda d: first(d)["intervals"][0].pop(), "ragged"),
    "text": (lambda d: first(d)["intervals"][0].__setitem__(0, "0"), "intervals"),
    "flat": (lambda d: first(d).update(intervals=[0.0] * 9), "intervals"),
    "huge": (lambda d: first(d)["intervals"][0].__setitem__(2, 10**400), "huge"),
    "no intervals": (lambda d: first(d).pop("intervals"), "intervals"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_another_form_is_refused(path: Path, name: str) -> None:
    change, expected = BROKEN[name]
    document = json.loads(path.read_text(encoding="utf-8"))
    change(document)
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(InputError, match=expected):
        read_claims(path)


@pytest.mark.parametrize("word", ["NaN", "Infinity", "-Infinity"])
def test_numbers_that_are_none(path: Path, word: str) -> None:
    text = path.read_text(encoding="utf-8")
    start = text.index("[[") + 2
    path.write_text(text[:start] + word + text[text.index(",", start) :], encoding="utf-8")
    with pytest.raises(InputError, match="finite"):
        read_claims(path)
