"""Segments and the places of their nodes."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.transcription.mesh import Mesh

UNEVEN = Mesh("lgr", (0.0, 0.1, 0.6, 1.0), (3, 5, 2))


def test_uniform_segments_share_the_phase_evenly() -> None:
    mesh = Mesh.uniform("lgr", 4, 3)
    np.testing.assert_allclose(np.diff(mesh.breaks), 0.25)
    assert (mesh.segments, mesh.point_count, mesh.control_count) == (4, 13, 12)


def test_neighbours_share_a_point_and_no_control() -> None:
    assert [UNEVEN.point_offset(k) for k in range(3)] == [0, 3, 8]
    assert [UNEVEN.control_offset(k) for k in range(3)] == [0, 3, 8]
    fractions = UNEVEN.point_fractions()
    assert len(fractions) == UNEVEN.point_count == 11
    assert np.all(np.diff(fractions) > 0.0)
    np.testing.assert_array_equal(fractions[[0, 3, 8, 10]], [0.0, 0.1, 0.6, 1.0])


@pytest.mark.parametrize("fraction", [0.0, 0.05, 0.1, 0.35, 0.6, 0.99, 1.0])
def test_locating_undoes_the_fraction(fraction) -> None:
    k, s = UNEVEN.locate(fraction)
    assert -1.0 <= s <= 1.0
    assert UNEVEN.fraction(k, s) == pytest.approx(fraction, abs=1e-15)


def test_a_break_belongs_to_the_later_segment_and_the_end_to_the_last() -> None:
    assert UNEVEN.locate(0.1) == (1, -1.0)
    assert UNEVEN.locate(0.0) == (0, -1.0)
    assert UNEVEN.locate(1.0) == (2, 1.0)
    assert UNEVEN.locate(1.0 + 1e-12) == (2, 1.0)


def test_splitting_halves_the_segments_named_and_no_others() -> None:
    finer = UNEVEN.split({1})
    np.testing.assert_allclose(finer.breaks, [0.0, 0.1, 0.35, 0.6, 1.0])
    assert finer.degrees == (3, 5, 5, 2)
    assert UNEVEN.split(set()) == UNEVEN
    assert UNEVEN.split({0, 1, 2}).segments == 6


@pytest.mark.parametrize(
    ("breaks", "degrees"),
    [
        ((0.0, 0.5), (3,)),
        ((0.1, 1.0), (3,)),
        ((0.0, 1.0), (3, 3)),
        ((0.0, 0.5, 0.5, 1.0), (3,) * 3),
    ],
)
def test_breaks_that_do_not_cut_the_phase_are_refused(breaks, degrees) -> None:
    with pytest.raises(InputError, match="mesh"):
        Mesh("lgr", breaks, degrees)
