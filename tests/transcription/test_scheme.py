"""The schemes' node sets."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.transcription.scheme import scheme


@pytest.mark.parametrize("degree", [1, 3, 6])
def test_radau_segments_collocate_all_but_the_end(degree) -> None:
    nodes = scheme("lgr")(degree)
    assert (nodes.points[0], nodes.points[-1]) == (-1.0, 1.0)
    assert nodes.collocated == tuple(range(degree))
    assert nodes.D.shape == (degree, degree + 1)
    np.testing.assert_array_equal(nodes.control_points, nodes.points[:-1])
    assert np.sum(nodes.weights) == pytest.approx(2.0)


@pytest.mark.parametrize("degree", [1, 3, 6])
def test_integrating_the_slope_gives_back_the_difference(degree) -> None:
    # wᵀ D = e_end - e_0 holds where quadrature is exact for derivatives of the state polynomial.
    nodes = scheme("lgr")(degree)
    expected = np.zeros(degree + 1)
    expected[[0, -1]] = -1.0, 1.0
    np.testing.assert_allclose(nodes.weights @ nodes.D, expected, atol=1e-13)


def test_an_unknown_scheme_is_told_which_there_are() -> None:
    with pytest.raises(InputError, match=r"no 'gauss' \(expected one of lgl, lgl-global, lgr\)"):
        scheme("gauss")
