import base64

import numpy as np
import pytest

from berthing.report.offline.packing import TYPES


@pytest.fixture
def unpacked():
    """Reads a reference as the page does."""

    def read(ref, buffers):
        raw = base64.b64decode(buffers[ref["b"]])
        return np.frombuffer(raw, dtype=TYPES[ref["t"]]).reshape(ref["n"])

    return read
