"""Trajectories that every sampling takes for clear, and passes a micrometre from the margin.

Each nearest approach is known in closed form, and each plan solves the dynamics. The search,
the check of the certificate and the small checkers must all say the same, the truth.
"""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from berthing.clearance.bodies import clearance
from berthing.verify.folder import read_plan, verify_folder
from berthing.verify.verification import Verification
from support.attacks import CHECK, Flight, accepted, block, certified, edit, reseal

MARGIN = 0.1
FINE_GRID = 1001


def sampled(folder: Path) -> float:
    """The least distance at every node and at every sample of a fine grid."""
    whole, plan = read_plan(folder)
    own, (flown,) = whole.phases[0].vehicles[0], plan.phases[0].vehicles
    t = np.union1d(np.linspace(flown.t0_s, flown.t1_s, FINE_GRID), plan.nodes[0].times_s)
    poses = own.model.pose(flown.state(t))
    (wall,) = whole.structures
    still = wall.motion.pose(np.zeros(1))[0]
    return min(clearance(own.body, poses[i], wall.body, still)[0].distance for i in range(len(t)))


def agree(folder: Path, expected: bool) -> Verification:
    """All three checks say ``expected``; what ``berthing verify --search`` finds."""
    found = verify_folder(folder, search=True)
    answers = {"verify": certified(folder), "small": accepted(folder)}
    said = {name: answer[0] for name, answer in answers.items()} | {"search": found.certified}
    assert said == dict.fromkeys(said, expected), (answers, found.reasons)
    return found


def bead_through_foil() -> tuple[Flight, list[dict]]:
    """0.5 mm through 1 mm in a few milliseconds, between two samples of a grid of 10 ms."""
    shape = {"type": "sphere", "radius_m": 5e-4}
    return Flight(shape, (-5.005, 0, 0), (1, 0, 0)), [block((1e-3, 4, 4), (0, 0, 0))]


def needle_through_foil() -> tuple[Flight, list[dict]]:
    """A needle that spins, its tip crossing a foil between two samples."""
    shape = {"type": "box", "size_m": [6, 2e-3, 2e-3]}
    # The tip, 3 m out, turns at 6 m/s; it is at the foil, at angle π/2, half way between samples.
    rate = 0.5 * np.pi / 5.005
    return Flight(shape, (0, 0, 0), (0, 0, 0), rate_rad_s=rate), [
        block((1e-4, 0.01, 0.01), (0, 2.995, 0))
    ]


@pytest.mark.parametrize("make_case", [bead_through_foil, needle_through_foil])
def test_tunnelling(make_case, tmp_path: Path) -> None:
    flight, structures = make_case()
    margin = 5e-4
    flight.write(tmp_path / "plan", structures, margin)
    assert sampled(tmp_path / "plan") > margin
    assert "is short of" in agree(tmp_path / "plan", False).reasons[0]


def reach(half: np.ndarray) -> float:
    """How far the corner of a box that spins about z gets."""
    return float(np.hypot(half[0], half[1]))


def spinning_box(by_m: float) -> tuple[Flight, list[dict]]:
    """A slender box that spins beside a face; its corner sweeps ``by_m`` inside the margin."""
    half = np.array([3.0, 0.05, 0.05])
    height = reach(half) + MARGIN - by_m
    shape = {"type": "box", "size_m": (2 * half).tolist()}
    flight = Flight(shape, (0, 0, 0), (0, 0, 0), rate_rad_s=0.5, segments=5)
    return flight, [block((20, 2, 20), (0, height + 1, 0))]


def passing_ball(by_m: float) -> tuple[Flight, list[dict]]:
    """Past an edge, nearest for an instant."""
    side = 0.5 + MARGIN - by_m
    flight = Flight({"type": "sphere", "radius_m": 0.5}, (-6, 1 + side, 0), (1.2, 0, 0))
    return flight, [block((0.2, 2, 2), (0, 0, 0))]


