from dataclasses import replace

import numpy as np

from berthing.report.offline.clock import MOST_SAMPLES, TURN_RAD, motion_times
from berthing.scenario.motion import ConstantSpin
from support import synthetic


def times_of(of):
    plan = synthetic.plan(of)
    return motion_times(of, plan, plan.phases[0]), plan


def test_nodes_and_breaks_are_among_the_times():
    of = synthetic.scenario()
    times, plan = times_of(of)
    assert np.all(np.diff(times) > 0.0)
    assert (times[0], times[-1]) == (0.0, synthetic.DURATION_S)
    for wanted in (plan.nodes[0].times_s, plan.phases[0].vehicles[0].breaks_s):
        assert np.all(np.isin(wanted, times))


def test_both_sides_of_a_jump_are_among_the_times():
    of = synthetic.scenario()
    plan = synthetic.plan(of)
    (phase,) = plan.phases
    (own,) = phase.vehicles
    # Adding to the first of the coefficients adds to the whole.
    jumping = [
        replace(s, control=s.control + np.outer(np.arange(len(s.control)) == 0, [i] * 6))
        for i, s in enumerate(own.segments)
    ]
    phase = replace(phase, vehicles=(replace(own, segments=tuple(jumping)),))
    times = motion_times(of, plan, phase)
    control = phase.vehicles[0].control(times)[:, 0]
    jumps = np.diff(control) > 0.9
    assert np.sum(jumps) == len(jumping) - 1
    assert np.all(np.diff(times)[jumps] < 1e-6)


def spun(rate):
    spinner = synthetic.spinner()
    motion = ConstantSpin(spinner.motion.pose0, np.array([0.0, 0.0, 1.0]), rate, np.zeros(3))
    return synthetic.scenario(structures=(replace(spinner, motion=motion),))


def test_what_turns_fast_is_sampled_more_often_within_reason():
    times, _ = times_of(spun(2.0))
    assert np.max(np.diff(times)) * 2.0 < 1.01 * TURN_RAD
    times, _ = times_of(spun(1e6))
    assert len(times) < 1.1 * MOST_SAMPLES
