from pathlib import Path

import pytest

from berthing import planner
from berthing.report.folder import write_result
from berthing.report.offline.page import shown_page
from berthing.report.offline.shown import Shown
from berthing.report.plan_json import plan_document
from berthing.scenario.files import load
from support import chromium, synthetic
from support.page_reading import at_size


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    with chromium.Browser(tmp_path_factory.mktemp("browser") / "profile") as found:
        yield found


@pytest.fixture(scope="session")
def planned(tmp_path_factory):
    """Plan folders of cases that ship, each planned once."""
    home = tmp_path_factory.mktemp("plans")

    def folder(name):
        target = home / name
        if not target.exists():
            scenario = load(name)
            write_result(scenario, planner.plan(scenario), scenario.solver, target)
        return target

    return folder


@pytest.fixture(scope="session")
def handmade(tmp_path_factory):
    """Pages of plans made by hand: quick, and of kinds that no case that ships has."""
    home = tmp_path_factory.mktemp("pages")

    def page(name, *scenarios, certified=True, claims=synthetic.claims):
        path = home / f"{name}.html"
        path.write_text(shown_page([shown(of, certified, claims) for of in scenarios]))
        return path

    return page


def shown(of, certified=True, claims=synthetic.claims):
    plan, verification = synthetic.plan(of), synthetic.verification(of, certified)
    outcome = "certified" if certified else "not_certified"
    document = plan_document(of, plan, verification, outcome)
    return Shown(of.name, of, plan, verification, claims(of), document)


@pytest.fixture
def opened(browser):
    """Opens pages at a width by name, and closes them."""
    pages = []

    def open_page(path: Path, size="desktop", **options):
        pages.append(at_size(browser, path, size, **options))
        return pages[-1]

    yield open_page
    for page in pages:
        page.close()
