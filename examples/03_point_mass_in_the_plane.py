"""The paper's point-mass problem: every pair with its proven clearance."""

import berthing as bt

result = bt.plan(bt.load("point-mass-2d"))

print(result.outcome, f"cost {result.plan.cost:.5f}")
for pair in result.verification.pairs:
    print(f"{pair.pair}: at least {pair.lower_bound_m:.4f} m, {pair.required_m} m required")
