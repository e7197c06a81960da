"""Plan a case that ships, and read what the check found."""

import berthing as bt

scenario = bt.load("scenario-b")
result = bt.plan(scenario)

found = result.verification
print(result.outcome)
print(f"cost {result.plan.cost:.6f}, clearance at least {found.clearance_lower_bound_m:.4f} m")
print(f"replay within {found.replay_position_error_m:.1e} m, equations {found.model_check}")
