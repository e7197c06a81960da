"""Paths of the full shape, collision-free at every instant, and what other planners need."""
