"""What is left of a plan from some instant on: its segments, its sites, its motion."""

from __future__ import annotations

import numpy as np

from berthing.trajectory import Plan
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from berthing.transcription.sites import Site

SLIVER = 0.3
"""A first segment shorter than this share of the next one is joined to it."""


def remaining(mesh: Mesh, done: float) -> Mesh:
    """The segments after the fraction ``done`` of the phase, as a mesh of their own."""
    later = [b for b in mesh.breaks if b > done]
    degrees = mesh.degrees[-len(later) :]
    if len(later) > 1 and later[0] - done < SLIVER * (later[1] - later[0]):
        later, degrees = later[1:], degrees[1:]
    breaks = [0.0, *((b - done) / (1.0 - done) for b in later[:-1]), 1.0]
    return Mesh(mesh.scheme, tuple(breaks), degrees)


def remaining_sites(old: Mesh, sites: list[Site], mesh: Mesh, done: float) -> list[Site]:
    """The sites after ``done``, at the same instants on the mesh that remains."""
    out = []
    for site in sites:
        at = (old.fraction(site.segment, site.s) - done) / (1.0 - done)
        if at > 0.0:
            segment, s = mesh.locate(min(at, 1.0))
            points = mesh.node_set(segment).points
            nearest = float(points[np.argmin(np.abs(points - s))])
            # What was a node of the old mesh is one of the new, but for rounding.
            s = nearest if abs(nearest - s) < 1e-9 else s
            out.append(Site(segment, s, site.pair))
    return sorted(set(out))


def shifted(plan: Plan, mesh: Mesh, from_s: float, to_s: float) -> Motion:
    """The plan's motion from one time of its clock to another, on ``mesh``."""
    (phase,) = plan.phases
    points = from_s + (to_s - from_s) * mesh.point_fractions()
    nodes = from_s + (to_s - from_s) * np.array(
        [mesh.fraction(k, float(s)) for k in range(mesh.segments)
         for s in mesh.node_set(k).control_points]
    )  # fmt: skip
    return Motion(
        to_s - from_s,
        {own.vehicle: own.state(points).T for own in phase.vehicles},
        {own.vehicle: own.control(nodes).T for own in phase.vehicles},
    )
