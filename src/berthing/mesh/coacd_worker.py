"""Runs CoACD in a process of its own: ``python coacd_worker.py IN.npz OUT.npz``.

The library is C++ under ctypes: where it fails it ends the process, and it does not hear Ctrl-C.
This file is run by its path and imports nothing of the package.
"""

from __future__ import annotations

import sys

import coacd
import numpy as np


def main(source: str, target: str) -> None:
    """Decompose the mesh in one file into the hulls in the other."""
    with np.load(source) as given:
        mesh = coacd.Mesh(given["vertices"], given["triangles"])
        threshold, seed = float(given["threshold"]), int(given["seed"])
    coacd.set_log_level("off")
    hulls = coacd.run_coacd(mesh, threshold=threshold, preprocess_mode="off", seed=seed)
    np.savez(target, *(points for points, _ in hulls))


if __name__ == "__main__":
    main(*sys.argv[1:])
