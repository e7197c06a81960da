"""What a formulation of "these two sets stay apart" has to say about one pair at one instant."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.sym import Sym

SymPose = tuple[Sym, Sym]
"""Position (d,) and rotation (d, d), own → world, of one set."""


@dataclass(frozen=True)
class Variables:
    """Decision variables of one block, by name.

    Attributes:
        names: one a scalar, e.g. ``n_x``.
        lower, upper: bounds (k,); infinite where there is none.
    """

    names: tuple[str, ...]
    lower: Array
    upper: Array

    def __len__(self) -> int:
        return len(self.names)


@dataclass(frozen=True)
class Rows:
    """Rows lower ≤ expression ≤ upper.

    Attributes:
        expression: casadi column (m,).
        lower, upper: (m,).
        separation: index of the row that states the distance, for naming and costates.
        regulariser: a scalar that keeps the multipliers small; no part of the cost.
    """

    expression: Sym
    lower: Array
    upper: Array
    separation: int
    regulariser: Sym


class PairFormulation(ABC):
    """The separation of one pair of sets A and B, posed in the world frame.

    ``variables`` and ``rows`` belong together: ``rows`` takes one expression a variable.

    Attributes:
        homotopy: falling values of ``eps``, one a solve, for rows that are relaxed by it; empty
            for a form that is exact as it stands.
    """

    variables: Variables
    homotopy: tuple[float, ...] = ()

    @abstractmethod
    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        """Rows that hold only if the sets are at least ``margin_m`` apart.

        Args:
            v: the block's variables (k,).
            pose_a, pose_b: position (d,) and rotation (d, d) of each set's own frame.
            margin_m: the distance to keep, a number or an expression; above zero, for at zero or
                less the rows ask for nothing.
            length_m: the length that the separation row is divided by.
            eps: how far the rows are relaxed, a number or an expression. An answer of relaxed
                rows may overstate the distance.
        """

    @abstractmethod
    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        """Values (n, k) of the variables for n pairs of poses, whether apart or not.

        ``normal`` (n, d) are unit vectors of the world that part A from B, or part them best;
        ``eps`` is that of the rows.
        """


@runtime_checkable
class Sweeping(Protocol):
    """A formulation whose block holds a plane, which can be asked for at a second pose too."""

    variables: Variables

    @property
    def sweep_size(self) -> int:
        """Variables of its own that the second pose takes."""
        ...

    def sweep_rows(
        self, v: Sym, tau: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float
    ) -> Rows:
        """Rows that hold only if the plane of the block ``v`` parts the sets at these poses."""
        ...

    def sweep_start(self, v: Array, pose_a: Pose, pose_b: Pose) -> Array:
        """Values (k,) of its variables at one pair of poses."""
        ...


def unbounded(names: tuple[str, ...]) -> Variables:
    """Free variables of these names."""
    return Variables(names, np.full(len(names), -np.inf), np.full(len(names), np.inf))
