"""Where the whole problem is begun from: our guesses, or the paper's continuation."""

from __future__ import annotations

from collections.abc import Callable

from berthing.errors import InputError
from berthing.guess.candidates import RANDOM_GUESSES, candidates
from berthing.guess.continuation import Continuation
from berthing.guess.path import motion_along
from berthing.transcription.problem import Motion

FirstMotions = list[tuple[str, Motion]]
"""Names and motions, in the order in which they are worth trying."""


def _candidates(whole: Continuation, seed: int, drawn: int) -> FirstMotions:
    duration_s = whole.phase.horizon.nominal_s
    return [
        (guess.name, motion_along(guess, whole.phase, whole.mesh, duration_s))
        for guess in candidates(whole.scenario, whole.phase, seed, drawn)
    ]


def _continuation(whole: Continuation, seed: int, _: int) -> FirstMotions:
    return [("paper continuation", whole.motion(seed))]


GUESSES: dict[str, Callable[[Continuation, int, int], FirstMotions]] = {
    "default": _candidates,
    "paper-continuation": _continuation,
}


def first_motions(
    name: str, whole: Continuation, seed: int, drawn: int = RANDOM_GUESSES
) -> FirstMotions:
    """The motions that the guess ``name`` gives, sub-problems solved where it has some.

    Args:
        drawn: random guesses, where there are any.

    Raises:
        InputError: no such guess.
    """
    try:
        make = GUESSES[name]
    except KeyError:
        known = ", ".join(sorted(GUESSES))
        raise InputError("guess", f"there is no {name!r}", f"one of {known}") from None
    return make(whole, seed, drawn)
