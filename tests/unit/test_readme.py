"""The README's program and commands work as described."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from places import ROOT

README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    """Return the README's fenced blocks in a language ("" for commands)."""
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


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
    assert "pip install uv && uv run pytest" in blocks("")[1]
    assert "pip install uv && uv run pytest" in (ROOT / ".ci" / "run").read_text()


def test_every_linked_page_exists():
    named = re.findall(r"\]\(([^)#:]+)\)", README)
    assert [name for name in named if not (ROOT / name).exists()] == []


@pytest.mark.slow
def test_the_demonstration_shows_three_feelings_and_draws_a_picture(tmp_path):
    picture = tmp_path / "demo.png"
    result = CliRunner().invoke(main, ["demo", "--picture", str(picture)])
    assert result.exit_code == 0
    assert "shown      neutral, joy, surprise, fear" in result.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
