"""A probe as URDF, and a folder in which meshes and robots lie."""

from __future__ import annotations

from pathlib import Path

import pytest

from berthing.mesh import cache
from support import solids

PROBE = """
<robot name="probe">
  <link name="bus">
    <inertial><mass value="8"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
    <collision><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <link name="hand"><collision><geometry><mesh filename="{hand}"/></geometry></collision></link>
  <joint name="wrist" type="continuous">
    <origin xyz="1 0 0"/><parent link="bus"/><child link="hand"/><axis xyz="0 0 1"/>
  </joint>
</robot>
"""


def write_probe(
    folder: Path, hand: str, factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bracket ``l.obj`` and ``probe.urdf`` with this hand; pieces are kept for the whole run."""
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(factory.getbasetemp() / "pieces-cache"))
    solids.write_obj(folder / "l.obj", solids.l_bracket())
    (folder / "probe.urdf").write_text(PROBE.format(hand=hand), encoding="utf-8")
