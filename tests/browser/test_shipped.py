"""The pages of cases that ship, in a real browser, as wide as a desk's screen and as a phone's."""

import csv
import json

import numpy as np
import pytest

from support.page_reading import SIZES, at_size, cursors, is_drawn, pixels, positions, seek, time_of

pytestmark = pytest.mark.browser

CASES = ("scenario-a", "scenario-b-tight", "spinning-structure", "two-vehicles-swap")
LARGEST_PAGE = 2_000_000


@pytest.fixture(scope="module", params=CASES)
def folder(request, planned):
    return planned(request.param)


@pytest.fixture(scope="module", params=SIZES)
def open_page(request, folder, browser):
    """Opening takes seconds where there is no graphics card, so it is done once."""
    page = at_size(browser, folder / "report.html", request.param)
    yield page
    page.close()


@pytest.fixture
def page(open_page):
    open_page.run("['start', 'whole'].forEach(id => document.getElementById(id).click())")
    return open_page


def test_nothing_is_asked_for_and_nothing_goes_wrong(page, folder):
    page.click(200, 200)
    for key in (" ", " ", "ArrowRight", "End", "Home", "v", "z", "Z", "c", "]", ".", ","):
        page.press(key, shift=key == "Z")
    assert page.requests == [(folder / "report.html").resolve().as_uri()]
    assert page.troubles == []


def test_the_file_is_small(folder):
    assert (folder / "report.html").stat().st_size < LARGEST_PAGE


def test_the_verdict_is_that_of_plan_json(page, folder):
    record = json.loads((folder / "plan.json").read_text())
    cells = page.run(
        "[...document.querySelectorAll('#verdict td[data-fields]')].map(cell =>"
        " [cell.previousElementSibling.textContent, cell.textContent, cell.dataset.fields])"
    )
    said = {label: text for label, text, _ in cells}
    for _, _, fields in cells:
        for key, value in json.loads(fields).items():
            found = record
            for name in key.split("."):
                found = found[name]
            assert found == value, key
    check = record["verification"]
    assert said["verdict"] == "certified" == record["outcome"]
    assert said["cost"] == f"{record['cost']:.6g}"
    assert said["clearance at every instant"].startswith("at least ")
    bound = float(said["clearance at every instant"].split()[2])
    assert 0.0 <= check["clearance_lower_bound_m"] - bound < 1e-5
    assert said["clearance required"] == f"{check['required_clearance_m']:.4f} m"
    pair = check["closest_pair"].replace("|", " – ")
    assert said["closest"] == (
        f"{pair}, {check['closest_distance_m']:.5f} m at {check['closest_time_s']:.2f} s"
    )
    assert said["method"] == (
        f"{record['formulation']}, {record['scheme']}, {record['nodes']} nodes"
    )
    assert said["effort"] == (
        f"{record['iterations']} iterations, {record['wall_time_s']['total']:.1f} s"
    )
    assert page.run("document.querySelector('.badge').textContent") == said["verdict"]


def test_the_scene_is_drawn(page):
    assert is_drawn(pixels(page, "#canvas"))


def test_the_slider_moves_vehicles_and_cursors(page, folder):
    with (folder / "trajectory.csv").open() as file:
        rows = list(csv.DictReader(file))
    before = pixels(page, "#canvas")
    for share in (0.3, 0.75):
        t = seek(page, share)
        last = float(rows[-1]["t_s"])
        assert t == pytest.approx(share * last, abs=0.02 * last)
        for name, place in positions(page).items():
            own = [row for row in rows if row["vehicle"] == name]
            times = [float(row["t_s"]) for row in own]
            for axis, value in zip("xyz", place, strict=True):
                line = [float(row[f"{axis}_m"]) for row in own]
                assert value == pytest.approx(np.interp(t, times, line), abs=2e-3)
        found = cursors(page)
        assert len(found) >= 6
        assert list(found.values()) == pytest.approx([t / last] * len(found), abs=0.01)
        after = pixels(page, "#canvas")
        assert np.mean(np.any(np.abs(after - before) > 0.05, axis=-1)) > 0.002
        before = after


def test_a_pair_and_the_closest_approach_can_be_gone_to(page, folder):
    check = json.loads((folder / "plan.json").read_text())["verification"]
    page.run("document.getElementById('closest').click()")
    assert time_of(page) == pytest.approx(check["closest_time_s"])
    page.run("document.querySelector('[data-seek]').click()")
    assert time_of(page) == pytest.approx(check["pairs"][0]["time_s"])


def test_the_page_is_no_wider_than_the_window(page):
    assert page.run("document.documentElement.scrollWidth <= innerWidth")
