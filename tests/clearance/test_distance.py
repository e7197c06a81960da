"""``berthing.distance`` at contacts of all kinds, of bodies, and with bad input."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks._distance_poses import differences, random_poses

import berthing as bt
from berthing.clearance import kernel as kernel_module
from berthing.clearance import set_numbers as set_numbers_module
from berthing.clearance.plane import plane_bound
from berthing.clearance.set_numbers import set_numbers
from berthing.clearance.support_search import best_normal
from berthing.errors import CapabilityError, InputError
from berthing.geometry import quaternion
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.geometry.truncated_cone import TruncatedCone
from support.distances import BRACKET, DEPTH, GRADIENT, faults
from support.shapes import SHAPES

CUBE = bt.Box([1.0, 1.0, 1.0])
STRAIGHT = [1.0, 0.0, 0.0, 0.0]
# Quarter turn about z, half of it, and one that stands a cube on its corner.
HALF_TURN_Z = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.pi / 4)
ON_CORNER = quaternion.from_axis_angle(np.array([1.0, -1.0, 0.0]), np.arccos(1.0 / np.sqrt(3.0)))
QUARTER_X = quaternion.from_axis_angle(np.array([1.0, 0.0, 0.0]), np.pi / 2)


@pytest.mark.parametrize("gap", [0.3, 1e-6, 0.0])
@pytest.mark.parametrize(
    ("b", "q", "reach"),
    [
        (CUBE, STRAIGHT, 1.0),
        (CUBE, HALF_TURN_Z, np.sqrt(2.0)),
        (bt.Sphere(0.7), STRAIGHT, 0.7),
        (bt.Cylinder(0.5, 1.5), STRAIGHT, 1.5),
        (Cone(0.5, 1.0, "x"), STRAIGHT, 1.0),
        (Superellipsoid([0.8, 0.5, 0.5], [8, 4, 2]), STRAIGHT, 0.8),
        (bt.Ellipsoid([0.9, 0.3, 0.3]), STRAIGHT, 0.9),
    ],
    ids=["faces", "edge-face", "ball", "ends", "base", "smooth", "tip"],
)
def test_a_face_of_a_cube_meets_others(b, q, reach, gap: float) -> None:
    found = bt.distance(CUBE, b, [1.0 + reach + gap, 0.1, 0.2, *q])
    assert found.distance == pytest.approx(gap, abs=BRACKET)
    if gap > 0.0:
        np.testing.assert_allclose(found.normal, [1.0, 0.0, 0.0], atol=1e-6)


def test_vertex_meets_vertex() -> None:
    corner = np.sqrt(3.0)
    turned = (bt.Pose.from_quaternion(np.zeros(3), ON_CORNER),)
    up = turned[0].rotation @ np.ones(3) / corner
    for gap in (0.5, 1e-7, 0.0):
        other = bt.Pose.from_quaternion((2 * corner + gap) * up, ON_CORNER)
        found = bt.distance(CUBE, CUBE, (turned[0], other))
        assert found.distance == pytest.approx(gap, abs=BRACKET)


def test_crossed_edges_meet() -> None:
    first = bt.Pose.from_quaternion(np.zeros(3), HALF_TURN_Z)
    crossed = quaternion.multiply(
        quaternion.from_axis_angle(np.array([0.0, 1.0, 0.0]), np.pi / 4), QUARTER_X
    )
    for gap in (0.2, 0.0):
        second = bt.Pose.from_quaternion(np.array([2 * np.sqrt(2.0) + gap, 0, 0]), crossed)
        found = bt.distance(CUBE, CUBE, (first, second))
        assert found.distance == pytest.approx(gap, abs=BRACKET)


@pytest.mark.parametrize(
    ("a", "b", "depth"),
    [
        (CUBE, CUBE, 2.0),
        (CUBE, bt.Sphere(0.5), 1.5),
        (bt.Sphere(0.4), bt.Sphere(0.3), 0.7),
        (bt.Ellipsoid([3.0, 2.0, 1.0]), bt.Ellipsoid([1.0, 0.5, 0.4]), 1.4),
        (Superellipsoid([2.0, 1.0, 0.8], [8, 2, 2]), Superellipsoid([1, 1, 0.5], [4, 4, 4]), 1.3),
        (bt.Cylinder(0.5, 2.0), Capsule(0.2, 1.0), 0.7),
        (bt.Box([1.0, 2.0]), bt.Sphere(0.5, dim=2), 1.5),
        (bt.Sphere(0.0), bt.Sphere(0.0), 0.0),
    ],
)
def test_bodies_about_one_centre(a, b, depth: float) -> None:
    where = [0.0] * 3 if a.dim == 2 else [0.0, 0.0, 0.0, *STRAIGHT]
    found = bt.distance(a, b, where)
    assert found.distance == pytest.approx(-depth, abs=DEPTH)
    assert np.linalg.norm(found.normal) == pytest.approx(1.0)


def test_capsules_that_cross() -> None:
    stick = Capsule(0.2, 1.0)
    found = bt.distance(stick, stick, [0.1, 0.2, 0.0, *HALF_TURN_Z])
    assert found.distance == pytest.approx(-0.4, abs=BRACKET)
    np.testing.assert_allclose(np.abs(found.normal), [0.0, 0.0, 1.0], atol=1e-9)


def test_gradients_by_hand() -> None:
    """A ball of 0.5 at (3, 1, 0) from a cube's face: it moves along x, and turning changes nothing;
    the cube's turn about z lifts the face there by 1 m a rad."""
    found = bt.distance(CUBE, bt.Sphere(0.5), [3.0, 0.7, 0.0, *STRAIGHT])
    np.testing.assert_allclose(found.gradient_b, [1, 0, 0, 0, 0, 0], atol=1e-9)
    np.testing.assert_allclose(found.gradient_a, [-1, 0, 0, 0, 0, 0.7], atol=1e-9)


