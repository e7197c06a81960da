"""Claims about the two scenarios, against plans of ours."""

from __future__ import annotations

from statistics import median

import numpy as np

from berthing.clearance.bodies import clearance
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.guess.normals import exact_normals
from berthing.refine.refiner import BACKOFF_M, SAMPLES
from berthing.refine.sampling import sample_clearance, sample_times
from berthing.reproduce.cases import Cases, Planned
from berthing.reproduce.finding import FAILS, HOLDS, MEASURED, PARTLY, Finding, verdict
from berthing.reproduce.moved import resolve_times
from berthing.scenario.rigid_body import RigidBody

ALIKE = 0.01
"""Of costs: two formulations of one problem."""

FLAT = 1e-3
"""Of the lower Hamiltonian's mean: as flat as a figure shows."""

EXACT = 1e-6
"""Of ends, in SI units."""

TOUCHING_M = 5e-3
"""Above the margin: as near as makes no difference."""

FULL = 0.99
"""Of a limit: where a control is stuck to it."""

PAPER_S = 0.1852
"""Printed for a solve with a guess, in another programme on another machine."""


def findings(cases: Cases) -> list[Finding]:
    """All of them, in the order of the paper."""
    return [
        _solved(cases), _as_near_as_allowed(cases), _as_printed(cases), _ends(cases),
        _at_the_boundary(cases), _controls(cases), _hamiltonian(cases), _replay(cases),
        _tight(cases), _fuel(cases), _exact_sets(cases), _continuation(cases), _online(cases),
    ]  # fmt: skip


def _solved(cases: Cases) -> Finding:
    costs = {name: cases[name].plan.cost for name in ("scenario-a", "scenario-b")}
    sound = all(cases[name].certified for name in costs)
    return Finding(
        "Simulation results", "the form finds trajectories for both scenarios",
        f"`kkt` on exact sets: certified with cost {costs['scenario-a']:.6f} on A and "
        f"{costs['scenario-b']:.6f} on B" if sound else "not both are certified",
        verdict(sound), {"cost_a": costs["scenario-a"], "cost_b": costs["scenario-b"]},
    )  # fmt: skip


def _distances(case: Planned) -> tuple[Array, Array]:
    """Times (k,) and least distances of any pair (k,)."""
    (phase,) = case.scenario.phases
    times = sample_times(case.plan.phases[0], SAMPLES)
    found = sample_clearance(
        case.scenario, case.scenario.pairs(phase), case.plan.phases[0], times, 1.0
    )
    return times, np.asarray(np.min(found.distances_m, axis=0))


def _as_near_as_allowed(cases: Cases) -> Finding:
    case = cases["scenario-a"]
    least, share = _near(case)
    d_safe = case.scenario.margins.default_m
    return Finding(
        "Scenario A", "the distance is the least possible at many points: no conservatism",
        f"the certified plan comes within {least:.4f} m, d_safe being {d_safe} m, and stays within "
        f"{TOUCHING_M * 1e3:.0f} mm of it for {share:.0%} of the time",
        verdict(least <= d_safe + TOUCHING_M), {"least_m": least, "share_of_time": share},
    )  # fmt: skip


def _near(case: Planned) -> tuple[float, float]:
    times, distances = _distances(case)
    near = distances <= case.scenario.margins.default_m + TOUCHING_M
    share = float(np.sum(np.diff(times)[near[1:] & near[:-1]])) / float(np.ptp(times))
    return float(np.min(distances)), share


def _as_printed(cases: Cases) -> Finding:
    case = cases["scenario-a-printed"]
    v = case.verification
    worst = min(float(np.min(_distances(case)[1])), v.closest_distance_m or np.inf)
    return Finding(
        "Scenario A", "with exponent 8 and 20 nodes d ≥ d_safe is never violated",
        f"cost {case.plan.cost:.5f}; the models keep their distance at the nodes, the true bodies "
        f"overlap by {-worst:.3f} m at t = {v.closest_time_s or 0.0:.1f} s ({v.closest_pair})",
        verdict(case.certified), {"cost": case.plan.cost, "least_m": worst},
    )  # fmt: skip


