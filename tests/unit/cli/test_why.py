"""The command `why`."""

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.console import ExitCode
from places import ROOT


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    """The log of an example, written by the command `run`."""
    path = tmp_path_factory.mktemp("log") / "avoid.why"
    command = ["run", str(ROOT / "examples/avoid.bt"), "--world", "arena", "--for", "15"]
    done = CliRunner().invoke(main, [*command, "--seed", "0", "--why", str(path)])
    assert done.exit_code == ExitCode.WELL, done.stderr
    return path


def why(log: Path, *more: str):
    return CliRunner().invoke(main, ["why", str(log), *more])


def test_without_a_question_it_lists_what_can_be_asked(log):
    done = why(log)
    assert done.exit_code == ExitCode.WELL
    assert "Why did the robot drive straight ahead at 0 s?" in done.stdout.splitlines()


def test_a_question_is_answered_in_sentences(log):
    done = why(log, "why did the robot turn left at 12.5?")
    assert done.exit_code == ExitCode.WELL
    first, second, third = done.stdout.splitlines()
    assert first.startswith("At 12.")
    assert first.endswith("s the robot was told to turn left on the spot: line 9 says turn(-60).")
    assert "line 5, if is_front_obstacle(100), was true at 11.25 s" in second
    assert third == "Before that, line 8, sleep(1), lasted from 11.25 to 12.25 s."


def test_a_question_in_spanish_is_answered_in_spanish(log, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "es")
    done = why(log, "¿por qué giró a la izquierda en 12,5?")
    assert "el robot recibió la orden de girar a la izquierda" in done.stdout


def test_an_answer_as_json_has_lines_and_times(log):
    done = why(log, "turn left at 12.5", "--json")
    answer = json.loads(done.stdout)
    assert answer["question"]["ask"] == "movement"
    assert [one["line"] for one in answer["sentences"]] == [9, 5, 8]
    assert answer["sentences"][1]["time"] == 11.25
    assert json.loads(why(log, "--json").stdout)[0]["ask"] == "movement"


def test_more_causes_are_printed_on_request(log):
    more = why(log, "goal", "--more").stdout.splitlines()
    fewer = why(log, "goal").stdout.splitlines()
    assert more[: len(fewer)] == fewer


def test_a_question_that_is_not_understood_says_what_can_be_asked(log):
    done = why(log, "why is the sky blue")
    assert done.exit_code == ExitCode.USAGE
    asked = re.findall(r"Why [^?]+\?", done.stderr)
    assert len(asked) == 3
    assert [why(log, question).exit_code for question in asked] == [ExitCode.WELL] * 3


def test_a_file_that_is_no_log_is_refused(tmp_path):
    other = tmp_path / "other.why"
    other.write_text("{}")
    assert why(other, "stop").exit_code == ExitCode.USAGE
