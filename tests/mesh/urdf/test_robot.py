"""Robot descriptions: links in their places, masses, and what is wrong with a file."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.mesh.urdf.parts import part_name, robot_parts
from berthing.mesh.urdf.robot import read_robot
from berthing.mesh.urdf.xml import rpy_matrix
from support import solids

ARM = """
<robot name="arm">
  <link name="base">
    <inertial><mass value="10"/><inertia ixx="1" iyy="2" izz="2.5"/></inertial>
    <collision><geometry><box size="1 2 3"/></geometry></collision>
    <collision><origin xyz="0 0 2"/><geometry><sphere radius="0.5"/></geometry></collision>
  </link>
  <link name="boom">
    <inertial>
      <origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>
      <mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.15"/>
    </inertial>
    <collision>
      <origin xyz="0 0 1"/><geometry><cylinder radius="0.1" length="2"/></geometry>
    </collision>
  </link>
  <link name="tool">
    <visual><geometry><mesh filename="l.obj" scale="0.001 0.001 0.001"/></geometry></visual>
  </link>
  <joint name="shoulder" type="revolute">
    <origin xyz="0 0 3" rpy="0 0 0.5"/><parent link="base"/><child link="boom"/>
    <axis xyz="0 2 0"/><limit lower="-1" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="slide" type="prismatic">
    <origin xyz="0 0 2"/><parent link="boom"/><child link="tool"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="0.5" effort="1" velocity="1"/>
  </joint>
