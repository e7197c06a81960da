import matplotlib
import numpy as np
import pytest
from matplotlib.image import imread

from berthing.report.figures import draw_figures
from support import synthetic

TWO = (synthetic.spacecraft(), synthetic.spacecraft("tug", (0.0, 6.0, 2.0)))
SCENARIOS = {
    "one": synthetic.scenario(),
    "two vehicles": synthetic.scenario(TWO, ()),
    "two phases": synthetic.two_phase_scenario(),
    "planar": synthetic.planar_scenario(),
    "nothing around": synthetic.scenario(structures=()),
}


def is_drawn(path):
    """More than a few shades, and ink well inside."""
    pixels = imread(path)[..., :3]
    height, width, _ = pixels.shape
    inside = pixels[height // 4 : 3 * height // 4, width // 8 : 7 * width // 8]
    return width > 600 and np.mean(np.any(inside < 0.9, axis=-1)) > 0.005


@pytest.mark.parametrize("name", SCENARIOS)
def test_every_figure_is_drawn_without_a_display(tmp_path, monkeypatch, name):
    monkeypatch.delenv("DISPLAY", raising=False)
    of = SCENARIOS[name]
    drawn = draw_figures(of, synthetic.plan(of), synthetic.verification(of), tmp_path)
    assert [path.stem for _, path in drawn] == [
        "trajectory", "states", "controls", "clearance", "hamiltonian"
    ]  # fmt: skip
    for caption, path in drawn:
        assert caption
        assert is_drawn(path) or (path.stem, name) == ("clearance", "nothing around")


def test_an_empty_picture_does_not_count_as_drawn(tmp_path):
    matplotlib.image.imsave(tmp_path / "blank.png", np.ones((500, 900, 3)))
    assert not is_drawn(tmp_path / "blank.png")


def test_pyplot_is_not_touched():
    # Its state is global, and its back ends look for a display.
    import subprocess
    import sys

    code = "import sys, berthing.report.figures; print('matplotlib.pyplot' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