PAIRS = [
    ("box", "cylinder-x"),
    ("wedge", "capsule"),
    ("ellipsoid", "needle"),
    ("cone", "lampshade"),
    ("paper-cylinder", "pillow"),
    ("inner-box", "outer-wedge"),
    ("box", "paper-cylinder"),
    ("triangle", "superellipse"),
    ("stadium", "rectangle"),
    ("cut-prism", "wall"),
]


@pytest.mark.parametrize("names", PAIRS, ids="|".join)
def test_gradients_match_differences(names: tuple[str, str]) -> None:
    a, b = (SHAPES[name] for name in names)
    poses = random_poses(np.random.default_rng(7), a, b, 20)
    found = bt.distance(a, b, poses)
    expected, kinks = differences(a, poses[0], b, poses[1])
    given = np.concatenate([found.gradient_a, found.gradient_b], axis=-1)
    error = np.linalg.norm(given - expected, axis=-1) / np.linalg.norm(given, axis=-1)
    smooth = kinks < 0.01
    assert np.sum(smooth) > 15
    assert np.max(error[smooth]) < GRADIENT
    # Half the torque would not pass.
    assert np.max(np.abs(given[smooth] - expected[smooth])) < 0.1 * np.max(np.abs(expected))


def test_faults_are_seen() -> None:
    a, b = SHAPES["box"], SHAPES["ellipsoid"]
    poses = random_poses(np.random.default_rng(3), a, b, 8)
    found = bt.distance(a, b, poses)
    assert faults(found, a, poses[0], b, poses[1]) == []
    for field, change in (
        ("lower_bound", 1e-3),
        ("upper_bound", 1e-3),
        ("distance", np.nan),
        ("normal", 0.1),
        ("point_a", 0.5),
    ):
        wrong = replace(found, **{field: getattr(found, field) + change})
        assert faults(wrong, a, poses[0], b, poses[1]), field


