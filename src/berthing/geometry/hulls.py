"""From half-spaces to vertices and back, by SciPy's Qhull.

Flat, empty and unbounded inputs are told apart and refused, since no set of the package is any of
these.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.optimize import linprog
from scipy.spatial import ConvexHull, QhullError

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import DIMENSIONS

# Relative to the size of the set: Qhull's own rounding is about 1e-15 of it times a small factor,
# and no drawing of a station is good to 1e-9.
MERGE_TOLERANCE = 1e-9
# A set thinner than this fraction of its size counts as flat.
FLATNESS_TOLERANCE = 1e-9


def extreme_points(points: Array, where: str) -> Array:
    """The extreme ones (k, d) of points (n, d).

    Raises:
        InputError: two or three dimensions it is not, too few points, or points in one plane.
    """
    count, dim = points.shape
    if dim not in DIMENSIONS:
        raise InputError(where, f"has {dim} columns", "2 or 3 coordinates a vertex")
    if count <= dim:
        raise InputError(where, f"has {count} vertices", f"at least {dim + 1}")
    centred = points - points.mean(axis=0)
    spread = np.linalg.svd(centred, compute_uv=False)
    if spread[-1] <= FLATNESS_TOLERANCE * spread[0]:
        raise InputError(where, "is flat: its vertices lie in one plane or line", "a volume")
    hull = _hull(centred, where)
    return np.asarray(points[np.sort(hull.vertices)])


def facets(corners: Array, where: str) -> tuple[Array, Array]:
    """Unit rows A (m, d) and b (m,) of the hull of extreme points; it lies in {A x ≤ b} exactly.

    Qhull cuts facets into simplices; rows that agree to ``MERGE_TOLERANCE`` are made one, and
    b is the support value of the corners, so that merging never cuts the set.
    """
    centre = corners.mean(axis=0)
    equations = _hull(corners - centre, where).equations
    size = float(np.max(np.abs(corners - centre)))
    scaled = equations / np.append(np.ones(corners.shape[1]), size)
    rows = equations[_distinct(scaled)][:, :-1]
    rows = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    return rows, np.max(rows @ corners.T, axis=1)


def enclosed(A: Array, b: Array, where: str) -> tuple[Array, Array, Array]:
    """Irredundant unit rows A (m, d), b (m,) of {A x ≤ b}, and its vertices (k, d).

    With c inside, the rows a_i/(b_i − a_i·c) are the points of the polar set: its extreme points
    are the irredundant rows and its facets the vertices (Ziegler, *Lectures on Polytopes*, 2.3).

    Raises:
        InputError: two or three dimensions it is not, a row of zeros, or an empty, flat or
            unbounded set.
    """
    A, b = unit_rows(A, b, where)
    centre = inner_point(A, b, where)
    slack = b - A @ centre
    hull = _hull(A / slack[:, None], where)
    normal, offset = hull.equations[:, :-1], hull.equations[:, -1]
    vertices = centre - normal / offset[:, None]
    size = float(np.max(np.abs(vertices - centre)))
    vertices = vertices[_distinct((vertices - centre) / size)]
    keep = np.sort(hull.vertices)
    return A[keep], b[keep], np.array([_polished(v, A, b, size) for v in vertices])


def unit_rows(A: Array, b: Array, where: str) -> tuple[Array, Array]:
    """A (m, d) with rows of length 1, b (m,) divided alike.

    Raises:
        InputError: two or three dimensions it is not, or a row of zeros.
    """
    dim = A.shape[1]
    if dim not in DIMENSIONS:
        raise InputError(where, f"has {dim} columns", "2 or 3 coordinates a row")
    length = np.linalg.norm(A, axis=1)
    if np.any(length == 0.0):
        raise InputError(where, f"row {int(np.argmin(length))} is zero", "an outward normal")
    return A / length[:, None], b / length


def inner_point(A: Array, b: Array, where: str) -> Array:
    """Centre (d,) of the largest ball in {A x ≤ b}, A of unit rows.

    Raises:
        InputError: an empty, flat or unbounded set.
    """
    _refuse_unbounded(A, where)
    return _deepest_point(A, b, where)


def normal_cones(A: Array, b: Array, centre: Array, where: str) -> npt.NDArray[np.int64]:
    """Triples (in the plane: pairs) of rows (k, d) whose cones cover all directions.

    The rows of one are those of faces that meet at a vertex of {A x ≤ b}: it is a facet of the
    polar set about ``centre``, cut into simplices.
    """
    return np.array(_hull(A / (b - A @ centre)[:, None], where).simplices, dtype=np.int64)


def _refuse_unbounded(A: Array, where: str) -> None:
    """{A x ≤ b} is bounded for every b iff the rows span all directions positively:

    Aᵀ λ = 0 with every λ ≥ 1, and full column rank (Stiemke's lemma).
    """
    dim = A.shape[1]
    rank = np.linalg.matrix_rank(A, tol=FLATNESS_TOLERANCE)
    positive = rank == dim and linprog(
        np.ones(len(A)), A_eq=A.T, b_eq=np.zeros(dim), bounds=(1.0, None)
    ).status == 0  # fmt: skip
    if not positive:
        raise InputError(where, "is unbounded", "half-spaces that enclose a bounded set")


def _deepest_point(A: Array, b: Array, where: str) -> Array:
    """Centre of the largest inscribed ball; InputError for an empty or flat set."""
    dim = A.shape[1]
    cost = np.append(np.zeros(dim), -1.0)
    rows = np.column_stack([A, np.ones(len(A))])
    # Scaled to the largest offset, for the solver's tolerances are absolute.
    scale = float(np.max(np.abs(b))) or 1.0
    answer = linprog(cost, A_ub=rows, b_ub=b / scale, bounds=(None, None))
    if answer.status != 0 or answer.x[-1] < -FLATNESS_TOLERANCE:
        raise InputError(where, "is empty: no point satisfies all its half-spaces", "a volume")
    if answer.x[-1] <= FLATNESS_TOLERANCE:
        raise InputError(where, "is flat: its half-spaces leave no volume", "a volume")
    return np.asarray(answer.x[:-1] * scale)


def _polished(vertex: Array, A: Array, b: Array, size: float) -> Array:
    """The vertex as the intersection of the rows that meet there, free of the polar's rounding."""
    near = np.abs(A @ vertex - b) <= MERGE_TOLERANCE * size
    step = np.linalg.lstsq(A[near], b[near] - A[near] @ vertex, rcond=None)[0]
    return np.asarray(vertex + step)


def _distinct(rows: Array) -> list[int]:
    """Indices of rows that differ from all earlier ones by more than ``MERGE_TOLERANCE``."""
    kept: list[int] = []
    for i, row in enumerate(rows):
        if not kept or np.min(np.max(np.abs(rows[kept] - row), axis=1)) > MERGE_TOLERANCE:
            kept.append(i)
    return kept


def _hull(points: Array, where: str) -> ConvexHull:
    try:
        return ConvexHull(points)
    except QhullError:
        raise InputError(where, "is flat or too thin for its size", "a volume") from None
