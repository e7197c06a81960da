"""Superellipsoids for cylinders: the paper's (x/L)^P + (y/r)² + (z/r)² ≤ 1, inside, and one around.

Half-length L, radius r, P even. The Hausdorff distance is proven as in ``polytope_smoothing``; all
sets here are bodies of revolution about one axis, so it is that of their halves in the plane
through the axis.

Inside, the distance from the cylinder is largest at the rim, where a member nearest to it bounds
it. Around, the set must contain the rim: with L' = L θ^(−1/P) and r' = r (1 − θ)^(−1/2) the two
terms are θ and 1 − θ there. The ends then bulge by L' − L, the mantle by r' − r, and θ makes these
equal.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from scipy.optimize import brentq

from berthing.errors import InputError
from berthing.geometry import direction_cover
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import finite, norm, positive
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.superellipsoid import Superellipsoid

# Of θ and 1 − θ.
SMALLEST_SHARE = 1e-12
# A model with sides as sharp as this is beyond the use of a smooth one.
GREATEST_EXPONENT = 1 << 20
# So that rounding leaves no point of the rim outside.
ROUNDING = 1e-14


def inner(cylinder: Cylinder, exponent: float) -> Superellipsoid:
    """The paper's model, inside the cylinder.

    Raises:
        InputError: an exponent that is not an even number of 2 or more.
    """
    return _along(cylinder, cylinder.half_length, cylinder.radius, _checked(exponent))


def outer(cylinder: Cylinder, exponent: float) -> Superellipsoid:
    """One around the cylinder, through its rims.

    Raises:
        InputError: an exponent that is not an even number of 2 or more.
    """
    P, L, r = _checked(exponent), cylinder.half_length, cylinder.radius

    def bulges(share: float) -> tuple[float, float]:
        """Of the ends and of the mantle, in metres; expm1 and log1p for shares near 1 and 0."""
        return (
            L * float(np.expm1(-np.log(share) / P)),
            r * float(np.expm1(-0.5 * np.log1p(-share))),
        )

    def uneven(share: float) -> float:
        ends, mantle = bulges(share)
        return ends - mantle

    share = brentq(uneven, SMALLEST_SHARE, 1.0 - SMALLEST_SHARE, xtol=SMALLEST_SHARE)
    ends, mantle = bulges(share)
    larger = 1.0 + ROUNDING
    return _along(cylinder, (L + ends) * larger, (r + mantle) * larger, P)


def for_error(
    cylinder: Cylinder, error_m: float, side: Literal["inner", "outer"]
) -> Superellipsoid:
    """The model with the smallest exponent that has no larger an error.

    Args:
        cylinder: what to model.
        error_m: allowed distance from any point of either set to the other.
        side: ``inner`` or ``outer``.

    Raises:
        InputError: an error that is not above zero, or so small that no exponent of use will do.
    """
    allowed, build = positive(error_m, "error_m"), BUILDERS[side]
    high = 2
    while error(cylinder, build(cylinder, high)) > allowed:
        high *= 2
        if high > GREATEST_EXPONENT:
            raise InputError("error_m", f"is {allowed:g}", "an error that an exponent can reach")
    low = high // 2
    # The error falls as the exponent grows: bisection over even numbers.
    while high - low > 2:
        middle = low + 2 * ((high - low) // 4)
        if error(cylinder, build(cylinder, middle)) > allowed:
            low = middle
        else:
            high = middle
    return build(cylinder, high)


BUILDERS: dict[str, Callable[[Cylinder, float], Superellipsoid]] = {"inner": inner, "outer": outer}


def error(cylinder: Cylinder, model: Superellipsoid) -> float:
    """A proven bound on the Hausdorff distance of a cylinder and its model, in metres."""
    across = 1 if cylinder.axis_index == 0 else 0
    keep = [cylinder.axis_index, across]
    half = Superellipsoid(model.semi_axes[keep], model.exponents[keep])
    corner = np.array([cylinder.half_length, cylinder.radius])
    if np.all(half.semi_axes <= corner):
        nearest, _ = half.hill.climb(corner[None], corner[None], pull=1.0)
        return float(norm(nearest[0] - corner))

    def beyond(u: Array) -> Array:
        return np.asarray(half.support(u)[0] - u @ corner)

    return direction_cover.largest(beyond, np.eye(2)[None])


def _along(cylinder: Cylinder, half_length: float, radius: float, exponent: int) -> Superellipsoid:
    semi_axes, exponents = np.full(3, radius), np.full(3, 2)
    semi_axes[cylinder.axis_index], exponents[cylinder.axis_index] = half_length, exponent
    return Superellipsoid(semi_axes, exponents)


def _checked(exponent: float) -> int:
    number = finite(exponent, "exponent")
    if number < 2 or number % 2 != 0:
        raise InputError("exponent", f"is {number:g}", "an even number, 2 or more, for a cylinder")
    return int(number)