def test_bodies_answer_with_their_closest_parts() -> None:
    parts = [
        bt.Part("left", bt.Sphere(0.5), bt.Pose(np.array([-2.0, 0.0, 0.0]), np.eye(3))),
        bt.Part("right", CUBE, bt.Pose(np.array([2.0, 0.0, 0.0]), np.eye(3))),
    ]
    dumbbell, ball = bt.Body(parts), bt.Sphere(0.25)
    poses = np.array([[-4.0, 0.0, 0.0, *STRAIGHT], [5.0, 0.5, 0.0, *STRAIGHT]])
    found = bt.distance(dumbbell, ball, poses)
    np.testing.assert_allclose(found.distance, [1.25, 1.75], atol=BRACKET)
    np.testing.assert_allclose(found.gradient_a[1], [-1, 0, 0, 0, 0, 0.5], atol=1e-9)
    np.testing.assert_allclose(found.gradient_b[1], [1, 0, 0, 0, 0, 0], atol=1e-9)


def test_shapes_of_batches() -> None:
    along = np.array([[[3.0 + i + 10 * j, 0, 0, *STRAIGHT] for i in range(4)] for j in range(2)])
    found = bt.distance(CUBE, CUBE, along)
    assert found.distance.shape == (2, 4)
    assert found.normal.shape == (2, 4, 3)
    assert found.gradient_b.shape == (2, 4, 6)
    np.testing.assert_allclose(found.distance, along[..., 0] - 2.0, atol=BRACKET)
    both = bt.distance(CUBE, CUBE, ([1.0, 0, 0, *STRAIGHT], along))
    np.testing.assert_allclose(both.distance, along[..., 0] - 3.0, atol=BRACKET)
    assert bt.distance(CUBE, CUBE, np.zeros((0, 7))).distance.shape == (0,)


def test_answers_do_not_depend_on_the_order() -> None:
    for a, b in (("paper-cylinder", "pillow"), ("cylinder-x", "cone"), ("box", "wedge")):
        shapes = SHAPES[a], SHAPES[b]
        pose_a, pose_b = random_poses(np.random.default_rng(11), *shapes, 60)
        order = np.random.default_rng(12).permutation(60)
        straight = bt.distance(*shapes, (pose_a, pose_b)).distance
        shuffled = bt.distance(*shapes, (pose_a[order], pose_b[order])).distance
        np.testing.assert_allclose(shuffled, straight[order], atol=1e-7)


@pytest.mark.parametrize(
    ("poses", "words"),
    [
        ([np.nan, 0, 0, 1, 0, 0, 0], "NaN"),
        ([0, 0, 0, 1, 0.1, 0, 0], "quaternion of length 1.00499"),
        ([0, 0, 0, 0, 0, 0, 0], "quaternion of length 0"),
        ([0, 0, 0], "shape"),
        ("here", "array of numbers"),
        (bt.Pose.identity(2), "2 dimensions"),
        ((bt.Pose.identity(3),), "tuple of 1"),
        ((np.tile([0, 0, 0, 1, 0, 0, 0.0], (2, 1)), np.tile([0, 0, 0, 1.0, 0, 0, 0], (3, 1))),
         "broadcast"),
    ],
)  # fmt: skip
def test_bad_poses(poses, words: str) -> None:
    with pytest.raises(InputError, match=words):
        bt.distance(CUBE, CUBE, poses)


def test_bad_sets() -> None:
    with pytest.raises(InputError, match="3 and 2 dimensions"):
        bt.distance(CUBE, bt.Box([1.0, 1.0]), [0.0] * 7)
    with pytest.raises(InputError, match="is a str"):
        bt.distance(CUBE, "cube", [0, 0, 0, *STRAIGHT])
    wall = HalfSpace([0, 0, 1], 0.0)
    with pytest.raises(CapabilityError, match="half-spaces"):
        bt.distance(wall, wall, [0, 0, 0, *STRAIGHT])


