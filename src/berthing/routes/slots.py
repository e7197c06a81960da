"""Parts with a number each, where they lie in their frames, and balls about them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.verify.frames import lifted, lifted_rotation
from berthing.verify.part_pair import enclosing_ball


class Slots:
    """Parts in frames that move or rest, each once, and their balls.

    Args:
        frames: of each part its row of moving frames, or 0, and its placement there.
    """

    def __init__(self, parts: Sequence[Part], rows: Sequence[int], placed: Sequence[Pose]) -> None:
        self.rows = np.array(rows, dtype=np.intp)
        self.turn = np.array([lifted_rotation(p.rotation) for p in placed]).reshape(-1, 3, 3)
        self.place = np.array([lifted(p.position) for p in placed]).reshape(-1, 3)
        own = [
            enclosing_ball(Part(p.name, p.shape, at)) for p, at in zip(parts, placed, strict=True)
        ]
        self.centre = np.array([ball.centre for ball in own]).reshape(-1, 3)
        self.radius = np.array([ball.radius for ball in own])
