"""The compiled distance: C sources of the package, built where first used and kept.

One second with the system's C compiler, once; the library is kept under the user's cache folder,
under a name made of the sources, the options and the compiler, so that a stale one is never
loaded. Without a compiler, ``kernel()`` is None and distances come from slower methods.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import shutil
import subprocess
import tempfile
import warnings
from functools import cache
from pathlib import Path
from typing import Any

SOURCES = Path(__file__).parent / "native"
# No contraction to fused operations and no processor of one's own: the same bits everywhere.
OPTIONS = ("-O3", "-std=c11", "-fPIC", "-shared", "-fno-math-errno", "-ffp-contract=off")
# Columns of an answer: both bounds, the distance, normal, witnesses (3 each), and the gradients by
# the poses of A and B (6 each).
WIDTH = 24
DISTANCE, BY_A, BY_B = 2, slice(12, 18), slice(18, 24)
COMPILERS = ("cc", "gcc", "clang")
TIME_LIMIT_S = 120.0


@cache
def library() -> Any | None:
    """What native/kernel.c exports, or None, said once as a warning, where no C compiler is found
    or it fails. Pointers are given as addresses."""
    compiler = next(filter(None, map(shutil.which, COMPILERS)), None)
    try:
        if compiler is None:
            raise OSError("no C compiler (cc, gcc, clang) was found")
        found = ctypes.CDLL(str(_library(compiler)))
    except (OSError, subprocess.SubprocessError) as error:
        warnings.warn(
            f"distances are up to a thousand times slower: {error}", RuntimeWarning, stacklevel=3
        )
        return None
    pointer, count, number, flag = ctypes.c_void_p, ctypes.c_long, ctypes.c_double, ctypes.c_int
    poses: list[Any] = [pointer, pointer, count]
    sets: list[Any] = [pointer, pointer, flag, count]
    counts, arrays = [count] * 3, [pointer] * 5
    for name, result, arguments in (
        ("distances", count, [*sets, *poses, *poses, number, number, pointer]),
        ("scene_new", pointer, [*counts, flag, *arrays, pointer, number, number]),
        ("scene_free", None, [pointer]),
        ("scene_valid", None, [pointer, count, pointer, number, pointer]),
        ("scene_settle", flag, [pointer] * 3),
        ("scene_extend", count,
         [*([pointer] * 3), number, number, flag, pointer, count, pointer, pointer]),
        ("scene_near", count,
         [pointer, count, pointer, number, count, pointer, pointer, pointer]),
        ("scene_blocked", number, [*([pointer] * 3), number, number]),
    ):  # fmt: skip
        function = getattr(found, f"berthing_{name}")
        function.argtypes, function.restype = arguments, result
    return found


def kernel() -> Any | None:
    """``berthing_distances`` of native/kernel.c, or None without a compiler."""
    found = library()
    return None if found is None else found.berthing_distances


def _library(compiler: str) -> Path:
    """The shared library, built if it is not there yet."""
    version = subprocess.run(
        [compiler, "--version"], capture_output=True, check=True, timeout=TIME_LIMIT_S
    ).stdout
    files = sorted(p for p in SOURCES.iterdir() if p.suffix in (".c", ".h"))
    digest = hashlib.sha256(version + repr(OPTIONS).encode())
    for file in files:
        digest.update(file.name.encode() + file.read_bytes())
    folder = _folder()
    library = folder / f"distances-{digest.hexdigest()[:32]}.so"
    if not library.exists():
        # Another process may be at it too: each writes its own, and the last one is kept.
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            built = Path(scratch) / library.name
            command = [compiler, *OPTIONS, str(SOURCES / "kernel.c"), "-o", str(built), "-lm"]
            subprocess.run(command, capture_output=True, check=True, timeout=TIME_LIMIT_S)
            os.replace(built, library)
    return library


def _folder() -> Path:
    """The cache folder, or a fresh one of this process where there is none to write to."""
    home = os.environ.get("XDG_CACHE_HOME")
    try:
        folder = (Path(home) if home else Path.home() / ".cache") / "berthing"
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except (OSError, RuntimeError):
        return Path(tempfile.mkdtemp(prefix="berthing-"))
