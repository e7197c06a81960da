"""A scenario as a document, as it would stand in a YAML file; sampled where you like."""

import numpy as np

import berthing as bt

scenario = bt.from_document(
    {
        "schema_version": 1,
        "name": "past-the-block",
        "horizon": {"duration_s": 150},
        "margins": {"default_m": 0.1},
        "vehicles": [
            {
                "name": "spacecraft",
                "parts": [{"name": "hull", "shape": {"type": "box", "size_m": [2, 1, 1]}}],
                "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
                "limits": {"max_force_n": 0.02, "max_torque_nm": 0.01},
                "start": {"position_m": [0, 0, 0]},
                "goal": {"position_m": [10, 1, 0]},
            }
        ],
        "structures": [
            {
                "name": "block",
                "position_m": [5, -1, 0],
                "parts": [{"name": "core", "shape": {"type": "box", "size_m": [2, 3, 3]}}],
            }
        ],
    }
)
result = bt.plan(scenario)
own = result.plan.phases[0].vehicle("spacecraft")
times = np.linspace(own.t0_s, own.t1_s, 4)
print(result.outcome)
for t, state in zip(times, own.state(times), strict=True):
    print(f"t = {t:5.1f} s at {np.round(state[0:3], 3)} m")
