"""Between 10 to 40 mixed shapes with a vehicle that is not convex."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.tight3d._crafts import NOT_CONVEX, craft
from benchmarks.tight3d._motion import ORIGIN, At, Leg, through, witness
from benchmarks.tight3d._scene import (
    Case,
    Craft,
    Document,
    Flight,
    case,
    part,
    plain,
    random_frame,
    random_turn,
    rod,
    structure,
)
from berthing.geometry import quaternion
from berthing.refine.sampling import sample_clearance
from berthing.scenario.files import from_document
from support.documents import box

KEPT_M = (0.03, 1.0)
"""Room that a shape leaves the witness beyond the margin: those nearer are in the way, those
further are of no interest."""

SAMPLES = 600
"""Of the witness, which moves by less than ``KEPT_M[0]`` meanwhile."""

NEAR_M = 2.0
BATCH = 40


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """A motion through three places, and whatever leaves it room."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    own = craft(rng, rng.uniform([1.5, 1.0, 0.8], [3.0, 2.2, 1.8]), NOT_CONVEX)
    legs, count = _legs(rng), int(rng.integers(10, 41))
    frame = random_frame(rng)
    shapes: list[Document] = []
    while len(shapes) < count:
        drawn = [_anywhere(rng, own, legs) for _ in range(BATCH)]
        shapes += _kept(margin, own, legs, drawn)
    structures = [
        structure(f"debris-{i:02d}", [part("core", shape)], at.seen_from(frame))
        for i, (shape, at) in enumerate(shapes[:count])
    ]
    return case(
        family, seed, rng, margin, frame, [Flight(own, legs)], structures,
        f"Between {count} shapes, each of which leaves a known motion some "
        "centimetres or more beyond the margin.",
    )  # fmt: skip


def _legs(rng: np.random.Generator) -> list[Leg]:
    x = np.linspace(0.0, rng.uniform(7.0, 11.0), 4)
    poses = [At(np.array([x[0], *rng.uniform(-1.5, 1.5, 2)]), random_turn(rng))]
    for along in x[1:]:
        turn = quaternion.multiply(poses[-1].q, random_turn(rng, 1.2))
        poses.append(At(np.array([along, *rng.uniform(-1.5, 1.5, 2)]), np.asarray(turn)))
    return through(*poses)


def _anywhere(rng: np.random.Generator, own: Craft, legs: list[Leg]) -> tuple[Document, At]:
    """A shape about as far from the way as the vehicle is large."""
    leg = legs[int(rng.integers(len(legs)))]
    (r,), _ = leg.poses(rng.uniform(0.0, 1.0, 1))
    size = float(rng.uniform(0.2, 1.2))
    away = rng.normal(size=3)
    away *= (own.radius * rng.uniform(0.2, 1.2) + size) / np.linalg.norm(away)
    kinds = list(SHAPES)
    shape = SHAPES[kinds[int(rng.integers(len(kinds)))]](rng, size)
    return shape, At(r + away, random_turn(rng))


def _kept(
    margin: float, own: Craft, legs: list[Leg], drawn: list[tuple[Document, At]]
) -> list[tuple[Document, At]]:
    """Those of the shapes drawn that leave the motion room, and not too much."""
    structures = [structure(f"s{i}", [part("core", s)], at) for i, (s, at) in enumerate(drawn)]
    whole = case("draft", 0, np.random.default_rng(0), margin, ORIGIN, [Flight(own, legs)], [], "")
    scenario = from_document(plain({**whole.document, "structures": structures}), "draft")
    (phase,) = scenario.phases
    (trajectory,) = witness(scenario, whole.legs).phases
    pairs, times = scenario.pairs(phase), np.linspace(0.0, trajectory.t1_s, SAMPLES)
    found = sample_clearance(scenario, pairs, trajectory, times, NEAR_M)
    room = np.full(len(drawn), np.inf)
    for pair, distances in zip(pairs, found.distances_m, strict=True):
        i = int(pair.owner_b.name[1:])
        room[i] = min(room[i], float(np.min(distances)) - margin)
    return [own for own, r in zip(drawn, room, strict=True) if KEPT_M[0] <= r <= KEPT_M[1]]


def _box(rng: np.random.Generator, size: float) -> Document:
    return box(*(2.0 * size * rng.uniform(0.2, 0.8, 3)))


def _ball(rng: np.random.Generator, size: float) -> Document:
    return {"type": "sphere", "radius_m": size * rng.uniform(0.4, 1.0)}


def _egg(rng: np.random.Generator, size: float) -> Document:
    return {"type": "ellipsoid", "semi_axes_m": size * rng.uniform(0.3, 1.0, 3)}


def _rod(kind: str) -> Callable[[np.random.Generator, float], Document]:
    return lambda rng, size: rod(
        size * rng.uniform(0.1, 0.5), size * rng.uniform(0.8, 2.0), kind=kind
    )


def _stone(rng: np.random.Generator, size: float) -> Document:
    points = rng.normal(size=(int(rng.integers(6, 13)), 3))
    points *= size / np.linalg.norm(points, axis=1)[:, None]
    return {"type": "polytope", "vertices_m": points}


SHAPES: dict[str, Callable[[np.random.Generator, float], Document]] = {
    "box": _box, "sphere": _ball, "ellipsoid": _egg, "polytope": _stone,
    "cylinder": _rod("cylinder"), "capsule": _rod("capsule"), "cone": _rod("cone"),
}  # fmt: skip
