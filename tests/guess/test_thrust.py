"""Bodies turned so that they push hardest along their way."""

from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.guess.candidates import candidates
from berthing.guess.thrust import pushing_attitude, turned_onto
from support.documents import puck, scenario, spacecraft

ALONG = np.array([10.0, 3.0, 0.0]) / np.sqrt(109.0)
IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])
LIMITS = {"max_force_n": [0.02, 0.01, 0.02], "max_torque_nm": 0.01}


def vehicle(**changes):
    return scenario(spacecraft(limits=LIMITS, **changes)).phases[0].vehicles[0]


@pytest.mark.parametrize("q", [IDENTITY, np.array([0.6, 0.0, 0.0, -0.8])])
def test_the_diagonal_of_the_box_of_forces_points_along_the_way(q):
    found = pushing_attitude(vehicle(), q, ALONG)
    in_body = quaternion.rotation_matrix(found).T @ ALONG
    np.testing.assert_allclose(np.abs(in_body), np.array([2, 1, 2]) / 3, atol=1e-12)
    # No other diagonal is nearer.
    assert quaternion.angle_between(q, found) <= np.arccos(1 / np.sqrt(3)) + 0.2


def test_no_turn_where_there_is_none_to_make():
    diagonal = quaternion.rotation_matrix(IDENTITY) @ np.array([2.0, 1.0, 2.0]) / 3
    np.testing.assert_array_equal(pushing_attitude(vehicle(), IDENTITY, diagonal), IDENTITY)
    np.testing.assert_array_equal(turned_onto(ALONG, -ALONG, IDENTITY), IDENTITY)


def test_who_cannot_turn_or_has_no_limit_is_left_alone():
    point = scenario(puck(limits={"max_force_n": 1})).phases[0].vehicles[0]
    assert pushing_attitude(point, IDENTITY, ALONG[:2]) is None
    assert pushing_attitude(replace(vehicle(), limits=_unlimited()), IDENTITY, ALONG) is None


def _unlimited():
    return scenario(spacecraft()).phases[0].vehicles[0].limits


@pytest.mark.parametrize("free", [True, False])
def test_it_is_a_guess_where_time_is_free(free):
    horizon = {"min_s": 50, "max_s": 150} if free else {"duration_s": 100}
    given = scenario(spacecraft(limits=LIMITS), horizon=horizon)
    names = [guess.name for guess in candidates(given, given.phases[0], 0)]
    assert ("pushing along the way" in names) is free
