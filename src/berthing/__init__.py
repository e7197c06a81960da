"""Plan collision-free, optimal motion for full-shape rigid bodies in tight spaces."""
