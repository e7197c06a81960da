"""Check the certificate in a plan folder with NumPy alone, as docs/certificate.md says."""

import hashlib
import json
import sys
from itertools import combinations, pairwise, product
from pathlib import Path

import numpy as np
from numpy.linalg import norm
from numpy.polynomial import chebyshev as cheb

SHAPES = ("box", "sphere", "point", "ellipsoid", "cylinder", "polytope")
PLANE = {"qw": np.cos, "qx": np.zeros_like, "qy": np.zeros_like, "qz": np.sin}  # of half an angle


def need(fact, what):
    if not fact:
        raise ValueError(what)


def lift(v):  # from the plane into space
    return np.append(v, np.zeros(3 - len(v)))


def turn(q):  # the rotation of a quaternion of any length
    k = np.array([[0, -q[3], q[2]], [q[3], 0, -q[1]], [-q[2], q[1], 0]])
    return np.eye(3) + 2 * (q[0] * k + k @ k) / np.dot(q, q)


def placed(block):
    half = block.get("angle_rad", 0) / 2
    q = block.get("attitude", [np.cos(half), 0, 0, np.sin(half)])
    return lift(block.get("position_m", [0])), turn(q)


def convex(part, body):  # support function, and centre and radius of a ball, in the body's frame
    s, (p, R) = part["shape"], placed(part)
    if body.get("motion", {}).get("type") == "fixed":  # its frame is the inertial one
        p, R = placed(body)[0] + placed(body)[1] @ p, placed(body)[1] @ R
    need(s["type"] in SHAPES and "normals" not in s, f"unknown shape {s['type']}")
    box = lift(s.get("size_m", [0])) / 2
    ball = lift(s.get("semi_axes_m", [s.get("radius_m", 0)] * 3))
    if (i := "xyz".find(s.get("axis", "none"))) >= 0:  # a cylinder's
        box[i], ball[i] = s["length_m"] / 2, 0
    V = np.array([lift(v) for v in s.get("vertices_m", [[0]])])
    middle = (V.max(0) + V.min(0)) / 2
    radius = np.hypot(norm(box), max(ball)) + max(norm(V - middle, axis=1))

    def support(n):
        m = R.T @ n
        return n @ p + box @ abs(m) + norm(ball * m) + max(V @ m)

    return support, p + R @ middle, radius


def poses(body, times, nodes):  # by the law, or by the segment that holds the interval
    if "segments" in body:
        s = next(s for s in body["segments"] if s["t0_s"] <= times[0] and times[1] <= s["t1_s"])
        x = (2 * times - s["t0_s"] - s["t1_s"]) / (s["t1_s"] - s["t0_s"])
        x = dict(zip(body["state_names"], cheb.chebval(x, s["state"]), strict=True))
        q = np.transpose([x.get(k, f(x.get("angle_rad", 0 * times) / 2)) for k, f in PLANE.items()])
        length = cheb.chebfit(nodes, (q[2:] ** 2).sum(1), len(nodes) - 1)
        need(abs(length[0] - 1) + abs(length[1:]).sum() < 0.01, "a quaternion is not a unit one")
        return np.transpose([x.get(k, 0 * times) for k in ("x_m", "y_m", "z_m")]), [*map(turn, q)]
    motion, (r, R) = body["motion"], placed({} if body["motion"]["type"] == "fixed" else body)
    v, e = lift(motion.get("velocity_m_s", [0])), np.array(motion.get("axis", [0, 0, 1]))
    half, known = motion.get("rate_rad_s", 0) * times / 2, ("fixed", "constant-velocity", "spin")
    need(motion["type"] in known and abs(half[1] - half[0]) < 4, "unknown, or too far, a motion")
    return r + np.outer(times, v), [R @ turn([np.cos(a), *np.sin(a) * e / norm(e)]) for a in half]


def bound(a, b, part_a, part_b, t0, t1, n0, n1):  # on the clearance; n linear from n0 to n1
    degrees = [len(s["state"]) for body in (a, b) for s in body.get("segments", [])]
    nodes, last = cheb.chebpts1(max(32, 2 * max(degrees))), max(32, 2 * max(degrees)) - 1
    (own_a, c, radius), h = part_a, (t1 - t0) / 2
    times = np.array([t0, t1, *((t0 + t1) / 2 + h * nodes)])
    both = [*zip(*poses(a, times, nodes), *poses(b, times, nodes), strict=True)]
    z = np.array([S.T @ (p + P @ c - r) for p, P, r, S in both])
    Q = np.array([S.T @ P for p, P, r, S in both])
    ends = zip((n0, n1), z[:2], Q[:2], strict=True)
    phi = [-n @ (x - P @ c) - own_a(P.T @ n) - part_b[0](-n) for n, x, P in ends]
    z, Q = (cheb.chebfit(nodes, y[2:].reshape(last + 1, -1), last) for y in (z, Q))
    (z1, z2), (Q1, Q2) = ([cheb.chebder(y, k, 1 / h) for k in (1, 2)] for y in (z, Q))
    Q1, Q2 = (norm(y.reshape(-1, 3, 3), 2, axis=(1, 2)).sum() for y in (Q1, Q2))
    slope, n = (n1 - n0) / (t1 - t0), n0 + np.outer(1 + nodes, n1 - n0) / 2
    bend = -2 * slope @ cheb.chebval(nodes, z1) - (n.T * cheb.chebval(nodes, z2)).sum(0)
    bend = cheb.chebfit(nodes, bend, last)
    K = bend[0] + abs(bend[1:]).sum() + radius * (2 * norm(slope) * Q1 + Q2)
    sag, gap = 2 * np.maximum(K, 0) * h**2 + 1e-13, abs(phi[1] - phi[0])  # n = 0 proves nothing
    return min(phi) if gap >= sag else sum(phi) / 2 - sag / 4 - gap**2 / (4 * sag)


