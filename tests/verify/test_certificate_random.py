"""Random motions of random bodies: bounds never exceed distances, verdicts match them."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from berthing.clearance.separation import PairQuery
from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.motion import ConstantSpin
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.certificate import Certificate, certify


def certificate(whole: Scenario, flown) -> Certificate:
    return certify(whole, whole.phases[0], PhaseTrajectory("main", (flown,)))


def only(found: Certificate):
    (verdict,) = found.verdicts
    return verdict


def random_case(make, rng: np.random.Generator):
    """Two tumbling bodies of several shapes and a law of motion for the second."""
    shapes = [
        Box(rng.uniform(0.3, 1.5, 3)),
        Sphere(rng.uniform(0.3, 1.0)),
        Cylinder(rng.uniform(0.2, 1.0), rng.uniform(0.3, 2.0), "xyz"[rng.integers(3)]),
    ]

    def pose() -> Pose:
        return make.placed(rng.normal(size=3), quaternion.normalise(rng.normal(size=4)))

    own = make.vehicle(shapes[rng.integers(3)], at=[pose()])
    motion = ConstantSpin(
        pose(), rng.normal(size=3), rng.uniform(-0.4, 0.4), 0.05 * rng.normal(size=3)
    )
    other = make.structure(shapes[rng.integers(3)], motion=motion)
    amplitude, pace = 3.0 * rng.normal(size=(3, 3)), rng.uniform(0.1, 0.6, (3, 1))
    axis, swing = rng.normal(size=3), rng.uniform(0.0, 3.0)
    flown = make.path(
        own, lambda t: np.sin(pace * t).T @ amplitude + np.array([0.0, 0.0, 2.5]),
        make.turn_about(axis, lambda t: swing * np.sin(0.4 * t)), degree=6,
    )  # fmt: skip
    return own, other, flown


@pytest.mark.parametrize("seed", range(12))
def test_no_leaf_claims_more_than_the_distance(make, seed: int) -> None:
    own, other, flown = random_case(make, np.random.default_rng(seed))
    t = np.linspace(0.0, 10.0, 1501)
    a, b = own.body.parts[0], other.body.parts[0]
    distance, _, _ = PairQuery(a.shape, b.shape).batch(
        own.model.pose(flown.state(t)).compose(a.placement),
        other.motion.pose(t).compose(b.placement),
    )
    least = float(np.min(distance))
    for margin in {max(0.0, least + shift) for shift in (-0.3, -1e-3, -1e-5, 1e-4)}:
        found = certificate(make.scenario([own], [other], margin), flown)
        leaves = found.evidence[0].leaves
        leaves = leaves.take(np.argsort(leaves.t0))
        assert leaves.t0[0] == 0.0
        assert leaves.t1[-1] == 10.0
        np.testing.assert_array_equal(leaves.t0[1:], leaves.t1[:-1])
        at = np.clip(np.searchsorted(leaves.t0, t, side="right") - 1, 0, None)
        assert np.all(leaves.bound[at] <= distance + 1e-8)
        if least < margin - 1e-8:
            assert only(found).verdict == "violated"


@pytest.mark.slow
def test_no_false_certificate_of_random_motions(make) -> None:
    """Margins a micrometre above and below the least distance that a fine search finds."""
    wrong, undecided, cases = 0, 0, 0
    for seed in range(1000, 1150):
        own, other, flown = random_case(make, np.random.default_rng(seed))
        a, b = own.body.parts[0], other.body.parts[0]
        query = PairQuery(a.shape, b.shape)

        def distance(t, own=own, other=other, flown=flown, query=query, a=a, b=b):
            t = np.atleast_1d(t)
            return query.batch(
                own.model.pose(flown.state(t)).compose(a.placement),
                other.motion.pose(t).compose(b.placement),
            )[0]

        t = np.linspace(0.0, 10.0, 2001)
        samples = distance(t)
        i = int(np.argmin(samples))
        refined = minimize_scalar(
            lambda s, distance=distance: float(distance(s)[0]),
            bounds=(t[max(i - 1, 0)], t[min(i + 1, 2000)]),
            method="bounded",
            options={"xatol": 1e-10},
        )
        least = min(float(refined.fun), float(samples[i]))
        if least < 0.01:
            continue
        cases += 1
        below = only(certificate(make.scenario([own], [other], least - 1e-4), flown))
        above = only(certificate(make.scenario([own], [other], least + 1e-6), flown))
        undecided += below.verdict != "certified"
        wrong += above.verdict == "certified"
    assert cases > 50
    assert (wrong, undecided) == (0, 0)
