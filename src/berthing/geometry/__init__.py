"""Convex sets, bodies and poses: what a thing is."""
