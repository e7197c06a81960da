"""Separation rows of a pair of convex sets, one formulation a file."""
