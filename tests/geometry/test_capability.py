"""A shape that lacks something says so, and names shapes that have it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import conic_form, halfspaces, level, mesh, vertices
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.polytope import Polytope
from berthing.geometry.sphere import Sphere


@dataclass(frozen=True, eq=False)
class _SupportOnly(ConvexSet):
    dim: int = 3
    bounding_radius: float = 1.0

    def support(self, n: Array) -> tuple[Array, Array]:
        return Sphere(1.0).support(n)


ASKED: list[tuple[Callable[[ConvexSet], Any], str]] = [
    (conic_form, "conic form"),
    (vertices, "vertices"),
    (halfspaces, "half-spaces"),
    (lambda shape: level(shape, np.zeros(3)), "level function"),
    (mesh, "mesh"),
]


@pytest.mark.parametrize(("ask", "what"), ASKED)
def test_a_lack_is_named_with_the_shapes_that_do_not_lack(
    ask: Callable[[ConvexSet], Any], what: str
) -> None:
    ask(Box([1.0, 1.0, 1.0]))
    with pytest.raises(CapabilityError, match=f"_SupportOnly has no .*{what}.*Box.*Polytope"):
        ask(_SupportOnly())


@pytest.mark.parametrize("ask", [vertices, halfspaces])
def test_curved_shapes_have_no_corners_or_faces(ask: Callable[[ConvexSet], Any]) -> None:
    with pytest.raises(CapabilityError, match="Sphere"):
        ask(Sphere(1.0))
    ask(Polytope.from_vertices([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))


def test_every_shape_is_a_convex_set_and_keys_a_dict() -> None:
    first, second = Box([1.0, 1.0]), Box([1.0, 1.0])
    assert len({first: 1, second: 2}) == 2
