"""All figures of a plan, as files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from matplotlib.figure import Figure

from berthing.report.clearance_curves import clearance_curves
from berthing.report.clearances import draw_clearances
from berthing.report.controls import draw_controls
from berthing.report.hamiltonian import draw_hamiltonian
from berthing.report.scene import draw_scene
from berthing.report.states import draw_states
from berthing.report.style import save
from berthing.report.track import tracks
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.verify.verification import Verification

CAPTIONS = {
    "trajectory": "The way through the structures, and hulls at several times on it.",
    "states": "Motion over time; circles are the solver's nodes.",
    "controls": "Controls over time; dashed lines are their limits.",
    "clearance": "Clearance of each pair; dashed lines are the margins.",
    "hamiltonian": "The lower Hamiltonian at the nodes; the dashed line is its mean.",
}


def draw_figures(
    scenario: Scenario, plan: Plan, verification: Verification, folder: Path
) -> list[tuple[str, Path]]:
    """Write every figure into ``folder``; captions and files, in the order of reading."""
    found = tracks(scenario, plan)
    drawings: dict[str, Callable[[], Figure]] = {
        "trajectory": lambda: draw_scene(scenario, found),
        "states": lambda: draw_states(found, verification),
        "controls": lambda: draw_controls(found),
        "clearance": lambda: draw_clearances(clearance_curves(scenario, plan), verification.pairs),
        "hamiltonian": lambda: draw_hamiltonian(verification.hamiltonian),
    }
    written = []
    for name, draw in drawings.items():
        path = folder / f"{name}.png"
        save(draw(), path)
        written.append((CAPTIONS[name], path))
    return written
