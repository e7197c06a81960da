"""What pages do whatever the plan, on plans made by hand."""

import re
from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.body import Body, Part
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.motion import Fixed
from berthing.scenario.structure import Structure
from berthing.verify.claims import Claims
from support import synthetic
from support.page_reading import cursors, is_drawn, pixels, positions, seek, time_of

pytestmark = pytest.mark.browser

TWO = (synthetic.spacecraft(), synthetic.spacecraft("tug", (0.0, 6.0, 2.0)))
# A span of 150 s has 200 steps.
STEP_S = 0.75


@pytest.fixture(scope="module")
def path(handmade):
    return handmade("one", synthetic.scenario())


def text(page, selector):
    return page.run(f"document.querySelector({selector!r}).textContent")


def test_a_request_and_an_error_would_be_noticed(opened, tmp_path):
    path = tmp_path / "bad.html"
    path.write_text(
        "<html data-ready=true><img src='http://127.0.0.1:9/x.png'><script>oops()</script>"
    )
    page = opened(path)
    page.wait("document.images[0].complete")
    page.settle()
    assert any(url.startswith("http:") for url in page.requests)
    assert any("oops" in trouble for trouble in page.troubles)


def test_without_webgl_the_scene_is_blank_and_the_rest_works(opened, path):
    page = opened(path, before="HTMLCanvasElement.prototype.getContext = (old => function (kind) {"
                  " return kind === '2d' ? old.call(this, kind) : null; })"
                  "(HTMLCanvasElement.prototype.getContext);")  # fmt: skip
    assert not is_drawn(pixels(page, "#canvas"))
    assert "no WebGL" in text(page, "#trouble")
    assert list(cursors(page).values()) == pytest.approx([0.0] * 8, abs=0.01)
    seek(page, 0.5)
    assert list(cursors(page).values()) == pytest.approx([0.5] * 8, abs=0.01)


def test_without_scripts_the_verdict_can_be_read(opened, path):
    page = opened(path, scripts=False)
    image = pixels(page, "#verdict")
    assert np.mean(image < 0.5) > 0.01
    assert page.troubles == []


def test_keys_drive_the_time(opened, path):
    page = opened(path)
    page.press("ArrowRight")
    assert time_of(page) == pytest.approx(STEP_S)
    page.press("ArrowRight", shift=True)
    assert time_of(page) == pytest.approx(11 * STEP_S)
    page.press("ArrowLeft")
    assert time_of(page) == pytest.approx(10 * STEP_S)
    page.press("End")
    assert time_of(page) == 150.0
    page.press(",")
    assert time_of(page) == pytest.approx(150.0 - 3.75)
    page.press("Home")
    page.press(".")
    assert time_of(page) == pytest.approx(3.75)
    page.press("c")
    assert time_of(page) == 52.0


def test_space_plays_at_the_speed_chosen_and_stops_at_the_end(opened, path):
    page = opened(path)
    page.press("]")
    assert page.run("document.getElementById('speed').value") == "20"
    page.run("document.getElementById('speed').value = '10000',"
             "document.getElementById('speed').dispatchEvent(new Event('change'))")  # fmt: skip
    page.press(" ")
    page.wait("document.getElementById('time').value === '150'", 10)
    assert page.run("document.getElementById('play').getAttribute('aria-label')") == "Play"
    page.press("Home")
    page.run("document.getElementById('speed').value = '1',"
             "document.getElementById('speed').dispatchEvent(new Event('change'))")  # fmt: skip
    page.press(" ")
    page.wait("Number(document.getElementById('time').value) > 0.3", 20)
    page.press(" ")
    stopped = time_of(page)
    page.settle()
    assert time_of(page) == stopped


def test_keys_in_the_scene_turn_it_and_not_the_time(opened, path):
    page = opened(path)
    before = pixels(page, "#canvas")
    page.run("document.getElementById('canvas').focus()")
    page.press("ArrowLeft")
    page.press("+")
    assert time_of(page) == 0.0
    assert np.mean(np.abs(pixels(page, "#canvas") - before)) > 0.005


def test_everything_is_reached_by_the_tab_key(opened, path):
    page = opened(path)
    reached = set()
    for _ in range(60):
        page.press("Tab")
        reached.add(page.run("document.activeElement.id || document.activeElement.className"))
    assert {"skip", "camera", "canvas", "start", "play", "closest", "time", "speed"} <= reached
    assert {"zoom", "whole", "near", "seek"} <= reached


def test_lines_are_switched_off_by_keys(opened, path):
    page = opened(path)
    name = "document.querySelectorAll('#plot-position .u-series > th')[1]"
    page.run(f"{name}.focus()")
    assert page.run(f"{name}.getAttribute('aria-pressed')") == "true"
    page.press("Enter")
    assert page.run(f"{name}.getAttribute('aria-pressed')") == "false"
    assert time_of(page) == 0.0


