import json
from dataclasses import replace

import numpy as np
import pytest

from berthing.clearance.separation import separation
from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.report.offline.content import Content
from berthing.report.offline.packing import Packing
from berthing.report.offline.separations import DRAWN, MOST_STEPS
from berthing.report.offline.shapes import packed_body
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.motion import Fixed
from berthing.scenario.structure import Structure
from berthing.verify.claims import Claims, PairClaim, PhaseClaims
from support import synthetic

TWO = (synthetic.spacecraft(), synthetic.spacecraft("tug", (0.0, 6.0, 2.0)))


@pytest.fixture
def page(unpacked):
    """The first plan of a page, and a reader of its arrays."""

    def make(*scenarios):
        content = Content()
        for of in scenarios:
            content.add(
                of.name, of, synthetic.plan(of), synthetic.verification(of), synthetic.claims(of)
            )
        whole = json.loads(json.dumps(content.to_json(), allow_nan=False))
        return whole, lambda ref: unpacked(ref, whole["buffers"])

    return make


def test_vehicles_move_as_the_plan_says(page):
    of = synthetic.scenario(TWO)
    whole, read = page(of)
    (phase,) = synthetic.plan(of).phases
    for track, own in zip(whole["plans"][0]["tracks"], phase.vehicles, strict=True):
        assert track["vehicle"] == own.vehicle
        times = read(track["dense"]["t"])
        state, control = own.state(times), own.control(times)
        np.testing.assert_allclose(read(track["dense"]["p"]), state[:, :3], atol=1e-5)
        np.testing.assert_allclose(read(track["dense"]["v"]), state[:, 3:6], atol=1e-5)
        turned = quaternion.angle_between(read(track["dense"]["q"]), state[:, 6:10])
        assert np.max(turned) < 1e-3
        force, torque = map(read, track["dense"]["u"])
        np.testing.assert_allclose(np.hstack([force, torque]), control, atol=1e-7)
        assert [p["unit"] for p in track["controls"]] == ["N", "N·m"]
        assert track["controls"][0]["upper"] == [0.02] * 3
        assert len(read(track["nodes"]["t"])) == 41


def test_no_limit_is_null(page):
    whole, _ = page(synthetic.planar_scenario())
    (panel,) = whole["plans"][0]["tracks"][0]["controls"]
    assert (panel["lower"], panel["upper"]) == ([-1.0, -1.0], [None, None])


def test_structures_at_rest_have_one_pose_and_others_many(page):
    whole, read = page(synthetic.scenario())
    block, spinner = whole["plans"][0]["structures"]
    assert read(block["p"]).shape == (1, 3)
    times, rotation = read(spinner["t"]), read(spinner["q"])
    assert len(times) > 400
    expected = synthetic.spinner().motion.pose(times).rotation
    np.testing.assert_allclose(quaternion.rotation_matrix(rotation), expected, atol=1e-6)


def test_the_closest_pair_is_the_closest_with_its_own_points(page):
    of = synthetic.scenario()
    whole, read = page(of)
    (found,) = whole["plans"][0]["separations"]
    times, closest = read(found["t"]), found["closest"]
    (own,) = synthetic.plan(of).phases[0].vehicles
    vehicle = of.phases[0].vehicles[0]
    for k in (0, 150, 300, len(times) - 1):
        t = times[k : k + 1]
        pose = vehicle.model.pose(own.state(t))[0]
        distances = {
            p.name: separation(
                p.part_a.shape, pose, p.part_b.shape,
                p.owner_b.motion.pose(t)[0].compose(p.part_b.placement),
            )
            for p in of.pairs(of.phases[0])
        }  # fmt: skip
        name = min(distances, key=lambda n: distances[n].distance)
        assert closest["names"][read(closest["pair"])[k]] == name
        distance = distances[name].distance
        assert read(closest["d"])[k] == pytest.approx(distance, abs=1e-5)
        gap = read(closest["b"])[k] - read(closest["a"])[k]
        np.testing.assert_allclose(gap, distance * read(closest["n"])[k], atol=1e-4)


def test_a_pair_that_may_touch_is_not_the_closest_while_others_have_a_margin(page):
    of = synthetic.scenario()
    free = MarginOverride("spacecraft", "block", None, (60.0, 90.0))
    whole, read = page(replace(of, margins=MarginPolicy(0.1, (free,))))
    (found,) = whole["plans"][0]["separations"]
    names = np.array(found["closest"]["names"])[read(found["closest"]["pair"])]
    times = read(found["t"])
    exempt = (times > 60.0) & (times < 90.0)
    block = names == "spacecraft.hull|block.core"
    assert not np.any(block[exempt])
    assert np.any(block[~exempt])


