"""What the docs say of the page and its server is so."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.server.projects import project_file

DOCS = Path(__file__).parents[2] / "docs"


def test_the_project_file_in_the_docs_is_one():
    shown = re.search(r"```json\n(.*?)```", (DOCS / "projects.md").read_text(), re.DOTALL)[1]
    project = project_file.decode(shown.encode(), "shown")
    assert "function.move_straight(40)" in project.blocktext


@pytest.mark.parametrize(
    "option", re.findall(r"^\| `(--[\w-]+)", (DOCS / "server.md").read_text(), re.MULTILINE)
)
def test_an_option_of_the_server_in_the_docs_is_one(option):
    assert option in CliRunner().invoke(main, ["--help"]).stdout


def test_every_option_of_the_server_is_in_the_docs():
    options = re.findall(r"^  (--[\w-]+)", CliRunner().invoke(main, ["--help"]).stdout, re.M)
    described = (DOCS / "server.md").read_text()
    assert [one for one in options if one not in ("--version",) and one not in described] == []


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.name)
def test_every_page_that_the_docs_point_to_is_there(page):
    named = re.findall(r"\]\((?!https?:)([^)#:]+)", page.read_text(encoding="utf-8"))
    assert [name for name in named if not (DOCS / name).exists()] == []
