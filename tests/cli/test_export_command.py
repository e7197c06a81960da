import pytest

from berthing.export.formats import FORMATS
from support import plan_folder


@pytest.fixture
def plan(tmp_path):
    """A plan folder, ``plan``, in the working folder, without ``meta:``."""
    scenario = plan_folder.scenario("carrier", meta={"frame": "EME2000"})
    plan_folder.write(tmp_path / "plan", scenario)
    (tmp_path / "mission.yaml").write_text(
        "meta:\n  epoch: 2026-03-01T12:00:00Z\n  centre: EARTH\n"
        "  object_ids: {carrier: 2026-001A}\n  naif_ids: {carrier: -100001}\n"
    )


@pytest.mark.usefixtures("plan")
@pytest.mark.parametrize("name", list(FORMATS))
def test_every_format_is_written(run, tmp_path, name):
    done = run("export", "plan", "--to", name, "--meta", "mission.yaml")
    assert (done.exit_code, done.stderr) == (0, "")
    written = done.stdout.split()
    assert written[0] == f"test{FORMATS[name].suffix}"
    assert all((tmp_path / file).stat().st_size > 1000 for file in written)


@pytest.mark.usefixtures("plan")
def test_the_file_and_the_vehicle_can_be_chosen(run, tmp_path):
    done = run("export", "plan", "--to", "MAT", "--out", "a.mat", "--vehicle", "carrier")
    assert (done.exit_code, done.stdout) == (0, "a.mat\n")
    assert (
        run("export", "plan", "--to", "mat", "--vehicle", "carrier").stdout == "test-carrier.mat\n"
    )


@pytest.mark.usefixtures("plan")
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["export", "plan"], "oem, aem, basilisk"),
        (["export", "plan", "--to", "xlsx"], "oem, aem, basilisk"),
        (["export", "plan", "--to", "oem"], "lacks epoch, centre, object_ids"),
        (["export", "absent", "--to", "oem"], "absent"),
        (["export", "plan", "--to", "oem", "--meta", "absent.yaml"], "absent.yaml"),
        (["export", "plan", "--to", "mat", "--vehicle", "x"], "--vehicle"),
    ],
)
def test_bad_input_exits_2_and_writes_nothing(run, tmp_path, words, said):
    before = sorted(tmp_path.rglob("*"))
    done = run(*words)
    assert done.exit_code == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stdout == ""
    assert sorted(tmp_path.rglob("*")) == before


def test_help_names_every_format(run):
    text = " ".join(run("export", "--help").stdout.split())
    assert "Examples" in text
    for name in FORMATS:
        assert name in text
