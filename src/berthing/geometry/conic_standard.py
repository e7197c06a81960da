"""Conic forms as rows with slacks in a product of cones, scaled to size, as solvers want them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock


@dataclass(frozen=True, eq=False)
class Standard:
    """{z : G z + s = h, s in K}, K the product of half-lines and of cones of ``p`` rows.

    Attributes:
        line_G, line_h: (m, size), (m,); one-row blocks are two of these.
        cone_G, cone_h: (..., cones, p, size), (..., cones, p), shorter cones filled with zeros.
            A leading batch axis may be there.
        unit: length that is 1 in z, in metres.
        reach: no z of the set is longer than this many units.
        line_scale, cone_scale: what the form's own rows were divided by (m,) and (cones,).
    """

    line_G: Array
    line_h: Array
    cone_G: Array
    cone_h: Array
    unit: float
    reach: float
    line_scale: Array
    cone_scale: Array

    def with_cone(self, G: Array, h: Array) -> Standard:
        """With one more cone, G (..., p, size) and h (..., p), which may differ in a batch."""
        own, rows = self.cone_h.shape[-2:]
        p, size = max(rows, G.shape[-2]), G.shape[-1]
        batch = np.broadcast_shapes(G.shape[:-2], h.shape[:-1])
        cone_G, cone_h = np.zeros((*batch, own + 1, p, size)), np.zeros((*batch, own + 1, p))
        cone_G[..., :own, :rows, :], cone_h[..., :own, :rows] = self.cone_G, self.cone_h
        cone_G[..., own, : G.shape[-2], :], cone_h[..., own, : h.shape[-1]] = G, h
        return replace(self, cone_G=cone_G, cone_h=cone_h)

    @property
    def degree(self) -> int:
        """Number of half-lines and cones."""
        return len(self.line_h) + int(self.cone_h.shape[-2])


def standard(form: ConicForm, unit: float, longest: float | None = None) -> Standard:
    """The rows of a form, scaled to size.

    Args:
        form: of a bounded set with an interior.
        unit: about the set's size, in metres.
        longest: no coordinate of z is longer, in metres; ``unit`` if not given.
    """
    flat = [b for b in form.blocks if is_flat(b)]
    round_ = [b for b in form.blocks if not is_flat(b)]
    rows = [form.linear_A, *(sign * b.A for b in flat for sign in (1.0, -1.0))]
    offsets = [form.linear_b, *(b.head - sign * b.b for b in flat for sign in (1.0, -1.0))]
    line_G, line_h = np.concatenate(rows) * unit, np.concatenate(offsets)
    scale = np.linalg.norm(line_G, axis=1)
    cone_G, cone_h, cone_scale = _stacked(round_, form.size, unit)
    reach = np.sqrt(form.size) * (unit if longest is None else longest) / unit
    line_G, line_h = line_G / scale[:, None], line_h / scale
    return Standard(line_G, line_h, cone_G, cone_h, unit, reach, scale, cone_scale)


def is_flat(block: SecondOrderBlock) -> bool:
    """Whether a block is a slab, which two half-spaces say as well."""
    return block.slope is None and len(block.b) == 1


def _stacked(blocks: list[SecondOrderBlock], size: int, unit: float) -> tuple[Array, Array, Array]:
    """Blocks as cones (cones, p, size), (cones, p), and their largest rows, they are divided by."""
    p = 1 + max((len(block.b) for block in blocks), default=1)
    G, h = np.zeros((len(blocks), p, size)), np.zeros((len(blocks), p))
    scales = np.ones(len(blocks))
    for i, block in enumerate(blocks):
        rows = 1 + len(block.b)
        G[i, 0] = 0.0 if block.slope is None else -unit * block.slope
        G[i, 1:rows], h[i, 0], h[i, 1:rows] = -unit * block.A, block.head, block.b
        scales[i] = np.max(np.linalg.norm(G[i], axis=-1))
        G[i], h[i] = G[i] / scales[i], h[i] / scales[i]
    return G, h, scales
