"""Distance of points from a set, for sets whose boundary is no simple formula."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.conic_algebra import joined
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import Standard, standard
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid


def distance_to(shape: ConvexSet, x: Array) -> Array:
    """Distance (k,) in metres of points x (k, dim) from the set; 0 for members.

    To 1e-10 of the sizes: by Newton's method where one smooth function bounds the set, else from
    its conic form.

    Raises:
        CapabilityError: a set with neither.
    """
    if isinstance(shape, SmoothedPolytope | Superellipsoid):
        outside = shape.level(x) > 0.0
        distance = np.zeros(len(x))
        nearest, _ = shape.hill.climb(x[outside], x[outside], pull=1.0)
        distance[outside] = norm(x[outside] - nearest)
        return distance
    return _from_conic(conic_form(shape), shape.bounding_radius, x)


def _from_conic(form: ConicForm, radius: float, x: Array) -> Array:
    """min τ with ‖z − x‖ ≤ τ, variables (z, τ), one cone differing from point to point."""
    unit = max(radius, float(np.max(norm(x), initial=0.0)))
    problem = _with_point(form, unit, x)
    objective = np.zeros((len(x), form.size + 1))
    objective[:, -1] = 1.0
    return np.maximum(minimise(problem, objective).point[:, -1], 0.0)


def _with_point(form: ConicForm, unit: float, x: Array) -> Standard:
    own = standard(joined([form], form.dim, 1), unit)
    rows = form.dim + 1
    G, h = np.zeros((rows, form.size + 1)), np.zeros((len(x), rows))
    G[0, -1] = -1.0
    G[1:, : form.dim] = -np.eye(form.dim)
    h[:, 1:] = -x / unit
    return own.with_cone(G, h)
