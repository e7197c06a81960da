import numpy as np

from berthing.report.offline.packing import Packing


def test_arrays_are_read_back_with_their_shapes(unpacked):
    packing = Packing()
    values = np.array([[1.5, np.nan, -2.0], [0.1, np.inf, 3.0]])
    for ref, precision in ((packing.floats(values), 1e-7), (packing.exact(values), 0.0)):
        np.testing.assert_allclose(unpacked(ref, packing.buffers), values, rtol=precision)


def test_indices_take_two_bytes_where_they_fit(unpacked):
    packing = Packing()
    for largest, kind in ((65535, "u16"), (65536, "u32")):
        ref = packing.indices([[0, largest]])
        assert ref["t"] == kind
        np.testing.assert_array_equal(unpacked(ref, packing.buffers), [[0, largest]])
    assert unpacked(packing.indices(np.empty((0, 2), dtype=int)), packing.buffers).shape == (0, 2)


def test_equal_arrays_are_kept_once():
    packing = Packing()
    first = packing.floats([1.0, 2.0])
    packing.floats([1.0, 3.0])
    assert packing.floats(np.array([1.0, 2.0])) == first
    assert len(packing.buffers) == 2
