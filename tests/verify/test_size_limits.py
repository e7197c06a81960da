"""What is too large to be a plan is refused before it takes memory or time."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.trajectory import Segment, VehicleTrajectory
from berthing.trajectory_io import strict_json
from berthing.verify import size_limits
from berthing.verify.size_limits import require_modest_scenario, require_modest_trajectory


def document(parts: int, structures: int) -> dict[str, Any]:
    part = {"name": "p"}
    return {
        "phases": [{"vehicles": [{"parts": [part] * parts}]}],
        "structures": [{"parts": [part] * structures}],
    }


def test_pairs_are_counted() -> None:
    require_modest_scenario(document(100, 1000), "here")
    with pytest.raises(InputError, match=r"here has \d+ pairs|here: has \d+ pairs"):
        require_modest_scenario(document(700, 0), "here")
    with pytest.raises(InputError, match="pairs of parts"):
        require_modest_scenario(document(201, 1000), "here")


@pytest.mark.parametrize("value", [[0] * 99, {"a": [{"b": list(range(95))}]}, [[0] * 9] * 10])
def test_values_are_counted(value: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    require_modest_scenario({"x": value}, "here")
    monkeypatch.setattr(size_limits, "MOST_SCENARIO_VALUES", 90)
    with pytest.raises(InputError, match="too many values"):
        require_modest_scenario({"x": value}, "here")


@pytest.mark.parametrize("bad", [None, 3, "x", [], [None], [[]], {"parts": 4}])
def test_whatever_is_there_is_counted_without_a_crash(bad: Any) -> None:
    require_modest_scenario({"phases": bad, "structures": bad}, "here")
    require_modest_scenario({"phases": [{"vehicles": bad}], "structures": [bad]}, "here")


def flown(degree: int, segments: int, control_degree: int = 0) -> VehicleTrajectory:
    piece = Segment(0.0, 1.0, np.zeros((degree + 1, 13)), np.zeros((control_degree + 1, 6)))
    names = tuple("abcdefghijklm"), tuple("nopqrs")
    return VehicleTrajectory("craft", "rigid-body", *names, (piece,) * segments)


def test_degrees_and_coefficients_are_counted() -> None:
    most = size_limits.LARGEST_DEGREE
    require_modest_trajectory(flown(most, 10), "here")
    for high in (flown(most + 1, 1), flown(1, 1, most + 1)):
        with pytest.raises(InputError, match=f"degree {most + 1}"):
            require_modest_trajectory(high, "here")
    many = size_limits.MOST_COEFFICIENTS // (19 * 11) + 1
    require_modest_trajectory(flown(10, many - 1), "here")
    with pytest.raises(InputError, match="coefficients"):
        require_modest_trajectory(flown(10, many), "here")
    require_modest_trajectory(flown(1, size_limits.MOST_SEGMENTS), "here")
    with pytest.raises(InputError, match="segments"):
        require_modest_trajectory(flown(1, size_limits.MOST_SEGMENTS + 1), "here")


def test_the_reader_has_limits_of_its_own(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file.json"
    path.write_text('{"a": [' + "0," * 200 + "0]}", encoding="utf-8")
    assert len(strict_json.read_object(path)["a"]) == 201
    monkeypatch.setattr(strict_json, "MOST_VALUES", 100)
    with pytest.raises(InputError, match="too many values"):
        strict_json.read_object(path)
    monkeypatch.setattr(strict_json, "LARGEST_FILE_BYTES", 100)
    with pytest.raises(InputError, match="too large"):
        strict_json.read_object(path)
