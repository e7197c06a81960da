"""A checker of plan folders that shares no code with the package: files in, distances out.

Distances are between the vertices' hulls, by non-negative least squares; a cylinder is replaced by
a prism that contains it, so that what it reports can only be too small.
"""

from __future__ import annotations

import csv
import json
from itertools import pairwise, product
from pathlib import Path

import numpy as np
from scipy.optimize import nnls

# Corners of the prism around a cylinder; it bulges by r (1 / cos(pi / n) - 1), 0.5 mm for 1 m.
PRISM = 100
# Weight of "the coefficients sum to one" against lengths of some metres.
UNITY = 1e4


def corners(shape: dict) -> np.ndarray:
    """Vertices (k, 3) of a set that contains the shape of a scenario file."""
    if shape["type"] == "box":
        half = 0.5 * np.array(shape["size_m"])
        return np.array(list(product(*zip(-half, half, strict=True))))
    if shape["type"] == "cylinder":
        angle = 2 * np.pi * np.arange(PRISM) / PRISM
        r = shape["radius_m"] / np.cos(np.pi / PRISM)
        ring = np.stack([np.zeros(PRISM), r * np.cos(angle), r * np.sin(angle)], axis=1)
        half = np.array([0.5 * shape["length_m"], 0.0, 0.0])
        solid = np.concatenate([ring - half, ring + half])
        return np.roll(solid, "xyz".index(shape.get("axis", "x")), axis=1)
    raise ValueError(shape["type"])


def rotation(q: np.ndarray) -> np.ndarray:
    """Body to inertial, for q = (w, x, y, z) of any length but zero."""
    w, v = q[0], q[1:]
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + 2 * (w * cross + cross @ cross) / (q @ q)


def hull_distance(a: np.ndarray, b: np.ndarray) -> float:
    """Distance of the hulls of a (k, 3) and b (m, 3)."""
    shift = a.mean(axis=0)
    pull = np.hstack([(a - shift).T, -(b - shift).T])
    ones = np.zeros((2, len(a) + len(b)))
    ones[0, : len(a)] = ones[1, len(a) :] = UNITY
    weights, _ = nnls(np.vstack([pull, ones]), np.array([0, 0, 0, UNITY, UNITY]))
    alpha, beta = weights[: len(a)], weights[len(a) :]
    return float(np.linalg.norm(alpha @ a / alpha.sum() - beta @ b / beta.sum()))


def poses(folder: Path, vehicle: str, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (k,), positions (k, 3) and quaternions (k, 4), interpolated from interpolant.json."""
    document = json.loads((folder / "interpolant.json").read_text())
    own = next(v for p in document["phases"] for v in p["vehicles"] if v["vehicle"] == vehicle)
    names, segments = own["state_names"], own["segments"]
    times = np.linspace(segments[0]["t0_s"], segments[-1]["t1_s"], count)
    columns = [names.index(n) for n in ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")]
    out = np.empty((count, 7))
    ends = np.array([s["t1_s"] for s in segments[:-1]])
    for i, t in enumerate(times):
        s = segments[int(np.searchsorted(ends, t, side="right"))]
        x = (2 * t - s["t0_s"] - s["t1_s"]) / (s["t1_s"] - s["t0_s"])
        basis = np.cos(np.arange(len(s["state"])) * np.arccos(np.clip(x, -1, 1)))
        out[i] = (basis @ np.array(s["state"]))[columns]
    return times, out[:, :3], out[:, 3:]


def route_poses(folder: Path, vehicle: str, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Positions (k, 3) and quaternions (k, 4) of route.json's first route, ``count`` a leg.

    Straight, and by slerp: sin((1 − s) θ) q₀ + sin(s θ) q₁ over sin θ.
    """
    document = json.loads((folder / "route.json").read_text())
    states = np.array([state[vehicle] for state in document["routes"][0]["states"]])
    found = []
    for one, other in pairwise(states):
        q0, q1 = one[3:], other[3:] if one[3:] @ other[3:] >= 0 else -other[3:]
        angle = np.arccos(min(1.0, q0 @ q1))
        for s in np.linspace(0.0, 1.0, count):
            shares = np.array([1 - s, s])
            if angle > 1e-6:
                shares = np.sin(shares * angle) / np.sin(angle)
            q = shares[0] * q0 + shares[1] * q1
            found.append(np.concatenate([(1 - s) * one[:3] + s * other[:3], q]))
    out = np.array(found)
    return out[:, :3], out[:, 3:]


def least_distance(folder: Path, count: int, near: float = 1.0) -> float:
    """The least distance of the first vehicle from any fixed structure at ``count`` times, or at
    so many instants of each leg of a route.

    Where bounding balls are further apart than ``near`` their gap is taken.
    """
    plans = (folder / "plan.json").exists()
    document = json.loads((folder / ("plan.json" if plans else "route.json")).read_text())
    scenario = document["scenario"]
    vehicle = scenario["phases"][0]["vehicles"][0]
    r, q = (poses if plans else route_poses)(folder, vehicle["name"], count)[-2:]
    hulls = [corners(part["shape"]) for part in vehicle["parts"]]
    least = np.inf
    for structure in scenario["structures"]:
        base = np.array(structure.get("position_m", [0, 0, 0]), float)
        for part in structure["parts"]:
            offset = np.array(part.get("position_m", [0, 0, 0]), float)
            solid = corners(part["shape"]) + base + offset
            centre = solid.mean(axis=0)
            reach = np.linalg.norm(solid - centre, axis=1).max()
            for hull, i in product(hulls, range(len(r))):
                gap = np.linalg.norm(r[i] - centre) - reach - np.linalg.norm(hull, axis=1).max()
                if gap > min(near, least):
                    continue
                least = min(least, hull_distance(hull @ rotation(q[i]).T + r[i], solid))
    return float(least)


def table(folder: Path, name: str) -> list[dict[str, str]]:
    """A CSV file of the folder."""
    with (folder / name).open() as file:
        return list(csv.DictReader(file))
