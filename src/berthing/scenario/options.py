"""How to solve: the scenario's own wishes, which the command line overrules."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.errors import InputError

EFFORTS = ("fast", "normal", "thorough")
POLYNOMIAL = "polynomial"
CONTROLS = (POLYNOMIAL, "piecewise-linear", "piecewise-constant")
"""As optimised, or as flight computers fly them: linear or held from sample to sample."""


@dataclass(frozen=True)
class SolverOptions:
    """Choices of method.

    Attributes:
        formulation: how separation is written, e.g. ``plane``.
        scheme: how time is discretised, e.g. ``lgr``.
        nodes: collocation nodes; None leaves the number to the planner.
        time_limit_s: wall time allowed; None for no limit.
        seed: of the guesses.
        guess: where first trajectories come from, ``default``, ``routes`` or
            ``paper-continuation``.
        controls: what flies between samples of the controls, one of ``CONTROLS``.
        sample_time_s: between them, where they are piecewise.
        tolerance: drift of the lower Hamiltonian, relative to its mean, down to which the mesh is
            refined about the touches; None leaves the first certified plan as it is.
        effort: how many guesses are solved and how many answers refined: ``fast``, ``normal`` or
            ``thorough``. It counts guesses, not seconds, so that every machine tries the same.

    Raises:
        InputError: fewer than two nodes, a time limit, a tolerance or a sample time not positive,
            a negative seed, unknown controls or an unknown effort.
    """

    formulation: str = "plane"
    scheme: str = "lgr"
    nodes: int | None = None
    time_limit_s: float | None = None
    seed: int = 0
    guess: str = "default"
    tolerance: float | None = None
    effort: str = "normal"
    controls: str = POLYNOMIAL
    sample_time_s: float = 1.0

    def __post_init__(self) -> None:
        if self.nodes is not None and self.nodes < 2:
            raise InputError("nodes", f"is {self.nodes}", "2 or more")
        if self.time_limit_s is not None and not self.time_limit_s > 0.0:
            raise InputError("time_limit_s", f"is {self.time_limit_s}", "a positive number")
        if self.tolerance is not None and not self.tolerance > 0.0:
            raise InputError("tolerance", f"is {self.tolerance}", "a positive number")
        if self.controls not in CONTROLS:
            raise InputError("controls", f"are {self.controls!r}", ", ".join(CONTROLS))
        if not self.sample_time_s > 0.0:
            raise InputError("sample_time_s", f"is {self.sample_time_s}", "a positive number")
        if self.seed < 0:
            raise InputError("seed", f"is {self.seed}", "0 or more")
        if self.effort not in EFFORTS:
            raise InputError("effort", f"is {self.effort!r}", f"one of {', '.join(EFFORTS)}")
