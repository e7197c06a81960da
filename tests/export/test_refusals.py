"""What is refused, and that nothing is left behind."""

import builtins
import json
import shutil

import pytest

from berthing.errors import InputError
from berthing.export import exporting
from berthing.export.exporting import export
from berthing.export.formats import FORMATS, format_named
from support import plan_folder

NEEDING = [name for name, kind in FORMATS.items() if kind.needs]
FREE = [name for name, kind in FORMATS.items() if not kind.needs]


@pytest.fixture
def bare_folder(tmp_path):
    """A plan without ``meta:``."""
    return plan_folder.write(tmp_path / "bare", plan_folder.scenario("carrier", meta={}))


@pytest.mark.parametrize("name", NEEDING)
def test_every_key_that_a_format_needs_is_asked_for(bare_folder, tmp_path, name):
    with pytest.raises(InputError) as refused:
        export(bare_folder, FORMATS[name], tmp_path / "out")
    for key in FORMATS[name].needs:
        assert f"{key}: " in str(refused.value)
    assert not list(tmp_path.glob("*out*"))


@pytest.mark.parametrize("name", NEEDING)
def test_each_key_alone_is_missed(folder, tmp_path, name):
    for key in FORMATS[name].needs:
        without = {key: None} | ({"object_ids": None} if key == "naif_ids" else {})
        with pytest.raises(InputError, match=f"lacks {key}"):
            export(folder, FORMATS[name], tmp_path / "out", extra_meta=without)


@pytest.mark.parametrize("name", FREE)
def test_formats_with_a_clock_of_their_own_need_none(bare_folder, tmp_path, name):
    (path,) = export(bare_folder, FORMATS[name], tmp_path / "out")
    assert b"Epoch: not given" in path.read_bytes() or name == "mat"


def test_one_vehicle_without_an_id_is_enough_to_refuse(pair_folder, tmp_path):
    with pytest.raises(InputError, match="lacks object_ids"):
        export(pair_folder, FORMATS["oem"], tmp_path / "out")


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("frame", "LVLH"),
        ("frame", "lvlh"),
        ("frame", ["EME2000"]),
        ("centre", "Erde\nMond"),
        ("centre", "Fobos ☄"),
        ("centre", "x" * 81),
        ("centre", True),
        ("object_ids", "2026-001A"),
        ("object_ids", {"carrier": ""}),
        ("object_names", {"carrier": "Träger"}),
        ("epoch", "soon"),
    ],
)
def test_values_that_cannot_be_written_are_refused(folder, tmp_path, key, value):
    with pytest.raises(InputError, match="meta"):
        export(folder, FORMATS["oem"], tmp_path / "out", extra_meta={key: value})
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", [n for n, kind in FORMATS.items() if kind.single])
def test_several_vehicles_need_a_choice(pair_folder, tmp_path, name):
    with pytest.raises(InputError, match="carrier, scout, puck"):
        export(pair_folder, FORMATS[name], tmp_path / "out")
    export(pair_folder, FORMATS[name], tmp_path / "out", vehicle="scout")


@pytest.mark.parametrize("name", [n for n, kind in FORMATS.items() if kind.attitude_only])
def test_a_point_mass_has_no_attitude(pair_folder, tmp_path, name):
    with pytest.raises(InputError, match="point mass"):
        export(pair_folder, FORMATS[name], tmp_path / "out", vehicle="puck")


def test_an_unknown_vehicle_is_refused(folder, tmp_path):
    with pytest.raises(InputError, match="did you mean carrier"):
        export(folder, FORMATS["mat"], tmp_path / "out", vehicle="carier")


@pytest.mark.parametrize("name", [None, "xlsx"])
def test_a_missing_or_unknown_format_names_the_options(name):
    with pytest.raises(InputError) as refused:
        format_named(name)
    for option in FORMATS:
        assert option in str(refused.value)
    assert format_named("OEM") is FORMATS["oem"]


