"""Which pairs of a phase the certificate is of, body by body, and how those bodies move."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.scenario.motion import Fixed
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory
from berthing.verify.body_motion import BodyMotion
from berthing.verify.frames import structure_motion, vehicle_motion
from berthing.verify.pair_motion import BodyPair
from berthing.verify.part_pair import PartPair

# All structures at rest share one frame.
INERTIAL = ""

Windows = Mapping[str, Sequence[tuple[float, float, float | None]]]


class Motions:
    """Motions of the frames of one phase over ``span_s``, each built once.

    Args:
        of_vehicle: builds that of a vehicle.
    """

    def __init__(
        self, span_s: tuple[float, float], of_vehicle: Callable[[Vehicle], BodyMotion]
    ) -> None:
        self.span_s, self._of_vehicle = span_s, of_vehicle
        self._built: dict[str, BodyMotion] = {}

    @staticmethod
    def along(trajectory: PhaseTrajectory) -> Motions:
        """As the interpolants of the phase say."""
        return Motions(
            (trajectory.t0_s, trajectory.t1_s),
            lambda own: vehicle_motion(own.model, trajectory.vehicle(own.name)),
        )

    def bodies(self, pair: Pair) -> BodyPair:
        """The two bodies of a pair.

        Raises:
            UnboundedAttitudeError: a quaternion comes near zero.
            CapabilityError: a model or law that is not known here.
        """
        return BodyPair(self._of(pair.owner_a), self._of(pair.owner_b))

    def _of(self, owner: Vehicle | Structure) -> BodyMotion:
        if owner.name not in self._built:
            self._built[owner.name] = self._build(owner)
        return self._built[owner.name]

    def _build(self, owner: Vehicle | Structure) -> BodyMotion:
        if _rests(owner):
            return structure_motion(Fixed(Pose.identity()), self.span_s)
        if isinstance(owner, Structure):
            return structure_motion(owner.motion, self.span_s)
        return self._of_vehicle(owner)


def windows_of(scenario: Scenario, phase: Phase, span_s: tuple[float, float]) -> Windows:
    """Of every pair of the phase, by name, the span cut where its margin changes."""
    margins = scenario.margins
    return {p.name: margins.windows(p.ref_a, p.ref_b, span_s) for p in scenario.pairs(phase)}


def by_bodies(pairs: Sequence[Pair], windows: Windows) -> list[list[Pair]]:
    """Pairs that some margin concerns, those of the same two bodies together."""
    groups: dict[tuple[str, str], list[Pair]] = {}
    for pair in pairs:
        if any(margin is not None for _, _, margin in windows[pair.name]):
            groups.setdefault((pair.owner_a.name, frame_of(pair)), []).append(pair)
    return list(groups.values())


def frame_of(pair: Pair) -> str:
    """Name of the body in whose frame the pair is seen: the second, or ``INERTIAL``."""
    return INERTIAL if _rests(pair.owner_b) else pair.owner_b.name


def parts_of(pair: Pair) -> PartPair:
    """The two parts, the second in the frame that it is seen in."""
    owner, part = pair.owner_b, pair.part_b
    if isinstance(owner, Structure) and isinstance(owner.motion, Fixed):
        part = Part(part.name, part.shape, owner.motion.fixed_pose.compose(part.placement))
    return PartPair(pair.part_a, part)


def _rests(owner: Vehicle | Structure) -> bool:
    return isinstance(owner, Structure) and isinstance(owner.motion, Fixed)