def windows(margins, refs, t0, t1):  # (from, to, margin) wherever two parts have one
    rules, (a, b) = [], ((ref, ref.split(".")[0]) for ref in refs)
    for rule in margins["overrides"]:
        x, y = rule["between"]
        if (x in a and y in b) or (x in b and y in a):
            rules.append((*rule.get("window_s", (t0, t1)), rule.get("margin_m")))
    cuts = sorted({t0, t1, *(t for r in rules for t in r[:2] if t0 < t < t1)})
    for w0, w1 in pairwise(cuts):
        own = [r[2] for r in rules if r[0] <= (w0 + w1) / 2 <= r[1]] or [margins["default_m"]]
        if own[-1] is not None:
            yield w0, w1, own[-1]


def main(folder):
    files = (Path(folder, f"{name}.json") for name in ("plan", "interpolant", "certificate"))
    plan, path, proof = (json.loads(f.read_text(), parse_constant=int) for f in files)
    scenario, begin = plan["scenario"], 0
    text = json.dumps(scenario, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    sha = hashlib.sha256(text.encode()).hexdigest()
    need(sha == path["scenario_sha256"] == proof["scenario_sha256"], "of another scenario")
    for phase, flown, said in zip(scenario["phases"], path["phases"], proof["phases"], strict=True):
        own = {v["vehicle"]: v for v in flown["vehicles"]}
        movers = [{**own[v["name"]], **v} for v in phase["vehicles"]]
        tubes = {s["name"]: (0, 0) for s in scenario["structures"]}
        tubes |= {v["vehicle"]: (v["position_m"], v["attitude_rad"]) for v in said["tubes"]}
        need(len(own) == len(flown["vehicles"]) and min(map(min, tubes.values())) >= 0, "nonsense")
        need(phase["name"] == flown["phase"] == said["phase"], "another phase")
        claims = {p["pair"]: p["intervals"] for p in said["pairs"]}
        ((t0, t1),) = {(v["segments"][0]["t0_s"], v["segments"][-1]["t1_s"]) for v in movers}
        T, joints = phase["horizon"].get("duration_s", t1 - t0), [v["segments"] for v in movers]
        need(abs(t0 - begin) < 1e-9 and abs(t1 - t0 - T) < 1e-6, "another clock")
        need(all(s["t1_s"] == u["t0_s"] for j in joints for s, u in pairwise(j)), "gaps in time")
        couples = [*product(movers, scenario["structures"]), *combinations(movers, 2)]
        for (a, b), k in ((two, k) for two in couples for k in product(*(o["parts"] for o in two))):
            refs = f"{a['name']}.{k[0]['name']}", f"{b['name']}.{k[1]['name']}"
            parts, proven = (convex(k[0], a), convex(k[1], b)), []
            reach = [(1, norm(c) + radius) for _, c, radius in parts]
            tube = np.dot(tubes[a["name"]], reach[0]) + np.dot(tubes[b["name"]], reach[1])
            for u0, u1, said_m, *n in claims.get("|".join(refs), []):
                n0, n1 = (np.array(x) / max(1, norm(x)) for x in (n[:3], n[3:]))
                found = bound(a, b, *parts, u0, u1, n0, n1) - tube
                need(said_m <= found + 1e-9, f"{refs} at {u0} s: claims more than {found} m")
                proven.append((u0, u1, found))
            for w0, w1, margin in windows(scenario["margins"], refs, t0, t1):
                for u0, u1, found in sorted(proven):
                    w0 = max(w0, u1) if u0 <= w0 and found >= margin else w0
                need(w0 >= w1, f"{refs}: nothing proves {margin} m from {w0} s on")
        begin = t1
    print("every clearance is proven, if the tubes are wide enough")


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except (ArithmeticError, LookupError, OSError, StopIteration, TypeError, ValueError) as error:
        sys.exit(f"not proven: {type(error).__name__}: {error}")
