"""Known wrenches: linear between times, the force's moment added."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.wrench import Wrench

POINT = np.array([0.0, 2.0, 0.0])
FORCE = np.array([[0.0, 0, 0], [3.0, 0, 0]])
TORQUE = np.array([[1.0, 0, 0], [1.0, 0, 4.0]])


def test_total_is_linear_between_and_constant_outside() -> None:
    wrench = Wrench("arm", POINT, np.array([10.0, 20.0]), FORCE, TORQUE)
    force, torque = wrench.total(np.array([0.0, 10.0, 15.0, 20.0, 99.0]))
    np.testing.assert_allclose(force[:, 0], [0, 0, 1.5, 3, 3])
    # ρ × f = (0, 2, 0) × (f, 0, 0) = (0, 0, −2 f)
    np.testing.assert_allclose(torque[:, 2], [0, 0, 2 - 3, 4 - 6, 4 - 6])
    np.testing.assert_allclose(torque[:, 0], 1.0)


@pytest.mark.parametrize(
    ("times", "force", "says"),
    [
        ([20.0, 10.0], FORCE, "do not increase"),
        ([10.0, 10.0], FORCE, "do not increase"),
        ([], FORCE, "do not increase"),
        ([10.0, 20.0], FORCE[:1], "force_n"),
        ([10.0, 20.0], FORCE * np.nan, "NaN"),
    ],
)
def test_bad_tables_are_refused(times: list[float], force: np.ndarray, says: str) -> None:
    with pytest.raises(InputError, match=says):
        Wrench("arm", POINT, np.array(times), force, TORQUE)