def _ends(cases: Cases) -> Finding:
    case = cases["scenario-a"]
    errors = [
        max(end.position_m, end.attitude_rad, end.velocity_m_s, end.rate_rad_s)
        for end in case.verification.ends
    ]
    return Finding(
        "Scenario A", "the state exactly meets the terminal conditions",
        f"start and goal are met to {max(errors):.0e} (SI)",
        verdict(max(errors) <= EXACT), {"largest_error": max(errors)},
    )  # fmt: skip


def _at_the_boundary(cases: Cases) -> Finding:
    scenario = cases["scenario-a"].scenario
    (phase,) = scenario.phases
    craft = phase.vehicles[0]
    goal = Pose(np.asarray(craft.goal.position_m), np.eye(3))
    gaps = {
        s.name: clearance(craft.body, goal, s.body, s.motion.pose(np.zeros(1))[0])[0].distance
        for s in scenario.structures
    }  # fmt: skip
    least = min(gaps.values())
    return Finding(
        "Scenario A", "the assembly point is at the boundary of the allowed distance",
        "there the hull is " + ", ".join(f"{gap:.2f} m from {s}" for s, gap in gaps.items())
        + f"; d_safe is {scenario.margins.default_m} m",
        verdict(least <= scenario.margins.default_m + TOUCHING_M), gaps,
    )  # fmt: skip


def _shares(case: Planned) -> tuple[float, float]:
    """Of force and torque: the largest of any axis over its limit."""
    own = case.plan.phases[0].vehicles[0]
    u = np.abs(own.control(np.linspace(own.t0_s, own.t1_s, 4001)))
    limits = case.scenario.phases[0].vehicles[0].limits.control_upper
    share = np.max(u, axis=0) / limits
    return float(np.max(share[:3])), float(np.max(share[3:]))


def _controls(cases: Cases) -> Finding:
    force, torque = _shares(cases["scenario-a"])
    inside = max(force, torque) <= 1.0
    stuck = min(force, torque) >= FULL
    return Finding(
        "Scenario A", "controls stick to the region that their limits allow",
        f"they stay inside it and do not reach its edge: thrust up to {force:.0%}, torque up to "
        f"{torque:.0%} of the limit" if not stuck else "both limits act",
        (HOLDS if stuck else PARTLY) if inside else FAILS,
        {"force_share": force, "torque_share": torque},
    )  # fmt: skip


def _hamiltonian(cases: Cases) -> Finding:
    drifts = {
        name: cases[name].verification.hamiltonian_relative_drift or 0.0
        for name in ("scenario-a", "scenario-a-printed", "scenario-b")
    }
    flat = [drift <= FLAT for drift in drifts.values()]
    a, printed, b = drifts.values()
    return Finding(
        "Fig. lowham", "the lower Hamiltonian is constant, and so the answer a Pontryagin extremal",
        f"drift over mean: {b:.0e} on B; {a:.0%} on A, whose costates jump where it touches, and "
        f"{printed:.0%} with 20 global nodes as printed; it is a necessary condition only",
        HOLDS if all(flat) else PARTLY if any(flat) else FAILS, drifts,
    )  # fmt: skip


def _replay(cases: Cases) -> Finding:
    a, printed = (
        cases[name].verification.replay_position_error_m
        for name in ("scenario-a", "scenario-a-printed")
    )
    case = cases["scenario-a-printed"]
    return Finding(
        "Figs. scenA-state, scenB-state", "flying the controls gives the same motion, which "
        "validates the answer",
        f"the motion agrees to {a:.0e} m, and to {printed:.0e} m on the plan as printed, in which "
        "bodies overlap: flying shows nothing of collisions",
        PARTLY if not case.certified else HOLDS,
        {"replay_m": a, "replay_printed_m": printed},
    )  # fmt: skip


