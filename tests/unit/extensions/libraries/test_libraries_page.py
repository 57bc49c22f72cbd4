"""The examples about libraries in docs/blocks.md, in the order of the page."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock import language, running
from learnblock.cli import main
from learnblock.extensions import libraries
from places import ROOT

PAGE = (ROOT / "docs" / "blocks.md").read_text("utf-8").partition("\n## Libraries\n")[2]
SESSIONS = re.findall(r"```console\n(.*?)```", PAGE, re.DOTALL)
COMMAND = re.compile(r"^\$ learnblock (.*)\n((?:[^$].*\n)*)", re.MULTILINE)


def example(kind):
    return re.search(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL)[1]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("ball.bt").write_text(example(r"blocktext ball\.bt"))
    Path("use.bt").write_text(example("blocktext"))
    return tmp_path


def test_the_commands_print_what_the_page_shows(folder):
    commands = [one for session in SESSIONS for one in COMMAND.findall(session)]
    said = [CliRunner().invoke(main, shlex.split(command)).output for command, _ in commands]
    assert said == [output for _, output in commands]
    assert running.check(running.read(folder / "use.bt")) == []


def test_the_program_becomes_the_python_below_it():
    written = language.to_python(language.parse(example("blocktext")), "learnblock.robots.ebo")
    assert example("python") == written.text


def test_the_manifest_is_valid():
    files = {"library.toml": example("toml").encode(), "__init__.py": b"def waltz(robot): pass\n"}
    assert libraries.from_files(files, "dance").manifest.title["es"] == "Salón de baile"


def test_the_limits_on_the_page_are_those_of_the_code():
    from learnblock.extensions.libraries.contents import LARGEST, MOST_FILES

    assert f"at most {MOST_FILES}, with {LARGEST // 2**20} MB in total" in PAGE
