"""Independent checks of a plan: the clearance certificate, replay, limits, ends, optimality."""
