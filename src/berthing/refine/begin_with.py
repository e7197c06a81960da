"""Forms that start from the answer of another: ``kkt`` from ``plane``'s.

Closest points are a poor place to search from: where sets overlap or faces are parallel the rows
have no slope, and a relaxed answer errs on the unsafe side. From ``plane``'s own optimum on the
same sites, multipliers included, they are a handful of iterations away.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

from berthing.errors import CapabilityError
from berthing.proximity.formulations import formulate
from berthing.refine.refiner import Refinement, Refiner
from berthing.scenario.pair import Pair
from berthing.transcription.problem import (
    Motion,
    Problem,
    ShapesOf,
    planned_shapes,
    true_shapes,
)

FIRST = {"kkt": "plane"}
"""What each form begins with; those not named begin with themselves."""


FREED = 3
"""Rounds without the guard: where these do not do, the passage needs it."""

TURNS = 3
"""Times that the first form hands over its answer, before a candidate is given up."""


@dataclass(frozen=True)
class Beginning:
    """The form in which guesses are solved, and what stands for the parts meanwhile."""

    formulation: str
    shapes_of: ShapesOf


def beginning(formulation: str, pairs: Sequence[Pair]) -> Beginning:
    """How a plan by ``formulation`` begins.

    ``plane`` does not take smoothed polytopes, which have no exact support function: ``kkt`` then
    begins with its answer for the shapes that they are models of, and with itself where ``plane``
    does not take those either.
    """
    first = FIRST.get(formulation, formulation)
    if first != formulation:
        for shapes_of in (planned_shapes, true_shapes):
            if _takes(first, pairs, shapes_of):
                return Beginning(first, shapes_of)
    return Beginning(formulation, planned_shapes)


def _takes(formulation: str, pairs: Sequence[Pair], shapes_of: ShapesOf) -> bool:
    try:
        for pair in pairs:
            formulate(formulation, *shapes_of(pair))
    except CapabilityError:
        return False
    return True


def refine(refiner: Refiner, name: str, coarse: Problem, motion: Motion) -> Refinement:
    """Refine ``motion``, the answer of ``coarse``, in the first form and then in the refiner's.

    Where parts are planned smaller than they are, no refinement would make the plan keep clear,
    and it is left as it comes.
    """
    if any(planned_smaller(pair) for pair in coarse.pairs):
        return refiner.once(name, coarse, motion)
    first = beginning(refiner.formulation, coarse.pairs)
    other = replace(refiner, formulation=first.formulation, shapes_of=first.shapes_of)
    begun = _in_its_passage(other, name, coarse, motion)
    if first.formulation == refiner.formulation:
        return begun
    last, attempts = begun, begun.attempts
    for turn in range(TURNS):
        if begun.answer is None:
            break
        last = refiner.follow(f"{name}, {refiner.formulation}", begun.answer)
        attempts = [*attempts, *last.attempts]
        spent = turn == TURNS - 1 or time.monotonic() > refiner.deadline
        if last.certified or last.answer is None or spent:
            break
        # Stuck where sites have been added: the first form takes them on, and hands back.
        begun = other.follow(f"{name}, {first.formulation} again", last.answer)
        attempts = [*attempts, *begun.attempts]
    return replace(last, attempts=attempts)


def _in_its_passage(refiner: Refiner, name: str, coarse: Problem, motion: Motion) -> Refinement:
    """Refine, guarded where a round goes astray; what is certified so is let off its guard again,
    for planes that hold from node to node cost a little."""
    begun = refiner.run(name, coarse, motion)
    guard = replace(refiner, guarded=True)
    if begun.astray and begun.attempts:
        held = guard.run(f"{name}, guarded", coarse, motion)
        begun = replace(held, attempts=[*begun.attempts, *held.attempts])
    elif not refiner.guarded:
        return begun
    if not begun.certified or begun.answer is None:
        return begun
    freed = replace(refiner, guarded=False).follow(
        f"{name}, freed", begun.answer, FREED
    )
    attempts = [*begun.attempts, *freed.attempts]
    better = freed if freed.certified and freed.cost < begun.cost else begun
    return replace(better, attempts=attempts)


def planned_smaller(pair: Pair) -> bool:
    """Whether a model of one of the parts lies inside it."""
    return pair.part_a.planned_smaller or pair.part_b.planned_smaller
