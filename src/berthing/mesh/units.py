"""Units of length. A file of triangles does not say in which it is; nobody guesses here."""

from __future__ import annotations

from berthing.errors import InputError

METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "in": 0.0254, "ft": 0.3048}


def metres_per(unit: str, where: str) -> float:
    """Length of a unit in metres; InputError with the options where there is none of that name."""
    if unit not in METRES:
        raise InputError(where, f"is {unit!r}", f"one of: {', '.join(METRES)}")
    return METRES[unit]


def refuse_to_guess(where: str, longest_side: float) -> InputError:
    """The error for a file whose units nobody stated: what it would be in those that are usual."""
    sizes = ", ".join(f"{longest_side * METRES[u]:.4g} m if {u}" for u in ("m", "mm", "in"))
    what = f"does not say its units; its longest side is {longest_side:.6g}: {sizes}"
    return InputError(where, what, f"--units, or units: in a scenario, one of: {', '.join(METRES)}")
