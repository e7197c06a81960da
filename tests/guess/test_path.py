"""Paths of poses and the motions along them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.guess.path import Guess, VehiclePath, motion_along, resample
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from support.documents import DURATION_S, puck, scenario, spacecraft
from support.solving import guessed, posed, solved

MESH = Mesh.uniform("lgr", 12, 6)
TURNED = quaternion.from_axis_angle(np.array([0.0, 0.6, 0.8]), 2.0)


def along(*positions: Any, attitudes: list[Any] | None = None) -> Motion:
    given = scenario(spacecraft())
    q = [[1.0, 0, 0, 0]] * len(positions) if attitudes is None else attitudes
    path = VehiclePath(np.array(positions, dtype=float), np.array(q, dtype=float))
    return motion_along(Guess("test", {"spacecraft": path}), given.phases[0], MESH, DURATION_S)


def test_a_path_begins_and_ends_at_its_ends_at_rest() -> None:
    motion = along([0, 0, 0], [4, 5, 1], [10, 3, 0], attitudes=[[1, 0, 0, 0], TURNED, -TURNED])
    x = motion.states["spacecraft"]
    np.testing.assert_allclose(x[0:3, 0], [0, 0, 0], atol=1e-12)
    np.testing.assert_allclose(x[0:3, -1], [10, 3, 0], atol=1e-12)
    assert quaternion.angle_between(x[6:10, 0], np.array([1.0, 0, 0, 0])) < 1e-7
    assert quaternion.angle_between(x[6:10, -1], TURNED) < 1e-7
    # Differenced over a small step, so nearly at rest only.
    for end in (0, -1):
        assert np.max(np.abs(x[3:6, end])) < 1e-3 * np.max(np.abs(x[3:6]))
        assert np.max(np.abs(x[10:13, end])) < 1e-3
    assert motion.duration_s == DURATION_S
    assert not motion.controls["spacecraft"].any()
    assert motion.controls["spacecraft"].shape == (6, MESH.control_count)


def test_it_passes_through_its_waypoints() -> None:
    motion = along([0, 0, 0], [4, 5, 1], [10, 3, 0])
    fine = Mesh.uniform("lgr", 400, 3)
    given = scenario(spacecraft())
    path = VehiclePath(np.array([[0.0, 0, 0], [4, 5, 1], [10, 3, 0]]), np.eye(4)[[0, 0, 0]])
    dense = motion_along(Guess("test", {"spacecraft": path}), given.phases[0], fine, DURATION_S)
    near = np.linalg.norm(dense.states["spacecraft"][:3].T - [4, 5, 1], axis=1)
    assert np.min(near) < 0.02
    straight = along([0, 0, 0], [10, 3, 0])
    assert np.min(np.linalg.norm(straight.states["spacecraft"][:3].T - [4, 5, 1], axis=1)) > 2.0
    assert np.max(np.abs(motion.states["spacecraft"][:3])) <= 10.0 + 1e-12


def test_where_times_are_given_it_is_there_then() -> None:
    tau = np.linspace(0.0, 1.0, 30)
    late = tau**3 * (4.0 - 3.0 * tau)
    positions = late[:, None] * [10.0, 3.0, 0.0]
    path = VehiclePath(positions, np.tile([1.0, 0.0, 0.0, 0.0], (len(tau), 1)), tau)
    given = scenario(spacecraft())
    motion = motion_along(Guess("test", {"spacecraft": path}), given.phases[0], MESH, DURATION_S)
    x, at = motion.states["spacecraft"], MESH.point_fractions()
    np.testing.assert_allclose(x[0], 10.0 * at**3 * (4.0 - 3.0 * at), atol=1e-3)
    speed = 10.0 * 12.0 * at**2 * (1.0 - at) / DURATION_S
    np.testing.assert_allclose(x[3], speed, atol=0.02 * np.max(speed))


def test_velocities_and_rates_are_those_of_the_path() -> None:
    motion = along([0, 0, 0], [10, 3, 0], attitudes=[[1, 0, 0, 0], TURNED])
    problem = posed(scenario(spacecraft()), 12, 6, sites=[])
    own = trajectories(problem, motion).vehicles[0]
    t = np.linspace(1.0, DURATION_S - 1.0, 197)
    x, slope = own.state(t), own.state_rate(t)
    # Differenced over a finite step, one-sided at the ends; speeds here reach 0.15 m/s.
    np.testing.assert_allclose(slope[:, :3], x[:, 3:6], atol=2e-5)
    q, w = x[:, 6:10], x[:, 10:13]
    turning = 2.0 * quaternion.multiply(quaternion.conjugate(q), slope[:, 6:10])[:, 1:]
    np.testing.assert_allclose(turning, w, atol=2e-5)
    assert np.max(np.abs(w)) > 0.02


@pytest.mark.parametrize("signs", [(1, 1, 1), (1, -1, 1), (-1, 1, -1), (1, 1, -1)])
def test_quaternions_do_not_jump_whatever_the_signs_of_the_waypoints(signs) -> None:
    waypoints = [np.array([1.0, 0, 0, 0]), TURNED, quaternion.multiply(TURNED, TURNED)]
    attitudes = [sign * q for sign, q in zip(signs, waypoints, strict=True)]
    q = along([0, 0, 0], [5, 5, 0], [10, 3, 0], attitudes=attitudes).states["spacecraft"][6:10].T
    np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1.0, atol=1e-12)
    assert np.min(np.sum(q[1:] * q[:-1], axis=1)) > 0.95
    np.testing.assert_allclose(q[0], attitudes[0], atol=1e-7)


def test_turning_in_place_is_a_path_too() -> None:
    motion = along([1, 2, 3], [1, 2, 3], attitudes=[[1, 0, 0, 0], TURNED])
    x = motion.states["spacecraft"]
    np.testing.assert_allclose(x[:3].T, np.tile([1.0, 2, 3], (MESH.point_count, 1)), atol=1e-12)
    assert quaternion.angle_between(x[6:10, -1], TURNED) < 1e-7
    still = along([1, 2, 3], [1, 2, 3]).states["spacecraft"]
    assert np.isfinite(still).all()


def test_a_planar_point_mass_has_no_attitude() -> None:
    problem = posed(scenario(puck()), 3, 4)
    motion = guessed(problem)
    assert motion.states["puck"].shape == (4, 13)
    np.testing.assert_allclose(motion.states["puck"][:2, -1], [6, 0], atol=1e-12)


COARSE = Mesh("lgr", (0.0, 0.4, 1.0), (4, 3))


def resampled(new: Mesh) -> tuple[Motion, Motion, Any]:
    found = solved(scenario(puck()), 1, 1)
    phase, rng = found.problem.phase, np.random.default_rng(3)
    motion = Motion(
        80.0,
        {"puck": rng.normal(size=(4, COARSE.point_count))},
        {"puck": rng.normal(size=(2, COARSE.control_count))},
    )
    return motion, resample(motion, phase, COARSE, new), phase


def test_resampling_on_a_finer_mesh_and_back_loses_nothing() -> None:
    # A finer mesh holds the same polynomials, piece by piece.
    finer = COARSE.split({0, 1})
    motion, there, phase = resampled(finer)
    back = resample(there, phase, finer, COARSE)
    np.testing.assert_allclose(back.states["puck"], motion.states["puck"], atol=1e-12)
    np.testing.assert_allclose(back.controls["puck"], motion.controls["puck"], atol=1e-12)
    assert back.duration_s == there.duration_s == 80.0


def test_resampling_on_the_same_mesh_changes_nothing() -> None:
    motion, there, _ = resampled(COARSE)
    np.testing.assert_allclose(there.states["puck"], motion.states["puck"], atol=1e-13)
    np.testing.assert_allclose(there.controls["puck"], motion.controls["puck"], atol=1e-13)


def test_resampling_is_exact_on_polynomials_and_not_beyond_the_degree() -> None:
    new = Mesh("lgr", (0.0, 0.3, 0.5, 1.0), (3, 4, 5))
    phase = scenario(puck()).phases[0]

    def cubic(mesh: Mesh, power: int) -> Motion:
        t = mesh.point_fractions()
        s = np.array(
            [mesh.fraction(k, float(c)) for k in range(mesh.segments)
             for c in mesh.node_set(k).control_points]
        )  # fmt: skip
        states = np.stack([t, 1 - t**2, t**power, t**3 - t])
        return Motion(50.0, {"puck": states}, {"puck": np.stack([s**2, 1.0 - s])})

    there = resample(cubic(COARSE, 3), phase, COARSE, new)
    np.testing.assert_allclose(there.states["puck"], cubic(new, 3).states["puck"], atol=1e-13)
    np.testing.assert_allclose(there.controls["puck"], cubic(new, 3).controls["puck"], atol=1e-13)
    beyond = resample(cubic(COARSE, 6), phase, COARSE, new).states["puck"][2]
    assert np.max(np.abs(beyond - cubic(new, 6).states["puck"][2])) > 1e-4
