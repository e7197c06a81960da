"""Random smooth passes of one turning body by another, and how near they really come.

The truth shares nothing with the certificate but the polynomials and the numbers of the shapes:
poses come from NumPy's Chebyshev evaluation and a formula of this file, distances from coal asked
directly, at a fine grid and at ever finer ones about every dip. What is found is a pair of points,
one in each body by the bodies' own inequalities, so that a least distance found is never too small.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import coal
import numpy as np
from numpy.polynomial import chebyshev
from scipy.spatial import ConvexHull

from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.motion import ConstantSpin
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory, Segment, VehicleTrajectory
from support import hand_made

DURATION_S, SEGMENTS, DEGREE = 10.0, 8, 8
GRID = 401
# Dips of the grid that are followed down, those within this of the lowest sample (m).
DIP_M = 0.2
# The last step of the search about a dip (s).
FINEST_S = 1e-7
# Columns of the position and the quaternion in a rigid body's state.
COLUMNS = [0, 1, 2, 6, 7, 8, 9]
# A point in a body fulfils its inequalities to this (m).
INSIDE_M = 1e-9
QUERY = coal.DistanceRequest()
QUERY.gjk_tolerance, QUERY.gjk_max_iterations = 1e-10, 1000


@dataclass(frozen=True)
class Solid:
    """A convex body three times: for the package, for coal, and as an inequality.

    ``offset`` and ``turn`` place it in its owner's frame.
    """

    shape: ConvexSet
    geometry: coal.CollisionGeometry
    kind: str
    numbers: np.ndarray
    offset: np.ndarray
    turn: np.ndarray

    @property
    def reach(self) -> float:
        """How far a point of it may be from its frame's origin (m)."""
        a = self.numbers
        if self.kind == "polytope":
            return float(np.linalg.norm(self.shape.corners, axis=1).max())
        return float(np.linalg.norm(a))

    def beyond(self, x: np.ndarray) -> float:
        """By how many metres the point x (3,), in the shape's frame, is outside; ≤ 0 within."""
        a = self.numbers
        if self.kind == "sphere":
            return float(np.linalg.norm(x) - a[0])
        if self.kind == "ellipsoid":
            return float((np.linalg.norm(x / a) - 1.0) * a.max())
        if self.kind == "cylinder":
            return float(max(np.hypot(x[0], x[1]) - a[0], abs(x[2]) - a[1]))
        if self.kind == "box":
            return float(np.max(np.abs(x) - a))
        return float(np.max(a[:, :3] @ x + a[:, 3]))


def random_solid(rng: np.random.Generator) -> Solid:
    """Boxes, slender ones among them, balls, ellipsoids, cylinders and hulls of random points."""
    kind = ("box", "sphere", "ellipsoid", "cylinder", "polytope")[rng.integers(5)]
    half = rng.uniform(0.2, 1.5, 3) * (np.array([2.5, 0.1, 0.1]) if rng.random() < 0.2 else 1.0)
    offset, turn = rng.normal(size=3), rotations(rng.normal(size=(1, 4)))[0]
    if kind == "box":
        return Solid(Box(half), coal.Box(*(2.0 * half)), kind, half, offset, turn)
    if kind == "sphere":
        radius = half[:1]
        return Solid(Sphere(radius[0]), coal.Sphere(radius[0]), kind, radius, offset, turn)
    if kind == "ellipsoid":
        half = np.maximum(half, 0.1)
        return Solid(Ellipsoid(half), coal.Ellipsoid(*half), kind, half, offset, turn)
    if kind == "cylinder":
        radius, length = half[1], half[0]
        geometry = coal.Cylinder(radius, 2.0 * length)
        numbers = np.array([radius, length])
        return Solid(Cylinder(radius, length, "z"), geometry, kind, numbers, offset, turn)
    hull = ConvexHull(half * rng.normal(size=(rng.integers(5, 13), 3)))
    corners = hull.points[hull.vertices]
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for point in corners:
        points.append(point)
    place = {old: new for new, old in enumerate(hull.vertices)}
    for simplex, row in zip(hull.simplices, hull.equations, strict=True):
        i, j, k = (place[v] for v in simplex)
        outward = np.cross(corners[j] - corners[i], corners[k] - corners[i]) @ row[:3] > 0.0
        triangles.append(coal.Triangle(i, j, k) if outward else coal.Triangle(i, k, j))
    geometry = coal.Convex(points, triangles)
    shape = Polytope.from_vertices(corners)
    return Solid(shape, geometry, kind, hull.equations, offset, turn)


