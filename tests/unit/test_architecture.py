"""The pages for contributors name only what exists."""

import re

import pytest

from build_parts import part_of_build
from places import ROOT

PAGES = [
    ROOT / "docs" / "architecture.md",
    ROOT / "docs" / "decisions.md",
    ROOT / "CONTRIBUTING.md",
]
FOLDERS = ("src/", "frontend/", "tests/", "scripts/", "docs/", "examples/")
#: A name of the code and its file, as in "`judge()` in `src/learnblock/lessons/judging.py`".
NAMED = re.compile(r"`([\w.]+)(?:\(\))?`\s+(?:in|of)\s+`((?:src|frontend)/[^`]+\.\w+)`")
#: How Python and TypeScript define a name.
DEFINITION = r"^\s*(?:(?:async|class|const|def|export|function|private|readonly)\s+)*{0}\b.*[:=({{]"
#: Where code may name a decision.
CODE = ("src/learnblock/**/*.py", "frontend/src/**/*.ts*", "hatch_*.py", "pyproject.toml")


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


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_name_that_it_finds_in_a_file_is_defined_there(page):
    named = NAMED.findall(page.read_text("utf-8"))
    assert page.name != "architecture.md" or len(named) > 50
    assert [
        (name, path)
        for name, path in named
        if not re.search(
            DEFINITION.format(name.rpartition(".")[2]), (ROOT / path).read_text("utf-8"), re.M
        )
    ] == []


def test_the_list_for_a_sensor_has_every_place_of_the_light_sensor():
    page = PAGES[0].read_text("utf-8")
    listed = page.partition("### A type of sensor")[2].partition("\n### ")[0]
    named = tuple(re.findall(r"`((?:src|frontend)/[^`]+)`", listed))
    files = [
        path
        for folder, pattern in (("src/learnblock", "*.*"), ("frontend/src", "*.ts*"))
        for path in (ROOT / folder).rglob(pattern)
        if "static" not in path.parts and "__pycache__" not in path.parts and path.is_file()
    ]
    places = {
        path.relative_to(ROOT).as_posix().replace("/i18n/es/", "/i18n/en/")
        for path in files
        if b"LightSensor" in path.read_bytes()
    }.difference(part_of_build("hatch_types").FILES)
    assert "src/learnblock/devices/sensors.py" in places
    folders = tuple(name for name in named if name.endswith("/"))
    assert [
        place for place in sorted(places) if place not in named and not place.startswith(folders)
    ] == []


def decisions():
    """Return the titles of the decisions, as code names them."""
    titles = re.findall(r"^\*\*(.+?)\*\*", PAGES[1].read_text("utf-8"), re.MULTILINE)
    return {title.replace("`", "").rstrip(".") for title in titles}


def test_each_decision_is_named_by_the_code_that_it_explains():
    files = [path for pattern in CODE for path in ROOT.glob(pattern)]
    code = "\n".join(path.read_text("utf-8") for path in files)
    named = {*re.findall(r'Why: docs/decisions\.md, "([^"]+)"', code)}
    assert len(named) > 40
    assert named == decisions()
