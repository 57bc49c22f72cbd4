"""docs/first-hour.md: what it quotes is what the pages say, and its commands exist."""

import re

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.lessons.reading import find_lesson, shipped_folder
from learnblock.lessons.texts import in_language
from places import ROOT

PAGE = (ROOT / "docs/first-hour.md").read_text("utf-8")
PROSE = re.sub(r"^\s*```.*?^\s*```$", "", PAGE, flags=re.MULTILINE | re.DOTALL)
ENGLISH = ROOT / "src/learnblock/i18n/en"
#: Words in italics that are not LearnBlock's.
OTHERS = {"Test", "client isolation", "mirrored"}


def words(*files):
    """Return what these files say, with their numbers as on the page."""
    text = "\n".join((ENGLISH / file).read_text("utf-8") for file in files)
    return re.sub(
        r"\{ \$(\w+) \}", lambda value: {"count": "5", "most": "4"}.get(value[1], ""), text
    )


def test_each_button_that_it_names_is_on_a_page():
    shown = words("page/class.ftl", "page/bar.ftl", "page/start.ftl", "page/teachers.ftl")
    titles = [
        in_language(find_lesson(path.name).lesson.title, "en")
        for path in shipped_folder().iterdir()
        if path.is_dir()
    ]
    blocks = (ROOT / "src/learnblock/blocks/configurations/words/en.json").read_text("utf-8")
    named = {*re.findall(r"(?<!\*)\*([^*\n]+)\*(?!\*)", PROSE)} - OTHERS
    assert len(named) > 12
    assert [
        name
        for name in named
        if not re.search(rf"= {re.escape(name)}$", shown, re.MULTILINE)
        and name not in titles
        and f'"{name}"' not in blocks
    ] == []


def test_each_message_that_it_explains_is_one():
    rows = re.findall(
        r"^\| ([A-Z].*?) \|", PAGE.partition("## If something fails")[2], re.MULTILINE
    )
    said = [row for row in rows if row.endswith(".") or "the name" in row]
    assert len(said) == 7
    shown = words("class.ftl")
    assert [row for row in said if f"= {row}" not in shown] == []


@pytest.mark.parametrize("command", ["lesson show 1-01-first-drive --solutions"])
def test_its_command_for_the_notes_prints_them(command):
    assert f"\nlearnblock {command}\n" in PAGE
    printed = CliRunner().invoke(main, command.split()).stdout
    assert "Time plan" in printed


def test_the_lesson_takes_as_long_as_it_says():
    lesson = find_lesson("1-01-first-drive").lesson
    assert f"do the five steps, about {lesson.minutes} minutes" in PAGE
    assert len(lesson.step) == 5
