"""Numeric separation of placed bodies, and bounds on it."""
