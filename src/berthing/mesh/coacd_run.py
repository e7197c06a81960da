"""CoACD: a solid cut into parts that are nearly convex.

X. Wei, M. Liu, Z. Ling, H. Su, *Approximate Convex Decomposition for 3D Meshes with
Collision-Aware Concavity and Tree Search*, ACM Transactions on Graphics 41 (4), 2022.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.mesh.optional import require
from berthing.mesh.solid import Solid

LIBRARY = "coacd"
WORKER = Path(__file__).with_name("coacd_worker.py")


def coacd_version() -> str:
    """Of the library; InputError, naming the extra, where it is not installed."""
    require(LIBRARY)
    return version(LIBRARY)


def nearly_convex(solid: Solid, threshold: float, seed: int) -> list[Array]:
    """Points (k, 3) in metres of each part; their hulls nearly cover the solid.

    The same for the same input: the seed is fixed, and the mesh goes in as it is, without the
    voxels of CoACD's own preprocessing, which would round it.

    Args:
        threshold: CoACD's measure of concavity, relative to the size of the solid: 0.01 to 1.
        seed: of its tree search.

    Raises:
        InputError: the library is not installed, or failed on the mesh.
    """
    require(LIBRARY)
    middle = solid.vertices.mean(axis=0)
    with tempfile.TemporaryDirectory(prefix="berthing-") as folder:
        source, target = Path(folder, "in.npz"), Path(folder, "out.npz")
        np.savez(
            source,
            vertices=solid.vertices - middle,
            triangles=solid.triangles.astype(np.int32),
            threshold=threshold,
            seed=seed,
        )
        command = [sys.executable, str(WORKER), str(source), str(target)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0 or not target.exists():
            raise InputError(solid.name, _complaint(done), "a surface that CoACD can cut")
        with np.load(target) as found:
            return [found[key] + middle for key in found.files]


def _complaint(done: subprocess.CompletedProcess[str]) -> str:
    lines = (done.stderr or done.stdout).strip().splitlines()
    said = f": {lines[-1]}" if lines else ""
    return f"made CoACD fail (exit {done.returncode}){said}"
