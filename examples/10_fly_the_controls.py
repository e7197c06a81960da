"""Fly the controls of a plan with NumPy alone: how far from the plan does it get?

The certificate holds for whatever stays in the tubes that it names, so that this is its other half:
from the start, Newton's and Euler's equations under the exported controls must stay in the tube,
meet the goal, and respect the limits. 10_fly_the_controls.py DIR
"""

import json
import sys
from pathlib import Path

import numpy as np
from numpy.linalg import norm, solve
from numpy.polynomial import chebyshev as cheb

STEPS = 40  # of Runge and Kutta in a segment
NEAR = 1e-6  # tolerance of ends in m, rad, m/s and rad/s, and of limits, relative
STATE = ["x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s", "qw", "qx", "qy", "qz"]
STATE += ["wx_rad_s", "wy_rad_s", "wz_rad_s"]
CONTROL = ["fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm"]
R, V, Q, W = slice(0, 3), slice(3, 6), slice(6, 10), slice(10, 13)
LIMITS = {"max_speed_m_s": V, "max_rate_rad_s": W}
FORCES = {"max_force_n": slice(0, 3), "max_torque_nm": slice(3, 6)}


def need(fact, what):
    if not fact:
        raise ValueError(what)


def lift(v):
    """From the plane into space."""
    return np.append(v, np.zeros(3 - len(v)))


def skew(v):
    """The matrix of v × ·; NumPy's own product is slow with single vectors."""
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def cross(u, v):
    return skew(u) @ v


def turn(q):
    """The rotation of a quaternion of any length."""
    k = skew(q[1:])
    return np.eye(3) + 2 * (q[0] * k + k @ k) / np.dot(q, q)


def angle(P, S):
    """Between two rotations."""
    return 2 * np.arcsin(min(1, norm(P - S) / 8**0.5))


def wide(rows, names, wanted):
    """Coefficients of all columns; a point mass is a body that does not turn."""
    out = np.zeros((len(rows), len(wanted)))
    if "qw" in wanted and "qw" not in names:
        out[0, wanted.index("qw")] = 1
    out[:, [wanted.index(name) for name in names]] = rows
    return out


def value(segment, key, t):
    s = (2 * t - segment["t0_s"] - segment["t1_s"]) / (segment["t1_s"] - segment["t0_s"])
    return cheb.chebval(s, segment[key]).T


def slopes(dynamics, t, x, u):
    """The equations of motion: force and torque at the reference point, first moment c."""
    P, q, w, f, g, m = turn(x[Q]), x[Q], x[W], u[:3], u[3:], dynamics["mass_kg"]
    c = np.array(dynamics.get("first_moment_kg_m", [0, 0, 0]))
    J, k = np.array(dynamics.get("inertia_kg_m2", [1, 1, 1])), skew(c)
    J = J if J.ndim == 2 else np.diag(J)
    for arm in dynamics.get("wrenches", []):
        times, rows = arm["times_s"], (arm["force_n"], arm["torque_nm"])
        force, torque = ([np.interp(t, times, y) for y in np.transpose(row)] for row in rows)
        f, g = f + force, g + torque + cross(arm["point_m"], force)
    load = [*(f - cross(w, cross(w, c))), *(g - cross(w, J @ w))]
    a = solve(np.block([[m * np.eye(3), -k], [k, J]]), load)
    dq = [-q[1:] @ w / 2, *(q[0] * w + cross(q[1:], w)) / 2]
    return np.array([*x[V], *P @ a[:3], *dq, *a[3:]])


def fly(segments, vehicle):
    """Largest distance and angle from the plan; limits are looked at on the way."""
    x, off, tilt = value(segments[0], "state", segments[0]["t0_s"]), 0, 0
    for s in segments:
        t = np.linspace(s["t0_s"], s["t1_s"], 2 * STEPS + 1)
        u, said, h = value(s, "control", t), value(s, "state", t), t[2] - t[0]
        need(np.all(abs(norm(said[:, Q], axis=1) - 1) < 1e-3), "a quaternion is not a unit one")
        for names, rows in ((LIMITS, said), (FORCES, u)):
            for name in names.keys() & vehicle["limits"].keys():
                most = np.array(vehicle["limits"][name]) * (1 + NEAR)
                width = np.size(most) if np.ndim(most) else 3
                need(np.all(abs(rows[:, names[name]][:, :width]) <= most), f"{name} is exceeded")
        for i in range(0, 2 * STEPS, 2):
            k = [0 * x]
            for j, part in ((0, 0), (1, h / 2), (1, h / 2), (2, h)):
                k.append(slopes(vehicle["dynamics"], t[i + j], x + part * k[-1], u[i + j]))
            x = x + h / 6 * (k[1] + 2 * k[2] + 2 * k[3] + k[4])
            off = max(off, norm(x[R] - said[i + 2, R]))
            tilt = max(tilt, angle(turn(x[Q]), turn(said[i + 2, Q])))
    return off, tilt


def check_ends(vehicle, segments):
    """Ends in the inertial frame: position, a given attitude, velocity and rate."""
    ends = (("start", segments[0], "t0_s"), ("goal", segments[-1], "t1_s"))
    for key, segment, time in ends:
        end, x = vehicle.get(key, {"frame": None}), value(segment, "state", segment[time])
        if "frame" in end:  # those in a structure's frame are left to berthing
            continue
        half = end.get("angle_rad", 0) / 2
        q = end.get("attitude", [np.cos(half), 0, 0, np.sin(half)])
        misses = [norm(x[R] - lift(end["position_m"])) - end["position_tolerance_m"]]
        if isinstance(q, list):
            misses.append(angle(turn(x[Q]), turn(q)) - end["attitude_tolerance_rad"])
        for name, columns in (("velocity_m_s", V), ("rate_rad_s", W)):
            wanted = end.get(name, [0, 0, 0])
            misses.append(0 if wanted == "free" else norm(x[columns] - lift(wanted)))
        need(max(misses) <= NEAR, f"{vehicle['name']} misses its {key} by {max(misses):.3g}")


def main(folder):
    files = (Path(folder, f"{name}.json") for name in ("plan", "interpolant", "certificate"))
    plan, path, proof = (json.loads(f.read_text(), parse_constant=int) for f in files)
    phases = zip(plan["scenario"]["phases"], path["phases"], proof["phases"], strict=True)
    for phase, flown, said in phases:
        tubes = {tube["vehicle"]: tube for tube in said["tubes"]}
        for vehicle in phase["vehicles"]:
            (own,) = (v for v in flown["vehicles"] if v["vehicle"] == vehicle["name"])
            for s in own["segments"]:
                s["state"] = wide(s["state"], own["state_names"], STATE)
                s["control"] = wide(s["control"], own["control_names"], CONTROL)
            off, tilt = fly(own["segments"], vehicle)
            tube = tubes[vehicle["name"]]["position_m"], tubes[vehicle["name"]]["attitude_rad"]
            need(off <= tube[0] and tilt <= tube[1], f"leaves its tube: {off} m, {tilt} rad")
            check_ends(vehicle, own["segments"])
            print(f"{vehicle['name']} stays within {off:.2g} m, {tilt:.2g} rad of its plan")


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except (ArithmeticError, LookupError, OSError, TypeError, ValueError) as error:
        sys.exit(f"not flown: {type(error).__name__}: {error}")
