"""A spacecraft with an arm, from its URDF: mass and shape of all links at given joint angles."""

from pathlib import Path

import berthing as bt

scenario = bt.load(Path(__file__).parent / "meshes" / "porter.yaml")
robot = scenario.phases[0].vehicles[0]
centre = robot.model.first_moment_kg_m / robot.model.mass_kg
print(", ".join(f"{part.name} ({type(part.shape).__name__})" for part in robot.body.parts))
print(f"{robot.model.mass_kg:.1f} kg, centre of mass {centre[0]:.3f} m ahead of the bus")

result = bt.plan(scenario)

print(result.outcome, f"cost {result.plan.cost:.5f}")
for pair in result.verification.pairs:
    if pair.pair.startswith("porter.fork") and pair.pair.endswith("rail"):
        print(f"{pair.pair}: at least {pair.lower_bound_m:.4f} m")
