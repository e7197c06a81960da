"""First trajectories for the solver, from nothing but the scenario."""
