"""Breaks of the mesh where wrenches have kinks."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.transcription.kinks import kink_fractions, through
from berthing.transcription.mesh import Mesh
from support import users
from support.documents import DURATION_S, scenario, spacecraft

ARM = {"name": "arm", "times_s": [-5, 0, 31, 60, 100, 130],
       "force_n": [[0, 0, 0]] * 6, "torque_nm": [[0, 0, 0]] * 6}  # fmt: skip
PUSHED = {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5], "wrenches": [ARM]}


def test_kinks_inside_the_phase_are_found() -> None:
    given = scenario(spacecraft(dynamics=PUSHED), spacecraft("other"))
    assert kink_fractions(given.phases[0]) == pytest.approx([0.31, 0.6])
    assert kink_fractions(given.phases[0], 31.0) == pytest.approx([0.29, 0.69, 0.99])


def test_kinks_of_the_users_dynamics_too() -> None:
    from dataclasses import replace

    phase = scenario().phases[0]
    own = replace(phase.vehicles[0], model=users.twin(phase.vehicles[0].model))
    own = replace(own, model=replace(own.model, kinks_s=(0.25 * DURATION_S,)))
    assert kink_fractions(replace(phase, vehicles=(own,))) == [0.25]


def test_none_where_the_duration_is_free() -> None:
    given = scenario(spacecraft(dynamics=PUSHED), horizon={"min_s": 50, "max_s": 100})
    assert kink_fractions(given.phases[0]) == []


def test_the_mesh_runs_through_them() -> None:
    mesh = through(Mesh.uniform("lgr", 10, 4), [0.31, 0.45])
    np.testing.assert_allclose(
        mesh.breaks, [0, 0.1, 0.2, 0.31, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
    )
    assert mesh.degrees == (4,) * 11


def test_a_mesh_of_one_segment_stays_one() -> None:
    mesh = Mesh.uniform("lgl-global", 1, 19)
    assert through(mesh, [0.3]) is mesh
    assert through(Mesh.uniform("lgr", 3, 4), []).segments == 3
