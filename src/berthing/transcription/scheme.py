"""Collocation schemes: where the state lives, where the dynamics hold, how integrals are taken."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.transcription import lgl, lgr
from berthing.transcription.lagrange import differentiation_matrix


@dataclass(frozen=True)
class NodeSet:
    """One segment of a scheme on [-1, 1].

    Attributes:
        points: (n,) support points of the state polynomial, -1 and 1 among them.
        collocated: indices (c,) of the points where ẋ = f is asked and a control lives.
        weights: (c,) quadrature weights at the collocated points.
        D: (c, n) derivative at the collocated points.
    """

    points: Array
    collocated: tuple[int, ...]
    weights: Array
    D: Array

    @property
    def control_points(self) -> Array:
        """(c,) support points of the control polynomial."""
        return self.points[list(self.collocated)]


@lru_cache(maxsize=64)
def lgr_nodes(degree: int) -> NodeSet:
    """Legendre–Gauss–Radau: ``degree`` collocated points from -1, and the end 1 besides."""
    points, weights = lgr.radau(degree)
    support = lgr.with_end(points)
    return NodeSet(support, tuple(range(degree)), weights, differentiation_matrix(support)[:degree])


@lru_cache(maxsize=64)
def lgl_nodes(degree: int) -> NodeSet:
    """Legendre–Gauss–Lobatto: ``degree`` + 1 points from -1 to 1, all of them collocated.

    As many equations as points leave the differentiation matrix without full rank (constants have
    no slope), so that the multipliers are not unique and costates may oscillate from node to node
    (Garg et al., 10.1016/j.automatica.2010.06.048). Radau points have neither fault.
    """
    points, weights = lgl.lobatto(degree + 1)
    return NodeSet(points, tuple(range(degree + 1)), weights, differentiation_matrix(points))


SCHEMES: dict[str, Callable[[int], NodeSet]] = {
    "lgr": lgr_nodes,
    "lgl": lgl_nodes,
    "lgl-global": lgl_nodes,
}

ONE_SEGMENT = frozenset({"lgl-global"})
"""Schemes whose mesh is one segment throughout, as in the paper; ``lgl`` has many."""

ONE_SEGMENT_NODES = 20
"""Of such a scheme where nobody asks for another number: the paper's."""


def scheme(name: str) -> Callable[[int], NodeSet]:
    """The node sets of the scheme ``name`` by degree; InputError where there is no such scheme."""
    try:
        return SCHEMES[name]
    except KeyError:
        known = ", ".join(sorted(SCHEMES))
        raise InputError("scheme", f"there is no {name!r}", f"one of {known}") from None
