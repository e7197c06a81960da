"""The measured claims; run one by name: ``python -m benchmarks NAME --json FILE``."""

import sys
from pathlib import Path

# What the measurements make by hand is shared with the tests.
sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
