"""Every bad file gives one message that says where it is wrong, and what would be right."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from berthing.scenario.files import from_document

Document = dict[str, Any]
Refused = Callable[[Document], str]

VEHICLE = "vehicles[0]"
DYNAMICS = "vehicles[0].dynamics"
SHAPE = "vehicles[0].parts[0].shape"
MOTION = "structures[0].motion"


def _set(document: Document, path: str, value: Any) -> None:
    """Set the value at a path such as ``vehicles[0].goal.frame``."""
    *way, last = [
        int(k) if k.isdigit() else k for k in path.replace("[", ".").replace("]", "").split(".")
    ]
    here: Any = document
    for key in way:
        here = here.setdefault(key, {}) if isinstance(here, dict) else here[key]
    here[last] = value


NORMALS = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
NAN = float("nan")

# path to set, value, where the message points, what it says
CASES: list[tuple[str, Any, str, str]] = [
    # numbers
    (f"{DYNAMICS}.mass_kg", -3, f"{DYNAMICS}.mass_kg", "is -3 (expected a number above 0)"),
    (f"{DYNAMICS}.mass_kg", 0, f"{DYNAMICS}.mass_kg", "above 0"),
    (f"{DYNAMICS}.mass_kg", NAN, f"{DYNAMICS}.mass_kg", "is nan (expected a finite number)"),
    (f"{DYNAMICS}.mass_kg", float("inf"), f"{DYNAMICS}.mass_kg", "finite"),
    (f"{DYNAMICS}.mass_kg", "3", f"{DYNAMICS}.mass_kg", "is '3' (expected a number)"),
    (f"{DYNAMICS}.mass_kg", 10**400, f"{DYNAMICS}.mass_kg", "expected a number"),
    (f"{DYNAMICS}.mass_kg", True, f"{DYNAMICS}.mass_kg", "is True"),
    (f"{DYNAMICS}.mass_kg", None, f"{DYNAMICS}.mass_kg", "is missing"),
    (f"{VEHICLE}.goal.position_m", [10, NAN, 0], f"{VEHICLE}.goal.position_m[1]", "is nan"),
    (f"{VEHICLE}.limits.max_force_n", -0.02, f"{VEHICLE}.limits.max_force_n", "0 or more"),
    (f"{VEHICLE}.limits.max_force_n", [1, 1], f"{VEHICLE}.limits.max_force_n", "3, or one number"),
    ("margins.default_m", -0.1, "margins.default_m", "is -0.1"),
    ("horizon.duration_s", 0, "horizon.duration_s", "above 0"),
    # inertia
    (f"{DYNAMICS}.inertia_kg_m2", [5, 5, -5], f"{DYNAMICS}.inertia_kg_m2", "positive definite"),
    (f"{DYNAMICS}.inertia_kg_m2", [1, 1, 3], f"{DYNAMICS}.inertia_kg_m2", "sum of the other two"),
    (f"{DYNAMICS}.inertia_kg_m2", [5, 5], f"{DYNAMICS}.inertia_kg_m2", "has 2 entries"),
    (
        f"{DYNAMICS}.inertia_kg_m2",
        [[5, 1, 0], [0, 5, 0], [0, 0, 5]],
        f"{DYNAMICS}.inertia_kg_m2",
        "symmetric",
    ),
    (f"{DYNAMICS}.first_moment_kg_m", [0, 4, 0], f"{DYNAMICS}.inertia_kg_m2", "centre of mass"),
    # shapes
    (f"{SHAPE}.size_m", [4, -2, 2], f"{SHAPE}.size_m[1]", "is -2"),
    (f"{SHAPE}.size_m", [4, 2], SHAPE, "has 2 dimensions in a scenario of 3"),
    (SHAPE, {"type": "bix"}, f"{SHAPE}.type", "'bix'; did you mean box? (expected one of: box,"),
    (SHAPE, {"size_m": [1, 1, 1]}, f"{SHAPE}.type", "is missing"),
    (SHAPE, "box", SHAPE, "is 'box' (expected a block of keys)"),
    (SHAPE, {"type": "sphere", "radius_m": 0}, f"{SHAPE}.radius_m", "above 0"),
    (SHAPE, {"type": "polytope"}, SHAPE, "vertices_m, or normals with offsets_m"),
    (
        SHAPE,
        {"type": "polytope", "normals": NORMALS[:5], "offsets_m": [1] * 5},
        SHAPE,
        "is unbounded",
    ),
    (
        SHAPE,
        {"type": "polytope", "normals": NORMALS, "offsets_m": [1, -2, 1, 1, 1, 1]},
        SHAPE,
        "is empty",
    ),
    (
        SHAPE,
        {"type": "polytope", "vertices_m": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]},
        SHAPE,
        "is flat",
    ),
    (
        SHAPE,
        {"type": "polytope", "vertices_m": [[0, 0, 0], [1, 0], [0, 1, 0], [1, 1, 0]]},
        f"{SHAPE}.vertices_m",
        "row 1 has 2 components (expected 3)",
    ),
    (f"{VEHICLE}.parts", [], f"{VEHICLE}.parts", "at least 1"),
    # attitudes
    (f"{VEHICLE}.start.attitude", [1, 0, 0, 0.1], f"{VEHICLE}.start.attitude", "norm 1.00498"),
    (f"{VEHICLE}.start.attitude", [0, 0, 0, 0], f"{VEHICLE}.start.attitude", "norm 0"),
    (f"{VEHICLE}.start.attitude", [1, 0, 0], f"{VEHICLE}.start.attitude", "has 3 entries"),
    (f"{VEHICLE}.start.attitude", "fre", f"{VEHICLE}.start.attitude", "expected 'free'"),
    (f"{VEHICLE}.start.attitude", 3, f"{VEHICLE}.start.attitude", "a list or free or a block"),
    (
        f"{VEHICLE}.start.attitude",
        {"body_axis": [0, 0, 0], "points_along": [1, 0, 0]},
        f"{VEHICLE}.start.attitude.body_axis",
        "zero",
    ),
    ("structures[0].attitude", [2, 0, 0, 0], "structures[0].attitude", "norm 2"),
    ("structures[0].angle_rad", 0.3, "structures[0].angle_rad", "in the plane"),
    # keys
    (f"{DYNAMICS}.mas_kg", 3, f"{DYNAMICS}.mas_kg", "not a known key; did you mean mass_kg?"),
    ("zzz", 3, "zzz", "not a known key (expected one of: schema_version"),
    ("vehicels", [], "vehicels", "did you mean vehicles?"),
    ("phases", [], "horizon", "stands beside phases"),
    ("schema_version", 2, "schema_version", "is 2 (expected 1)"),
    ("horizon", {"duration_s": 1, "min_s": 1}, "horizon", "needs duration_s, or min_s with max_s"),
    ("horizon", {"min_s": 9, "max_s": 3}, "horizon", "0 < min_s <= max_s"),
    ("cost", {"control_energy": 0}, "cost", "no weight above zero"),
    ("solver", {"nodes": 1.5}, "solver.nodes", "a whole number"),
    ("solver", {"nodes": 1}, "solver.nodes", "2 or more"),
    ("meta", {"frame": "lvlh"}, "meta.frame", "RTN or LVLH_CCSDS"),
    ("meta", {"epoch": NAN}, "test.yaml", "NaN"),
    (f"{DYNAMICS}.model", "rigid-boddy", f"{DYNAMICS}.model", "did you mean rigid-body?"),
    # names
    ("name", "../escape", "name", "letters, digits"),
    (f"{VEHICLE}.name", "a.b", f"{VEHICLE}.name", "letters, digits"),
    (f"{VEHICLE}.name", "block", f"{VEHICLE}.name", "as is that of a structure"),
    (f"{VEHICLE}.goal.frame", "blok", f"{VEHICLE}.goal.frame", "did you mean block?"),
    (f"{VEHICLE}.goal.frame", "spacecraft", f"{VEHICLE}.goal.frame", "(expected one of: block)"),
    (
        "margins.overrides",
        [{"between": ["spacecraft.hul", "block"], "margin_m": 0.2}],
        "margins.overrides[0].between[0]",
        "did you mean spacecraft.hull or spacecraft?",
    ),
    (
        "margins.overrides",
        [{"between": ["block", "block.core"], "margin_m": 0.2}],
        "margins.overrides[0].between",
        "not kept apart",
    ),
    (
        "margins.overrides",
        [{"between": ["spacecraft", "block"]}],
        "margins.overrides[0]",
        "one of margin_m and contact",
    ),
    (
        "margins.overrides",
        [{"between": ["spacecraft", "block"], "margin_m": 0.2, "window_s": [9, 3]}],
        "margins.overrides[0].window_s",
        "from < to",
    ),
    # motions
    (MOTION, {"type": "spin", "rate_rad_s": 1, "axis": [0, 0, 0]}, MOTION, "zero"),
    (
        MOTION,
        {"type": "constant-velocity", "velocity_m_s": [1, 0]},
        f"{MOTION}.velocity_m_s",
        "shape 2",
    ),
    (
        MOTION,
        {"type": "tabulated", "times_s": [0, 1], "positions_m": [[0, 0, 0], [1, 0, 0]]},
        "structures[0].position_m",
        "beside a table",
    ),
]


@pytest.mark.parametrize(
    ("path", "value", "where", "says"), CASES, ids=[f"{c[0]}-{i}" for i, c in enumerate(CASES)]
)
def test_a_bad_value_is_refused_where_it_stands(
    document: Document, refused: Refused, path: str, value: Any, where: str, says: str
) -> None:
    from_document(document)
    _set(document, path, value)
    message = refused(document)
    assert message.startswith("test.yaml: " + where + ":" if where != "test.yaml" else where)
    assert says in message
    assert "\n" not in message


@pytest.mark.parametrize("key", ["schema_version", "name", "horizon", "margins", "vehicles"])
def test_missing_keys_are_named(document: Document, refused: Refused, key: str) -> None:
    del document[key]
    assert refused(document).startswith(f"test.yaml: {key}: is missing")


def test_several_problems_are_counted(document: Document, refused: Refused) -> None:
    _set(document, f"{DYNAMICS}.mass_kg", -1)
    _set(document, "margins.default_m", -1)
    assert "[and 1 more problem]" in refused(document)


@pytest.mark.parametrize("raw", [None, [], "text", 3])
def test_a_document_that_is_no_block(raw: Any, refused: Refused) -> None:
    assert "expected a block of keys" in refused(raw)


def test_names_used_twice(document: Document, refused: Refused) -> None:
    document["structures"].append(dict(document["structures"][0]))
    message = refused(document)
    assert message.startswith("test.yaml: structures[1].name: is 'block', as is that of entry 0")
    document["structures"].pop()
    document["vehicles"].append(dict(document["vehicles"][0]))
    assert "vehicles[1].name" in refused(document)
    document["vehicles"].pop()
    parts = document["structures"][0]["parts"]
    parts.append(dict(parts[0]))
    assert "structures[0].parts[1].name" in refused(document)
    parts.pop()
    wrench = {"name": "arm", "times_s": [0], "force_n": [[0, 0, 0]], "torque_nm": [[0, 0, 0]]}
    document["vehicles"][0]["dynamics"]["wrenches"] = [wrench, wrench]
    assert "vehicles[0].dynamics.wrenches[1].name" in refused(document)
    del document["vehicles"][0]["dynamics"]["wrenches"]
    phase = {key: document.pop(key) for key in ("horizon", "vehicles")}
    document["phases"] = [{"name": "a", **phase}, {"name": "a", **phase}]
    assert "phases[1].name" in refused(document)


def test_a_table_must_cover_the_horizon(document: Document, refused: Refused) -> None:
    structure = document["structures"][0]
    del structure["position_m"]
    table = {"type": "tabulated", "times_s": [0, 150], "positions_m": [[5, 0, 0], [5, 1, 0]]}
    structure["motion"] = table
    from_document(document)
    table["times_s"] = [0, 149]
    message = refused(document)
    assert (
        "structures[0].motion.times_s: runs from 0 to 149 s (expected all of 0 to 150 s)" in message
    )


def test_a_first_phase_needs_a_start(document: Document, refused: Refused) -> None:
    del document["vehicles"][0]["start"]
    assert "start is missing" in refused(document)


def test_a_point_mass_neither_turns_nor_has_torque(planar: Document, refused: Refused) -> None:
    vehicle = planar["vehicles"][0]
    vehicle["limits"]["max_torque_nm"] = 1
    assert "vehicles[0].limits.max_torque_nm: limits what a point mass does not have" in refused(
        planar
    )
    del vehicle["limits"]["max_torque_nm"]
    vehicle["goal"]["attitude"] = [0, 1, 0, 0]
    assert "vehicles[0].goal.attitude: is asked of a point mass" in refused(planar)
    vehicle["goal"]["attitude"] = "free"
    vehicle["goal"]["rate_rad_s"] = [0, 0, 1]
    assert "vehicles[0].goal.rate_rad_s: is asked of a point mass" in refused(planar)
    del vehicle["goal"]["rate_rad_s"]
    from_document(planar)


def test_dimensions_do_not_mix(planar: Document, document: Document, refused: Refused) -> None:
    planar["structures"][0]["attitude"] = [1, 0, 0, 0]
    assert "structures[0].attitude: is a turn in space" in refused(planar)
    del planar["structures"][0]["attitude"]
    planar["vehicles"][0]["dynamics"] = document["vehicles"][0]["dynamics"]
    assert "is rigid-body, of 3 dimensions in a scenario of 2" in refused(planar)
    document["vehicles"][0]["start"]["position_m"] = [0, 0]
    assert "vehicles[0].start.position_m: has 2 components" in refused(document)
    document["vehicles"][0]["start"]["position_m"] = [0, 0, 0]
    document["structures"][0]["position_m"] = [0, 0]
    assert "structures[0].position_m: has 2 components" in refused(document)
