"""The builders of ``support.hand_made``, as one fixture."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.scenario.attitude import FixedAttitude
from support import hand_made


@pytest.fixture(scope="session")
def make() -> SimpleNamespace:
    """The builders."""
    own = hand_made
    return SimpleNamespace(
        placed=own.placed, body=own.body, vehicle=own.vehicle, structure=own.structure,
        scenario=own.scenario, trajectory=own.trajectory, path=own.path,
        turn_about=own.turn_about, glide=own.glide, glide_nodes=own.glide_nodes, plan=own.plan,
        document_plan=own.document_plan, write_folder=own.write_folder,
        certify_folder=own.certify_folder, box=lambda *half: Box(np.array(half)),
        document=own.DOCUMENT, rigid_body=own.rigid_body, attitude=FixedAttitude,
    )  # fmt: skip
