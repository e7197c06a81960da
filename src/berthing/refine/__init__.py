"""Where a solution falls short between its nodes, and what to add there."""
