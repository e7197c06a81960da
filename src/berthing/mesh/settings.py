"""How a solid is to be decomposed."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.errors import InputError

# Pieces may add this much to the solid's volume, if nobody says otherwise: a torus then has about
# ten pieces.
VOLUME_RATIO = 1.15
# The push that is tried last, of the size of the solid.
LARGEST_PUSH = 1e-3


@dataclass(frozen=True)
class DecomposeSettings:
    """What is asked of a decomposition.

    Attributes:
        volume_ratio: the sum of the pieces' volumes over the solid's that is aimed at; fewer
            pieces with fewer faces for a larger one. Above 1.
        largest_push_m: the most by which the pieces' faces are moved out; None for a thousandth
            of the size of the solid.
        seed: of CoACD.

    Raises:
        InputError: a ratio of 1 or less, or a push that is not positive.
    """

    volume_ratio: float = VOLUME_RATIO
    largest_push_m: float | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        if not 1.0 < self.volume_ratio < float("inf"):
            raise InputError("volume_ratio", f"is {self.volume_ratio:g}", "a number above 1")
        if self.largest_push_m is not None and not 0.0 < self.largest_push_m < float("inf"):
            raise InputError("largest_push_m", f"is {self.largest_push_m:g}", "above 0, in metres")
        if self.seed < 0:
            raise InputError("seed", f"is {self.seed}", "0 or more")


DEFAULT = DecomposeSettings()
