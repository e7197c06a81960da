"""Equations of motion, pose maps and motion laws as casadi expressions, one model a file."""
