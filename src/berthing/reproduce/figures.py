"""Every figure of the paper, from plans of ours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure

from berthing.report.controls import draw_controls
from berthing.report.hamiltonian import draw_hamiltonian
from berthing.report.scene import draw_scene
from berthing.report.states import draw_states
from berthing.report.style import save
from berthing.report.track import tracks
from berthing.reproduce.cases import Cases, Planned
from berthing.reproduce.drawings import draw_error, draw_spacecraft


@dataclass(frozen=True)
class Drawn:
    """One file.

    Attributes:
        label: of the paper's figure.
        caption: what ours shows.
        file: its name.
    """

    label: str
    caption: str
    file: str


def _scene(case: Planned) -> Figure:
    return draw_scene(case.scenario, tracks(case.scenario, case.plan))


def _states(case: Planned) -> Figure:
    return draw_states(tracks(case.scenario, case.plan), case.verification)


def _controls(case: Planned) -> Figure:
    return draw_controls(tracks(case.scenario, case.plan))


def _hamiltonian(case: Planned) -> Figure:
    return draw_hamiltonian(case.verification.hamiltonian)


OF_A_PLAN: tuple[tuple[str, str, Callable[[Planned], Figure]], ...] = (
    ("traj", "the way, in two views", _scene),
    ("state", "position, velocity, attitude and rates; circles are the solver's nodes", _states),
    ("controls", "forces and torques over time; dashed lines are their limits", _controls),
    ("lowham", "the lower Hamiltonian at the nodes", _hamiltonian),
)

LABELS = {
    "scenario-a": {"traj": "trajA", "state": "scenA-state", "controls": "scenA-controls",
                   "lowham": "lowhamA"},
    "scenario-b": {"traj": "trajB", "state": "scenB-state", "controls": "scenB-controls",
                   "lowham": "lowhamB"},
}  # fmt: skip
"""The paper's labels; those of the plan as printed are A's."""


def draw_all(cases: Cases, folder: Path) -> list[Drawn]:
    """Write every figure into ``folder``, in the order of the paper."""
    craft = "the vehicle of offset-mass-wrench"
    drawn = [_save(folder, "robotic-sc", craft, draw_spacecraft())]
    for name, suffix in (
        ("scenario-a", ""),
        ("scenario-a-printed", "-printed"),
        ("scenario-b", ""),
    ):
        labels = LABELS.get(name, LABELS["scenario-a"])
        case = cases[name]
        for key, caption, draw in OF_A_PLAN:
            drawn.append(_save(folder, labels[key], f"{name}: {caption}", draw(case), suffix))
    caption = "corners of smoothed squares, by exponent and size"
    return [*drawn, _save(folder, "err-analysis", caption, draw_error())]


def _save(folder: Path, label: str, caption: str, figure: Figure, suffix: str = "") -> Drawn:
    file = f"{label}{suffix}.png"
    save(figure, folder / file)
    return Drawn(label, caption, file)
