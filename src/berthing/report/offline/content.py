"""What the page draws, as JSON: every plan of it, and the arrays that they refer to."""

from __future__ import annotations

from typing import Any

import numpy as np

from berthing.report.offline.clock import motion_times
from berthing.report.offline.motions import packed_structure, packed_track
from berthing.report.offline.packing import Packing
from berthing.report.offline.separations import packed_separations
from berthing.report.track import tracks
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.verify.claims import Claims
from berthing.verify.optimality import hamiltonian
from berthing.verify.verification import Verification

SCHEMA_VERSION = 1


class Content:
    """Plans are added one by one, sharing arrays; costly, so done before the clock is read."""

    def __init__(self) -> None:
        self._packing = Packing()
        self._plans: list[dict[str, Any]] = []

    def add(
        self,
        label: str,
        scenario: Scenario,
        plan: Plan,
        verification: Verification,
        claims: Claims,
    ) -> None:
        """Add a plan; scenario, verification and claims must be its own."""
        packing = self._packing
        marked = [pair.time_s for pair in verification.pairs]
        times = {p.phase: motion_times(scenario, plan, p) for p in plan.phases}
        own = {(p.phase, v.vehicle): v for p in plan.phases for v in p.vehicles}
        whole = np.unique(np.concatenate(list(times.values())))
        self._plans.append(
            {
                "label": label,
                "dim": scenario.dim,
                "span": [plan.phases[0].t0_s, plan.phases[-1].t1_s],
                "closest_time": verification.closest_time_s,
                "tracks": [
                    packed_track(
                        track, own[track.phase, track.vehicle.name], times[track.phase], packing
                    )
                    for track in tracks(scenario, plan)
                ],
                "structures": [packed_structure(s, whole, packing) for s in scenario.structures],
                "separations": [
                    packed_separations(scenario, p, marked, claims.phase(p.phase), packing)
                    for p in plan.phases
                ],
                "hamiltonian": _packed_hamiltonian(scenario, plan, packing),
            }
        )

    def to_json(self) -> dict[str, Any]:
        """Everything added so far."""
        return {
            "schema_version": SCHEMA_VERSION,
            "plans": self._plans,
            "buffers": self._packing.buffers,
        }


def _packed_hamiltonian(scenario: Scenario, plan: Plan, packing: Packing) -> list[dict[str, Any]]:
    found = []
    for phase in scenario.phases:
        nodes = [n for n in plan.nodes if n.phase == phase.name]
        times, values = hamiltonian(phase, nodes)
        found.append({"phase": phase.name, "t": packing.exact(times), "h": packing.exact(values)})
    return found