@pytest.mark.parametrize(
    ("build", "words"),
    [
        (lambda: bt.Box([1.0, 0.0, 1.0]), "half_extents"),
        (lambda: bt.Box([1.0, np.nan, 1.0]), "half_extents"),
        (lambda: bt.Sphere(-1.0), "radius"),
        (lambda: bt.Ellipsoid([1.0, 0.0, 1.0]), "semi_axes"),
        (lambda: bt.Cylinder(0.0, 1.0), "radius"),
        (lambda: bt.Cylinder(1.0, 0.0), "half_length"),
        (lambda: Capsule(0.0, 1.0), "radius"),
        (lambda: Cone(1.0, 0.0), "half_length"),
        (lambda: TruncatedCone(1.0, 0.0, 0.0), "top_radius"),
        (lambda: Offset(CUBE, 0.0), "radius"),
        (lambda: HalfSpace([0.0, 0.0, 0.0], 0.0), "normal"),
        (lambda: bt.Polytope.from_vertices([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), "flat"),
        (lambda: Intersection([CUBE, HalfSpace([1.0, 0.0, 0.0], -1.0)]), "flat"),
        (lambda: Superellipsoid([1.0, 0.0, 1.0], [2, 2, 2]), "semi_axes"),
        (lambda: SmoothedPolytope.inner(bt.Box([0.1, 0.1, 0.1]), 8.0), "empty"),
        (lambda: bt.Pose(np.array([np.nan, 0.0, 0.0]), np.eye(3)), "NaN"),
        (lambda: bt.Pose(np.zeros(3), 2.0 * np.eye(3)), "orthonormal"),
        (lambda: bt.Pose(np.zeros(3), np.diag([1.0, 1.0, -1.0])), "mirrors"),
        (lambda: bt.Pose.from_quaternion(np.zeros(3), np.zeros(4)), "zero"),
    ],
)
def test_sets_of_no_size_and_poses_that_are_none(build, words: str) -> None:
    with pytest.raises(InputError, match=words):
        build()


def test_depths_of_ellipsoids_are_bracketed_where_they_hardly_overlap() -> None:
    """There the hull of what is left of them when balls are peeled off misses the origin."""
    a, b = bt.Ellipsoid([1.0, 0.8, 0.7]), bt.Ellipsoid([3.0, 0.4, 0.3])
    pose_a, pose_b = random_poses(np.random.default_rng(5), a, b, 30)
    first = bt.distance(a, b, (pose_a, pose_b))
    for depth in (1e-6, 1e-3, 0.1, 0.5):
        moved = pose_b.position - (first.distance + depth)[:, None] * first.normal
        poses = pose_a, bt.Pose(moved, pose_b.rotation)
        found = bt.distance(a, b, poses)
        assert faults(found, a, poses[0], b, poses[1]) == []
        for i in range(0, 30, 10):
            turn = poses[0].rotation[i]
            to_b = turn.T @ poses[1].rotation[i], (moved[i] - pose_a.position[i]) @ turn
            n = turn @ best_normal(a, b, *to_b)
            best = plane_bound(a, poses[0][i], b, poses[1][i], n)
            assert found.lower_bound[i] - 1e-9 <= best <= found.upper_bound[i] + 1e-12


def test_without_a_compiler_answers_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    a, b = SHAPES["box"], SHAPES["cylinder-x"]
    poses = random_poses(np.random.default_rng(2), a, b, 10)
    fast = bt.distance(a, b, poses)
    monkeypatch.setattr(kernel_module.shutil, "which", lambda name: None)
    kernel_module.library.cache_clear()
    try:
        with pytest.warns(RuntimeWarning, match="no C compiler"):
            slow = bt.distance(a, b, poses)
    finally:
        kernel_module.library.cache_clear()
    np.testing.assert_allclose(slow.distance, fast.distance, atol=DEPTH)
    np.testing.assert_allclose(slow.normal, fast.normal, atol=1e-3)


def test_a_damaged_source_is_said_not_run(
    monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.mktemp("native")
    (folder / "kernel.c").write_text("this is not C")
    monkeypatch.setattr(kernel_module, "SOURCES", folder)
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder))
    kernel_module.library.cache_clear()
    try:
        with pytest.warns(RuntimeWarning, match="slower"):
            assert kernel_module.kernel() is None
    finally:
        kernel_module.library.cache_clear()


