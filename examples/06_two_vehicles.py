"""Two vehicles on one clock that change places; they keep clear of each other, too."""

import berthing as bt

scenario = bt.load("two-vehicles-swap")
result = bt.plan(scenario)

print(result.outcome, f"cost {result.plan.cost:.5f}")
between = next(p for p in result.verification.pairs if p.pair == "alpha.hull|beta.hull")
print(f"{between.pair}: at least {between.lower_bound_m:.3f} m apart at all times")
