"""What encloses a solid, and one clear message for everything that does not."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.mesh import soundness
from berthing.mesh.boxes_tree import BoxTree
from berthing.mesh.crossing import first_crossing
from berthing.mesh.solid import Surface
from support import solids


def surface(corners):
    return Surface.joined("part.stl", "", np.asarray(corners, dtype=float))


def shrunk(corners, factor=0.2, centre=(0.03, 0.03, 0.1)):
    return (corners - centre) * factor + centre


L = solids.l_bracket()
INWARD = L[:, ::-1]


@pytest.mark.parametrize("make", [solids.l_bracket, solids.c_bracket, solids.torus, solids.tube])
def test_sound_surfaces_pass(make):
    assert solids.solid(make()).volume > 0.0


def test_volumes_are_right():
    assert solids.solid(solids.l_bracket()).volume == pytest.approx(0.00768)
    assert solids.solid(solids.box((1, 2, 3), (50, 60, 70))).volume == pytest.approx(6.0)


def test_a_truss_is_one_skin():
    assert len(solids.solid(solids.truss()).triangles) == 672


@pytest.mark.parametrize(
    ("corners", "says", "advice"),
    [
        (L[1:], "not closed: 3 edges", "Close Holes"),
        (np.concatenate([INWARD[:1], L[1:]]), "turned over: along 3 edges", "Recalculate Normals"),
        (INWARD, "inside out", "Invert Faces"),
        (L * [1, 1, 0], "encloses no volume", "thickness"),
        (L * [1, 1, 1e-12], "encloses no volume", "thickness"),
        (np.concatenate([L, solids.moved(L, 0.2, 0.03, 0.1)]), "crosses itself", "boolean union"),
        (np.concatenate([L, shrunk(L)]), "lies inside another solid", "hollows"),
        (np.concatenate([L, solids.moved(shrunk(INWARD), 1, 0, 0)]), "faces inward", "hollows"),
        (np.empty((0, 3, 3)), "no triangles", "closed"),
    ],
)
def test_what_is_no_solid_is_refused_with_advice(corners, says, advice):
    with pytest.raises(InputError) as caught:
        soundness.sound(surface(corners))
    message = str(caught.value)
    assert message.startswith("part.stl: ")
    assert says in message
    assert advice in message


def test_too_many_triangles_are_refused_with_a_way_to_have_fewer(monkeypatch):
    monkeypatch.setattr(soundness, "MOST_TRIANGLES", 19)
    with pytest.raises(InputError, match=r"has 20 triangles.*at most 19; .*Decimate"):
        soundness.sound(surface(L))


@pytest.mark.slow
def test_a_million_triangles_say_how_to_have_fewer():
    with pytest.raises(InputError, match=r"1,002,000 triangles.*Decimat"):
        soundness.sound(surface(solids.torus(1000, 501)))


def test_hollows_and_neighbours_are_no_fault():
    hollow = soundness.sound(surface(np.concatenate([L, shrunk(INWARD)])))
    assert hollow.volume == pytest.approx(solids.solid(L).volume * (1 - 0.2**3))
    apart = np.concatenate([L, solids.moved(L, 1, 0, 0)])
    touching = np.concatenate([L, solids.moved(L, 0, 0, 0.2)])
    for corners in (apart, touching):
        assert soundness.sound(surface(corners)).volume == pytest.approx(0.01536)


def test_minus_zero_is_zero():
    corners = solids.box((1, 1, 1), (0.5, 0.5, 0.5))
    corners[np.arange(0, 12, 2)] *= np.where(corners[np.arange(0, 12, 2)] == 0, -1.0, 1.0)
    assert len(surface(corners).vertices) == 8


def test_triangles_without_extent_are_left_out():
    point = np.tile(L[0, 0], (1, 3, 1))
    assert len(surface(np.concatenate([L, point])).triangles) == len(L)


def test_the_tree_finds_every_overlap():
    draw = np.random.default_rng(3)
    lower = draw.random((300, 3))
    upper = lower + 0.2 * draw.random((300, 3))
    upper[:50] = lower[:50]  # flat ones
    found = [
        pair for a, b in BoxTree.of(lower, upper).overlapping() for pair in zip(a, b, strict=True)
    ]
    meet = np.all((lower[:, None] <= upper) & (lower <= upper[:, None]), axis=2)
    wanted = {(i, j) for i, j in np.argwhere(meet) if i < j}
    assert {(min(p), max(p)) for p in found} == wanted
    assert len(found) == len(wanted)


def test_the_tree_works_in_batches(monkeypatch):
    monkeypatch.setattr("berthing.mesh.boxes_tree.BATCH", 7)
    test_the_tree_finds_every_overlap()


def test_crossings_are_counted_and_placed():
    assert first_crossing(surface(solids.torus())) is None
    count, place = first_crossing(surface(np.concatenate([L, solids.moved(L, 0.2, 0.03, 0.1)])))
    assert count > 0
    assert np.all((place >= [0.2, 0.03, 0.1]) & (place <= [0.4, 0.3, 0.2]))
