"""A goal in the frame of a structure that spins: where the dock is by then, turning along."""

import numpy as np

import berthing as bt


def body(*size_m):
    return bt.Body((bt.Part("core", bt.Box(0.5 * np.array(size_m)), bt.Pose.identity()),))


at_rest = {"velocity_m_s": np.zeros(3), "rate_rad_s": np.zeros(3)}
model = bt.RigidBody(3.0, 5.0 * np.eye(3))
craft = bt.Vehicle(
    "craft",
    body(2.0, 1.0, 1.0),
    model,
    bt.Limits.unbounded(len(model.state_names), len(model.control_names)),
    start=bt.End(np.zeros(3), **at_rest),
    goal=bt.End(np.array([2.5, 0.0, 0.0]), frame="dock", **at_rest),
)
spin = bt.ConstantSpin(
    bt.Pose(np.array([9.0, 0.0, 0.0]), np.eye(3)), np.array([0.0, 0.0, 1.0]), 0.01, np.zeros(3)
)
dock = bt.Structure("dock", body(2.0, 2.0, 2.0), spin)
phase = bt.Phase("main", (craft,), bt.Horizon.fixed(100.0))
result = bt.plan(bt.Scenario("spinning-dock", "", (phase,), (dock,), bt.MarginPolicy(0.1)))

(last,) = result.plan.phases[0].vehicle("craft").state(np.array([100.0]))
print(result.outcome)
print(f"at {np.round(last[0:3], 3)} m, moving along with {np.round(last[3:6], 4)} m/s")
