"""The README's program and commands work as described."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from PIL import Image

from learnblock import language, running
from learnblock.cli import main
from places import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")
DOCS = ROOT / "docs"
PACKAGE = ROOT / "src/learnblock"
#: All pages that link to others.
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md")),
    ROOT / "examples/README.md",
    *sorted(DOCS.rglob("*.md")),
]
#: What may name a page of the docs, such as a message.
NAMING = (
    *("src/**/*.py", "src/**/*.ftl", "src/**/*.template", "frontend/src/**/*.ts*"),
    *("scripts/*", "benchmarks/*.py", "tests/**/*.py", "pyproject.toml"),
)
#: Pages of pycozmo.
FOREIGN = {"docs/protocol.md", "docs/functions.md"}
#: Where the words in the picture come from.
WORDS = ("i18n/en/**/*.ftl", "blocks/**/*.json", "simulator/worlds/*.toml")


def blocks(language):
    """Return the README's fenced blocks in a language ("" for commands)."""
    every = re.findall(r"^```(\w*)\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    return [text for its_language, text in every if its_language == language]


@pytest.fixture
def first(tmp_path, monkeypatch):
    """A folder with the reader's first program, in which commands are run."""
    monkeypatch.chdir(tmp_path)
    Path("first.bt").write_text(blocks("blocktext")[0])
    return tmp_path


@pytest.mark.parametrize(
    "command",
    re.findall(r"^learnblock ((?:check|run) first\.bt .*)$", README, re.MULTILINE),
)
def test_a_command_of_the_first_program_works(first, command):
    result = CliRunner().invoke(main, command.split())
    assert result.exit_code == 0, result.stderr


def test_the_first_program_meets_an_obstacle_and_looks_surprised(first):
    [command] = re.findall(r"^learnblock (run first\.bt .*)$", README, re.MULTILINE)
    report = CliRunner().invoke(main, command.split()).stderr
    assert "shown      surprise" in report
    assert "not reached" not in report


def test_its_python_is_the_one_shown_and_runs_by_itself(first):
    result = CliRunner().invoke(
        main, ["convert", "first.bt", "--to", "python", "--robot", "sim-thymio"]
    )
    assert blocks("python")[0] == result.stdout
    Path("first.py").write_text(result.stdout)
    run = [sys.executable, "first.py"]
    environment = {**os.environ, "LEARNBLOCK_LANGUAGE": "en"}
    ended = subprocess.run(
        run, check=True, timeout=60, capture_output=True, text=True, env=environment
    )
    assert re.fullmatch(r"first\.py: [\d.]+ s, \d+ mm driven, in the world \w+\.\n", ended.stderr)


def test_continuous_integration_runs_the_same_test_command():
    assert "pip install uv && uv run pytest\n" in blocks("")
    assert "pip install uv && uv run pytest" in (ROOT / ".ci" / "run").read_text()


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_linked_page_exists(page):
    prose = re.sub(r"```.*?```|`[^`\n]*`", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    named = re.findall(r"\]\(([^)#:]+)[^):]*\)", prose)
    assert [name for name in named if not (page.parent / name).exists()] == []


def anchors(page):
    """Return the anchors of a page's headings, as GitHub and GitLab name them."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    titles = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in titles}


def test_every_link_to_a_heading_finds_it():
    links = [
        (page.parent / name if name else page, anchor)
        for page in PAGES
        for name, anchor in re.findall(r"\]\(([^)#:]*)#([^)]+)\)", page.read_text("utf-8"))
    ]
    assert len(links) > 50
    assert [(to.name, anchor) for to, anchor in links if anchor not in anchors(to)] == []


def test_every_page_that_the_source_names_exists():
    files = [path for pattern in NAMING for path in ROOT.glob(pattern) if path.is_file()]
    text = "\n".join(path.read_text(encoding="utf-8") for path in files)
    named = {*re.findall(r"\bdocs/[a-z/-]+\.md\b", text)}
    assert "docs/add-a-robot.md" in named
    assert [name for name in sorted(named - FOREIGN) if not (ROOT / name).exists()] == []


def test_the_list_of_all_pages_and_that_of_all_commands_are_complete():
    pages = (DOCS / "README.md").read_text(encoding="utf-8")
    assert [page.name for page in DOCS.glob("[a-z]*.md") if f"({page.name})" not in pages] == []
    commands = pages.partition("## All commands")[2].partition("## Glossary")[0]
    named = set(
        re.findall(r"[a-z]+", " ".join(re.findall(r"^\| (.+?) \|", commands, re.MULTILINE)))
    )
    assert set(main.list_commands(None)) - named == set()


@pytest.mark.parametrize("page", ["README.md", "docs/README.md"])
def test_a_command_for_users_installs_nothing_for_developers(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    assert set(re.findall(r"uv run (?!pytest)([\w-]+)", text)) == {"--no-dev"}


def test_the_first_screen_has_one_command_which_opens_the_page():
    begin = README[: README.index("\n## ")]
    assert re.findall(r"^```\n(.*?)^```", begin, re.MULTILINE | re.DOTALL) == [
        "pip install uv && uv run --no-dev learnblock\n"
    ]
    assert len(begin.splitlines()) < 32


def said(picture):
    """Return what a picture of the page says, as `scripts/pictures` has written into it."""
    with Image.open(picture) as opened:
        opened.load()
        return opened.text


def test_the_picture_shows_the_program_as_it_is_today():
    tree = running.read(ROOT / "examples/first/square.bt").tree
    shown = said(DOCS / "images/page.png")["Program"]
    # If this fails, run `scripts/pictures page`.
    assert language.to_python(tree, "learnblock.robots.sim_ev3").text == shown


def test_the_picture_shows_the_words_of_today():
    today = " ".join(
        path.read_text(encoding="utf-8") for pattern in WORDS for path in PACKAGE.glob(pattern)
    )
    shown = said(DOCS / "images/page.png")["Words"].splitlines()
    assert "Run" in shown
    # If this fails, run `scripts/pictures page`.
    assert [words for words in shown if not re.search(rf"\b{re.escape(words)}(?!\w)", today)] == []


def test_every_picture_of_the_readme_is_taken_by_a_script():
    # Those of blocks have tests of their own: test_docs_blocks.py.
    scripts = " ".join(path.read_text(encoding="utf-8") for path in (ROOT / "scripts").iterdir())
    pictures = re.findall(r"!\[.*?\]\(((?!docs/images/blocks/).*?)\)", README)
    assert pictures
    assert [picture for picture in pictures if picture not in scripts] == []


@pytest.mark.slow
def test_the_demonstration_shows_three_feelings_and_draws_a_picture(tmp_path):
    picture = tmp_path / "demo.png"
    result = CliRunner().invoke(main, ["demo", "--picture", str(picture)])
    assert result.exit_code == 0
    assert "shown      neutral, joy, surprise, fear" in result.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
