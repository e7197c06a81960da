"""The shapes that every law is tried on, by name, and how exactly each is known."""

from __future__ import annotations

from itertools import product

from benchmarks._distance_poses import size as size
from benchmarks._distance_sets import PLANE, SPACE, TRIANGLE, WEDGE

from berthing.errors import CapabilityError
from berthing.geometry.capability import conic_form
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.polytope import Polytope
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid

# A prism cut by a slanted plane.
CUT_ROWS = [[1, 0, 0], [-1, 0, 0], [0, 2, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [1, 1, 1]]
CUT_OFFSETS = [1, 1, 1, 0.5, 0.7, 0.7, 1.2]

# Those that the collision library takes, padded or not, and half-spaces: a query is quick.
QUICK_SPACE: dict[str, ConvexSet] = {
    **{name: SPACE[name] for name in ("box", "plate", "ball", "point", "ellipsoid", "needle")},
    "cylinder-x": SPACE["cylinder"],
    "cylinder-y": Cylinder(0.3, 1.0, "y"),
    "disc-z": SPACE["disc"],
    "wedge": WEDGE,
    "cut-prism": Polytope(CUT_ROWS, CUT_OFFSETS),
    "capsule": SPACE["capsule"],
    "cone": SPACE["cone"],
    "padded-box": SPACE["padded box"],
}
QUICK_PLANE: dict[str, ConvexSet] = {
    "rectangle": PLANE["rectangle"],
    "disc": PLANE["circle"],
    "point-2d": Sphere(0.0, dim=2),
    "ellipse": PLANE["ellipse"],
    "triangle": TRIANGLE,
    "pentagon": Polytope([[1, 0], [0, 1], [-1, 0], [0, -1], [1, 1]], [1, 1, 1, 1, 1.5]),
    "stadium": PLANE["stadium"],
    "padded-triangle": Offset(TRIANGLE, 0.2),
}
SLOW_SPACE: dict[str, ConvexSet] = {
    "lampshade": SPACE["lampshade"],
    "paper-cylinder": SPACE["superellipsoid 8-2-2"],
    "pillow": Superellipsoid([1.0, 0.6, 0.4], [4, 6, 2], size=1.2, size_exponent=3),
    "inner-box": SPACE["smoothed box"],
    "outer-wedge": SPACE["smoothed wedge"],
    "cut-cylinder": SPACE["cut cylinder"],
}
SLOW_PLANE: dict[str, ConvexSet] = {
    "superellipse": PLANE["superellipse"],
    "inner-square": PLANE["smoothed square"],
    "lens": PLANE["lens"],
}
UNBOUNDED: dict[str, ConvexSet] = {
    "wall": HalfSpace([0.0, 0.0, 1.0], 0.5),
    "edge": HalfSpace([0.0, -1.0], -0.3),
}
BOUNDED = QUICK_SPACE | QUICK_PLANE | SLOW_SPACE | SLOW_PLANE
SHAPES = BOUNDED | UNBOUNDED

QUICK_PAIRS = [
    *product(QUICK_SPACE, repeat=2),
    *product(QUICK_PLANE, repeat=2),
    *product(QUICK_SPACE, ["wall"]),
    *product(["wall"], QUICK_SPACE),
    *product(QUICK_PLANE, ["edge"]),
]
# At least one a slow shape, and one a method of distance.
SEARCHED_PAIRS = [
    ("lampshade", "box"),
    ("point", "lampshade"),
    ("paper-cylinder", "pillow"),
    ("box", "outer-wedge"),
    ("cut-cylinder", "wall"),
    ("superellipse", "triangle"),
    ("disc", "inner-square"),
]
SLOW_PAIRS = [
    ("lampshade", "lampshade"),
    ("lens", "rectangle"),
    ("inner-box", "cylinder-x"),
    ("cut-cylinder", "needle"),
    ("capsule", "lampshade"),
    ("padded-box", "lampshade"),
    ("paper-cylinder", "inner-box"),
    ("paper-cylinder", "capsule"),
    ("outer-wedge", "inner-box"),
    ("pillow", "plate"),
    ("cone", "cut-cylinder"),
    ("point", "cut-cylinder"),
    ("lens", "lens"),
    ("inner-square", "superellipse"),
]


def is_searched(pair: tuple[ConvexSet, ConvexSet]) -> bool:
    """Whether the pair's distance is found by solvers and searches of the package's own."""
    slow = [*SLOW_SPACE.values(), *SLOW_PLANE.values()]
    return any(shape in slow for shape in pair)


def has_conic_form(shape: ConvexSet) -> bool:
    """Whether it has one, which for some shapes depends on their sizes."""
    try:
        conic_form(shape)
    except CapabilityError:
        return False
    return True


CONIC = {name: shape for name, shape in SHAPES.items() if has_conic_form(shape)}


# Closed forms are good to rounding; Newton's method to what a residual of rounding means; the
# cone solver to its own tolerance, and less where the problem is nearly degenerate.
_ROUNDING: dict[type[ConvexSet], float] = {SmoothedPolytope: 1e-11, Intersection: 2e-9}


def rounding(shape: ConvexSet) -> float:
    """Of support values and points, in terms of the shape's size."""
    return _ROUNDING.get(type(shape), 1e-12)


def radius_slack(shape: ConvexSet) -> float:
    """By how much the bounding radius may be too large, relatively."""
    return 1.1e-3 if type(shape) in _ROUNDING else 1e-12


def level_rounding(shape: ConvexSet) -> float:
    """Of levels; that of a padded set is a solved distance."""
    return 1e-9 if isinstance(shape, Offset) else rounding(shape)
