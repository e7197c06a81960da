"""How soon can it be there? Full thrust, the hull turned so that its diagonal points the way."""

from dataclasses import replace

import numpy as np

import berthing as bt

given = bt.load("free-space")
phase = replace(given.phases[0], horizon=bt.Horizon(30.0, 150.0), cost=bt.Cost(0.0, 1.0))
result = bt.plan(replace(given, phases=(phase,)))

own = result.plan.phases[0].vehicle("spacecraft")
force = own.control(np.linspace(0.0, own.t1_s, 1001))[:, :3]
share = np.mean(np.abs(force) > 0.99 * 0.02)
print(
    f"{result.outcome} after {own.t1_s:.2f} s; a thruster is at its limit {share:.0%} of the time"
)