</robot>
"""


@pytest.fixture
def urdf(tmp_path):
    """Writes a description beside its mesh, texts replaced."""
    solids.write_obj(tmp_path / "l.obj", 1000 * solids.l_bracket())

    def write(*changes):
        text = ARM
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "arm.urdf"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def poses(path, **joints):
    return {name: shape.placement for name, shape in read_robot(path, joints).shapes}


def test_links_stand_where_joints_put_them(urdf):
    at = poses(urdf(), shoulder=0.7, slide=0.25)
    turn = rpy_matrix(np.array([0, 0, 0.5])) @ rpy_matrix(np.array([0, 0.7, 0]))
    np.testing.assert_allclose(at["boom"].rotation, turn, atol=1e-15)
    np.testing.assert_allclose(at["boom"].position, [0, 0, 3] + turn @ [0, 0, 1])
    np.testing.assert_allclose(at["tool"].position, [0, 0, 3] + turn @ [0.25, 0, 2])
    still = poses(urdf())
    np.testing.assert_allclose(still["tool"].position, [0, 0, 5])


def test_roll_pitch_and_yaw_turn_about_fixed_axes():
    r, p, y = 0.3, -0.5, 1.1
    axes = np.eye(3)
    turns = [
        quaternion.rotation_matrix(quaternion.from_axis_angle(axis, np.array(angle)))
        for axis, angle in zip(axes, (r, p, y), strict=True)
    ]
    wanted = turns[2] @ turns[1] @ turns[0]
    np.testing.assert_allclose(rpy_matrix(np.array([r, p, y])), wanted, atol=1e-15)


def test_masses_add_up_in_the_root_frame(urdf):
    mass = read_robot(urdf()).mass
    assert mass.mass_kg == 12.0
    turn = rpy_matrix(np.array([0, 0, 0.5]))
    np.testing.assert_allclose(mass.first_moment_kg_m, [0, 0, 2 * 4])
    spun = turn @ np.diag([0.2, 0.1, 0.15]) @ turn.T
    wanted = np.diag([1, 2, 2.5]) + spun + 2 * 16 * np.diag([1, 1, 0])
    np.testing.assert_allclose(mass.inertia_kg_m2, wanted, atol=1e-12)


def test_a_joint_may_follow_another(urdf):
    mimic = '<mimic joint="shoulder" multiplier="0.5" offset="0.1"/><axis xyz="1 0 0"/>'
    path = urdf(('<axis xyz="1 0 0"/>', mimic))
    at = poses(path, shoulder=0.4)
    np.testing.assert_allclose(
        at["tool"].position - poses(urdf(), shoulder=0.4)["tool"].position,
        at["tool"].rotation @ [0.3, 0, 0],
    )


def test_parts_are_those_of_a_scenario(urdf, tmp_path):
    parts = robot_parts(read_robot(urdf()), tmp_path / "elsewhere")
    assert [part["name"] for part in parts] == ["base", "base-2", "boom", "tool"]
    assert parts[0]["shape"] == {"type": "box", "size_m": [1, 2, 3]}
    assert parts[2]["shape"]["axis"] == "z"
    assert parts[3]["mesh"] == "../l.obj"
    assert parts[3]["certificate"]["volume_m3"] == pytest.approx(0.00768)


def test_a_link_without_masses_weighs_nothing(urdf):
    assert read_robot(urdf(('<mass value="10"/>', '<mass value="0"/>'))).mass.mass_kg == 2.0
    bare = [(f'<mass value="{m}"/>', '<mass value="0"/>') for m in (10, 2)]
    assert read_robot(urdf(*bare)).mass is None


@pytest.mark.parametrize(
    ("text", "name"), [("a b/c", "a-b-c"), ("_hand", "hand"), ("--", "part"), ("é", "part")]
)
def test_names_are_made_fit(text, name):
    assert part_name(text) == name


@pytest.mark.parametrize("layout", ["package/meshes/l.obj", "meshes/l.obj"])
def test_packages_are_found_around_the_file(tmp_path, layout):
    home = tmp_path / "robots" / "package"
    (home / "urdf").mkdir(parents=True)
    mesh = tmp_path / "robots" / layout if layout.startswith("package") else home / layout
    mesh.parent.mkdir(exist_ok=True)
    solids.write_obj(mesh, solids.l_bracket())
    path = home / "urdf" / "arm.urdf"
    path.write_text(ARM.replace("l.obj", "package://package/meshes/l.obj"), encoding="utf-8")
    (_, shape) = read_robot(path).shapes[-1]
    assert shape.mesh.samefile(mesh)


BAD = {
    "not XML": (("<link", "<<link"), "not well-formed XML"),
    "not a robot": (("robot", "world"), "begins with <world>"),
    "mesh": (("l.obj", "absent.obj"), "mesh that is missing: 'absent.obj'"),
    "package": (("l.obj", "package://x/l2.obj"), "missing: 'package://x/l2.obj'"),
    "scale": (('scale="0.001 0.001 0.001"', 'scale="0 1 1"'), "scale of zero"),
    "size": (('size="1 2 3"', 'size="1 2"'), "3 finite numbers"),
    "negative": (('size="1 2 3"', 'size="1 -2 3"'), "above 0"),
    "radius": (('radius="0.5"', 'radius="0"'), "above 0"),
    "word": (('radius="0.5"', 'radius="half"'), "1 finite number"),
    "lacks": (('<sphere radius="0.5"/>', "<sphere/>"), "lacks 'radius'"),
    "shape": (('<sphere radius="0.5"/>', "<capsule/>"), "holds <capsule>"),
    "no shape": (('<geometry><sphere radius="0.5"/></geometry>', ""), "lacks <geometry>"),
    "kind": (("prismatic", "floating"), "type 'floating'"),
    "no link": (('<child link="tool"/>', '<child link="tol"/>'), "names no link: 'tol'"),
    "two parents": (('<child link="tool"/>', '<child link="boom"/>'), "two parents"),
    "circle": (('<parent link="base"/>', '<parent link="tool"/>'), "circle"),
    "axis": (('<axis xyz="0 2 0"/>', '<axis xyz="0 0 0"/>'), "length zero"),
    "mass": (('<mass value="10"/>', '<mass value="-1"/>'), "mass of -1 kg"),
    "two roots": (('name="boom"', 'name="other"'), "names no link"),
}


@pytest.mark.parametrize("case", BAD)
def test_a_bad_description_is_one_clear_message(urdf, case):
    change, says = BAD[case]
    path = urdf(change)
    with pytest.raises(InputError) as caught:
        read_robot(path)
    assert says in str(caught.value)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize(
    ("joints", "says"),
    [
        ({"elbow": 1.0}, "no joint 'elbow' to set.*one of: shoulder, slide"),
        ({"shoulder": 3.0}, "at 3.*-1 to 2"),
    ],
)
def test_joint_positions_are_checked(urdf, joints, says):
    with pytest.raises(InputError, match=says):
        read_robot(urdf(), joints)


def test_a_missing_file_and_one_without_shapes(tmp_path):
    with pytest.raises(InputError, match="does not exist"):
        read_robot(tmp_path / "absent.urdf")
    (tmp_path / "empty.urdf").write_text('<robot name="e"><link name="l"/></robot>')
    with pytest.raises(InputError, match="no link with a shape"):
        read_robot(tmp_path / "empty.urdf")
