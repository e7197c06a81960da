"""Clearance is proven where it is there, and never where it is not."""

import numpy as np
import pytest

from berthing.clearance.separation import PairQuery
from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.motion import ConstantSpin, ConstantVelocity
from berthing.scenario.point_mass import PointMass
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.certificate import Certificate, certify
from berthing.verify.settings import CertificateSettings


def certificate(whole: Scenario, *flown, **options) -> Certificate:
    return certify(whole, whole.phases[0], PhaseTrajectory("main", flown), **options)


def only(found: Certificate):
    (verdict,) = found.verdicts
    return verdict


def straight(start, velocity):
    return lambda t: np.array(start, dtype=float) + t[:, None] * np.array(velocity, dtype=float)


def pass_by(make, gap: float, margin: float):
    """A ball of 0.5 m flies past a ball of 1 m along a line that clears it by ``gap``."""
    ball, still = make.vehicle(Sphere(0.5)), make.structure(Sphere(1.0))
    flown = make.path(ball, straight([-6, 1.5 + gap, 0.3], [1.2, 0, 0]))
    gap_there = np.hypot(1.5 + gap, 0.3) - 1.5
    return make.scenario([ball], [still], margin), flown, gap_there


@pytest.mark.parametrize("shift", [1e-3, 1e-4, 1e-6])
def test_a_pass_that_just_clears_is_certified(make, shift: float) -> None:
    *_, gap = pass_by(make, 0.1, 0.0)
    whole, flown, _ = pass_by(make, 0.1, gap - shift)
    verdict = only(certificate(whole, flown))
    assert verdict.verdict == "certified"
    assert gap - shift <= verdict.lower_bound_m <= gap


@pytest.mark.parametrize("shift", [1e-6, 1e-4, 1e-2])
def test_a_pass_that_just_violates_is_found(make, shift: float) -> None:
    *_, gap = pass_by(make, 0.1, 0.0)
    whole, flown, _ = pass_by(make, 0.1, gap + shift)
    verdict = only(certificate(whole, flown))
    assert verdict.verdict == "violated"
    assert verdict.time_s == pytest.approx(5.0, abs=0.1)
    assert 0.0 < verdict.depth_m <= shift + 1e-9
    assert verdict.depth_m >= shift - 1e-3
    assert verdict.lower_bound_m <= gap
    assert f"t = {verdict.time_s:.6g} s" in verdict.reason
    assert verdict.violations_s


def test_a_pass_at_the_margin_is_undecided(make) -> None:
    *_, gap = pass_by(make, 0.1, 0.0)
    whole, flown, _ = pass_by(make, 0.1, gap)
    verdict = only(certificate(whole, flown))
    assert verdict.verdict == "undecided"
    assert verdict.lower_bound_m == pytest.approx(gap, abs=1e-6)
    assert "undecided" in verdict.reason


def test_tunnelling_between_the_samples_is_seen(make) -> None:
    """A bead goes through a foil in 3 ms: no sample of a grid of 1001 is near."""
    bead = make.vehicle(Sphere(5e-4))
    foil = make.structure(Box(np.array([5e-4, 2.0, 2.0])))
    flown = make.path(bead, straight([-5.005, 0, 0], [1, 0, 0]))
    t = np.linspace(0.0, 10.0, 1001)
    poses = bead.model.pose(flown.state(t))
    distance, _, _ = PairQuery(bead.body.parts[0].shape, foil.body.parts[0].shape).batch(
        poses, Pose.identity()
    )
    assert np.min(distance) > 1e-3
    verdict = only(certificate(make.scenario([bead], [foil], 1e-3), flown))
    assert verdict.verdict == "violated"
    assert verdict.time_s == pytest.approx(5.005, abs=2e-3)


@pytest.mark.parametrize(("gap", "expected"), [(0.1, "certified"), (-0.01, "violated")])
def test_the_tip_of_a_spinning_rod(make, gap: float, expected: str) -> None:
    """Half a length of 3 m turning at 2 rad/s beside a plate that only the tip comes near."""
    rod = make.vehicle(Box(np.array([3.0, 0.05, 0.05])))
    reach = np.hypot(3.0, 0.05)
    plate = make.structure(
        Box(np.array([5.0, 0.5, 5.0])), at=[make.placed([0, reach + 0.5 + 0.05 + gap, 0])]
    )
    spin = make.turn_about([0, 0, 1], lambda t: 2.0 * t)
    flown = make.path(rod, lambda t: np.zeros((len(t), 3)), spin, segments=40)
    verdict = only(certificate(make.scenario([rod], [plate], 0.05), flown))
    assert verdict.verdict == expected
    if expected == "certified":
        # The tip is nearest five or six times; the bound must come close to the truth.
        assert 0.05 <= verdict.lower_bound_m <= gap + 0.05 + 1e-6


