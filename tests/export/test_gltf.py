"""Read with pygltflib; accessors by hand, as the format's book has them."""

import numpy as np
import pygltflib
import pytest
from scipy.spatial.transform import Rotation

from support.plan_folder import Truth, assert_rotations

COLUMNS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
TYPES = {pygltflib.FLOAT: "<f4", pygltflib.UNSIGNED_INT: "<u4"}
# float32 rounds 10 m by 5e-7 m, and a component of a quaternion by 6e-8.
POSITION_M, ANGLE_RAD = 1e-6, 3e-7
# From glTF's axes, y up, to the plan's, z up.
UPRIGHT = Rotation.from_euler("x", 90, degrees=True)


def numbers(gltf, index):
    accessor = gltf.accessors[index]
    view = gltf.bufferViews[accessor.bufferView]
    width = COLUMNS[accessor.type]
    start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
    found = np.frombuffer(
        gltf.binary_blob(), TYPES[accessor.componentType], accessor.count * width, start
    ).reshape(-1, width)
    assert start % 4 == 0
    assert found.min(axis=0).tolist() == accessor.min
    assert found.max(axis=0).tolist() == accessor.max
    return found.astype(float)


def node(gltf, name):
    (index,) = [i for i, n in enumerate(gltf.nodes) if n.name == name]
    return index


def channel(gltf, name, path):
    """Times (k,) and rows of a node's animated property."""
    animation = gltf.animations[0]
    target = node(gltf, name)
    (found,) = [c for c in animation.channels if c.target.node == target and c.target.path == path]
    sampler = animation.samplers[found.sampler]
    t = numbers(gltf, sampler.input)[:, 0]
    assert np.all(np.diff(t) > 0)
    return t, numbers(gltf, sampler.output)


def check(path, truth, name="carrier"):
    gltf = pygltflib.GLTF2().load(str(path))
    t, r = channel(gltf, name, "translation")
    np.testing.assert_allclose(r, truth.position(t), rtol=0, atol=POSITION_M)
    t, q = channel(gltf, name, "rotation")
    assert_rotations(Rotation.from_quat(q), truth.rotation(t), ANGLE_RAD)
    return gltf


def test_the_animation_reads_back(to, truth):
    gltf = check(to("gltf"), truth)
    t, _ = channel(gltf, "carrier", "translation")
    assert (t[0], t[-1]) == (0.0, 100.0)
    assert len(t) >= 1001


def test_a_wrong_order_is_noticed(to, truth, wrong_order, monkeypatch):
    monkeypatch.setattr("berthing.export.gltf.scalar_last", wrong_order)
    with pytest.raises(AssertionError, match="off by"):
        check(to("gltf"), truth)


def test_z_is_up(to):
    gltf = pygltflib.GLTF2().load(str(to("gltf")))
    (root,) = gltf.scenes[gltf.scene].nodes
    turn = Rotation.from_quat(gltf.nodes[root].rotation)
    np.testing.assert_allclose(turn.apply([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0], atol=1e-12)
    assert (turn * UPRIGHT).magnitude() < 1e-12
    names = {gltf.nodes[child].name for child in gltf.nodes[root].children}
    assert names == {"carrier", "block", "spinner", "rock"}


def test_parts_have_their_true_shapes(to):
    gltf = pygltflib.GLTF2().load(str(to("gltf")))
    sizes = {}
    for owner in ("carrier", "block", "spinner", "rock"):
        (child,) = gltf.nodes[node(gltf, owner)].children
        primitive = gltf.meshes[gltf.nodes[child].mesh].primitives[0]
        vertices = numbers(gltf, primitive.attributes.POSITION)
        triangles = numbers(gltf, primitive.indices).reshape(-1, 3).astype(int)
        corners = vertices[triangles]
        # Six times the volume of the solid, positive where triangles face outwards.
        volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
        sizes[owner] = (vertices.max(axis=0) - vertices.min(axis=0), volume / 6)
    np.testing.assert_allclose(sizes["carrier"][0], [4, 2, 2], atol=1e-6)
    np.testing.assert_allclose(sizes["block"][1], 6.0, rtol=1e-6)
    np.testing.assert_allclose(sizes["rock"][1], 1 / 6, rtol=1e-6)
    np.testing.assert_allclose(sizes["spinner"][0], [0.6, 4.0, 0.6], atol=1e-6)


def test_structures_move_as_they_should(to):
    gltf = pygltflib.GLTF2().load(str(to("gltf")))
    t, q = channel(gltf, "spinner", "rotation")
    true = Rotation.from_rotvec(np.outer(0.01 * t, [0, 0, 1]))
    assert_rotations(Rotation.from_quat(q), true, ANGLE_RAD)
    still = gltf.nodes[node(gltf, "block")]
    assert still.translation == [40.0, 0.0, 0.0]
    moving = {channel.target.node for channel in gltf.animations[0].channels}
    assert moving == {node(gltf, "carrier"), node(gltf, "spinner")}


def test_every_vehicle_is_there(to, pair_folder):
    path = to("gltf", source=pair_folder)
    check(path, Truth(pair_folder, "scout"), "scout")
    gltf = pygltflib.GLTF2().load(str(path))
    t, r = channel(gltf, "puck", "translation")
    np.testing.assert_allclose(r, Truth(pair_folder, "puck").position(t), rtol=0, atol=POSITION_M)


def test_phases_show_their_own_parts(to, phases_folder):
    gltf = pygltflib.GLTF2().load(str(to("gltf", source=phases_folder)))
    shown = {}
    for phase in ("out", "on"):
        t, size = channel(gltf, f"carrier in {phase}", "scale")
        shown[phase] = dict(zip(t.tolist(), size[:, 0].tolist(), strict=True))
    assert shown == {"out": {0.0: 1.0, 100.0: 0.0}, "on": {0.0: 0.0, 100.0: 1.0}}
    t, _ = channel(gltf, "carrier", "translation")
    assert (t[0], t[-1]) == (0.0, 200.0)


def test_the_file_says_what_it_is(to):
    told = " ".join(pygltflib.GLTF2().load(str(to("gltf"))).asset.extras["berthing"])
    for said in ("scalar last", "EME2000", "UTC", "polynomials of time", "z to glTF's y"):
        assert said in told
