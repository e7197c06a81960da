from pathlib import Path

import pytest

from berthing.mesh import cache


@pytest.fixture(scope="session")
def pieces_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def own_cache(pieces_cache: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Nothing of the user's cache is read or written; the tests share one."""
    monkeypatch.setenv(cache.FOLDER_VARIABLE, str(pieces_cache))
    return pieces_cache
