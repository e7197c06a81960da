"""Piecewise controls keep to the plan, meet its end, and are certified as they fly."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.flight.flown import with_controls
from berthing.flight.holds import HOLDS, sample_times
from berthing.planner import plan
from berthing.report.folder import write_result
from berthing.scenario.files import from_document, load
from berthing.scenario.options import CONTROLS, SolverOptions
from berthing.trajectory import PhaseTrajectory, Plan, Segment
from berthing.verify.folder import verify_folder
from berthing.verify.verification import verify
from support import hand_made

KINDS = CONTROLS[1:]
EVERY_S = 4.0
ROOM_M = 3e-3


@pytest.fixture(scope="module")
def sound():
    """A body that turns on its way past a block, with 0.1 m asked for and far more there."""
    return hand_made.document_plan()


def only(made: Plan):
    (phase,) = made.phases
    (own,) = phase.vehicles
    return own


@pytest.mark.parametrize("kind", KINDS)
def test_what_flies_is_certified(sound, kind: str) -> None:
    whole, made = sound
    flown = with_controls(whole, made, kind, EVERY_S)
    found = verify(whole, flown)
    assert found.certified, found.reasons
    # The states are those of the commands: nothing is left to the tube but the integrator's own.
    assert found.tube_m < 1e-7
    own, planned = only(flown), only(made)
    rows = {"constant": 1, "linear": 2}[own.control_interpolation]
    assert {len(s.control) for s in own.segments} == {rows}
    t = np.linspace(own.t0_s, own.t1_s, 997)
    assert np.max(np.abs(own.state(t) - planned.state(t))[:, :3]) < 1e-3
    assert np.max(np.abs(own.state(t[-1:]) - planned.state(t[-1:]))) < 1e-7
    assert flown.cost == pytest.approx(energy(planned), rel=1e-2)


def energy(own) -> float:
    s, w = np.polynomial.legendre.leggauss(12)
    total = 0.0
    for a, b in zip(own.breaks_s[:-1], own.breaks_s[1:], strict=True):
        u = own.control(0.5 * (a + b) + 0.5 * (b - a) * s)
        total += 0.5 * (b - a) * float(w @ np.sum(u**2, axis=1))
    return total


@pytest.mark.parametrize("kind", KINDS)
def test_nodes_lie_on_what_flies(sound, kind: str, tmp_path: Path) -> None:
    whole, made = sound
    flown = with_controls(whole, made, kind, EVERY_S)
    hand_made.write_folder(tmp_path / "plan", whole, flown)
    assert verify_folder(tmp_path / "plan").certified
    # As it was written, with the nodes of the polynomials.
    hand_made.write_folder(tmp_path / "other", whole, replace(flown, nodes=made.nodes))
    assert "nodes.csv" in "".join(verify_folder(tmp_path / "other").reasons)


def test_averages_alone_drift_and_the_tube_says_so(sound) -> None:
    """The plan's own states beside held averages: what flies is elsewhere, and is not certified."""
    whole, made = sound
    own, hold = only(made), HOLDS["piecewise-constant"]
    times = sample_times(own.t0_s, own.t1_s, 5.0)
    commands = hold.commands(own, times)
    pieces = tuple(
        Segment(s.t0_s, s.t1_s, s.state, commands[i][None]) for i, s in enumerate(own.segments)
    )
    assert [s.t0_s for s in pieces] == pytest.approx(times[:-1].tolist())
    naive = replace(own, segments=pieces, control_interpolation="constant")
    found = verify(whole, replace(made, phases=(PhaseTrajectory("main", (naive,)),)))
    assert not found.certified
    assert found.tube_m > 1e-3
    assert any(reason.startswith("replay[craft") for reason in found.reasons)


def test_a_tube_wider_than_the_room_is_named(sound) -> None:
    whole, made = sound
    least = verify(whole, made).closest_distance_m
    assert least is not None
    own = only(made)
    off = [replace(s, control=s.control * (1 + 1e-3 * (i % 2))) for i, s in enumerate(own.segments)]
    flies_off = replace(own, segments=tuple(off))
    tight = replace(whole, margins=replace(whole.margins, default_m=least - ROOM_M))
    assert verify(tight, made).certified
    found = verify(tight, replace(made, phases=(PhaseTrajectory("main", (flies_off,)),)))
    assert not found.certified
    assert found.tube_m > ROOM_M
    assert any("the replay takes" in reason for reason in found.reasons)


