import numpy as np
import pytest

from berthing.routes.broad_phase import FEW, BroadPhase


@pytest.mark.parametrize("count", [1, FEW, FEW + 1, 400])
def test_trees_find_what_looking_at_each_finds(count):
    rng = np.random.default_rng(count)
    centres = rng.uniform(-10.0, 10.0, (count, 3))
    radii = 10.0 ** rng.uniform(-3.0, 0.5, count)
    radii[rng.random(count) < 0.1] = 0.0
    radii[0] = np.inf
    points, reach = rng.uniform(-10.0, 10.0, (50, 3)), rng.uniform(-0.1, 2.0, 50)
    rows, balls = BroadPhase(centres, radii).near(points, reach)
    gaps = np.linalg.norm(points[:, None] - centres, axis=-1) - radii
    wanted = np.nonzero(gaps <= reach[:, None])
    assert np.array_equal(np.stack([rows, balls]), np.stack(wanted))
    assert len(rows) >= len(points)
