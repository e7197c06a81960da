"""Poses that break distance algorithms: touching, parallel, crossed, concentric, far, thin."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks._distance_contacts import ALL_CONTACTS, CONTACTS, Contact

from berthing.clearance.placed_distance import distance
from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.geometry.capability import level
from berthing.geometry.pose import Pose
from support.distances import BRACKET, DEPTH

# coal enlarges boxes by 1e-10 of their size, and its EPA ends at 1e-6 of it.
TOLERANCE_M = 5e-6


def check(contact: Contact, distance: float, at: Pose) -> None:
    a, b, beyond = contact.a, contact.b, at.compose(contact.pose)
    found = PairQuery(a, b).query(at, beyond)
    assert found.distance == pytest.approx(distance, abs=TOLERANCE_M)
    assert found.lower_bound == pytest.approx(distance, abs=TOLERANCE_M)
    bound = plane_bound(a, at, b, beyond, found.normal)
    assert found.lower_bound == pytest.approx(float(bound), abs=1e-14 * (1e3 + abs(distance)))
    assert np.linalg.norm(found.normal) == pytest.approx(1.0, abs=1e-14)
    assert level(a, at.inverse().apply(found.point_a)) < TOLERANCE_M
    assert level(b, beyond.inverse().apply(found.point_b)) < TOLERANCE_M
    np.testing.assert_allclose(
        found.point_b - found.point_a, found.distance * found.normal, atol=TOLERANCE_M
    )


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.name)
def test_contact(contact: Contact) -> None:
    check(contact, contact.distance, Pose.identity(contact.a.dim))


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.name)
def test_contact_elsewhere(contact: Contact) -> None:
    """The same away from the origin and turned, so that rounding disturbs the symmetry."""
    check(contact, contact.distance, contact.elsewhere)


def check_bracket(contact: Contact, true_m: float, at: Pose) -> None:
    """The true distance is known as exactly as the project asks, between two proofs."""
    found = distance(contact.a, contact.b, (at, at.compose(contact.pose)))
    rounding = 1e-15 * (1e3 + abs(true_m))
    width = BRACKET if true_m > 0.0 else DEPTH
    assert found.lower_bound - rounding <= true_m <= found.upper_bound + rounding
    assert found.upper_bound - found.lower_bound <= width
    assert found.distance == pytest.approx(true_m, abs=BRACKET)
    assert np.linalg.norm(found.normal) == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("contact", ALL_CONTACTS, ids=lambda contact: contact.name)
def test_contact_is_bracketed(contact: Contact) -> None:
    for at in (Pose.identity(contact.a.dim), contact.elsewhere):
        check_bracket(contact, contact.distance, at)


def test_the_checks_notice_a_wrong_distance() -> None:
    with pytest.raises(AssertionError):
        check(CONTACTS[0], 1e-5, Pose.identity())
    for contact in (CONTACTS[2], CONTACTS[3]):
        for error in (1e-7, -1e-7):
            with pytest.raises(AssertionError):
                check_bracket(contact, contact.distance + error, Pose.identity())
