"""Forms that start from the answer of another: ``kkt`` from ``plane``'s.

Closest points are a poor place to search from: where sets overlap or faces are parallel the rows
have no slope, and a relaxed answer errs on the unsafe side. From ``plane``'s own optimum on the
same sites, multipliers included, they are a handful of iterations away.
"""

from __future__ import annotations

from dataclasses import replace

from berthing.refine.refiner import Refinement, Refiner
from berthing.transcription.problem import Motion, Problem

FIRST = {"kkt": "plane"}
"""What each form begins with; those not named begin with themselves."""


def first_formulation(formulation: str) -> str:
    """The form in which guesses are solved for a plan by ``formulation``."""
    return FIRST.get(formulation, formulation)


def refine(refiner: Refiner, name: str, coarse: Problem, motion: Motion) -> Refinement:
    """Refine ``motion``, the answer of ``coarse``, in the first form and then in the refiner's."""
    first = first_formulation(refiner.formulation)
    begun = replace(refiner, formulation=first).run(name, coarse, motion)
    if first == refiner.formulation:
        return begun
    if begun.answer is None:
        return begun
    followed = refiner.follow(f"{name}, {refiner.formulation}", begun.answer)
    return replace(followed, attempts=[*begun.attempts, *followed.attempts])
