"""What a shape may offer beside its support function, and how to ask for it.

Whoever needs a capability asks through the function here; a shape that lacks it answers with an
error that names the shapes that have it.
"""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.mesh import Mesh


@runtime_checkable
class HasConicForm(Protocol):
    """Linear rows and second-order cones."""

    def conic_form(self) -> ConicForm: ...


@runtime_checkable
class HasVertices(Protocol):
    """Finitely many extreme points."""

    def vertices(self) -> Array: ...


@runtime_checkable
class HasHalfspaces(Protocol):
    """Finitely many linear inequalities."""

    def halfspaces(self) -> tuple[Array, Array]: ...


@runtime_checkable
class HasLevel(Protocol):
    """A convex function whose zero sub-level set is the shape."""

    def level(self, x: Array) -> Array: ...


@runtime_checkable
class HasSmoothLevel(Protocol):
    """A level function with two derivatives, its gradient nowhere zero on the boundary."""

    def level(self, x: Array) -> Array: ...

    def level_gradient(self, x: Array) -> Array: ...

    def level_hessian(self, x: Array) -> Array: ...


@runtime_checkable
class HasMesh(Protocol):
    """Triangles for drawing."""

    def mesh(self) -> Mesh: ...


def conic_form(shape: ConvexSet) -> ConicForm:
    """The shape as {x : linear_A x ≤ linear_b, ‖A_i x + b_i‖ ≤ head_i}; CapabilityError if none."""
    if isinstance(shape, HasConicForm):
        return shape.conic_form()
    raise _lacks(shape, "conic form", HasConicForm)


def vertices(shape: ConvexSet) -> Array:
    """Extreme points (k, dim) in metres, own frame; CapabilityError for a curved shape."""
    if isinstance(shape, HasVertices):
        return shape.vertices()
    raise _lacks(shape, "finite set of vertices", HasVertices)


def halfspaces(shape: ConvexSet) -> tuple[Array, Array]:
    """A (m, dim) with unit rows and b (m,) in metres, the shape being {x : A x ≤ b}.

    Raises:
        CapabilityError: a curved shape.
    """
    if isinstance(shape, HasHalfspaces):
        return shape.halfspaces()
    raise _lacks(shape, "finite set of half-spaces", HasHalfspaces)


def level(shape: ConvexSet, x: Array) -> Array:
    """A convex function (...) of x (..., dim): below 0 inside, 0 on the boundary, above outside.

    Its unit is the shape's own choice (metres, or a ratio for an ellipsoid).

    Raises:
        CapabilityError: the shape has none.
        InputError: the last axis of x is not ``shape.dim``.
    """
    if isinstance(shape, HasLevel):
        return shape.level(x)
    raise _lacks(shape, "level function", HasLevel)


def level_gradient(shape: ConvexSet, x: Array) -> Array:
    """Gradient (..., dim) of the level function at x (..., dim), in its unit per metre.

    Raises:
        CapabilityError: the shape's boundary is not one smooth function's.
        InputError: the last axis of x is not ``shape.dim``.
    """
    if isinstance(shape, HasSmoothLevel):
        return shape.level_gradient(x)
    raise _lacks(shape, "smooth level function", HasSmoothLevel)


def level_hessian(shape: ConvexSet, x: Array) -> Array:
    """Second derivatives (..., dim, dim) of the level function at x (..., dim), symmetric.

    Raises:
        CapabilityError: the shape's boundary is not one smooth function's.
        InputError: the last axis of x is not ``shape.dim``.
    """
    if isinstance(shape, HasSmoothLevel):
        return shape.level_hessian(x)
    raise _lacks(shape, "smooth level function", HasSmoothLevel)


def mesh(shape: ConvexSet) -> Mesh:
    """Triangles for drawing, in metres, own frame; CapabilityError if the shape has none."""
    if isinstance(shape, HasMesh):
        return shape.mesh()
    raise _lacks(shape, "mesh", HasMesh)


def kinds_with(*protocols: type) -> str:
    """Names of the loaded kinds of set that have one of these capabilities, as errors list them."""
    able = {kind.__name__ for kind in _kinds(ConvexSet) if issubclass(kind, protocols)}
    return ", ".join(sorted(able)) or "none"


def _lacks(shape: ConvexSet, what: str, protocol: type) -> CapabilityError:
    return CapabilityError(
        f"{type(shape).__name__} has no {what}; those loaded that have one: {kinds_with(protocol)}"
    )


def _kinds(base: type) -> list[type]:
    direct: list[type] = base.__subclasses__()
    return direct + [kind for child in direct for kind in _kinds(child)]