def test_what_is_proven_lies_below_the_curve(page):
    whole, read = page(synthetic.scenario())
    (found,) = whole["plans"][0]["separations"]
    times = read(found["t"])
    steps = 0
    for pair in found["pairs"]:
        distance = read(pair["d"])
        for t0, t1, bound in read(pair["proven"]):
            inside = (times >= t0) & (times <= t1)
            assert np.all(distance[inside] >= bound - 1e-6)
            steps += 1
    assert steps > 3


def test_of_many_pairs_the_nearest_are_drawn_and_the_rest_counted(page):
    balls = [
        Part(f"ball{i}", Sphere(0.1), Pose(np.array([0.0, 0.0, 3.0 + i]), np.eye(3)))
        for i in range(DRAWN + 5)
    ]
    row = Structure("row", Body(tuple(balls)), Fixed(Pose(np.array([5.0, -6.0, 0.0]), np.eye(3))))
    whole, read = page(synthetic.scenario(structures=(row,)))
    (found,) = whole["plans"][0]["separations"]
    assert len(found["pairs"]) == DRAWN
    assert found["more"] == 5
    least = [read(pair["d"]).min() for pair in found["pairs"]]
    assert least == sorted(least)
    names = {pair["name"] for pair in found["pairs"]}
    assert f"spacecraft.hull|row.ball{DRAWN + 4}" not in names
    assert "spacecraft.hull|row.ball0" in names


def test_where_nothing_is_claimed_nothing_is_proven(unpacked):
    of = synthetic.scenario()
    content = Content()
    content.add("x", of, synthetic.plan(of), synthetic.verification(of), Claims("", ()))
    whole = content.to_json()
    for pair in whole["plans"][0]["separations"][0]["pairs"]:
        assert unpacked(pair["proven"], whole["buffers"]).shape == (0, 3)


def test_many_steps_are_joined_below_all_of_them(unpacked):
    t = np.linspace(0.0, 150.0, 5 * MOST_STEPS)
    bound = 1.0 + np.sin(t)
    claim = PairClaim(
        "spacecraft.hull|block.core", t[:-1], t[1:], bound[:-1], np.zeros((len(t) - 1, 2, 3))
    )
    of, content = synthetic.scenario(), Content()
    claims = Claims("", (PhaseClaims("main", {}, (claim,)),))
    content.add("x", of, synthetic.plan(of), synthetic.verification(of), claims)
    whole = content.to_json()
    pairs = {p["name"]: p for p in whole["plans"][0]["separations"][0]["pairs"]}
    rows = unpacked(pairs[claim.pair]["proven"], whole["buffers"])
    assert len(rows) == MOST_STEPS
    np.testing.assert_array_equal(rows[1:, 0], rows[:-1, 1])
    for t0, t1, joined in rows[::50]:
        assert joined == bound[:-1][(t[:-1] >= t0) & (t[1:] <= t1)].min()


def test_plans_compared_share_their_arrays(page):
    one, _ = page(synthetic.scenario())
    both, _ = page(synthetic.scenario(), synthetic.scenario(name="other"))
    assert len(both["buffers"]) == len(one["buffers"])


def test_a_body_is_one_mesh_with_its_creases():
    packing = Packing()
    body = Body(
        (
            Part("box", Box(np.array([1.0, 2.0, 3.0])), Pose(np.array([5.0, 0, 0]), np.eye(3))),
            Part("ball", Sphere(0.5), Pose.identity(3)),
        )
    )
    packed = packed_body(body, packing)
    assert packed["e"]["n"] == [12, 2]
    assert packed["i"]["n"][0] == 12 + len(Sphere(0.5).mesh().triangles)


def test_parts_are_where_they_are_placed(unpacked):
    packing = Packing()
    place = Pose(np.array([5.0, 0.0]), Pose.planar(np.zeros(2), np.pi / 2).rotation)
    packed = packed_body(Body((Part("flat", Box(np.array([1.0, 2.0])), place),)), packing)
    points = unpacked(packed["v"], packing.buffers)
    np.testing.assert_allclose(points.min(axis=0), [3.0, -1.0, 0.0], atol=1e-6)
    np.testing.assert_allclose(points.max(axis=0), [7.0, 1.0, 0.0], atol=1e-6)
    assert packed["e"]["n"] == [4, 2]
