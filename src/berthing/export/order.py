"""Quaternions as others write them. Ours is q_IB = (w, x, y, z), v_I = R(q_IB) v_B."""

from __future__ import annotations

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array

SCALAR_LAST = "x y z w: scalar last; the Hamilton quaternion that turns body axes to the frame's"


def scalar_last(q_IB: Array) -> Array:
    """(..., 4) as x, y, z, w: CCSDS AEM 2.0, STK, CZML, glTF, ROS.

    CCSDS and STK speak of the rotation from the frame to the body. By that they mean the one that
    carries the frame's axes onto the body's, by an angle φ about e, written (e sin φ/2, cos φ/2);
    it takes body components to the frame's, as q_IB does. Their matrices, of components, are the
    transposes of R(q_IB).
    """
    return np.roll(q_IB, -1, axis=-1)


def spice(q_IB: Array) -> Array:
    """(..., 4), scalar first, of SPICE's C-matrix, v_B = C v_I: the conjugate (NAIF, q2m_c)."""
    return quaternion.conjugate(q_IB)
