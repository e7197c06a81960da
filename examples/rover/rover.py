"""A car in the plane, with a cost and a constraint; ``rover.yaml`` names what is here."""

from berthing import UserModel


def derivative(t, x, u, p, xp):
    """x: position, heading, speed, steering angle; u: acceleration, rate of steering."""
    return xp.vector(*_along(x, xp), x[3] * xp.tan(x[4]) / p["wheelbase_m"], u)


def _along(x, xp):
    return x[3] * xp.cos(x[2]), x[3] * xp.sin(x[2])


rover = UserModel(
    "rover", 2, ("x_m", "y_m", "angle_rad", "speed_m_s", "steering_rad"),
    ("throttle_m_s2", "steer_rad_s"), derivative,
    place=lambda x, p, xp: (x[0:2], x[2]), attitude="angle",
    rates=lambda x, p, xp: (xp.vector(*_along(x, xp)), x[3] * xp.tan(x[4]) / p["wheelbase_m"]),
    assemble_state=lambda r, angle, v, rate, p: [*r, angle, (v @ v) ** 0.5, 0.0],
)  # fmt: skip


def swerve(t, x, u, p, xp):
    """Steering costs."""
    return p["weight"] * x[4] ** 2


def sideways(t, x, u, p, xp):
    """At or below zero where the wheels hold, to the left and to the right."""
    pull = x[3] ** 2 * xp.tan(x[4])
    return xp.vector(pull - p["most_m_s2"], -pull - p["most_m_s2"])
