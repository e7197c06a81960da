"""A module is carried into a truss bay that is one mesh: which of its pieces come closest?"""

from pathlib import Path

import berthing as bt

scenario = bt.load(Path(__file__).parent / "meshes" / "truss_bay.yaml")
pieces = [type(part.shape).__name__ for part in scenario.structures[0].body.parts]
print(f"12 struts and their nodes: {len(pieces)} pieces, {pieces.count('Box')} of them boxes")

result = bt.plan(scenario)

print(result.outcome, f"cost {result.plan.cost:.5f}")
nearest = sorted(result.verification.pairs, key=lambda pair: pair.lower_bound_m)[:3]
for pair in nearest:
    print(f"{pair.pair}: at least {pair.lower_bound_m:.4f} m, {pair.required_m} m required")
