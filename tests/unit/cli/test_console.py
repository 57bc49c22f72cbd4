"""What a program says reaches a terminal readably, and can't command it."""

import json

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from learnblock.cli import main
from learnblock.cli.console import print_json, visible

NASTY = "\x1b]0;x\x07\x1b[2J\x9b31m\x7f\r"
FORGERY = """from learnblock.robots.sim_ebo import Robot
robot = Robot()
import gc, os
from learnblock.runtime import messages as m
from learnblock.i18n import Phrase
[link] = [one for one in gc.get_objects() if type(one).__name__ == "SocketLink"]
link.send({})
os._exit(0)
"""


@given(st.text())
def test_no_control_character_is_left_but_new_lines_and_tabs(text):
    left = {one for one in visible(text) if ord(one) < 0x20 or 0x7F <= ord(one) < 0xA0}
    assert left <= {"\n", "\t"}
    assert visible(visible(text)) == visible(text)


def test_control_characters_become_symbols():
    assert visible(NASTY) == "␛]0;x␇␛[2J␛[31m␡␍"


def test_json_stays_what_it_was_and_has_no_control_characters(capsys):
    print_json({"output": NASTY})
    printed = capsys.readouterr().out
    assert json.loads(printed) == {"output": NASTY}
    assert visible(printed) == printed


@pytest.mark.slow
def test_prints_and_errors_of_a_program_are_shown_with_symbols(tmp_path):
    (tmp_path / "a.py").write_text(
        "from learnblock.robots.sim_ebo import Robot\nrobot = Robot()\n"
        "print('a\\x1b[2J')\nraise ValueError('b\\x1b[2J')\n"
    )
    result = CliRunner().invoke(main, ["run", str(tmp_path / "a.py")])
    assert "a␛[2J\n" in result.output
    assert "b␛[2J" in result.output
    assert "\x1b" not in result.output


@pytest.mark.slow
@pytest.mark.parametrize(
    "message",
    [
        "m.Ended(m.Fault(Phrase('run-finished'), (1,), '/dev/ptmx', 2))",
        "m.Ended(m.Fault(Phrase('x'), (1,), '/a\\0b', 2))",
        "m.Ended(m.Fault(Phrase('run-too-much-output'), (1,), '', 0))",
        "m.Logged(0, 2**62, b'x')",
    ],
)
def test_a_forged_message_is_the_programs_error_in_every_report(tmp_path, message):
    program = tmp_path / "a.py"
    program.write_text(FORGERY.format(message))
    files = ["--why", str(tmp_path / "a.why"), "--trace", str(tmp_path / "a.trace")]
    result = CliRunner().invoke(main, ["run", str(program), "--json", *files])
    assert (result.exit_code, result.exception.args) == (3, (3,))
    error = json.loads(result.stdout)["error"]
    assert "makes no sense" in error["message"]
    assert "within" not in error
    again = CliRunner().invoke(main, ["why", str(tmp_path / "a.why"), "--json"])
    assert again.exit_code == 0
