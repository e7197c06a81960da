"""The table of formulations by name."""

from __future__ import annotations

from collections.abc import Callable

from berthing.errors import InputError
from berthing.geometry.convex_set import ConvexSet
from berthing.proximity.dual import DualFormulation
from berthing.proximity.enclosed import bounding_ellipsoid, bounding_sphere
from berthing.proximity.formulation import PairFormulation
from berthing.proximity.kkt import KktFormulation
from berthing.proximity.kkt_complementarity import KktComplementarityFormulation
from berthing.proximity.linearised import LinearisedFormulation
from berthing.proximity.plane import PlaneFormulation

FORMULATIONS: dict[str, Callable[[ConvexSet, ConvexSet], PairFormulation]] = {
    "plane": PlaneFormulation,
    "dual": DualFormulation,
    "kkt": KktFormulation,
    "kkt-complementarity": KktComplementarityFormulation,
    "bounding-sphere": bounding_sphere,
    "bounding-ellipsoid": bounding_ellipsoid,
}

SEQUENTIAL: dict[str, Callable[[ConvexSet, ConvexSet], PairFormulation]] = {
    "signed-distance-sequential": LinearisedFormulation,
}
"""Forms that hold only near where they start: for steps in a trust region, not for plans."""


def formulate(name: str, a: ConvexSet, b: ConvexSet) -> PairFormulation:
    """The formulation ``name`` for the sets A and B.

    Raises:
        InputError: no such formulation.
        CapabilityError: the formulation cannot take one of the sets.
    """
    try:
        build = (FORMULATIONS | SEQUENTIAL)[name]
    except KeyError:
        known = ", ".join(sorted(FORMULATIONS))
        raise InputError("formulation", f"there is no {name!r}", f"one of {known}") from None
    return build(a, b)


def check_planned(name: str) -> None:
    """Refuse a formulation that no plan can be made with, or that does not exist.

    Raises:
        InputError: naming those that there are.
    """
    if name not in FORMULATIONS:
        known = ", ".join(sorted(FORMULATIONS))
        what = f"there is no {name!r}"
        if name in SEQUENTIAL:
            what = f"{name!r} is there to be compared with only"
        raise InputError("formulation", what, f"one of {known}")
