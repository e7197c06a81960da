"""The one type of everything that casadi computes with; casadi itself is not imported here."""

from __future__ import annotations

from typing import Any

Sym = Any
"""A casadi expression or matrix: SX, MX, DM, or a float where casadi takes one.

casadi's stubs give each of these classes its own overloads, and the code here is written once for
all of them.
"""
