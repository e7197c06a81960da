"""Multipliers of limits and path constraints, as functions of time at the nodes.

A row at a node pulls on the sum w_i h/2 H_i, so that its multiplier over the node's weight is that
of the continuous problem, a unit of the row and a second. Rows of limits are on Bernstein
coefficients: what they pull on a node is the sum of theirs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.trajectory import limit_name, path_name
from berthing.transcription.defects import quadrature
from berthing.transcription.elements import Index
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.nodes import collocated


@dataclass(frozen=True)
class LimitRows:
    """The rows that limit one component on one segment.

    Attributes:
        component: of the state or control, by its native name.
        scale: physical over stored.
        points: (n,) of the mesh; bernstein: (n, n), coefficients (rows) from values (columns).
    """

    vehicle: str
    component: str
    scale: float
    points: Index
    rows: Index
    bernstein: Array


@dataclass(frozen=True)
class PathRows:
    """Rows (n, m) of a path constraint of m rows at n points of the mesh."""

    vehicle: str
    constraint: str
    scale: float
    points: Index
    rows: Index


def limit_costates(
    layout: PhaseLayout, limits: tuple[LimitRows, ...], paths: tuple[PathRows, ...],
    multipliers: Array, duration_s: float, owner: VehicleLayout,
) -> Mapping[str, Array]:  # fmt: skip
    """By name, (points,) of one vehicle; NaN at points that are not collocated.

    Rows at the last point, where that is not collocated, pull on the end alone and are left out.
    """
    name, cost = owner.vehicle.name, layout.scale.cost
    count = layout.mesh.point_count
    found: dict[str, Array] = {}
    for row in (own for own in limits if own.vehicle == name):
        pull = found.setdefault(limit_name(row.component), np.zeros(count))
        np.add.at(pull, row.points, multipliers[row.rows] @ row.bernstein * cost / row.scale)
    for path in (own for own in paths if own.vehicle == name):
        for i, rows in enumerate(path.rows.T):
            pull = found.setdefault(path_name(path.constraint, i), np.zeros(count))
            np.add.at(pull, path.points, multipliers[rows] * cost / path.scale)
    seconds = _weights_s(layout, duration_s)
    return {key: pull / seconds for key, pull in found.items()}


def _weights_s(layout: PhaseLayout, duration_s: float) -> Array:
    """Of the quadrature at every point (points,); a point of two segments has what both give."""
    out = np.full(layout.mesh.point_count, np.nan)
    for point, weight in zip(collocated(layout)[0], quadrature(layout), strict=True):
        out[point] = np.nan_to_num(out[point]) + weight * duration_s
    return out
