"""One verdict; every kind of damage to a true plan is noticed."""

import json
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.scenario.goal import End
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.trajectory import Plan, VehicleTrajectory
from berthing.verify.verification import Verification, verify


def damaged(made: Plan, change) -> Plan:
    """The plan with ``change`` applied to every segment of its vehicle."""
    (phase,) = made.phases
    (own,) = phase.vehicles
    flown = replace(own, segments=tuple(change(s) for s in own.segments))
    return replace(made, phases=(replace(phase, vehicles=(flown,)),))


def state_changed(change):
    def apply(segment):
        state = segment.state.copy()
        change(state)
        return replace(segment, state=state)

    return apply


def shifted(segment, column: int, by: float):
    state = segment.state.copy()
    state[0, column] += by
    return replace(segment, state=state)


def only_reasons(whole, made) -> tuple[str, ...]:
    found = verify(whole, made)
    assert not found.certified
    assert found.reasons
    return found.reasons


def test_a_sound_plan_is_certified(make) -> None:
    whole, made = make.document_plan(turn=np.pi / 2)
    found = verify(whole, made)
    assert found.certified
    assert found.reasons == ()
    assert not found.undecided
    assert found.clearance_lower_bound_m >= found.required_clearance_m == 0.1
    assert found.closest_pair in {p.pair for p in found.pairs}
    assert found.closest_distance_m >= found.clearance_lower_bound_m - 1e-9
    assert found.replay_position_error_m < 1e-6
    assert found.replay_attitude_error_rad < 1e-6
    assert found.limits_ok
    assert found.model_check == "independent"
    assert found.backoff_m == 1e-3
    assert verify(whole, made, backoff_m=0.5).backoff_m == 0.5


def test_the_record_is_json(make) -> None:
    whole, made = make.document_plan()
    record = json.loads(json.dumps(verify(whole, made).to_json(), allow_nan=False))
    assert record["certified"] is True
    assert {
        "clearance_lower_bound_m", "required_clearance_m", "backoff_m", "closest_pair",
        "closest_time_s", "replay_position_error_m", "replay_attitude_error_rad",
        "hamiltonian_relative_drift", "limits_ok", "model_check", "certified", "reasons", "pairs",
    } <= set(record)  # fmt: skip


def test_nothing_to_keep_clear_of(make) -> None:
    whole, made = make.document_plan()
    found = verify(replace(whole, structures=()), made)
    assert found.certified
    assert found.clearance_lower_bound_m == np.inf
    assert found.closest_pair is None
    assert found.to_json()["clearance_lower_bound_m"] is None


DAMAGE = {
    "shifted by 5 cm": (lambda s: shifted(s, 1, 0.05), "start[craft, position"),
    "shifted by 50 cm": (lambda s: shifted(s, 1, 0.5), "clearance[craft.hull, block.face"),
    "stretched in time": (
        lambda s: replace(s, t0_s=1.05 * s.t0_s, t1_s=1.05 * s.t1_s), "clock[main, craft]: lasts"),
    "quaternion scalar last": (
        state_changed(lambda c: c.__setitem__((slice(None), slice(6, 10)), c[:, [7, 8, 9, 6]])),
        "start[craft, attitude"),
    "quaternion conjugated": (
        state_changed(lambda c: c.__setitem__((slice(None), 9), -c[:, 9])), "goal[craft, attitude"),
    "velocities of another sign": (
        state_changed(lambda c: c.__setitem__((slice(None), 3), -c[:, 3])), "replay[craft"),
    "controls of another sign": (lambda s: replace(s, control=-s.control), "replay[craft"),
    "controls doubled": (lambda s: replace(s, control=4.0 * s.control), "limit[craft, fx_n"),
    "one segment moved": (
        lambda s: shifted(s, 2, 0.01) if s.t0_s == 50.0 else s, "craft, t = 50 s]: z_m jumps"),
    "a gap in time": (
        lambda s: replace(s, t0_s=50.1) if s.t0_s == 50.0 else s, "begins where none ends"),
    "quaternion halved": (
        state_changed(lambda c: c.__setitem__((slice(None), slice(6, 10)), 0.9 * c[:, 6:10])),
        "limit[craft, quaternion norm"),
}  # fmt: skip


@pytest.mark.parametrize(("change", "expected"), DAMAGE.values(), ids=DAMAGE.keys())
def test_damage_is_noticed(make, change, expected: str) -> None:
    whole, made = make.document_plan()
    reasons = only_reasons(whole, damaged(made, change))
    assert any(expected in reason for reason in reasons), reasons


