"""Every tolerance of the checks, with its reason."""

from __future__ import annotations

from dataclasses import dataclass

# Start and goal must be met to this: m, rad, m/s and rad/s (solvers reach 1e-8).
BOUNDARY_TOLERANCE = 1e-6

# Largest jump of a native state where two segments meet. Segments share their end node, so what
# is left is the rounding of the coefficients; the solver's own tolerance bounds the rest.
CONTINUITY_TOLERANCE = 1e-6

# Times are written with 17 digits; sums of durations err by a few units in the last place.
TIME_TOLERANCE = 1e-9

# The replay of the exported controls must stay within this of the interpolant.
REPLAY_POSITION_TOLERANCE_M = 1e-3
REPLAY_ATTITUDE_TOLERANCE_RAD = 0.01 * 3.141592653589793 / 180.0

# Velocities and rates are columns of their own in the interpolant, and limits are checked on them,
# so they must be those of the motion. In m/s and rad/s: a hundredth of the speeds in use.
REPLAY_RATE_TOLERANCE = 1e-4

# The integrator's own tolerances: four orders below what is asked of the replay over 1e4 steps.
REPLAY_RELATIVE = 1e-10
REPLAY_ABSOLUTE = 1e-11

# An estimate of the replay's own error, added to the tube around the interpolant: ten times what
# was found on the shipped cases against an integration at 1e-13. It is not proven.
INTEGRATOR_POSITION_M = 1e-8
INTEGRATOR_ATTITUDE_RAD = 1e-9

# A claim in certificate.json that exceeds what is found by more than this is false; rounding on
# another machine is far less. Tubes: m and rad.
CLAIM_TOLERANCE_M = 1e-9
TUBE_TOLERANCE = 1e-9

# Limits, relative to their size. A solver meets a scaled row to about 1e-8; an actuator's limit
# is not known to six digits.
LIMIT_RELATIVE_TOLERANCE = 1e-6

# Between nodes the norm of an interpolated quaternion may leave 1 by this. Poses normalise it, so
# that it costs no clearance; more than this says that the attitude is not resolved.
QUATERNION_NORM_TOLERANCE = 1e-3

# A table that is derived from the interpolant and printed with 17 digits agrees to rounding; this
# leaves room for tables printed with ten.
TABLE_TOLERANCE = 1e-8

# Distances of two implementations of one query agree to this; an end nearer than its margin by
# less is accepted.
ENDPOINT_TOLERANCE_M = 1e-9


@dataclass(frozen=True)
class CertificateSettings:
    """How hard the certificate tries before it gives up.

    Attributes:
        violation_m: a sample this much nearer than required is a violation. GJK at 1e-10 errs
            by less than 1e-9 on bodies of some metres.
        depth_m: the depth of a violation is found to this, in metres.
        undecided_m: an interval with a sample that clears the requirement by no more than this,
            and a bound that misses it by no more, is left undecided: bisection never ends where
            clearance equals the requirement.
        undecided_s: nor is an interval split below this length.
        max_intervals: over one pair of bodies at one depth; the rest is left undecided. A slide
            of an hour at 1e-6 m needs fewer.
        float_slack: rounding of positions, supports and plane bounds, relative to the lengths
            that enter. Most comes from the recurrence of Chebyshev polynomials, which errs by the
            square of the degree in units of 1.1e-16; this is twice what degree 90 needs.
        motion_inflation: the bounds on motion are enlarged by this factor: they are computed in
            floating point too, and others who check the certificate may have bounds that are a
            little wider. It costs half as much in the number of intervals.
    """

    violation_m: float = 1e-8
    depth_m: float = 1e-3
    undecided_m: float = 1e-7
    undecided_s: float = 1e-7
    max_intervals: int = 200_000
    float_slack: float = 2e-12
    motion_inflation: float = 1.01


DEFAULT_CERTIFICATE = CertificateSettings()

# Checking a certificate that was found with the settings above: what must be allowed for, and no
# more, so that rounding does not decide.
CHECKED_CERTIFICATE = CertificateSettings(float_slack=1e-12, motion_inflation=1.0 + 1e-9)