def test_a_long_slide_at_a_tenth_of_a_millimetre(make) -> None:
    box, face = (
        make.vehicle(Box(np.array([2.0, 1.0, 1.0]))),
        make.structure(Box(np.array([6.0, 3, 3]))),
    )

    def angle(t):
        return 0.6 * np.sin(np.pi * t / 30.0)

    def position(t):
        height = 3.1001 + 2.0 * np.abs(np.sin(angle(t))) + np.cos(angle(t))
        return np.stack([0.1 * t - 3.0, height, 0.0 * t], axis=1)

    flown = make.path(
        box, position, make.turn_about([0, 0, 1], angle), duration_s=60.0, segments=32
    )
    found = certificate(make.scenario([box], [face], 0.1, 60.0), flown)
    assert only(found).verdict == "certified"
    # 45,000 intervals would do at first order.
    assert len(found.evidence[0].leaves.pair) < 1500


def test_bodies_that_move_together_cost_nothing(make) -> None:
    box = make.vehicle(Box(np.ones(3)))
    hub = make.structure(
        Box(np.ones(3)),
        motion=ConstantSpin(Pose.identity(), np.array([0, 0, 1.0]), 0.2, np.zeros(3)),
    )

    def position(t):
        return 2.1001 * np.stack([np.cos(0.2 * t), np.sin(0.2 * t), 0.0 * t], axis=1)

    flown = make.path(box, position, make.turn_about([0, 0, 1], lambda t: 0.2 * t), degree=10)
    found = certificate(make.scenario([box], [hub], 0.1), flown)
    assert only(found).verdict == "certified"
    assert len(found.evidence[0].leaves.pair) < 200


def test_two_vehicles_and_a_drifting_structure(make) -> None:
    a, b = make.vehicle(Box(np.ones(3)), name="a"), make.vehicle(Box(np.ones(3)), name="b")
    drifting = make.structure(
        Box(np.ones(3)), motion=ConstantVelocity(make.placed([0, 10, 0]), np.array([0.3, 0, 0]))
    )
    flown = [
        make.path(a, straight([0, 0, 0], [0.3, 0, 0])),
        make.path(b, straight([2.2, 0, 0], [0.28, 0.01, 0]), segments=7),
    ]
    verdicts = certificate(make.scenario([a, b], [drifting], 0.1), *flown).verdicts
    found = {v.pair: v for v in verdicts}
    assert found["a.p0|b.p0"].verdict == "violated"
    # They close in at 2 cm/s from 0.2 m.
    assert found["a.p0|b.p0"].depth_m == pytest.approx(0.1, abs=2e-3)
    assert found["a.p0|wall.p0"].verdict == found["b.p0|wall.p0"].verdict == "certified"


def test_margins_change_with_windows(make) -> None:
    box, wall = (
        make.vehicle(Box(np.ones(3))),
        make.structure(Box(np.ones(3)), at=[make.placed([5, 0, 0])]),
    )
    flown = make.path(box, straight([0, 0, 0], [0.299, 0, 0]))

    def verdict(*overrides: MarginOverride):
        return only(certificate(make.scenario([box], [wall], MarginPolicy(0.1, overrides)), flown))

    assert verdict().verdict == "violated"
    late = MarginOverride("craft", "wall", 0.005, (9.5, 10.0))
    assert verdict(late).verdict == "certified"
    assert verdict(late).required_m in (0.005, 0.1)
    # The gap is 0.1 m at t = 9.699 s: a window that opens later comes too late.
    assert verdict(MarginOverride("craft", "wall", 0.005, (9.8, 10.0))).verdict == "violated"
    assert verdict(MarginOverride("craft", "wall", 0.02, (9.5, 10.0))).verdict == "violated"
    assert verdict(MarginOverride("craft", "wall", None, (9.5, 10.0))).verdict == "certified"
    touching = verdict(MarginOverride("craft", "wall", None))
    assert (touching.verdict, touching.lower_bound_m, touching.required_m) == (
        "exempt",
        np.inf,
        None,
    )


