"""Where the plan's frame lies on the turning Earth, for scenes drawn on it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.export.epoch import Epoch
from berthing.export.meta import Meta
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array

DAY_S = 86400.0
CENTURY_DAYS = 36525.0
# WGS 84: semi-major axis and flattening.
WGS84_A_M, WGS84_F = 6378137.0, 1.0 / 298.257223563
INERTIAL = ("EME2000", "J2000", "ICRF", "GCRF")
EARTH_FIXED = ("ITRF", "ITRF2000", "ITRF2008", "ITRF2014", "ITRF2020", "WGS84", "ECEF")


@dataclass(frozen=True, eq=False)
class Placement:
    """The plan's frame I in the Earth-fixed one F over time.

    Attributes:
        q_FI: (k, 4), v_F = R(q_FI) v_I.
        origin_m: the plan's origin (3,), Earth-fixed.
        told: how it came about, in one line.
    """

    q_FI: Array
    origin_m: Array
    told: str

    def poses(self, position_m: Array, q_IB: Array) -> tuple[Array, Array]:
        """Positions (k, 3) and quaternions q_FB (k, 4) of the plan's (k, 3) and (k, 4)."""
        turned = np.einsum("kij,kj->ki", quaternion.rotation_matrix(self.q_FI), position_m)
        return self.origin_m + turned, quaternion.multiply(self.q_FI, q_IB)


def placement(meta: Meta, epoch: Epoch, t_s: Array) -> Placement:
    """The placement at the times t (k,).

    With ``site`` in ``meta:``, the plan stands still on the Earth there, x east, y north, z up,
    whatever its frame: a stage to look at. Else its frame and centre have to be the Earth's.

    Raises:
        InputError: none of these.
    """
    still = np.tile([1.0, 0.0, 0.0, 0.0], (len(t_s), 1))
    if "site" in meta.values:
        longitude, latitude, height = _site(meta)
        q = quaternion.multiply(_about(2, np.pi / 2 + longitude), _about(0, np.pi / 2 - latitude))
        told = "drawn at rest at meta.site: x east, y north, z up (WGS 84)"
        origin = _geodetic(longitude, latitude, height)
        return Placement(np.tile(q, (len(t_s), 1)), origin, told)
    frame = (meta.frame or "").upper()
    if (meta.centre or "").upper() == "EARTH" and frame in (*EARTH_FIXED, *INERTIAL):
        if frame in EARTH_FIXED:
            return Placement(still, np.zeros(3), "the plan's frame is fixed to the Earth")
        q_FI = quaternion.conjugate(_earth_axes(epoch.tdb_s + t_s))
        told = "turned from ICRF to Earth-fixed axes by the IAU's IAU_EARTH, good to 0.2 degrees"
        return Placement(q_FI, np.zeros(3), told)
    what = f"has the frame {meta.frame!r} and the centre {meta.centre!r}, not the Earth's"
    site = "site: {longitude_deg: 0, latitude_deg: 0, height_m: 400000}"
    raise InputError(meta.where, what, f"{site}, where the plan is to be drawn")


def _earth_axes(tdb_s: Array) -> Array:
    """q_IF (k, 4) of the Earth-fixed axes in ICRF, at seconds of TDB past J2000.

    B. A. Archinal et al., Report of the IAU Working Group on Cartographic Coordinates and
    Rotational Elements: 2009, doi:10.1007/s10569-010-9320-4, table 1: the pole's right ascension
    and declination and the prime meridian's angle, in degrees. Against the full model of
    precession, nutation and rotation it is off by 0.05 to 0.11 degrees in the years 2000 to 2035.
    """
    days = tdb_s / DAY_S
    centuries = days / CENTURY_DAYS
    right_ascension = np.radians(-0.641 * centuries)
    declination = np.radians(90.0 - 0.557 * centuries)
    meridian = np.radians((190.147 + 360.9856235 * days) % 360.0)
    node = quaternion.multiply(
        _about(2, np.pi / 2 + right_ascension), _about(0, np.pi / 2 - declination)
    )
    return quaternion.multiply(node, _about(2, meridian))


def _about(axis: int, angle: Array | float) -> Array:
    return quaternion.from_axis_angle(np.eye(3)[axis], angle)


def _site(meta: Meta) -> tuple[float, float, float]:
    """Longitude and latitude in radians, height in metres."""
    site, where = meta.values["site"], f"{meta.where}.site"
    if not isinstance(site, Mapping):
        raise InputError(where, f"is {site!r}", "longitude_deg, latitude_deg and height_m")
    longitude = _number(site, "longitude_deg", where, 360.0)
    latitude = _number(site, "latitude_deg", where, 90.0)
    height = _number(site, "height_m", where, 1e9)
    return float(np.radians(longitude)), float(np.radians(latitude)), height


def _number(site: Mapping[str, Any], key: str, where: str, most: float) -> float:
    value = site.get(key)
    sound = isinstance(value, int | float) and not isinstance(value, bool)
    if not sound or not abs(float(site[key])) <= most:
        raise InputError(f"{where}.{key}", f"is {value!r}", f"a number of {-most:g} to {most:g}")
    return float(site[key])


def _geodetic(longitude: float, latitude: float, height_m: float) -> Array:
    """Earth-fixed position (3,) of a point above the WGS 84 ellipsoid."""
    eccentricity2 = WGS84_F * (2.0 - WGS84_F)
    normal = WGS84_A_M / np.sqrt(1.0 - eccentricity2 * np.sin(latitude) ** 2)
    across = (normal + height_m) * np.cos(latitude)
    return np.array(
        [
            across * np.cos(longitude),
            across * np.sin(longitude),
            (normal * (1.0 - eccentricity2) + height_m) * np.sin(latitude),
        ]
    )