def test_a_click_in_a_plot_goes_there_and_a_drag_zooms_all(opened, path):
    page = opened(path)
    over = page.rect("#plot-velocity .u-over")
    page.click(over["x"] + 0.5 * over["width"], over["y"] + 40)
    assert time_of(page) == pytest.approx(75.0, abs=1.0)
    over = page.rect("#plot-velocity .u-over")
    page.drag(
        over["x"] + 0.4 * over["width"], over["y"] + 40,
        over["x"] + 0.8 * over["width"], over["y"] + 40,
    )  # fmt: skip
    assert time_of(page) == pytest.approx(75.0, abs=1.0)
    over = page.rect("#plot-velocity .u-over")
    page.move(over["x"] + 0.8 * over["width"], over["y"] + 40)
    assert list(cursors(page).values()) == pytest.approx([0.8] * 8, abs=0.03)
    page.move(2, 2)
    # 75 s lies a quarter of the way between 60 and 120 s.
    assert list(cursors(page).values()) == pytest.approx([0.25] * 8, abs=0.03)
    page.run("document.getElementById('whole').click()")
    assert list(cursors(page).values()) == pytest.approx([0.5] * 8, abs=0.02)


def test_the_camera_follows_the_vehicle(opened, path):
    page = opened(path)
    page.run("document.getElementById('camera').value = 'follow 0',"
             "document.getElementById('camera').dispatchEvent(new Event('change'))")  # fmt: skip
    for share in (0.1, 0.9):
        seek(page, share)
        image = pixels(page, "#canvas")
        height, width, _ = image.shape
        middle = image[height // 3 : 2 * height // 3, width // 3 : 2 * width // 3]
        # The vehicle is the one thing that is blue.
        assert np.mean(middle[..., 2] - middle[..., 0] > 0.3) > 0.1


def test_layers_can_be_hidden(opened, path):
    page = opened(path)
    seek(page, 0.35)
    before = pixels(page, "#canvas")
    for index in range(5):
        page.run(f"document.querySelectorAll('#layers input')[{index}].click()")
        page.settle()
        after = pixels(page, "#canvas")
        assert np.any(np.abs(after - before) > 0.05)
        before = after
    assert page.run("document.getElementById('tag').hidden")


def test_dark_where_the_reader_has_it_dark(opened, path):
    for dark in (False, True):
        page = opened(path, dark=dark)
        for selector in ("body", "#canvas", "#plot-position"):
            median = np.median(pixels(page, selector))
            assert median < 0.2 if dark else median > 0.8
        assert is_drawn(pixels(page, "#canvas"))


def test_a_change_of_mind_about_the_dark_is_followed(opened, path):
    page = opened(path)
    seek(page, 0.5)
    page.call(
        "Emulation.setEmulatedMedia",
        features=[{"name": "prefers-color-scheme", "value": "dark"}],
    )
    page.settle()
    assert np.median(pixels(page, "#canvas")) < 0.2
    assert is_drawn(pixels(page, "#canvas"))
    assert time_of(page) == pytest.approx(75.0, abs=1.5)
    assert page.troubles == []


def test_what_is_seen_is_also_said(opened, path):
    page = opened(path)
    seek(page, 0.4)
    page.wait("document.getElementById('spoken').textContent.includes('closest')")
    assert re.match(r"\d+\.\d\d s: spacecraft at .* m; closest spacecraft\.hull – block\.core, ",
                    text(page, "#spoken"))  # fmt: skip
    assert "spacecraft" in page.run("document.getElementById('canvas').ariaLabel")
    summary = text(page, "#plot-control-0 .hidden")
    assert "Force, in N: fx from" in summary
    assert "levels at −0.02, 0.02" in summary
    unnamed = page.run(
        "[...document.querySelectorAll('button, input, select, canvas:not([aria-hidden])')]"
        ".filter(e => !(e.ariaLabel || e.textContent.trim() || e.labels?.length))"
        ".map(e => e.outerHTML)"
    )
    assert unnamed == []


def test_several_vehicles_are_told_apart(opened, handmade):
    page = opened(handmade("two", synthetic.scenario(TWO)))
    assert set(positions(page)) == {"spacecraft", "tug"}
    image = pixels(page, "#canvas")
    assert np.mean(image[..., 2] - image[..., 0] > 0.3) > 0.001
    assert np.mean(image[..., 0] - image[..., 2] > 0.5) > 0.001
    page.run("document.querySelectorAll('#shown input')[1].click()")
    labels = page.run("[...document.querySelectorAll('#plot-position .u-label')]"
                      ".map(e => e.textContent)")  # fmt: skip
    assert labels == ["t", "x", "y", "z"]


def test_structures_that_move_are_moved(opened, handmade):
    # Nothing else may move: the vehicle is far away, and its trail and closest points are hidden.
    page = opened(handmade("spin", synthetic.scenario()))
    for index in (1, 2, 3):
        page.run(f"document.querySelectorAll('#layers input')[{index}].click()")
    page.run("document.getElementById('camera').value = 'top',"
             "document.getElementById('camera').dispatchEvent(new Event('change'))")  # fmt: skip
    seek(page, 0.98)
    before = pixels(page, "#canvas")
    page.press("End")
    after = pixels(page, "#canvas")
    changed = np.any(np.abs(after - before) > 0.1, axis=-1)
    blue = (before[..., 2] - before[..., 0] > 0.2) | (after[..., 2] - after[..., 0] > 0.2)
    assert np.sum(changed & ~blue) > 20


def test_the_plane_is_seen_from_above(opened, handmade):
    page = opened(handmade("planar", synthetic.planar_scenario()), "phone")
    assert is_drawn(pixels(page, "#canvas"))
    cameras = page.run("[...document.getElementById('camera').options].map(o => o.text)")
    assert cameras == ["Overview", "Follow puck"]
    seek(page, 0.5)
    assert positions(page)["puck"] == pytest.approx([2.0, 1.0, 0.0], abs=0.05)
    labels = page.run("[...document.querySelectorAll('#plot-position .u-label')]"
                      ".map(e => e.textContent)")  # fmt: skip
    assert labels == ["t", "x", "y"]
    assert page.troubles == []


def test_phases_follow_each_other(opened, handmade):
    page = opened(handmade("phases", synthetic.two_phase_scenario()))
    page.press("End")
    assert time_of(page) == 300.0
    assert positions(page)["spacecraft"] == pytest.approx([20.0, 6.0, 0.0], abs=1e-3)
    assert page.run("document.querySelectorAll('#ticks .phase').length") == 1
    assert page.troubles == []


def test_of_nothing_around_the_page_says_so(opened, handmade):
    page = opened(handmade("free", synthetic.scenario(structures=())))
    assert "Nothing to keep clear of." in text(page, "#pairs")
    assert "Nothing to keep clear of." in text(page, "#plot-clearance")
    assert is_drawn(pixels(page, "#canvas"))
    assert page.troubles == []


def test_a_hundred_thousand_triangles_are_drawn_as_fewer_and_the_page_says_so(opened, handmade):
    turns = 2.0 * np.pi * np.arange(80) / 80.0
    ring = [Pose(np.array([5.0 + np.cos(a), np.sin(a), -2.0]), np.eye(3)) for a in turns]
    parts = tuple(Part(f"bead{i}", Sphere(0.3), pose) for i, pose in enumerate(ring))
    beads = Structure("ring", Body(parts), Fixed(Pose.identity(3)))
    of = synthetic.scenario(structures=(beads,))
    path = handmade("ring", of, claims=lambda _: Claims("", ()))
    page = opened(path)
    assert path.stat().st_size < 2_000_000
    assert "fewer triangles than the shapes have" in text(page, "#coarse")
    assert page.run("document.getElementById('coarse').hidden") is False
    assert is_drawn(pixels(page, "#canvas"))
    assert page.troubles == []


def test_shapes_drawn_as_they_are_need_no_word_about_it(opened, path):
    assert opened(path).run("document.getElementById('coarse').hidden") is True


def test_what_is_wrong_comes_first(opened, handmade):
    page = opened(handmade("bad", synthetic.scenario(), certified=False))
    assert text(page, ".badge") == "NOT certified"
    assert "is short of 0.1 m" in text(page, "#verdict .banner")


def test_plans_are_compared_in_one_scene(opened, handmade):
    other = replace(synthetic.scenario(), name="other")
    page = opened(handmade("both", synthetic.scenario(), other))
    assert text(page, "#verdict thead").strip() == "syntheticother"
    assert set(positions(page)) == {"synthetic", "other"}
    labels = page.run("[...document.querySelectorAll('#plot-clearance .u-label')]"
                      ".map(e => e.textContent)")  # fmt: skip
    assert len(labels) == 1 + 2 * 3
    assert is_drawn(pixels(page, "#canvas"))
    assert page.troubles == []


def test_names_are_text_and_nothing_else(opened, handmade):
    evil = "</script><img src=http://127.0.0.1:9/x onerror=document.title='owned'>"
    of = replace(synthetic.scenario(), name=evil, description=evil)
    page = opened(handmade("evil", of))
    assert text(page, "h1") == evil
    assert page.run("document.images.length") == 0
    assert "owned" not in page.run("document.title").replace(evil, "")
    assert len(page.requests) == 1
    assert page.troubles == []


def test_no_script_but_the_bundle_runs(opened, handmade):
    path = handmade("patched", synthetic.scenario())
    path.write_text(path.read_text().replace("<main>", "<main><script>document.title=1</script>"))
    page = opened(path)
    assert page.run("document.title") != "1"
    assert any("Content Security Policy" in trouble for trouble in page.troubles)