def test_the_bound_reported_is_where_the_default_margin_holds(make) -> None:
    box, wall = (
        make.vehicle(Box(np.ones(3))),
        make.structure(Box(np.ones(3)), at=[make.placed([5, 0, 0])]),
    )
    flown = make.path(box, straight([0, 0, 0], [0.299, 0, 0]))
    policy = MarginPolicy(0.1, (MarginOverride("craft", "wall", 0.005, (9.5, 10.0)),))
    found = certificate(make.scenario([box], [wall], policy), flown)
    assert only(found).lower_bound_m < 0.1 <= found.bound_where_required(0.1)


def test_parts_far_from_their_origins(make) -> None:
    """The same motion, the box placed with an offset or in its shape's own frame."""
    wall = make.structure(Cylinder(1.0, 2.0, "z"))
    turn = make.turn_about([0, 0, 1], lambda t: 0.3 * t)
    bounds = []
    for offset in (0.0, 3.0):
        part = make.placed([offset, 0, 0])
        own = make.vehicle(Box(np.array([0.5, 0.5, 0.5])), at=[part])

        def position(t, offset=offset):
            back = quaternion.rotation_matrix(turn(t)) @ np.array([-offset, 0, 0])
            return np.array([0.0, 2.5, 0.0]) + back

        bounds.append(
            only(certificate(make.scenario([own], [wall]), make.path(own, position, turn)))
        )
    assert [b.verdict for b in bounds] == ["certified"] * 2
    assert bounds[0].lower_bound_m == pytest.approx(bounds[1].lower_bound_m, abs=0.05)


def test_in_the_plane(make) -> None:
    disc = make.vehicle(Box(np.ones(2)), model=PointMass(1.0, 2))
    wall = make.structure(Box(np.array([2.0, 1.0])), at=[Pose(np.array([0.0, 2.2]), np.eye(2))])

    def states(t):
        return np.stack([t - 5.0, 0.0 * t, 1.0 + 0.0 * t, 0.0 * t], axis=1)

    flown = make.trajectory(disc, states)
    assert only(certificate(make.scenario([disc], [wall], 0.199), flown)).verdict == "certified"
    assert only(certificate(make.scenario([disc], [wall], 0.201), flown)).verdict == "violated"


def test_an_attitude_that_is_not_bounded_proves_nothing(make) -> None:
    box, wall = (
        make.vehicle(Box(np.ones(3))),
        make.structure(Box(np.ones(3)), at=[make.placed([9, 0, 0])]),
    )

    def shrinking(t):
        return (t - 5.0)[:, None] * np.array([[1.0, 0.0, 0.0, 0.0]])

    flown = make.path(box, straight([0, 0, 0], [0, 0, 0]), shrinking)
    found = certificate(make.scenario([box], [wall]), flown)
    assert only(found).verdict == "undecided"
    assert found.bound_where_required(0.1) == -np.inf
    assert found.notes


def test_the_budget_ends_in_undecided(make) -> None:
    box, wall = make.vehicle(Box(np.ones(3))), make.structure(Box(np.ones(3)))
    flown = make.path(box, straight([-5, 2.1, 0], [1, 0, 0]))
    settings = CertificateSettings(undecided_m=0.0, max_intervals=20)
    found = certificate(make.scenario([box], [wall], 0.1), flown, settings=settings)
    assert only(found).verdict == "undecided"


def test_the_closest_pair_is_named_even_far_away(make) -> None:
    ball = make.vehicle(Sphere(0.5))
    far = make.structure(Sphere(1.0), name="far", at=[make.placed([0, 30, 0])])
    near = make.structure(Sphere(1.0), name="near", at=[make.placed([0, -20, 0])])
    flown = make.path(ball, straight([-5, 0, 0], [1, 0, 0]))
    name, time, distance = certificate(make.scenario([ball], [far, near]), flown).closest
    assert name == "craft.p0|near.p0"
    assert distance == pytest.approx(18.5, abs=0.05)
    assert time == pytest.approx(5.0, abs=0.6)