@pytest.mark.parametrize("name", [n for n, kind in FORMATS.items() if kind.package])
def test_a_missing_package_says_how_to_get_it(folder, tmp_path, name, monkeypatch):
    package = FORMATS[name].package

    def absent(wanted, *rest):
        if wanted == package:
            raise ModuleNotFoundError(f"No module named {package!r}", name=package)
        return builtins.__import__(wanted, *rest)

    monkeypatch.setattr("berthing.export.extras.import_module", absent)
    with pytest.raises(InputError, match=rf"pip install {package}.*berthing\[export\]"):
        export(folder, FORMATS[name], tmp_path / "out")


def test_files_of_two_plans_are_refused(folder, tmp_path):
    mixed = tmp_path / "mixed"
    shutil.copytree(folder, mixed)
    other = plan_folder.write(tmp_path / "other", plan_folder.scenario("carrier", meta={"a": 1}))
    shutil.copy(other / "interpolant.json", mixed)
    with pytest.raises(InputError, match="another scenario"):
        export(mixed, FORMATS["mat"], tmp_path / "out")


def test_a_motion_with_a_gap_is_refused(folder, tmp_path):
    torn = tmp_path / "torn"
    shutil.copytree(folder, torn)
    path = torn / "interpolant.json"
    document = json.loads(path.read_text())
    document["phases"][0]["vehicles"][0]["segments"][2]["t0_s"] += 0.5
    path.write_text(json.dumps(document))
    with pytest.raises(InputError, match="without gaps"):
        export(torn, FORMATS["mat"], tmp_path / "out")


def test_what_is_not_certified_is_marked(tmp_path):
    source = plan_folder.write(
        tmp_path / "bad", plan_folder.scenario("carrier"), outcome="not_certified"
    )
    (path,) = export(source, FORMATS["oem"], tmp_path / "out.oem")
    assert "NOT CERTIFIED" in path.read_text()


def test_targets_that_are_no_files_are_refused(folder, tmp_path):
    with pytest.raises(InputError, match="is a folder"):
        export(folder, FORMATS["mat"], tmp_path)
    with pytest.raises(InputError, match="does not exist"):
        export(folder, FORMATS["mat"], tmp_path / "no" / "out.mat")
    with pytest.raises(InputError, match="plan folder"):
        export(folder, FORMATS["basilisk"], folder / "nodes.csv")


def test_a_failure_leaves_what_was_there(folder, tmp_path, monkeypatch):
    target = tmp_path / "out.mat"
    target.write_text("older")

    def fail(name):
        module = type("module", (), {})()

        def write(handover, path):
            path.write_text("half")
            raise KeyboardInterrupt

        module.write = write
        return module

    monkeypatch.setattr(exporting, "import_module", fail)
    with pytest.raises(KeyboardInterrupt):
        export(folder, FORMATS["mat"], target)
    assert target.read_text() == "older"
    assert list(tmp_path.iterdir()) == [target]


def test_an_older_file_is_replaced(folder, tmp_path):
    target = tmp_path / "out.oem"
    target.write_text("older")
    assert export(folder, FORMATS["oem"], target) == [target]
    assert target.read_text().startswith("CCSDS_OEM_VERS")
    assert list(tmp_path.iterdir()) == [target]


def test_a_full_disk_is_told_of(folder, tmp_path, monkeypatch):
    def fail(name):
        module = type("module", (), {})()
        module.write = lambda handover, path: (_ for _ in ()).throw(OSError(28, "No space left"))
        return module

    monkeypatch.setattr(exporting, "import_module", fail)
    with pytest.raises(InputError, match="No space left"):
        export(folder, FORMATS["mat"], tmp_path / "out.mat")


def test_states_that_do_not_tell_rates_are_refused_where_rates_are_written(folder, monkeypatch):
    from berthing.export.samples import Samples

    monkeypatch.setattr(Samples, "tells_rates", False)
    with pytest.raises(InputError, match="velocity and rate"):
        export(folder, FORMATS["oem"])