@pytest.mark.parametrize("kind", KINDS)
def test_commands_carry_the_impulse_and_keep_the_limits(sound, kind: str) -> None:
    own, hold = only(sound[1]), HOLDS[kind]
    times = sample_times(own.t0_s, own.t1_s, 7.0)
    assert times[-1] - times[-2] == pytest.approx(2.0)
    commands = hold.commands(own, times)
    dense = own.control(np.linspace(own.t0_s, own.t1_s, 4001))
    assert np.all(commands <= dense.max(axis=0) + 1e-12)
    assert np.all(commands >= dense.min(axis=0) - 1e-12)
    middle = 0.5 * (commands[:-1] + commands[1:]) if hold.ends else commands[:-1]
    impulse = np.diff(times) @ middle
    true = np.trapezoid(dense, np.linspace(own.t0_s, own.t1_s, 4001), axis=0)
    np.testing.assert_allclose(impulse, true, atol=2e-4 if hold.ends else 1e-6)


def test_limits_are_kept_where_the_plan_is_at_them(sound) -> None:
    whole, made = sound
    own = only(made)
    t = np.linspace(own.t0_s, own.t1_s, 1001)
    most = float(np.max(np.abs(own.control(t)[:, :3])))
    vehicle = whole.phases[0].vehicles[0]
    lower, upper = vehicle.limits.control_lower.copy(), vehicle.limits.control_upper.copy()
    lower[:3], upper[:3] = -most, most
    limits = replace(vehicle.limits, control_lower=lower, control_upper=upper)
    phase = replace(whole.phases[0], vehicles=(replace(vehicle, limits=limits),))
    tight = replace(whole, phases=(phase,))
    for kind in KINDS:
        flown = with_controls(tight, made, kind, 2.0)
        assert verify(tight, flown).limits_ok
        assert np.max(np.abs(only(flown).control(t)[:, :3])) <= most


def test_intervals_are_cut_where_a_manipulator_has_a_kink() -> None:
    document = hand_made.DOCUMENT | {"structures": []}
    craft = dict(document["vehicles"][0])
    arm = {
        "name": "arm", "point_m": [0, 0, 0], "times_s": [10.25, 30.5],
        "force_n": [[0, 0, 0], [1e-3, 0, 0]], "torque_nm": [[0, 0, 0], [0, 0, 0]],
    }  # fmt: skip
    craft["dynamics"] = craft["dynamics"] | {"wrenches": [arm]}
    whole = from_document(document | {"vehicles": [craft]}, "test")
    made = hand_made.document_plan(0.0)[1]
    own = only(with_controls(whole, made, "piecewise-constant", EVERY_S))
    assert {10.25, 30.5} <= set(own.breaks_s.tolist())
    # The plan knew of no arm; the commands push against it and still keep to the plan.
    t = np.array([own.t1_s])
    assert np.max(np.abs(own.state(t) - only(made).state(t))) < 1e-6


def test_sample_times_that_do_not_serve(sound) -> None:
    whole, made = sound
    with pytest.raises(InputError, match="intervals at most"):
        with_controls(whole, made, KINDS[0], 1e-4)
    own = only(made)
    wild = [replace(s, state=s.state * np.where(np.arange(13) < 10, 1, 300)) for s in own.segments]
    spun = replace(made, phases=(PhaseTrajectory("main", (replace(own, segments=tuple(wild)),)),))
    with pytest.raises(InputError, match="too long for the motion"):
        with_controls(whole, spun, KINDS[0], 100.0)
    with pytest.raises(InputError, match="sample_time_s"):
        SolverOptions(sample_time_s=0.0)
    with pytest.raises(InputError, match="controls"):
        SolverOptions(controls="bang-bang")


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["free-space", "scenario-a"])
def test_shipped_cases_fly_on_piecewise_controls(name: str, kind: str, tmp_path: Path) -> None:
    scenario = load(name)
    options = replace(scenario.solver, controls=kind, sample_time_s=0.5)
    result = plan(scenario, options=options)
    assert result.verification is not None
    assert result.verification.certified, result.verification.reasons
    write_result(scenario, result, options, tmp_path / "plan")
    assert verify_folder(tmp_path / "plan").certified