@dataclass(frozen=True)
class Mover:
    """A body with what the package and the truth each make of its motion."""

    solid: Solid
    owner: Vehicle | Structure
    flown: VehicleTrajectory | None

    def poses(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Positions (k, 3) and rotations (k, 3, 3) of the solid at times t (k,)."""
        if self.flown is None:
            law = self.owner.motion
            half = 0.5 * law.rate_rad_s * t[:, None]
            q = np.hstack([np.cos(half), np.sin(half) * law.axis_body])
            turned = law.pose0.rotation @ rotations(q)
            origin = law.pose0.position + np.outer(t, law.velocity_m_s)
        else:
            rows = np.empty((len(t), 7))
            for segment in self.flown.segments:
                here = (t >= segment.t0_s) & (t <= segment.t1_s)
                if here.any():
                    span = segment.t1_s - segment.t0_s
                    s = (2.0 * t[here] - segment.t0_s - segment.t1_s) / span
                    rows[here] = chebyshev.chebval(s, segment.state[:, COLUMNS]).T
            origin, turned = rows[:, :3], rotations(rows[:, 3:])
        return origin + turned @ self.solid.offset, turned @ self.solid.turn


def random_mover(rng: np.random.Generator, name: str, structure: bool) -> Mover:
    """A tumbling vehicle on a smooth path, or a structure that spins and drifts."""
    solid = random_solid(rng)
    at = [Pose(solid.offset, solid.turn)]
    if structure:
        pose = Pose(rng.normal(size=3), rotations(rng.normal(size=(1, 4)))[0])
        drift = 0.05 * rng.normal(size=3)
        law = ConstantSpin(pose, rng.normal(size=3), rng.uniform(-0.4, 0.4), drift)
        return Mover(solid, hand_made.structure(solid.shape, name=name, at=at, motion=law), None)
    own = hand_made.vehicle(solid.shape, name=name, at=at)
    sway, pace = 3.0 * rng.normal(size=(3, 3)), rng.uniform(0.1, 0.6, (3, 1))
    axis, swing = rng.normal(size=3), rng.uniform(0.0, 3.0)
    centre = np.array([0.0, 0.0, 2.5 if name == "craft" else -2.5])
    turning = hand_made.turn_about(axis, lambda t: swing * np.sin(0.4 * t))

    def states(t: np.ndarray) -> np.ndarray:
        x = np.zeros((len(t), 13))
        x[:, :3], x[:, 6:10] = np.sin(pace * t).T @ sway + centre, turning(t)
        return x

    edges = np.linspace(0.0, DURATION_S, SEGMENTS + 1)
    control = np.zeros((1, 6))
    pieces = tuple(
        Segment(float(a), float(b), hand_made.fitted(states, a, b, DEGREE), control)
        for a, b in pairwise(edges)
    )
    model = own.model
    flown = VehicleTrajectory(name, model.kind, model.state_names, model.control_names, pieces)
    return Mover(solid, own, flown)


@dataclass(frozen=True)
class Pass:
    """A vehicle past a second body, and the least distance found (m), between two real points."""

    craft: Mover
    other: Mover
    least_m: float

    @property
    def trajectory(self) -> PhaseTrajectory:
        flown = [m.flown for m in (self.craft, self.other) if m.flown is not None]
        return PhaseTrajectory("main", tuple(flown))


def random_pass(rng: np.random.Generator, nearest_m: float) -> Pass:
    """A pass that stays ``nearest_m`` apart at least; two vehicles in three cases of ten."""
    while True:
        craft = random_mover(rng, "craft", structure=False)
        other = random_mover(rng, "other", structure=rng.random() < 0.7)
        least = least_distance(craft, other, nearest_m)
        if least is not None:
            return Pass(craft, other, least)


def least_distance(a: Mover, b: Mover, nearest_m: float) -> float | None:
    """By the grid and the searches; None below ``nearest_m``, or where coal's points are none."""
    ask = Asked(a, b)
    t = np.linspace(0.0, DURATION_S, GRID)
    samples = ask.near(t)
    if np.min(samples) < nearest_m:
        return None
    padded = np.concatenate([[np.inf], samples, [np.inf]])
    low = samples <= np.min(samples) + DIP_M
    dips = np.flatnonzero(low & (samples <= padded[:-2]) & (samples <= padded[2:]))
    found = [_bottom(ask, float(t[i]), float(samples[i]), t[1] - t[0]) for i in dips]
    best, best_t = min(found)
    if best < nearest_m:
        return None
    return ask.witnessed(best_t)


def _bottom(ask: Asked, t: float, value: float, step: float) -> tuple[float, float]:
    """The least value about the time t, and when, by ever finer grids about the lowest sample."""
    while step > FINEST_S:
        around = np.clip(t + step * np.linspace(-1.0, 1.0, 9), 0.0, DURATION_S)
        values = ask.distances(around)
        i = int(np.argmin(values))
        if values[i] < value:
            t, value = float(around[i]), float(values[i])
        step *= 0.25
    return value, t


class Asked:
    """Distances of two movers by coal."""

    def __init__(self, a: Mover, b: Mover) -> None:
        self._movers = a, b
        self._result = coal.DistanceResult()
        self._placed = coal.Transform3s(), coal.Transform3s()

    def near(self, t: np.ndarray) -> np.ndarray:
        """Distances (k,) as far as they matter, else the gap between balls about the bodies."""
        poses = [mover.poses(t) for mover in self._movers]
        reach = sum(mover.solid.reach for mover in self._movers)
        out = np.linalg.norm(poses[1][0] - poses[0][0], axis=1) - reach
        least = np.inf
        for i in np.argsort(out):
            if out[i] > least + DIP_M:
                break
            out[i] = self._ask(*(poses[0][k][i] for k in (0, 1)), *(poses[1][k][i] for k in (0, 1)))
            least = min(least, out[i])
        return out

    def distances(self, t: np.ndarray) -> np.ndarray:
        """At the times t (k,)."""
        rows = zip(*self._movers[0].poses(t), *self._movers[1].poses(t), strict=True)
        return np.array([self._ask(*row) for row in rows])

    def _ask(self, r1: np.ndarray, R1: np.ndarray, r2: np.ndarray, R2: np.ndarray) -> float:
        one, two = self._placed
        one.setTransform(R1, r1)
        two.setTransform(R2, r2)
        self._result.clear()
        a, b = (mover.solid.geometry for mover in self._movers)
        return float(coal.distance(a, one, b, two, QUERY, self._result))

    def witnessed(self, t: float) -> float | None:
        """The distance of coal's two points where each lies in its body, else None."""
        self.distances(np.array([t]))
        p, q = self._result.getNearestPoint1(), self._result.getNearestPoint2()
        for mover, point in zip(self._movers, (p, q), strict=True):
            origin, turned = mover.poses(np.array([t]))
            if mover.solid.beyond(turned[0].T @ (point - origin[0])) > INSIDE_M:
                return None
        return float(np.linalg.norm(p - q))


def rotations(q: np.ndarray) -> np.ndarray:
    """Matrices (k, 3, 3) of quaternions (k, 4), scalar first, of any length but zero."""
    w, x, y, z = (q / np.linalg.norm(q, axis=1)[:, None]).T
    rows = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return np.moveaxis(np.array(rows), 2, 0)
