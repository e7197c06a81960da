"""Where and when separation is asked for."""

from __future__ import annotations

import numpy as np

from berthing.transcription.mesh import Mesh
from berthing.transcription.sites import Site, node_sites, site_margins, site_times
from support.documents import box, puck, scenario, structure

MESH = Mesh("lgr", (0.0, 0.25, 1.0), (3, 2))


def test_every_node_but_the_first_and_the_end_besides() -> None:
    sites = node_sites(MESH, 2)
    assert len(sites) == len(set(sites)) == 2 * (3 + 2 - 1 + 1)
    places = {(site.segment, site.s) for site in sites}
    assert (0, -1.0) not in places
    assert {(1, -1.0), (1, 1.0)} <= places
    # A point that two segments share is asked once.
    assert (0, 1.0) not in places
    assert all((Site(k, s, 1) in sites) and (Site(k, s, 0) in sites) for k, s in places)


def test_times_are_on_the_scenarios_clock() -> None:
    sites = [Site(0, -1.0, 0), Site(0, 0.0, 0), Site(1, -1.0, 1), Site(1, 1.0, 0)]
    times = site_times(sites, MESH, 10.0, 80.0)
    np.testing.assert_allclose(times, [10.0, 20.0, 30.0, 90.0])


def test_margins_follow_the_pair_and_the_window() -> None:
    given = scenario(
        puck(),
        structures=[structure("wall", [3, 2], box(1, 1)), structure("dock", [7, 0], box(1, 1))],
        margins={"default_m": 0.1, "overrides": [
            {"between": ["puck", "dock"], "margin_m": 0.02, "window_s": [50, 100]},
            {"between": ["puck", "dock"], "contact": "allowed", "window_s": [90, 100]},
        ]},
    )  # fmt: skip
    phase = given.phases[0]
    dock = [pair.name for pair in given.pairs(phase)].index("puck.rim|dock.core")
    sites = [Site(0, 0.0, dock), Site(0, 0.0, dock), Site(0, 0.0, dock), Site(0, 0.0, 1 - dock)]
    margins = site_margins(given, phase, sites, np.array([10.0, 60.0, 95.0, 95.0]))
    assert margins == [0.1, 0.02, None, 0.1]
