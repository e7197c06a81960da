"""Shapes of every kind in files, and the models that stand for them while a motion is planned."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.capsule import Capsule
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.geometry.shape_model import ShapeModel
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.scenario.files import from_document, json_schema
from support.documents import Document, box, puck, scenario, spacecraft, structure

CUBE = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
LENS = [
    {"position_m": [0.5, 0, 0], "shape": {"type": "sphere", "radius_m": 1}},
    {"position_m": [-0.5, 0, 0], "shape": {"type": "sphere", "radius_m": 1}},
]
# Each with its support value along (0, 0.6, 0.8), by hand.
SPACE: dict[str, tuple[Document, float]] = {
    "superellipsoid": (
        {"type": "superellipsoid", "semi_axes_m": [2, 1, 1], "exponents": [8, 2, 2]}, 1.0,
    ),
    "smoothed-polytope": (
        {"type": "smoothed-polytope", "normals": CUBE, "offsets_m": [1] * 6, "exponents": [1e3]},
        1.4,
    ),
    "capsule": ({"type": "capsule", "radius_m": 0.5, "length_m": 4, "axis": "z"}, 0.5 + 1.6),
    "cone": ({"type": "cone", "radius_m": 0.5, "length_m": 4, "axis": "z"}, 1.6),
    "truncated-cone": (
        {"type": "truncated-cone", "base_radius_m": 1, "top_radius_m": 0.5, "length_m": 2,
         "axis": "z"},
        0.3 + 0.8,
    ),
    "half-space": ({"type": "half-space", "normal": [0, 3, 4], "offset_m": 10}, 2.0),
    "offset": ({"type": "offset", "shape": box(2, 2, 2), "radius_m": 0.25}, 1.4 + 0.25),
    "intersection": ({"type": "intersection", "sets": LENS}, np.sqrt(0.75)),
}  # fmt: skip
PLANE: dict[str, Document] = {
    "capsule": {"type": "capsule", "radius_m": 0.5, "length_m": 4, "axis": "y"},
    "superellipsoid": {"type": "superellipsoid", "semi_axes_m": [2, 1], "exponents": [4]},
    "half-space": {"type": "half-space", "normal": [0, 1]},
}
HALF = {"type": "half-space", "normal": [1, 0, 0]}


def shape_of(document: Document) -> ConvexSet:
    made = scenario(structures=[structure("wall", [0, -50, 0], document)])
    return made.structures[0].body.parts[0].shape


@pytest.mark.parametrize(("document", "value"), SPACE.values(), ids=SPACE.keys())
def test_shapes_in_space_are_what_the_file_says(document: Document, value: float) -> None:
    n = np.array([0.0, 0.6, 0.8])
    within = 2e-3 if document["type"] == "smoothed-polytope" else 1e-9
    assert float(shape_of(document).support(n)[0]) == pytest.approx(value, abs=within)


@pytest.mark.parametrize("document", PLANE.values(), ids=PLANE.keys())
def test_shapes_in_the_plane(document: Document) -> None:
    made = scenario(puck(), structures=[structure("wall", [0, -9], document)])
    assert made.structures[0].body.dim == 2


@pytest.mark.parametrize("document", [d for d, _ in SPACE.values()], ids=SPACE.keys())
def test_a_scenario_with_them_is_read_again_from_its_own_document(document: Document) -> None:
    made = scenario(structures=[structure("wall", [0, -50, 0], document)])
    again = from_document(dict(made.document))
    assert again.document == made.document
    n = np.array([0.0, 0.6, 0.8])
    parts = [s.structures[0].body.parts[0].shape for s in (made, again)]
    assert parts[0].support(n)[0] == pytest.approx(parts[1].support(n)[0], abs=1e-12)


def test_the_schema_has_every_shape() -> None:
    written = str(json_schema())
    for name in (*SPACE, *PLANE, "shape_model"):
        assert f"'{name}'" in written


BAD: list[tuple[Document, str]] = [
    ({"type": "superellipsoid", "semi_axes_m": [1, 1, 1], "exponents": [3]}, "exponents[0]"),
    ({"type": "superellipsoid", "semi_axes_m": [1, 1, 1], "exponents": [2, 2]}, "has the shape"),
    ({"type": "capsule", "radius_m": 0, "length_m": 1}, "radius_m: is 0"),
    ({"type": "cone", "radius_m": 1, "length_m": 1, "axis": "w"}, "axis"),
    ({"type": "half-space", "normal": [0, 0, 0]}, "is zero"),
    ({"type": "half-space", "normal": [0, 1]}, "has 2 dimensions in a scenario of 3"),
    ({"type": "offset", "shape": HALF, "radius_m": 1}, "without bounds"),
    ({"type": "offset", "shape": {"type": "bux"}, "radius_m": 1}, "did you mean box?"),
    ({"type": "intersection", "sets": LENS[:1]}, "at least 2"),
    ({"type": "intersection", "sets": [{"shape": HALF}, {"shape": HALF}]}, "is unbounded"),
    (
        {"type": "intersection", "sets": [LENS[0], {**LENS[1], "position_m": [-5, 0, 0]}]},
        "is empty",
    ),
    (
        {"type": "smoothed-polytope", "normals": CUBE, "offsets_m": [0.2] * 6, "exponents": [8]},
        "too small for an exponent of 8 per metre",
    ),
]


@pytest.mark.parametrize(("document", "says"), BAD)
def test_bad_shapes_are_refused(document: Document, says: str) -> None:
    with pytest.raises(InputError) as caught:
        shape_of(document)
    assert says in str(caught.value)
    assert "structures[0].parts[0].shape" in str(caught.value)


def test_a_vehicle_has_no_half_space() -> None:
    part = {"name": "skirt", "shape": HALF}
    with pytest.raises(InputError, match=r"has a part 'skirt' without bounds: HalfSpace"):
        scenario(spacecraft(parts=[part]))


def modelled(model: Document | None, default: Document | None, shape: Document) -> Part:
    part: dict[str, Any] = {"name": "core", "shape": shape}
    if model is not None:
        part["shape_model"] = model
    block = {"name": "block", "position_m": [0, 50, 0], "parts": [part]}
    more = {} if default is None else {"solver": {"shape_model": default}}
    return scenario(structures=[block], **more).structures[0].body.parts[0]


INNER, OUTER = {"side": "inner", "exponent": 8}, {"side": "outer", "error_m": 0.05}
ROD = {"type": "cylinder", "radius_m": 1, "length_m": 4}


def test_parts_are_planned_as_they_are_unless_they_say_otherwise() -> None:
    part = modelled(None, None, box(2, 2, 2))
    assert part.planning_shape is part.shape
    assert not part.planned_smaller


def test_the_default_holds_for_parts_that_are_silent() -> None:
    silent, own = modelled(None, INNER, box(2, 2, 2)), modelled(OUTER, INNER, box(2, 2, 2))
    assert isinstance(silent.planning_shape, SmoothedPolytope)
    assert isinstance(own.planning_shape, SmoothedPolytope)
    assert (silent.planning_shape.side, own.planning_shape.side) == ("inner", "outer")
    assert (silent.planned_smaller, own.planned_smaller) == (True, False)
    assert np.all(silent.planning_shape.exponents == 8.0)
    assert own.planning_shape.error_m <= 0.05
    exact = modelled({"side": "exact"}, INNER, box(2, 2, 2))
    assert exact.planning_shape is exact.shape


def test_the_papers_models_follow_from_one_exponent() -> None:
    rod = modelled(None, INNER, ROD).planning_shape
    assert isinstance(rod, Superellipsoid)
    assert rod.exponents.tolist() == [8, 2, 2]


def test_a_smooth_shape_is_its_own_model() -> None:
    ball = modelled(None, INNER, {"type": "sphere", "radius_m": 1})
    assert ball.planning_shape is ball.shape
    assert not ball.planned_smaller


def test_the_true_shape_is_kept_and_the_model_made_once() -> None:
    part = modelled(INNER, None, box(2, 2, 2))
    n = np.array([1.0, 1.0, 1.0])
    assert float(part.shape.support(n)[0]) == pytest.approx(3.0)
    assert float(part.planning_shape.support(n)[0]) < 2.7
    assert part.planning_shape is part.planning_shape


BAD_MODELS: list[tuple[Document, Document, str]] = [
    ({"side": "inside", "exponent": 8}, box(2, 2, 2), "shape_model.side: is 'inside'"),
    ({"side": "inner"}, box(2, 2, 2), "is inner, with 0 of exponent and error_m"),
    ({"side": "exact", "exponent": 8}, box(2, 2, 2), "stands beside an exact model"),
    ({"side": "inner", "exponent": 8, "error_m": 1}, box(2, 2, 2), "is inner, with 2 of exponent"),
    ({"side": "inner", "error_m": 0}, box(2, 2, 2), "shape_model.error_m: is 0"),
    # A cube of half-size below ln(6)/8 = 0.224 m.
    (INNER, box(0.44, 0.44, 0.44), "Polytope is empty: the polytope is too small for an exponent"),
    (OUTER, {"type": "capsule", "radius_m": 1, "length_m": 1}, "Capsule has no outer model"),
    ({"side": "inner", "exponent": 7}, ROD, "exponent is 7 (expected an even number"),
]


@pytest.mark.parametrize(("model", "shape", "says"), BAD_MODELS)
def test_bad_models_are_refused_where_they_stand(
    model: Document, shape: Document, says: str
) -> None:
    with pytest.raises(InputError) as caught:
        modelled(model, None, shape)
    assert says in str(caught.value)
    assert "structures[0].parts[0]" in str(caught.value)


def test_a_bad_default_is_refused_where_it_stands() -> None:
    with pytest.raises(InputError, match=r"solver\.shape_model\.side: is inner, with 0 of"):
        modelled(None, {"side": "inner"}, box(2, 2, 2))


def test_a_cube_just_above_the_size_that_is_empty_has_a_model() -> None:
    assert isinstance(modelled(INNER, None, box(0.46, 0.46, 0.46)).planning_shape, SmoothedPolytope)


def test_what_lacks_a_model_is_told_which_shapes_have_one() -> None:
    part = Part("arm", Capsule(1.0, 1.0), Pose.identity(), ShapeModel("outer", error_m=0.1))
    with pytest.raises(InputError, match=r"expected exact, or one of: Box, Polytope, Cylinder"):
        _ = part.planning_shape


def test_planned_smaller_is_about_the_model_not_the_name() -> None:
    def part(model: ShapeModel, shape: ConvexSet) -> Part:
        return Part("arm", shape, Pose.identity(), model)

    inner = ShapeModel("inner", exponent=8.0)
    assert not part(inner, Superellipsoid([1.0, 1.0, 1.0], 2)).planned_smaller
    directions: Array = np.eye(3)
    smooth = part(inner, Superellipsoid([1.0, 1.0, 1.0], 2)).planning_shape
    np.testing.assert_allclose(smooth.support(directions)[0], 1.0)
