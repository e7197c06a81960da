"""The meshes of the examples are the solids that the tests know, in millimetres."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from berthing.mesh.from_file import solid_of
from support import solids

MESHES = Path(__file__).parents[2] / "examples" / "meshes"
# The files have four decimals of a millimetre.
ROUNDED_M = 1e-7


def truss_bay():
    """A cube of 1.2 m with 12 struts."""
    nodes = 1.2 * np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    struts = [
        (i, j) for i, j in combinations(range(8), 2) if np.count_nonzero(nodes[i] - nodes[j]) == 1
    ]
    return solids.wire(nodes, struts, 0.03)


SOURCES = {
    "l_bracket": solids.l_bracket,
    "c_bracket": solids.c_bracket,
    "truss": solids.truss,
    "truss_bay": truss_bay,
}


@pytest.mark.parametrize("name", SOURCES)
def test_the_file_is_the_solid(name: str) -> None:
    found, _ = solid_of(MESHES / f"{name}.obj", units="mm")
    wanted = solids.solid(SOURCES[name]())
    assert len(found.triangles) == len(wanted.triangles)
    assert found.volume == pytest.approx(wanted.volume, rel=1e-4)
    for a, b in ((found, wanted), (wanted, found)):
        apart = np.linalg.norm(a.vertices[:, None] - b.vertices, axis=2)
        assert np.max(np.min(apart, axis=1)) <= ROUNDED_M


def test_no_other_meshes_lie_there() -> None:
    assert {path.stem for path in MESHES.glob("*.obj")} == set(SOURCES)
