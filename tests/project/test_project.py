import json
import re
from pathlib import Path

import pytest
from ruamel.yaml import YAML

from berthing._version import __version__
from berthing.commands import exit_codes
from berthing.scenario.files import from_document
from berthing.trajectory_io import HEADER

ROOT = Path(__file__).parents[2]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def addresses(lock):
    """Lines of a lock that are neither a version nor a hash."""
    version = r"[a-z0-9.-]+==[0-9][\w.+!]*( ;.*)? \\"
    allowed = re.compile(rf"{version}|    --hash=sha256:[0-9a-f]{{64}}( \\)?")
    return [line for line in lock.splitlines() if line and not allowed.fullmatch(line)]


def test_the_lock_has_versions_and_hashes_only():
    assert addresses(text("requirements.lock")) == []


@pytest.mark.parametrize(
    "line",
    [
        "--index-url https://example.org/simple",
        "--find-links /somewhere",
        "numpy @ file:///numpy.whl \\",
        "numpy==2.0.0",
        "    # via scipy",
    ],
)
def test_a_lock_with_anything_else_is_noticed(line):
    assert addresses(f"{text('requirements.lock')}{line}\n") == [line]


def test_the_lock_has_every_dependency():
    block = text("pyproject.toml").split("\ndependencies = [")[1].split("]")[0]
    wanted = re.findall(r'"([\w.-]+)>=', block)
    locked = re.findall(r"^([\w.-]+)==", text("requirements.lock"), re.MULTILINE)
    assert wanted
    assert {name.replace(".", "-") for name in wanted} <= set(locked)


def test_the_lock_of_the_page_has_versions_and_hashes_only():
    lock = json.loads(text("viewer/package-lock.json"))
    packages = {name: found for name, found in lock["packages"].items() if name}
    assert packages
    for name, found in packages.items():
        assert {"version", "integrity"} <= set(found), name
        assert "resolved" not in found, name
    assert "://" not in text("viewer/package.json")


def test_the_page_has_what_its_source_says_it_contains():
    wanted = json.loads(text("viewer/package.json"))["dependencies"]
    licences = text("src/berthing/report/offline/assets/LICENCES.txt")
    assert set(wanted) == {"three", "uplot"}
    for name, version in wanted.items():
        assert f"{name} {version}\n" in licences


def test_the_page_has_every_element_that_its_script_asks_for():
    page = text("src/berthing/report/offline/assets/page.html")
    scripts = "".join(path.read_text("utf-8") for path in (ROOT / "viewer/src").glob("**/*.ts"))
    asked = set(re.findall(r'\belement(?:<\w+>)?\("([\w-]+)"\)', scripts))
    assert {"time", "canvas", "play"} <= asked
    assert asked <= set(re.findall(r'\bid="([\w-]+)"', page))


def test_the_scenario_in_the_readme_is_one():
    (block,) = re.findall(r"```yaml\n(.*?)```", text("README.md"), re.DOTALL)
    scenario = from_document(YAML(typ="safe", pure=True).load(block), "README.md")
    assert scenario.name == "past-the-block"


def test_the_readme_has_every_exit_code():
    rows = re.findall(r"^\| (\d+) \|", text("README.md"), re.MULTILINE)
    codes = [value for name, value in vars(exit_codes).items() if name.isupper()]
    assert sorted(map(int, rows)) == sorted(codes)


def test_the_conventions_have_the_columns_as_they_are_written():
    assert ",".join(HEADER) in text("docs/conventions.md")


def test_the_citation_has_the_version():
    assert f"version: {__version__}\n" in text("CITATION.cff")
