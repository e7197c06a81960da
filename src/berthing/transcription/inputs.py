"""The inputs of a kernel, declared by name and wired to indices by the same names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca
import numpy as np
import numpy.typing as npt

from berthing.sym import Sym
from berthing.transcription.elements import Elements, Kernel


class Inputs:
    """Variables, parameters and constants of one kernel, in the order of their declaration.

    Variables are stored scaled in the programme's vector; what a kernel is written in are the
    physical values.
    """

    def __init__(self) -> None:
        self._symbols: dict[str, list[Sym]] = {"z": [], "p": [], "c": []}
        self._names: dict[str, list[tuple[str, int]]] = {"z": [], "p": [], "c": []}

    def variable(
        self, name: str, size: int, scale: npt.ArrayLike = 1.0, shift: npt.ArrayLike = 0.0
    ) -> Sym:
        """Declare a variable (size,) with its scaling; returns its physical value."""
        stored = self._declare("z", name, size)
        spread = [ca.DM(np.broadcast_to(np.asarray(v, np.float64), size)) for v in (scale, shift)]
        return spread[1] + spread[0] * stored

    def parameter(self, name: str, size: int) -> Sym:
        """Declare a parameter (size,)."""
        return self._declare("p", name, size)

    def constant(self, name: str, size: int = 1) -> Sym:
        """Declare a number (size,) that each element brings along."""
        return self._declare("c", name, size)

    def kernel(self, rows: Sym, objective: Sym = 0.0) -> Kernel:
        """The kernel of these inputs."""
        z, p, c = (ca.vertcat(*self._symbols[kind]) for kind in "zpc")
        return Kernel(z, p, c, rows, objective)

    def add(
        self, elements: Elements, kernel: Kernel, values: Mapping[str, Any], rows: npt.ArrayLike
    ) -> None:
        """Append n elements: indices or constants (n, size) by name, rows (n, m)."""
        lines = np.atleast_2d(np.asarray(rows))
        n = len(lines)
        z, p, c = (
            np.hstack([np.reshape(values[name], (n, size)) for name, size in self._names[kind]])
            if self._names[kind]
            else np.empty((n, 0))
            for kind in "zpc"
        )
        elements.add(kernel, z, p, c, lines)

    def _declare(self, kind: str, name: str, size: int) -> Sym:
        symbol = ca.SX.sym(name, size)
        self._symbols[kind].append(symbol)
        self._names[kind].append((name, size))
        return symbol