def test_sources_compile_without_a_warning(tmp_path) -> None:
    compiler = kernel_module.shutil.which("cc") or kernel_module.shutil.which("gcc")
    assert compiler
    command = [compiler, "-Wall", "-Wextra", "-Werror", "-std=c11", "-O1", "-c"]
    command += [str(kernel_module.SOURCES / "kernel.c"), "-o", str(tmp_path / "kernel.o")]
    assert kernel_module.subprocess.run(command, check=False).returncode == 0


@pytest.mark.parametrize("offset", [0.0, 0.7])
@pytest.mark.parametrize("exponents", [(8.0, 8.0, 8.0), (250.0, 3.0, 40.0)], ids=str)
def test_formulas_for_smoothed_boxes_agree_with_the_search(
    exponents: tuple[float, ...], offset: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A smoothed box by its own formulas, and by the search that any smoothed polytope goes to."""
    A, b = CUBE.halfspaces()
    given = A, b + offset * A[:, 0], np.tile(exponents, 2)
    box, other = SmoothedPolytope(*given), SHAPES["pillow"]
    poses = random_poses(np.random.default_rng(4), box, other, 40)
    found = bt.distance(box, other, poses)
    assert faults(found, box, poses[0], other, poses[1]) == []
    monkeypatch.setattr(set_numbers_module, "STEEPEST", 0.0)
    searched = SmoothedPolytope(*given)
    numbers = set_numbers(box), set_numbers(searched)
    assert [int(n[0]) for n in numbers] == [
        set_numbers_module.SMOOTHED_BOX,
        set_numbers_module.LOG_SUM_EXP,
    ]
    again = bt.distance(searched, other, poses)
    np.testing.assert_allclose(again.distance, found.distance, atol=BRACKET)


def test_every_shape_is_compiled() -> None:
    assert [name for name, shape in SHAPES.items() if set_numbers(shape) is None] == []


def test_an_intersection_of_too_many_rows_is_answered_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def clipped() -> Intersection:
        return Intersection([CUBE, bt.Sphere(1.2)])

    where = [3.0, 0.4, 0.0, *STRAIGHT]
    fast = bt.distance(clipped(), CUBE, where)
    monkeypatch.setattr(set_numbers_module, "MOST_CONE_ROWS", 5)
    large = clipped()
    assert set_numbers(large) is None
    assert bt.distance(large, CUBE, where).distance == pytest.approx(fast.distance, abs=BRACKET)
    assert fast.distance == pytest.approx(1.0, abs=BRACKET)


def test_answers_do_not_depend_on_the_poses_before() -> None:
    # From another pose's points Newton may end where needles apart look as if they overlapped.
    needle, rng = bt.Ellipsoid([3.0, 0.1, 0.1]), np.random.default_rng(0)

    def drawn() -> tuple[np.ndarray, np.ndarray]:
        turns = quaternion.rotation_matrix(rng.normal(size=(500, 4)))
        return rng.uniform(-4.0, 4.0, (500, 3)), turns

    (r_a, R_a), (r_b, R_b) = drawn(), drawn()
    forth = bt.distance(needle, needle, (bt.Pose(r_a, R_a), bt.Pose(r_b, R_b)))
    back = bt.distance(
        needle, needle, (bt.Pose(r_a[::-1], R_a[::-1]), bt.Pose(r_b[::-1], R_b[::-1]))
    )  # fmt: skip
    np.testing.assert_allclose(forth.distance, back.distance[::-1], rtol=0, atol=DEPTH)
    np.testing.assert_allclose(forth.upper_bound, back.upper_bound[::-1], rtol=0, atol=DEPTH)
