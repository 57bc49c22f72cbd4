"""The page docs/why.md: its program and its answers are those of the command."""

import re
import shlex
from pathlib import Path

from click.testing import CliRunner

from learnblock.cli import main
from learnblock.why import EventHistory, read
from learnblock.why.parser import parse
from learnblock.why.questions import QuestionKind
from places import ROOT

PAGE = (ROOT / "docs" / "why.md").read_text(encoding="utf-8")


def write_program():
    [(name, program)] = re.findall(
        r"^```blocktext (\S+)\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL
    )
    Path(name).write_text(program, encoding="utf-8")


def test_the_worked_examples_print_what_the_page_shows(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "en")
    write_program()
    sessions = re.findall(r"^```console\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    session = "".join(sessions)
    for command, shown in re.findall(
        r"^\$ learnblock (.*)\n((?:[^$].*\n)*)", session, re.MULTILINE
    ):
        assert CliRunner().invoke(main, shlex.split(command)).stdout == shown


def test_each_question_of_the_page_is_understood(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_program()
    run = ["run", "away.bt", "--world", "arena", "--for", "2", "--why", "away.why"]
    CliRunner().invoke(main, run)
    history = EventHistory(read("away.why"))
    table = PAGE.partition("| you ask about |")[2].partition("\n\n")[0]
    asked = [one for one in re.findall(r"`([^`]+)`", table) if "near" not in one]
    assert {parse(one, history).ask for one in asked} >= {*QuestionKind} - {
        QuestionKind.WHEN,
        QuestionKind.NOT_WHEN,
        QuestionKind.NOT_LINE,
        # This run reached no goal and printed nothing.
        QuestionKind.REACHED,
        QuestionKind.PRINTED,
        # It was no game.
        QuestionKind.SCORE,
        QuestionKind.LIVES,
        QuestionKind.GAME,
    }
