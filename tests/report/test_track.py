import numpy as np

from berthing.geometry import quaternion
from berthing.report.placed import GHOSTS, ghost_indices, placed_parts
from berthing.report.track import motion, tracks
from support import synthetic


def test_the_dense_motion_is_the_interpolant_and_spans_the_phase():
    of = synthetic.scenario()
    plan = synthetic.plan(of)
    (track,) = tracks(of, plan)
    t = track.dense.times_s
    assert (t[0], t[-1]) == (0.0, synthetic.DURATION_S)
    assert np.all(np.diff(t) >= 0.0)
    states = plan.phases[0].vehicles[0].state(t)
    np.testing.assert_allclose(track.dense.pose.position, states[:, :3], atol=1e-12)
    np.testing.assert_allclose(track.dense.rate_rad_s, states[:, 10:13], atol=1e-12)


def test_quaternions_do_not_jump_through_a_whole_turn():
    vehicle = synthetic.spacecraft()
    t = np.linspace(0.0, 2.0, 201)
    q = quaternion.from_axis_angle(np.tile([0.0, 0.6, 0.8], (201, 1)), 2 * np.pi * t)
    states = np.concatenate([np.zeros((201, 6)), q, np.zeros((201, 3))], axis=1)
    shown = motion(vehicle, t, states, np.zeros((201, 6))).q_IB
    assert np.abs(np.diff(shown, axis=0)).max() < 0.05
    np.testing.assert_allclose(np.abs(np.einsum("ki,ki->k", shown, q)), 1.0)


def test_a_planar_vehicle_turns_about_z():
    of = synthetic.planar_scenario()
    (track,) = tracks(of, synthetic.plan(of))
    np.testing.assert_allclose(track.dense.q_IB, np.tile([1.0, 0, 0, 0], (480, 1)))
    assert track.dense.pose.dim == 2


def test_a_plan_without_nodes_has_a_track():
    from dataclasses import replace

    of = synthetic.scenario()
    (track,) = tracks(of, replace(synthetic.plan(of), nodes=()))
    assert len(track.nodes.times_s) == 0
    assert track.nodes.control.shape == (0, 6)


def test_ghosts_begin_and_end_with_the_track_and_are_spread_over_its_way():
    of = synthetic.scenario()
    (track,) = tracks(of, synthetic.plan(of))
    chosen = ghost_indices(track)
    assert len(chosen) == GHOSTS
    assert (chosen[0], chosen[-1]) == (0, len(track.dense.times_s) - 1)
    steps = np.linalg.norm(np.diff(track.dense.pose.position[chosen], axis=0), axis=1)
    assert steps.min() > 0.5


def test_moving_structures_are_drawn_several_times_and_fixed_ones_once():
    of = synthetic.scenario()
    placed = placed_parts(of, tracks(of, synthetic.plan(of)))
    # The block, two parts of the spinner at four times, the hull at seven.
    assert len(placed) == 1 + 2 * 4 + 7
    tips = np.stack([p.points.mean(axis=0) for p in placed[1:9]])
    assert len(np.unique(tips.round(6), axis=0)) > 4


def test_each_vehicle_keeps_its_colour_through_the_phases():
    of = synthetic.two_phase_scenario()
    out, on = tracks(of, synthetic.plan(of))
    assert (out.phase, on.phase) == ("out", "on")
    assert out.colour == on.colour
    assert on.dense.times_s[0] == out.dense.times_s[-1]
