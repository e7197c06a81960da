"""Where the whole problem is begun from: our guesses, ways looked for, the paper's continuation."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from berthing.errors import InputError
from berthing.guess.blocked import is_blocked, is_detour
from berthing.guess.candidates import RANDOM_GUESSES, candidates
from berthing.guess.continuation import Continuation
from berthing.guess.path import Guess, motion_along
from berthing.guess.routed import routed
from berthing.transcription.problem import Motion

MORE_ROUTES = 2
"""Times as many routes where nothing else is tried."""

DEFAULT, ROUTES = "default", "routes"

FirstMotions = list[tuple[str, Motion]]
"""Names and motions, in the order in which they are worth trying."""


def _candidates(whole: Continuation, seed: int, drawn: int, routes: int) -> FirstMotions:
    guesses = candidates(whole.scenario, whole.phase, seed, drawn)
    simple = _along(whole, guesses)
    pairs = whole.scenario.pairs(whole.phase)
    if any(
        not is_detour(guess) and not is_blocked(pairs, whole.mesh, motion)
        for guess, (_, motion) in zip(guesses, simple, strict=True)
    ):
        return simple
    return _routed(whole, seed, routes) + simple


def _along(whole: Continuation, guesses: Iterable[Guess]) -> FirstMotions:
    duration_s = whole.phase.horizon.nominal_s
    return [
        (guess.name, motion_along(guess, whole.phase, whole.mesh, duration_s)) for guess in guesses
    ]


def _routed(whole: Continuation, seed: int, routes: int) -> FirstMotions:
    seconds = whole.budget.wall_time_s
    return _along(whole, routed(whole.scenario, whole.phase, seed, routes, seconds))


def _routes(whole: Continuation, seed: int, _: int, routes: int) -> FirstMotions:
    return _routed(whole, seed, MORE_ROUTES * routes)


def _continuation(whole: Continuation, seed: int, *_: int) -> FirstMotions:
    return [("paper continuation", whole.motion(seed))]


GUESSES: dict[str, Callable[[Continuation, int, int, int], FirstMotions]] = {
    DEFAULT: _candidates,
    ROUTES: _routes,
    "paper-continuation": _continuation,
}


def first_motions(
    name: str, whole: Continuation, seed: int, drawn: int = RANDOM_GUESSES, routes: int = 1
) -> FirstMotions:
    """The motions that the guess ``name`` gives, sub-problems solved where it has some.

    Args:
        drawn: random guesses, where there are any.
        routes: guesses along routes, where there are any.

    Raises:
        InputError: no such guess.
    """
    try:
        make = GUESSES[name]
    except KeyError:
        known = ", ".join(sorted(GUESSES))
        raise InputError("guess", f"there is no {name!r}", f"one of {known}") from None
    return make(whole, seed, drawn, routes)