def _tight(cases: Cases) -> Finding:
    case = cases["scenario-b"]
    least = float(np.min(_distances(case)[1]))
    craft = case.scenario.phases[0].vehicles[0]
    duration = case.plan.phases[0].t1_s
    way = float(np.linalg.norm(craft.goal.position_m - craft.start.position_m))
    assert isinstance(craft.model, RigidBody)
    free = 12.0 * (craft.model.mass_kg * way) ** 2 / duration**3
    return Finding(
        "Scenario B", "a tight environment, ended as near as possible to the last component",
        f"a straight line meets it: cost {case.plan.cost:.6f}, that of empty space being "
        f"{free:.6f}; nothing comes nearer than {least:.2f} m, five times d_safe",
        verdict(least <= case.scenario.margins.default_m + TOUCHING_M),
        {"cost": case.plan.cost, "cost_free": free, "least_m": least},
    )  # fmt: skip


def _fuel(cases: Cases) -> Finding:
    """Which of two controls is cheaper, in metres and in millimetres."""
    push, turn = np.array([2.0, 0.0]), np.array([0.0, 1.0])
    ratios = [
        float(np.sum((push * [1, k]) ** 2) / np.sum((turn * [1, k]) ** 2)) for k in (1.0, 1e3)
    ]
    own = cases["scenario-a"].plan.phases[0].vehicles[0]
    t = np.linspace(own.t0_s, own.t1_s, 4001)
    impulse = float(np.trapezoid(np.sum(np.abs(own.control(t)[:, :3]), axis=1), t))
    return Finding(
        "(objective-u)", "∫ ‖u‖² is the fuel used",
        f"it adds N² to (N·m)²: 2 N cost {ratios[0]:.0f} times as much as 1 N·m in metres and "
        f"{ratios[1]:.0e} times in millimetres; the plan's impulse, which is fuel, is "
        f"{impulse:.3f} N·s",
        verdict(bool(np.isclose(ratios[0], ratios[1]))),
        {"ratio_m": ratios[0], "ratio_mm": ratios[1], "impulse_n_s": impulse},
    )  # fmt: skip


def _exact_sets(cases: Cases) -> Finding:
    kkt, plane = cases["scenario-a"].plan.cost, cases["scenario-a-plane"].plan.cost
    return Finding(
        "Discussion", "exact polyhedra may be used instead, with m multipliers",
        f"A costs {kkt:.6f} so and {plane:.6f} with separating planes; complementarity has to "
        "be relaxed and driven to zero, from the planes' answer",
        verdict(abs(kkt / plane - 1.0) <= ALIKE and cases["scenario-a"].certified),
        {"cost_kkt": kkt, "cost_plane": plane},
    )  # fmt: skip


def _continuation(cases: Cases) -> Finding:
    case, best = cases["scenario-a-continuation"], cases["scenario-a-plane"].plan.cost
    steps = [a.iterations for a in case.result.attempts]
    return Finding(
        "Discussion, continuation", "sub-problems of one component, superposed, lead quickly to an "
        "optimum",
        f"certified with cost {case.plan.cost:.6f} (best known {best:.6f}) after {len(steps)} "
        f"solves and {sum(steps)} iterations" if case.certified else "not certified",
        verdict(case.certified and case.plan.cost <= (1.0 + ALIKE) * best),
        {"cost": case.plan.cost, "solves": len(steps), "iterations": sum(steps)},
    )  # fmt: skip


def _online(cases: Cases) -> Finding:
    case = cases["scenario-a-plane"]
    (phase,) = case.scenario.phases
    times = resolve_times(case.scenario, exact_normals(case.scenario.pairs(phase)), BACKOFF_M)
    middle = median(times)
    return Finding(
        "Discussion", "0.1852 s a solve on average with a guess given: fit for use online",
        f"{middle:.2f} s here, the median of {len(times)} re-solves of A by planes after its start "
        "has moved (40 nodes; seconds depend on the machine)",
        MEASURED, {"median_s": middle, "printed_s": PAPER_S},
    )  # fmt: skip