def sliding_cylinder(by_m: float) -> tuple[Flight, list[dict]]:
    """Along a face, rolling, the same line of it nearest all the while."""
    shape = {"type": "cylinder", "radius_m": 0.5, "length_m": 1, "axis": "z"}
    height = 1 + 0.5 + MARGIN - by_m
    flight = Flight(
        shape, (-3, height, 0), (0.1, 0, 0), rate_rad_s=0.008, duration_s=20.0, segments=4
    )
    return flight, [block((20, 2, 20), (0, 0, 0))]


def sliding_box(by_m: float) -> tuple[Flight, list[dict]]:
    """For a minute along a face, four corners nearest at once."""
    shape = {"type": "box", "size_m": [2, 1, 1]}
    height = 1 + 0.5 + MARGIN - by_m
    flight = Flight(shape, (-3, height, 0), (0.1, 0, 0), duration_s=60.0)
    return flight, [block((20, 2, 20), (0, 0, 0))]


CLOSE = {
    "spinning box": spinning_box,
    "passing ball": passing_ball,
    "sliding cylinder": sliding_cylinder,
    "sliding box": sliding_box,
}


@pytest.mark.parametrize("by_m", [1e-6, pytest.param(1e-3, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", CLOSE)
def test_inside_the_margin(name: str, by_m: float, tmp_path: Path) -> None:
    flight, structures = CLOSE[name](by_m)
    flight.write(tmp_path / "plan", structures, MARGIN)
    (pair,) = agree(tmp_path / "plan", False).pairs
    assert pair.verdict == "violated"
    assert 0.0 < pair.depth_m <= by_m + 1e-8


@pytest.mark.parametrize("name", CLOSE)
def test_outside_the_margin(name: str, tmp_path: Path) -> None:
    flight, structures = CLOSE[name](-1e-6)
    flight.write(tmp_path / "plan", structures, MARGIN)
    (pair,) = agree(tmp_path / "plan", True).pairs
    assert MARGIN <= pair.lower_bound_m <= MARGIN + 1e-6


@pytest.mark.parametrize(
    "name", ["passing ball", *(pytest.param(n, marks=pytest.mark.slow) for n in [*CLOSE][2:])]
)
def test_the_certificate_of_a_safe_twin(name: str, tmp_path: Path) -> None:
    """The proof of a plan a millimetre further out, under the plan that is too near."""
    folder, twin = tmp_path / "plan", tmp_path / "twin"
    for target, by_m in ((folder, 1e-6), (twin, -1e-3)):
        flight, structures = CLOSE[name](by_m)
        flight.write(target, structures, MARGIN)
    shutil.copy(twin / "certificate.json", folder)
    reseal(folder)
    assert not certified(folder)[0]
    assert not accepted(folder)[0]

    def humble(document: dict) -> None:
        """Nor where its bounds are no more than what is required."""
        for row in document["phases"][0]["pairs"][0]["intervals"]:
            row[2] = MARGIN

    edit(folder / "certificate.json", humble)
    assert "not proven" in certified(folder)[1]
    assert not accepted(folder)[0]


def test_a_margin_of_nothing_is_not_proven_by_no_normal(tmp_path: Path) -> None:
    """n = 0 gives the plane bound 0 whatever the bodies do; here one goes through the other."""
    flight, structures = sliding_box(0.0)
    flight = replace(flight, start_m=(-3, 1.2, 0))
    flight.write(tmp_path / "plan", structures, 0.0)

    def blank(document: dict) -> None:
        phase = document["phases"][0]
        rows = [[t, t + 6.0, 0.0] + [0.0] * 6 for t in np.arange(0.0, 60.0, 6.0)]
        phase["pairs"] = [{"pair": "craft.hull|block.face", "intervals": rows}]
        phase["tubes"][0].update(position_m=0.0, attitude_rad=0.0)

    edit(tmp_path / "plan" / "certificate.json", blank)
    assert "not proven" in certified(tmp_path / "plan")[1]
    with pytest.raises(ValueError, match="nothing proves"):
        CHECK(str(tmp_path / "plan"))
