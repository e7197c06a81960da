"""What certificate.json claims is proven from its normals, or not at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.geometry.sphere import Sphere
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.motion import ConstantSpin
from berthing.trajectory import PhaseTrajectory
from berthing.verify import claimed_bounds
from berthing.verify.certificate import Certificate, certify
from berthing.verify.claims import Claims, PairClaim, PhaseClaims, claims_of
from berthing.verify.recheck import check_claims
from berthing.verify.tube import EXACT, Tube

PAIR = "craft.p0|wall.p0"


@pytest.fixture(scope="module")
def case(make):
    """A ball passes a spinning box; what is claimed of it is what the search has found."""
    own = make.vehicle(Sphere(0.5))
    law = ConstantSpin(make.placed([0, 0, 0]), np.array([0, 0, 1.0]), 0.3, np.zeros(3))
    wall = make.structure(Box(np.array([1.0, 1.0, 1.0])), motion=law)
    late = MarginOverride("craft", "wall", 0.05, (6.0, 10.0))
    whole = make.scenario([own], [wall], MarginPolicy(0.1, (late,)))
    flown = make.path(own, lambda t: np.stack([t - 5.0, 2.6 + 0.0 * t, 0.0 * t], axis=1), degree=3)
    trajectory = PhaseTrajectory("main", (flown,))
    found = certify(whole, whole.phases[0], trajectory, tubes={"craft": EXACT})
    return whole, trajectory, claims_of([found], "").phase("main")


def checked(case, claims: PhaseClaims | None = None, tube: Tube = EXACT) -> Certificate:
    whole, trajectory, own = case
    return check_claims(whole, whole.phases[0], trajectory, claims or own, {"craft": tube})


def changed(case, **columns) -> PhaseClaims:
    """The claims with columns of the one pair replaced."""
    (pair,) = case[2].pairs
    return replace(case[2], pairs=(replace(pair, **columns),))


def only(found: Certificate):
    (verdict,) = found.verdicts
    return verdict


def test_what_the_search_found_is_proven(case) -> None:
    found = checked(case)
    assert only(found).verdict == "certified"
    assert not found.notes
    (pair,) = case[2].pairs
    assert only(found).lower_bound_m >= np.min(pair.bound) - 1e-12
    assert found.closest is not None
    assert found.closest[0] == PAIR


@pytest.mark.parametrize("row", [0, 3, -1])
def test_a_gap_is_found_where_it_is(case, row: int) -> None:
    (pair,) = case[2].pairs
    keep = np.ones(len(pair.t0), dtype=bool)
    keep[row] = False
    columns = {name: getattr(pair, name)[keep] for name in ("t0", "t1", "bound", "normals")}
    verdict = only(checked(case, changed(case, **columns)))
    assert verdict.verdict == "unproven"
    assert verdict.gap_s == (pair.t0[row], pair.t1[row])
    assert "is not proven by certificate.json" in verdict.reason
    assert verdict.lower_bound_m == -np.inf


def test_bounds_beyond_their_normals_are_false(case) -> None:
    (pair,) = case[2].pairs
    found = checked(case, changed(case, bound=pair.bound + 10.0))
    # The clearance is proven all the same; the file says what is not so.
    assert only(found).verdict == "certified"
    assert "claims" in found.notes[0]
    assert PAIR in found.notes[0]
    assert not checked(case, changed(case, bound=pair.bound + 1e-10)).notes


def test_long_normals_prove_no_more_than_unit_ones(case) -> None:
    (pair,) = case[2].pairs
    long = only(checked(case, changed(case, normals=1e6 * pair.normals)))
    assert long.lower_bound_m == pytest.approx(only(checked(case)).lower_bound_m, abs=1e-9)


def test_a_normal_that_is_none(case) -> None:
    (pair,) = case[2].pairs
    normals = pair.normals.copy()
    normals[2, 1, 0] = np.nan
    assert only(checked(case, changed(case, normals=normals))).verdict == "unproven"


def test_an_interval_over_several_cells_proves_what_its_parts_do(case) -> None:
    """The proof of two neighbours, put in one interval with the normal of the first."""
    (pair,) = case[2].pairs
    n = pair.normals[0, 0]
    spans = [(0.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
    bounds = []
    for t0, t1 in spans:
        one = PairClaim(PAIR, np.array([t0]), np.array([t1]), np.zeros(1), np.array([[n, n]]))
        (evidence,) = checked(case, replace(case[2], pairs=(one,))).evidence
        bounds.append(float(evidence.leaves.bound[0]))
    assert bounds[2] == pytest.approx(min(bounds[:2]))


def test_too_many_parts_are_refused(case, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(claimed_bounds, "MOST_CUTS", 5)
    wide = changed(
        case, t0=np.zeros(2), t1=np.full(2, 10.0), bound=np.zeros(2), normals=np.zeros((2, 2, 3))
    )
    with pytest.raises(InputError, match="too many segments"):
        checked(case, wide)


def test_a_pair_that_is_not_the_scenarios(case) -> None:
    (pair,) = case[2].pairs
    more = replace(case[2], pairs=(pair, replace(pair, pair="craft.p0|moon.p0")))
    assert "'craft.p0|moon.p0'" in checked(case, more).notes[0]
    assert "twice" in checked(case, replace(case[2], pairs=(pair, pair))).notes[0]


def test_tubes_are_what_is_wider(case) -> None:
    """A tube narrower than the replay's is false; a wider one weakens every bound."""
    narrow = checked(case, tube=Tube(1e-3, 0.0))
    assert "gives craft a tube of 0 m" in narrow.notes[0]
    assert narrow.tube_m == pytest.approx(1e-3)
    wide = replace(case[2], tubes={"craft": Tube(2e-3, 0.0)})
    found = checked(case, wide, Tube(1e-3, 0.0))
    assert not [note for note in found.notes if "tube" in note]
    assert found.tube_m == pytest.approx(2e-3)
    weaker = only(checked(case)).lower_bound_m - 2e-3
    assert only(found).lower_bound_m == pytest.approx(weaker, abs=1e-9)


def test_a_phase_that_the_file_is_silent_about(case) -> None:
    nothing = Claims("", ()).phase("main")
    verdict = only(checked(case, nothing))
    assert verdict.verdict == "unproven"
    assert verdict.gap_s == (0.0, 6.0)
