import re
from pkgutil import resolve_name

import pytest
from ruamel.yaml.error import YAMLError

from support.code_blocks import ACTIONS, DOCS, ROOT, SHOWN, Block, Reader, blocks, pages

# The README's commands set everything up: CI is what runs them. Its scenario is read, and its
# Python is that of the tutorial.
SITE = [page for page in pages() if page.is_relative_to(DOCS)]
RUN = [page for page in SITE if any(b.language not in SHOWN for b in blocks(page))]


def name(page):
    return str(page.relative_to(ROOT))


@pytest.mark.slow
@pytest.mark.parametrize("page", RUN, ids=name)
def test_a_reader_can_follow_the_page(page, tmp_path):
    reader = Reader(tmp_path)
    for block in blocks(page):
        reader.follow(block)


@pytest.mark.parametrize("page", pages(), ids=name)
def test_each_block_is_of_a_language_that_is_run_or_shown(page):
    for block in blocks(page):
        assert block.language in ACTIONS or block.language in SHOWN, block.place
    assert page.read_text().count("```") == 2 * len(blocks(page))


def test_the_pages_that_teach_have_something_to_run():
    assert {name(page) for page in RUN} >= {
        "docs/tutorial.md", "docs/how-to/vehicle.md", "docs/how-to/dynamics.md",
        "docs/how-to/moving-target.md", "docs/how-to/failed-plan.md", "docs/how-to/loop.md",
        "docs/how-to/compare.md", "docs/theory.md", "docs/gallery.md",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("language", "code", "error"),
    [
        ("python", "assert 1 == 2", AssertionError),
        ("sh", "false; true", RuntimeError),
        ("sh", "berthing plan absent.yaml", RuntimeError),
        ("yaml", "a: [1", YAMLError),
        ("json", "{", ValueError),
        ("fortran", "END", KeyError),
    ],
)
def test_a_block_that_does_not_work_is_noticed(language, code, error, tmp_path):
    with pytest.raises(error):
        Reader(tmp_path).follow(Block("a:1", language, None, code))


NAMES = re.compile(r"`(berthing(?:\.\w+)+)`|^::: (berthing(?:\.\w+)+)$", re.MULTILINE)


@pytest.mark.parametrize("page", SITE, ids=name)
def test_names_of_the_package_exist(page):
    for one, other in NAMES.findall(page.read_text()):
        assert resolve_name(one or other) is not None


def test_a_name_that_does_not_exist_would_be_noticed():
    (found,) = NAMES.findall("see `berthing.planner.plam` here")
    with pytest.raises(AttributeError):
        resolve_name(found[0])


def test_every_page_of_the_navigation_exists():
    nav = (ROOT / "mkdocs.yml").read_text().split("\nnav:")[1]
    named = set(re.findall(r"([\w/-]+\.md)", nav)) - {"examples.md"}
    assert len(named) > 15
    assert named <= {str(page.relative_to(DOCS)) for page in SITE}


def test_the_lock_of_the_docs_has_versions_and_hashes_only():
    lock = (ROOT / "requirements-docs.lock").read_text()
    wanted = re.findall(r"^([\w-]+)", (ROOT / "requirements-docs.in").read_text(), re.MULTILINE)
    locked = re.findall(r"^([\w.-]+)==[^ ]+ \\\n    --hash=sha256:", lock, re.MULTILINE)
    assert len(wanted) == 3
    assert set(wanted) <= set(locked)
    assert len(locked) == lock.count("==")
    assert "://" not in lock
    assert "index-url" not in lock


def test_blocks_share_a_folder_and_a_session(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        '# x\n\n```yaml title="a/b.yaml"\nk: 1\n```\n\n'
        '```python\nfrom pathlib import Path\nx = Path("a/b.yaml").read_text()\n```\n'
        "1. y\n\n    ```sh\n    cat a/b.yaml > c\n    ```\n\n```text\nnot run\n```\n"
    )
    reader = Reader(tmp_path)
    found = blocks(page)
    assert [b.language for b in found] == ["yaml", "python", "sh", "text"]
    for block in found:
        reader.follow(block)
    assert reader.names["x"] == (tmp_path / "c").read_text() == "k: 1\n"


def test_the_gallery_shows_cases_that_ship_with_pictures():
    from berthing.scenario.library import library

    text = (DOCS / "gallery.md").read_text()
    shown = re.findall(r"^## (.*)$", text, re.MULTILINE)
    # The site's builder adds a case that the page says nothing of.
    assert len(shown) > 10
    assert set(shown) <= set(library())
    for case in shown:
        assert f"](images/{case}.png)" in text
        assert (DOCS / "images" / f"{case}.png").stat().st_size < 250_000
