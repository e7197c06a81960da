"""A rigid body in space: the paper's spacecraft."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.pose import Pose
from berthing.scenario.native_state import Model
from berthing.scenario.wrench import Wrench

# Files print inertias to six digits or so, and a relative error of this size is rounding: it is
# allowed in the symmetry and in the triangle inequality (a thin plate meets that with equality).
INERTIA_ROUNDING = 1e-5


@dataclass(frozen=True, eq=False)
class RigidBody(Model):
    """Mass properties and known wrenches of a rigid body.

    The native state is r_I, v_I (inertial axes), q_IB (scalar first), ω_B; the control is force
    and torque in the body frame at the reference point.

    Attributes:
        mass_kg: m > 0.
        inertia_kg_m2: J about the reference point, body axes (3, 3).
        first_moment_kg_m: c = m times the centre of mass, body axes (3,).
        wrenches: known inputs of time.

    Raises:
        InputError: mass not positive; inertia not symmetric, or about the centre of mass not
            positive definite or with one principal moment above the sum of the other two, which
            no distribution of mass has.
    """

    mass_kg: float
    inertia_kg_m2: Array
    first_moment_kg_m: Array = field(default_factory=lambda: np.zeros(3))
    wrenches: tuple[Wrench, ...] = ()

    kind: ClassVar[str] = "rigid-body"

    def __post_init__(self) -> None:
        if not (np.isfinite(self.mass_kg) and self.mass_kg > 0.0):
            raise InputError("mass_kg", f"is {self.mass_kg}", "a positive number")
        inertia = as_array(self.inertia_kg_m2, (3, 3), "inertia_kg_m2")
        object.__setattr__(self, "inertia_kg_m2", inertia)
        moment = as_array(self.first_moment_kg_m, (3,), "first_moment_kg_m")
        object.__setattr__(self, "first_moment_kg_m", moment)
        object.__setattr__(self, "wrenches", tuple(self.wrenches))
        _check_inertia(inertia, self.inertia_cm_kg_m2)

    @property
    def dim(self) -> int:
        return 3

    @property
    def state_names(self) -> tuple[str, ...]:
        return (
            *("x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s"),
            *("qw", "qx", "qy", "qz", "wx_rad_s", "wy_rad_s", "wz_rad_s"),
        )

    @property
    def control_names(self) -> tuple[str, ...]:
        return ("fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm")

    @property
    def centre_of_mass_m(self) -> Array:
        """c / m, body axes (3,)."""
        return self.first_moment_kg_m / self.mass_kg

    @property
    def inertia_cm_kg_m2(self) -> Array:
        """J − (‖c‖² I − c cᵀ)/m, about the centre of mass (3, 3): the parallel axis theorem."""
        c = self.first_moment_kg_m
        return self.inertia_kg_m2 - (c @ c * np.eye(3) - np.outer(c, c)) / self.mass_kg

    def pose(self, x: Array) -> Pose:
        return Pose.from_quaternion(x[..., 0:3], x[..., 6:10])

    def velocity(self, x: Array) -> tuple[Array, Array]:
        rotation = quaternion.rotation_matrix(x[..., 6:10])
        return x[..., 3:6], np.einsum("...ij,...j->...i", rotation, x[..., 10:13])

    def assemble(self, r_m: Array, q_IB: Array, v_m_s: Array, w_body_rad_s: Array) -> Array:
        return np.concatenate([r_m, v_m_s, q_IB, w_body_rad_s], axis=-1)


def _check_inertia(inertia: Array, about_centre: Array) -> None:
    where = "inertia_kg_m2"
    scale = float(np.max(np.abs(inertia)))
    if np.max(np.abs(inertia - inertia.T)) > INERTIA_ROUNDING * scale:
        raise InputError(where, "is not symmetric", "a symmetric 3×3 matrix")
    moments = np.linalg.eigvalsh(0.5 * (inertia + inertia.T))
    if moments[0] <= 0.0:
        what = f"is not positive definite: its smallest principal moment is {moments[0]:.6g} kg·m²"
        raise InputError(where, what, "positive principal moments")
    moments = np.linalg.eigvalsh(0.5 * (about_centre + about_centre.T))
    if moments[0] <= 0.0:
        what = (
            "less what the first moment accounts for is not positive definite: about the centre "
            f"of mass the smallest principal moment is {moments[0]:.6g} kg·m²"
        )
        raise InputError(where, what, "J − (‖c‖² I − c cᵀ)/m positive definite")
    if moments[2] > (moments[0] + moments[1]) * (1.0 + INERTIA_ROUNDING):
        found = ", ".join(f"{m:.6g}" for m in moments)
        what = f"has the principal moments {found} kg·m² about the centre of mass"
        raise InputError(where, what, "none above the sum of the other two")
