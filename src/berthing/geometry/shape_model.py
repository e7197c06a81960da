"""What stands for a shape while a motion is planned: the shape, or a smooth set inside or around.

Whatever the model, a plan is checked against the shape itself.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from berthing.errors import InputError
from berthing.geometry import smoothed_cylinder
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet, positive
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid

Side = Literal["exact", "inner", "outer"]
SIDES: tuple[Side, ...] = ("exact", "inner", "outer")


@dataclass(frozen=True)
class ShapeModel:
    """How a part is modelled in planning.

    Attributes:
        side: ``exact``, ``inner`` (the paper's) or ``outer``.
        exponent: of the smooth model: per metre for boxes and polytopes, the even power along the
            axis for cylinders.
        error_m: instead of the exponent: the distance allowed between the model and the shape.

    Raises:
        InputError: another side, a number that is not above zero, or not exactly one of the two.
    """

    side: Side = "exact"
    exponent: float | None = None
    error_m: float | None = None

    def __post_init__(self) -> None:
        if self.side not in SIDES:
            raise InputError("side", f"is {self.side!r}", " or ".join(SIDES))
        given = [name for name in ("exponent", "error_m") if getattr(self, name) is not None]
        for name in given:
            positive(getattr(self, name), name)
        if self.side == "exact" and given:
            raise InputError(given[0], "stands beside an exact model", "inner or outer with it")
        if self.side != "exact" and len(given) != 1:
            what = f"is {self.side}, with {len(given)} of exponent and error_m"
            raise InputError("side", what, "one of the two")

    def of(self, shape: ConvexSet) -> ConvexSet:
        """The shape's model; the shape itself where it is smooth as it is, or to be exact.

        Raises:
            InputError: no smooth model of such a shape is known, or the exponent leaves nothing.
        """
        if self.side == "exact" or isinstance(shape, _SMOOTH):
            return shape
        try:
            by_exponent, by_error = _MODELS[type(shape)]
        except KeyError:
            able = ", ".join(kind.__name__ for kind in (*_MODELS, *_SMOOTH))
            what = f"{type(shape).__name__} has no {self.side} model"
            raise InputError("shape_model", what, f"exact, or one of: {able}") from None
        try:
            if self.exponent is not None:
                return by_exponent[self.side](shape, self.exponent)
            return by_error(shape, self.error_m, self.side)
        except InputError as error:
            what = f"{error.where} {error.what}"
            raise InputError("shape_model", what, error.expected) from None


EXACT = ShapeModel()


def model_error_m(shape: ConvexSet, model: ConvexSet) -> float:
    """A proven bound on the Hausdorff distance of a shape and its model, in metres."""
    if isinstance(model, SmoothedPolytope):
        return model.error_m
    if isinstance(shape, Cylinder) and isinstance(model, Superellipsoid):
        return smoothed_cylinder.error(shape, model)
    return 0.0


# One smooth function is all they are.
_SMOOTH = (Sphere, Ellipsoid, Superellipsoid, SmoothedPolytope)

_POLYTOPE = (
    {"inner": SmoothedPolytope.inner, "outer": SmoothedPolytope.outer},
    SmoothedPolytope.for_error,
)
_MODELS: Mapping[type, tuple[Mapping[str, Callable[..., ConvexSet]], Callable[..., ConvexSet]]] = {
    Box: _POLYTOPE,
    Polytope: _POLYTOPE,
    Cylinder: (smoothed_cylinder.BUILDERS, smoothed_cylinder.for_error),
}
