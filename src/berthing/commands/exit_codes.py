"""What the command line's exit codes mean."""

from __future__ import annotations

CERTIFIED = 0
BAD_INPUT = 2
NO_PLAN = 3
NOT_CERTIFIED = 4
INTERRUPTED = 130
