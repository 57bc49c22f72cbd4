"""The pages for contributors name only what exists."""

import re

import pytest

from places import ROOT

PAGES = [
    ROOT / "docs" / "architecture.md",
    ROOT / "docs" / "decisions.md",
    ROOT / "CONTRIBUTING.md",
]
FOLDERS = ("src/", "frontend/", "tests/", "scripts/", "docs/")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_path_in_it_exists(page):
    named = [word.split()[0] for word in re.findall(r"`([^`]+)`", page.read_text("utf-8"))]
    paths = [word for word in named if word.startswith(FOLDERS)]
    assert [path for path in paths if not (ROOT / path).exists()] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_link_in_it_leads_somewhere(page):
    links = re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8"))
    assert [link for link in links if not (page.parent / link).exists()] == []


def test_every_folder_is_in_the_table():
    page = PAGES[0].read_text("utf-8")
    listed = set(re.findall(r"^\| `(\w+)/` \|", page, re.MULTILINE))
    package = ROOT / "src" / "learnblock"
    there = {path.parent.name for path in package.glob("*/__init__.py")}
    assert there - {"static"} == listed & there
