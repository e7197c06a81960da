"""The certificate of a plan, of straight legs between states."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.scenario.motion import Fixed
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.verify.bisection import Bisection
from berthing.verify.bounds import Bounds
from berthing.verify.certificate import Certificate, certify_motions
from berthing.verify.grouping import Motions, by_bodies, parts_of
from berthing.verify.leaves import Intervals, Status
from berthing.verify.leg_motion import LegMotion
from berthing.verify.pair_motion import BodyPair
from berthing.verify.part_pair import PartPair
from berthing.verify.settings import DEFAULT_CERTIFICATE, CertificateSettings
from berthing.verify.verdict import CERTIFIED, EXEMPT

# Beyond this the shorter way of turning hangs on rounding, and readers of a route might turn the
# other way (rad).
WIDEST_TURN = 3.14


@dataclass(frozen=True)
class Legs:
    """What is proven of n legs.

    Attributes:
        bound_m: below the clearance of every pair at every instant of the leg (n,).
        excess_m: the least of bound less margin over the pairs (n,); +∞ where there are none.
        certified: every pair keeps its margin all the way.
        faults: why not, each with pair, leg and amount.
        trouble: where margins are broken or cannot be shown to hold, as numbers of legs and
            fractions: 2.25 is a quarter into leg 2.
        closest: pair, such a number, and distance of the least distance met; None without pairs.
    """

    bound_m: Array
    excess_m: Array
    certified: bool
    faults: tuple[str, ...]
    trouble: tuple[float, ...]
    closest: tuple[str, float, float] | None


def strictest(scenario: Scenario, phase: Phase) -> dict[Pair, float]:
    """The largest margin that each pair ever has; without those that may always touch.

    Whoever moves along a path does so at times that the path does not know.
    """
    end = sum(own.horizon.max_s for own in scenario.phases)
    found = {}
    for pair in scenario.pairs(phase):
        windows = scenario.margins.windows(pair.ref_a, pair.ref_b, (0.0, end))
        margins = [margin for _, _, margin in windows if margin is not None]
        if margins:
            found[pair] = max(margins)
    return found


def require_rest(scenario: Scenario) -> None:
    """Refuse structures that move: a path without times cannot keep clear of them.

    Raises:
        InputError: names the first one.
    """
    for structure in scenario.structures:
        if not isinstance(structure.motion, Fixed):
            what = f"moves ({structure.motion.kind}), and a path has no times"
            raise InputError(structure.name, what, "structures at rest")


def certify_legs(
    scenario: Scenario,
    phase: Phase,
    starts: Array,
    ends: Array,
    settings: CertificateSettings = DEFAULT_CERTIFICATE,
) -> Legs:
    """Prove the clearance of every pair along the legs between states (n, V, 7), n ≥ 1.

    On a leg each vehicle's reference point moves straight, and its attitude turns at a constant
    rate about a fixed axis, the shorter way, all in step.

    Raises:
        InputError: a structure that moves, or a leg that turns by half a turn.
        CapabilityError: a shape that the certificate does not know.
    """
    require_rest(scenario)
    legs = len(starts)
    paths = leg_motions(phase.vehicles, starts, ends)
    _check_turns(paths)
    margins = {pair.name: margin for pair, margin in strictest(scenario, phase).items()}
    span = (0.0, float(legs))
    windows = {p.name: [(*span, margins.get(p.name))] for p in scenario.pairs(phase)}
    motions = Motions(span, lambda own: paths[own.name])
    # What is not a number, as the middle of a half-space's ball, proves nothing.
    with np.errstate(all="ignore"):
        return _read(certify_motions(scenario, phase, motions, windows, settings), legs)


class LegProver:
    """Yes or no, for planners that ask of thousands of motions.

    The search of the certificate without its record: no bounds of legs, no closest instant, and
    what rests is made ready once.

    Args:
        scenario: at rest.
        phase: of it.
    """

    def __init__(self, scenario: Scenario, phase: Phase) -> None:
        margins = strictest(scenario, phase)
        self._vehicles = phase.vehicles
        windows = {pair.name: [(0.0, 1.0, margin)] for pair, margin in margins.items()}
        self._groups = [
            (group[0], [*map(parts_of, group)], np.array([margins[pair] for pair in group]))
            for group in by_bodies(list(margins), windows)
        ]

    def clear(self, start: Array, end: Array) -> bool:
        """Whether the leg between two states (V, 7) is certified, and less than half a turn."""
        paths = leg_motions(self._vehicles, start[None], end[None])
        if any(np.any(path.ceilings.rate > WIDEST_TURN) for path in paths.values()):
            return False
        motions = Motions((0.0, 1.0), lambda own: paths[own.name])
        with np.errstate(all="ignore"):
            return all(
                self._proven(motions.bodies(first), parts, own)
                for first, parts, own in self._groups
            )

    @staticmethod
    def _proven(bodies: BodyPair, parts: list[PartPair], margins: Array) -> bool:
        exact = [0.0] * len(parts)
        bounds = Bounds(bodies, parts, exact, DEFAULT_CERTIFICATE)
        zeros = np.zeros(len(parts))
        roots = Intervals.unasked(np.arange(len(parts)), zeros, zeros + 1.0, margins)
        leaves, _ = Bisection(bounds, exact, DEFAULT_CERTIFICATE).run(roots)
        return bool(np.all(leaves.status == int(Status.CERTIFIED)))


def leg_motions(vehicles: Sequence[Vehicle], starts: Array, ends: Array) -> dict[str, LegMotion]:
    """By vehicle."""
    return {own.name: LegMotion(starts[:, i], ends[:, i]) for i, own in enumerate(vehicles)}


def _check_turns(paths: Mapping[str, LegMotion]) -> None:
    for name, path in paths.items():
        wide = np.flatnonzero(path.ceilings.rate > WIDEST_TURN)
        if len(wide):
            angle = path.ceilings.rate[wide[0]]
            what = f"turns by {angle:.6g} rad: either way is as short"
            raise InputError(f"leg {wide[0]} of {name}", what, f"{WIDEST_TURN} rad at most")


def _read(found: Certificate, legs: int) -> Legs:
    bound, excess = np.full(legs, np.inf), np.full(legs, np.inf)
    for own in found.evidence:
        leaves = own.leaves
        leg = np.minimum(0.5 * (leaves.t0 + leaves.t1), legs - 0.5).astype(np.intp)
        np.minimum.at(bound, leg, leaves.bound)
        np.minimum.at(excess, leg, leaves.bound - leaves.required)
    bad = [v for v in found.verdicts if v.verdict not in (CERTIFIED, EXEMPT)]
    trouble = sorted({t for v in bad for t in (v.violations_s or (v.time_s,))})
    faults = tuple(v.reason.replace("t = ", "leg ").replace(" s]", "]") for v in bad)
    return Legs(bound, excess, not bad, faults, tuple(trouble), found.closest)
