"""From a scenario to a nonlinear programme: nodes, differentiation, packing, scaling, rows."""
