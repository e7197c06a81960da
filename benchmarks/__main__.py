"""``python -m benchmarks NAME [--json FILE]``: a measurement by its name."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path


def main() -> int:
    """Run the benchmark named first on the command line with the arguments after it."""
    here = Path(__file__).parent
    files = [*here.glob("*.py"), *(own.parent for own in here.glob("*/__init__.py"))]
    names = sorted(p.stem for p in files if not p.stem.startswith("_"))
    if len(sys.argv) < 2 or sys.argv[1] not in names:
        print(f"usage: python -m benchmarks NAME [--json FILE], NAME one of: {', '.join(names)}")
        return 2
    return int(import_module(f"benchmarks.{sys.argv[1]}").main(sys.argv[2:]))


if __name__ == "__main__":
    raise SystemExit(main())
