"""Two brackets from CAD: one is turned and carried into the other, and what was made of the files.

The same from a shell: ``berthing plan examples/meshes/brackets.yaml``.
"""

from pathlib import Path

import berthing as bt

scenario = bt.load(Path(__file__).parent / "meshes" / "brackets.yaml")
model = scenario.phases[0].vehicles[0].model
for block in (*scenario.document["structures"], *scenario.document["phases"][0]["vehicles"]):
    for part in block["parts"]:
        said = part["certificate"]
        print(
            f"{part['mesh']}: {said['pieces']} pieces contain it, {said['uncovered_area_m2']} m² "
            f"left out, {said['volume_ratio']:.4f} of its volume"
        )
print(f"the carrier weighs {model.mass_kg:.3f} kg by its density")

result = bt.plan(scenario)

closest = result.verification.closest_pair
print(result.outcome, f"cost {result.plan.cost:.5f}")
print(f"{closest}: at least {result.verification.clearance_lower_bound_m:.4f} m at all times")
