"""Leap seconds for SPICE."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import spiceypy

# As of 2017, and the constants of TDB − TT: NAIF's naif0012.tls without the leaps before 1999.
LEAP_SECONDS = """KPL/LSK
\\begindata
DELTET/DELTA_T_A = 32.184
DELTET/K = 1.657D-3
DELTET/EB = 1.671D-2
DELTET/M = ( 6.239996D0 1.99096871D-7 )
DELTET/DELTA_AT = ( 32, @1999-JAN-1  33, @2006-JAN-1  34, @2009-JAN-1  35, @2012-JUL-1
                    36, @2015-JUL-1  37, @2017-JAN-1 )
\\begintext
"""


@contextmanager
def leap_seconds_loaded(folder: Path) -> Iterator[None]:
    """SPICE knows them, and nothing else once this has ended."""
    kernel = folder / "leap.tls"
    kernel.write_text(LEAP_SECONDS, encoding="utf-8")
    with spiceypy.KernelPool([str(kernel)]):
        yield
    spiceypy.kclear()
