"""Named blocks and the vector that they make up."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.transcription.packing import Packing

UP = np.array([[1.0], [2.0]])


@pytest.fixture
def packing() -> Packing:
    made = Packing()
    made.add("state", (2, 3), scale=[10.0, 0.5], shift=[5.0, 0.0], lower=-20.0, upper=UP)
    made.add("time", (1, 1), scale=100.0, lower=50.0)
    made.add("free", (2, 1))
    return made


VALUES = {
    "state": np.array([[5.0, 15.0, -5.0], [1.0, 2.0, 3.0]]),
    "time": 150.0,
    "free": np.array([7.0, 8.0]),
}


def test_joining_and_splitting_are_inverse(packing) -> None:
    vector = packing.join(VALUES)
    assert vector.shape == (packing.size,) == (9,)
    for name, value in packing.split(vector).items():
        expected = np.reshape(VALUES[name], packing.blocks[name].shape)
        np.testing.assert_allclose(value, expected, atol=1e-14)


def test_the_vector_is_scaled_and_column_major(packing) -> None:
    expected = [0.0, 2.0, 1.0, 4.0, -1.0, 6.0, 1.5, 7.0, 8.0]
    np.testing.assert_allclose(packing.join(VALUES), expected)


def test_indices_point_at_what_was_packed(packing) -> None:
    vector = packing.join(VALUES)
    block = packing.blocks["state"]
    stored = vector[block.indices]
    np.testing.assert_allclose(block.shift + block.scale * stored, VALUES["state"])
    assert block.indices[1, 2] == 5
    # A transposed packing would not.
    assert not np.allclose(stored.ravel(), vector[block.offset : block.offset + block.size])


def test_bounds_are_scaled_alike(packing) -> None:
    lower, upper = packing.bounds()
    np.testing.assert_allclose(lower, [-2.5, -40.0] * 3 + [0.5, -np.inf, -np.inf])
    np.testing.assert_allclose(upper, [-0.4, 4.0] * 3 + [np.inf] * 3)


def test_a_missing_block_is_named(packing) -> None:
    with pytest.raises(KeyError, match="free"):
        packing.join({"state": VALUES["state"], "time": 1.0})


def test_two_blocks_of_one_name_are_refused(packing) -> None:
    with pytest.raises(ValueError, match="two blocks are called 'time'"):
        packing.add("time", (1, 1))


def test_carrying_takes_blocks_of_one_name_and_shape(packing) -> None:
    other = Packing()
    other.add("new", (2, 1))
    other.add("free", (2, 1))
    other.add("time", (1, 1), scale=100.0)
    other.add("state", (2, 2))
    carried = packing.carry(packing.join(VALUES), other, np.full(other.size, 9.0))
    np.testing.assert_allclose(carried, [9.0, 9.0, 7.0, 8.0, 1.5, 9.0, 9.0, 9.0, 9.0])
