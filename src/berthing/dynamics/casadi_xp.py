"""The user's vocabulary with casadi's expressions."""

from __future__ import annotations

import casadi as ca

from berthing.sym import Sym
from berthing.xp import Namespace


class CasadiNamespace(Namespace):
    """Expressions to be differentiated and solved."""

    def sin(self, a: Sym) -> Sym:
        return ca.sin(a)

    def cos(self, a: Sym) -> Sym:
        return ca.cos(a)

    def exp(self, a: Sym) -> Sym:
        return ca.exp(a)

    def log(self, a: Sym) -> Sym:
        return ca.log(a)

    def sqrt(self, a: Sym) -> Sym:
        return ca.sqrt(a)

    def arctan(self, a: Sym) -> Sym:
        return ca.atan(a)

    def arctan2(self, y: Sym, x: Sym) -> Sym:
        return ca.atan2(y, x)

    def abs(self, a: Sym) -> Sym:
        return ca.fabs(a)

    def minimum(self, a: Sym, b: Sym) -> Sym:
        return ca.fmin(a, b)

    def maximum(self, a: Sym, b: Sym) -> Sym:
        return ca.fmax(a, b)

    def where(self, condition: Sym, a: Sym, b: Sym) -> Sym:
        return ca.if_else(condition, a, b)

    def vector(self, *parts: Sym) -> Sym:
        return ca.vertcat(*parts)

    def size(self, a: Sym) -> int:
        return int(ca.SX(a).numel())


CASADI = CasadiNamespace()
