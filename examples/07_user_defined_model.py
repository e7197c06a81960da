"""Dynamics, cost and constraint of your own: a planar free-flyer that burns its mass away.

Each function is written once, in the vocabulary ``xp``: the solver, the replay and the proof of
clearance call it in forms of their own.
"""

import numpy as np

import berthing as bt

DATA = {"inertia_kg_m2": 2.0, "exhaust_m_s": 4.0, "most_m_s": 0.085}


def dynamics(t, x, u, p, xp):
    """x: position, velocity, angle, rate, mass; u: force in body axes, torque."""
    force = xp.rotate_plane(x[4], u[0:2])
    return xp.vector(x[2:4], force / x[6], x[5], u[2] / p["inertia_kg_m2"], -fuel(t, x, u, p, xp))


def fuel(t, x, u, p, xp):
    """Mass flow in kg/s; the small term, 1 mN squared, rounds off its corner at zero thrust."""
    return xp.sqrt(xp.sumsqr(u[0:2]) + 1e-6) / p["exhaust_m_s"]


def speed(t, x, u, p, xp):
    """At or below zero where the flyer is no faster than allowed."""
    return xp.sumsqr(x[2:4]) - p["most_m_s"] ** 2


states = ("x_m", "y_m", "vx_m_s", "vy_m_s", "angle_rad", "wz_rad_s", "mass_kg")
model = bt.UserModel(
    "free-flyer", 2, states, ("fx_n", "fy_n", "gz_nm"), dynamics,
    place=lambda x, p, xp: (x[0:2], x[4]), attitude="angle",
    rates=lambda x, p, xp: (x[2:4], x[5]), parameters=DATA,
)  # fmt: skip
limit = bt.PathConstraint("speed", bt.UserFunction("speed", speed, DATA), 1e-4, scale=0.01)
burnt = bt.RunningCost("flyer", bt.UserFunction("fuel", fuel, DATA), scale=1e-3)
still = {"velocity_m_s": np.zeros(2), "rate_rad_s": np.zeros(3)}


def body(*size_m):
    return bt.Body((bt.Part("core", bt.Box(0.5 * np.array(size_m)), bt.Pose.identity(2)),))


flyer = bt.Vehicle(
    "flyer", body(2.0, 1.0), model, bt.Limits.unbounded(7, 3),
    start=bt.End(np.zeros(2), states={"mass_kg": 4.0}, **still),
    goal=bt.End(np.array([9.0, 1.0]), **still), path_constraints=(limit,),
)  # fmt: skip
block = bt.Structure("block", body(1.0, 4.0), bt.Fixed(bt.Pose.planar(np.array([4.5, 0.0]), 0.4)))
phase = bt.Phase("main", (flyer,), bt.Horizon.fixed(150.0), bt.Cost(running=(burnt,)))
result = bt.plan(bt.Scenario("free-flyer", "", (phase,), (block,), bt.MarginPolicy(0.1)))
(last,) = result.plan.phases[0].vehicles[0].state(np.array([150.0]))
print(f"{result.outcome}, model check: {result.verification.model_check}")
print(f"{4.0 - last[6]:.3f} kg burnt, cost {result.plan.cost:.4f}")