def test_a_gap_leaves_nothing_proven(make) -> None:
    whole, made = make.document_plan()
    found = verify(whole, damaged(made, DAMAGE["a gap in time"][0]))
    assert found.clearance_lower_bound_m == -np.inf
    assert found.replay_position_error_m == np.inf
    assert found.to_json()["replay_position_error_m"] is None
    assert {p.verdict for p in found.pairs} == {"undecided"}


def test_a_body_that_is_larger_than_planned(make) -> None:
    whole, made = make.document_plan()
    phase = whole.phases[0]
    own = phase.vehicles[0]
    part = replace(own.body.parts[0], shape=Box(np.array([1.5, 0.5, 0.5])))
    grown = replace(own, body=replace(own.body, parts=(part,)))
    bigger = replace(whole, phases=(replace(phase, vehicles=(grown,)),))
    assert any("clearance[craft.hull" in reason for reason in only_reasons(bigger, made))


def test_a_wider_margin_than_planned(make) -> None:
    whole, made = make.document_plan()
    wide = replace(whole, margins=MarginPolicy(0.6))
    found = verify(wide, made)
    assert not found.certified
    assert found.clearance_lower_bound_m < 0.6 == found.required_clearance_m
    violated = {p.pair for p in found.pairs if p.verdict == "violated"}
    assert violated
    exempted = MarginPolicy(
        0.6, (MarginOverride("craft", "block", None), MarginOverride("craft", "post", 0.1))
    )
    assert verify(replace(whole, margins=exempted), made).certified


def test_undecided_is_told_from_violated(make) -> None:
    whole, made = make.document_plan(turn=0.0)
    phase = whole.phases[0]
    own = replace(phase.vehicles[0], goal=End(np.array([10.0, 0.0, 0.0])))
    whole = replace(whole, phases=(replace(phase, vehicles=(own,)),))
    # The box glides past the face at y = 1.5 with its side at 0.5 m: exactly 1 m.
    found = verify(replace(whole, margins=MarginPolicy(1.0)), made)
    assert [p.verdict for p in found.pairs] == ["undecided", "certified"]
    assert found.undecided
    assert not found.certified
    assert not verify(replace(whole, margins=MarginPolicy(1.01)), made).undecided


def test_more_reasons_take_the_certificate_away(make) -> None:
    whole, made = make.document_plan()
    found = verify(whole, made)
    assert found.with_reasons([]).certified
    assert not found.with_reasons(["tables differ"]).certified


def first_segment(**changes):
    return lambda own: replace(own, segments=(replace(own.segments[0], **changes),))


FOREIGN = {
    "name": lambda own: replace(own, vehicle="tug"),
    "model": lambda own: replace(own, model="point-mass"),
    "columns": lambda own: replace(own, state_names=own.state_names[::-1]),
    "interpolation": lambda own: replace(own, control_interpolation="spline"),
    "controls": lambda own: replace(own, control_interpolation="linear"),
    "empty": lambda own: replace(own, segments=()),
    "shape": first_segment(state=np.ones((3, 12))),
    "NaN": first_segment(state=np.full((3, 13), np.nan)),
    "huge": first_segment(control=np.full((3, 6), 1e300)),
    "infinite time": first_segment(t1_s=np.inf),
}


@pytest.mark.parametrize("change", FOREIGN.values(), ids=FOREIGN.keys())
def test_a_plan_of_something_else_is_bad_input(make, change) -> None:
    whole, made = make.document_plan()
    (phase,) = made.phases
    other: VehicleTrajectory = change(phase.vehicles[0])
    with pytest.raises(InputError):
        verify(whole, replace(made, phases=(replace(phase, vehicles=(other,)),)))
    with pytest.raises(InputError):
        verify(whole, replace(made, phases=()))


@pytest.mark.slow
@pytest.mark.parametrize("size", [1e11, -1e11])
def test_absurd_numbers_end_in_no_certificate(make, size: float) -> None:
    whole, made = make.document_plan()
    rng = np.random.default_rng(0)

    def scramble(segment):
        return replace(segment, state=size * rng.normal(size=segment.state.shape))

    found: Verification = verify(whole, damaged(made, scramble))
    assert not found.certified


def test_verify_loads_no_solver() -> None:
    code = (
        "import sys, berthing.verify.verification, berthing.verify.folder, "
        "berthing.verify.endpoints; print('casadi' in sys.modules)"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "False"
