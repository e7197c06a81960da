"""The plane formulation: what it starts from, what it proves, and that it proves all there is."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from berthing.clearance.separation import PairQuery
from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.proximity.plane import PlaneFormulation

ROUNDING = 1e-9
SOLVED = 2e-6
"""IPOPT at 1e-9 stops this near the corners of the feasible set; distances are of order one."""

HALF = 0.5 * np.pi


def placed(*position: float, axis=(0.0, 0.0, 1.0), angle: float = 0.0) -> Pose:
    turn = quaternion.from_axis_angle(np.array(axis), angle)
    return Pose.from_quaternion(np.array(position), turn)


@pytest.mark.parametrize("reach", [1.2, 3.0])
def test_start_is_feasible_and_tight_where_the_sets_are_apart(pair, reach, poses, rows_at) -> None:
    a, b = pair
    form, query = PlaneFormulation(a, b), PairQuery(a, b)
    distance = reach * (a.bounding_radius + b.bounding_radius) + 0.1
    poses_a, poses_b = poses(4, a.dim, 0.1), poses(4, a.dim, distance)
    gaps, normals, _ = query.batch(poses_a, poses_b)
    starts = form.start(poses_a, poses_b, normals)
    assert starts.shape == (4, len(form.variables))
    for i in range(4):
        values, rows = rows_at(form, starts[i], poses_a[i], poses_b[i], 0.0)
        assert gaps[i] > 0.0
        assert np.all(values >= rows.lower - ROUNDING)
        assert values[rows.separation] == pytest.approx(gaps[i], abs=1e-6 * distance)
        held, _ = rows_at(form, starts[i], poses_a[i], poses_b[i], gaps[i] + 0.01)
        assert held[rows.separation] < 0.0


def test_the_best_plane_is_the_distance(pair, poses, best_gap) -> None:
    a, b = pair
    form, query = PlaneFormulation(a, b), PairQuery(a, b)
    size = a.bounding_radius + b.bounding_radius
    poses_a, poses_b = poses(2, a.dim, 0.3), poses(2, a.dim, 0.9 * size + 0.5)
    distances, _, _ = query.batch(poses_a, poses_b)
    # From the line of centres, which is not the answer.
    way = poses_b.position - poses_a.position
    starts = form.start(poses_a, poses_b, way / np.linalg.norm(way, axis=1, keepdims=True))
    for i in range(2):
        gap = best_gap(form, starts[i], poses_a[i], poses_b[i])
        # Where the sets overlap, n = 0 is best, and a positive margin has no solution.
        assert gap == pytest.approx(max(distances[i], 0.0), abs=SOLVED * (1.0 + size))


CONTACTS = {
    "faces apart": (Box([1, 1, 1]), placed(0, 0, 0), Box([1, 2, 1]), placed(2.5, 0.3, 0), 0.5),
    "faces touch": (Box([1, 1, 1]), placed(0, 0, 0), Box([1, 2, 1]), placed(2, 0.3, 0), 0.0),
    "edge on face": (
        Box([1, 1, 1]), placed(0, 0, 0), Box([1, 1, 1]),
        placed(1.5 + np.sqrt(2), 0, 0, angle=0.25 * np.pi), 0.5,
    ),
    "edge on edge": (
        Box([1, 1, 1]), placed(0, 0, 0, angle=0.25 * np.pi), Box([1, 1, 1]),
        placed(2 * np.sqrt(2) + 0.5, 0, 0, axis=(0, 1, 0), angle=0.25 * np.pi), 0.5,
    ),
    "corner to corner": (
        Box([1, 1, 1]), placed(0, 0, 0), Box([1, 1, 1]), placed(3, 3, 3), np.sqrt(3.0),
    ),
    "rim on face": (Cylinder(1, 2), placed(0, 0, 0), Box([1, 1, 1]), placed(0, 2.25, 0), 0.25),
    "end on end": (Cylinder(1, 2), placed(0, 0, 0), Cylinder(1, 2), placed(4.1, 0, 0), 0.1),
    "side by side": (Cylinder(1, 2), placed(0, 0, 0), Cylinder(1, 2), placed(0, 2.1, 0), 0.1),
    "crossed": (
        Cylinder(1, 2), placed(0, 0, 0), Cylinder(1, 2), placed(0, 0, 2.1, angle=HALF), 0.1,
    ),
    "two points": (Sphere(0.0), placed(0, 0, 0), Sphere(0.0), placed(0, 0.2, 0), 0.2),
    "balls inside each other": (Sphere(1.0), placed(0, 0, 0), Sphere(2.0), placed(0, 0, 0), 0.0),
    "tip on face": (
        Polytope.from_vertices([[0, 0, 0], [1, 1, 0], [1, -1, 0], [1, 0, 1]]), placed(0.2, 0, 0),
        Box([1, 1, 1]), placed(-1, 0, 0), 0.2,
    ),
}  # fmt: skip


@pytest.mark.parametrize("contact", CONTACTS.values(), ids=CONTACTS.keys())
def test_the_best_plane_is_the_distance_in_degenerate_contact(contact, best_gap) -> None:
    a, pose_a, b, pose_b, expected = contact
    form = PlaneFormulation(a, b)
    normal = np.array([0.6, 0.48, 0.64])
    start = form.start(pose_a, pose_b, normal)
    assert best_gap(form, start, pose_a, pose_b) == pytest.approx(expected, abs=SOLVED * 5)


def test_any_feasible_point_understates(pair, rng, poses, rows_at) -> None:
    a, b = pair
    form = PlaneFormulation(a, b)
    pose_a, pose_b = poses(1, a.dim, 0.3)[0], poses(1, a.dim, 5.0)[0]
    distance = PairQuery(a, b).query(pose_a, pose_b).distance
    for n in rng.normal(size=(5, a.dim)):
        n = n / np.linalg.norm(n) * rng.uniform(0.1, 1.0)
        v = form.start(pose_a, pose_b, n)
        # Multipliers above the least ones are feasible too.
        v[a.dim :] += rng.uniform(0.0, 0.5, size=len(v) - a.dim)
        values, rows = rows_at(form, v, pose_a, pose_b, 0.0)
        assert np.all(values[1:] >= rows.lower[1:] - ROUNDING)
        assert values[rows.separation] <= max(distance, 0.0) + 1e-6


def test_a_longer_normal_or_a_smaller_multiplier_is_infeasible(rows_at) -> None:
    form = PlaneFormulation(Box([1, 1, 1]), Cylinder(1, 2))
    pose_a, pose_b = placed(0, 0, 0), placed(5, 1, 0, angle=0.3)
    normal = np.array([0.8, 0.6, 0.0])
    v = form.start(pose_a, pose_b, normal)
    values, rows = rows_at(form, v, pose_a, pose_b, 0.0)
    assert np.all(values >= rows.lower - ROUNDING)
    stretched, _ = rows_at(form, form.start(pose_a, pose_b, 1.1 * normal), pose_a, pose_b, 0.0)
    assert np.min(stretched) < -0.1
    for i in (3, 4, 6, 7):
        less = v.copy()
        less[i] -= 0.1
        assert np.min(rows_at(form, less, pose_a, pose_b, 0.0)[0]) < -1e-3


def test_the_row_is_divided_by_the_length_and_the_margin_taken_off() -> None:
    form = PlaneFormulation(Sphere(1.0), Sphere(0.5))
    pose_a, pose_b = placed(0, 0, 0), placed(5, 0, 0)
    v = form.start(pose_a, pose_b, np.array([1.0, 0.0, 0.0]))
    world = [(ca.DM(p.position), ca.DM(p.rotation)) for p in (pose_a, pose_b)]
    rows = form.rows(ca.DM(v), *world, 0.5, 10.0)
    assert float(rows.expression[rows.separation]) == pytest.approx((5.0 - 1.5 - 0.5) / 10.0)


def test_the_regulariser_is_of_the_multipliers_alone() -> None:
    form = PlaneFormulation(Box([1, 1, 1]), Cylinder(1, 2))
    world = (ca.DM.zeros(3), ca.DM.eye(3))

    def regulariser(v: np.ndarray) -> float:
        return float(form.rows(ca.DM(v), world, world, 0.0, 1.0).regulariser)

    v = np.zeros(len(form.variables))
    assert regulariser(v) == 0.0
    v[:3] = [0.1, -0.7, 0.2]
    assert regulariser(v) == 0.0
    for i in range(3, len(v)):
        v[i] = -2.0
    assert regulariser(v) == pytest.approx(4.0 * (len(v) - 3))


def test_variables_are_named_and_unbounded() -> None:
    names = PlaneFormulation(Box([1, 1, 1]), Cylinder(1, 2)).variables.names
    assert names == ("n_x", "n_y", "n_z", "tau_a0", "tau_a1", "tau_a2", "tau_b0", "tau_b1")
    planar = PlaneFormulation(Box([1, 1]), Sphere(1.0, dim=2)).variables
    assert planar.names == ("n_x", "n_y", "tau_a0", "tau_a1", "tau_b0")
    assert len(planar) == 5
    assert not np.isfinite([*planar.lower, *planar.upper]).any()
