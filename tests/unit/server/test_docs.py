"""The docs about the page and its server match the code."""

import re

import pytest
from click.testing import CliRunner

from learnblock.blocks import block_sets, builtin
from learnblock.blocks.palette import palette
from learnblock.cli import main
from learnblock.errors import BlockSetError
from learnblock.project.files import project_file
from places import ROOT

DOCS = ROOT / "docs"


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
def test_every_page_that_the_docs_link_to_exists(page):
    text = re.sub(r"`[^`\n]*`", "", page.read_text(encoding="utf-8"))
    named = re.findall(r"\]\((?!https?:)([^)#:]+)", text)
    assert [name for name in named if not (DOCS / name).exists()] == []


def test_the_set_of_blocks_in_the_docs_is_one():
    text = (DOCS / "class.md").read_text("utf-8")
    shown = re.search(r"```toml\n(.*?)```", text, re.DOTALL)[1]
    assert block_sets.parse(shown, "tuesday").title["en"] == "On Tuesday"
    shown_error = re.search(r"```text\n(.*?)```", text, re.DOTALL)[1]
    with pytest.raises(BlockSetError) as refused:
        block_sets.parse(shown.replace("blocks =", "block =", 1), "tuesday")
    assert str(refused.value) == shown_error.strip()


def test_every_set_and_every_tab_of_the_language_is_in_the_docs():
    text = (DOCS / "class.md").read_text("utf-8")
    tabs = {tab["category"] for tab in palette(builtin(), "en")["toolbox"]["contents"]}
    assert [one for one in (*block_sets.BUILT_IN, *tabs) if f"`{one}`" not in text] == []
