"""What tests of several stages begin with."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from support import hand_made


@pytest.fixture(scope="session")
def hand_made_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The plan folder of ``support.hand_made``; not to be changed."""
    path = tmp_path_factory.mktemp("hand-made")
    hand_made.write_folder(path, *hand_made.document_plan())
    return path


@pytest.fixture
def folder(hand_made_folder: Path, tmp_path: Path) -> Path:
    """A copy of it, to be spoilt: a sound plan of a body that turns on its way past a block."""
    return Path(shutil.copytree(hand_made_folder, tmp_path / "plan"))
