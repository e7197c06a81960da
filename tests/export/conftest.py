import pytest

from berthing.export.exporting import export
from berthing.export.formats import FORMATS
from support import plan_folder


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """The plan folder of one vehicle, with all of ``meta:``."""
    return plan_folder.write(
        tmp_path_factory.mktemp("plans") / "one", plan_folder.scenario("carrier")
    )


@pytest.fixture(scope="session")
def pair_folder(tmp_path_factory):
    """Of two vehicles with attitude and a point mass."""
    scenario = plan_folder.scenario("carrier", "scout", point="puck")
    return plan_folder.write(tmp_path_factory.mktemp("plans") / "three", scenario)


@pytest.fixture(scope="session")
def phases_folder(tmp_path_factory):
    """Of one vehicle in two phases."""
    scenario = plan_folder.two_phase_scenario()
    return plan_folder.write(tmp_path_factory.mktemp("plans") / "two", scenario)


@pytest.fixture(scope="session")
def truth(folder):
    return plan_folder.Truth(folder)


@pytest.fixture
def to(folder, tmp_path):
    """Exports the plan of one vehicle; the file."""

    def write(name, *, source=folder, file="out", **more):
        kind = FORMATS[name]
        return export(source, kind, tmp_path / f"{file}{kind.suffix}", **more)[0]

    return write


@pytest.fixture(
    params=[lambda q: q, lambda q: q[..., ::-1], lambda q: q * [-1, -1, -1, 1] @ SHIFT],
    ids=["scalar first", "backwards", "conjugate"],
)
def wrong_order(request):
    """Mistaken ways of writing (w, x, y, z) as scalar last."""
    return request.param


# (x, y, z, w)-columns from (w, x, y, z).
SHIFT = [[0, 0, 0, 1], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
