"""Custom blocks on the command line, from saving to running on another computer."""

import json
import os

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.extensions import custom_blocks

DANCE = '''\
from learnblock.devices import Base


def waltz(robot, times: int = 2) -> None:
    """Dance a waltz."""
    base = robot.device(Base)
    for _ in range(times):
        base.move(0, 30)
        robot.clock.sleep(1)
    base.stop()
'''


@pytest.fixture
def run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def of(*arguments):
        return CliRunner().invoke(main, arguments)

    return of


@pytest.fixture
def program(tmp_path):
    """Run a program in Block-Text, and return its report."""

    def of(text, run):
        (tmp_path / "program.bt").write_text(text)
        return json.loads(run("run", "program.bt", "--json").stdout)

    return of


def test_an_empty_list_explains_how_to_add_a_block(run):
    assert "You have no custom blocks yet." in run("blocks").stdout


def test_the_list_names_files_functions_and_problems(run, own_home):
    custom_blocks.save("dance", DANCE)
    (own_home / "skills" / "bad.py").write_text("def tango(robot:\n")

    assert (
        "bad              tango\n"
        "    source:1: This is not valid Python: '(' was never closed.\n"
        "dance            waltz\n"
    ) == run("blocks").stdout
    listed = json.loads(run("blocks", "--json").stdout)
    assert [("bad", 1), ("dance", 0)] == [(one["name"], len(one["problems"])) for one in listed]


def test_a_file_is_checked_without_being_run(run, tmp_path):
    (tmp_path / "dance.py").write_text("def turn(robot): ...\nraise SystemExit\n")
    result = run("blocks", "check", "dance.py")

    assert 1 == result.exit_code
    assert result.stdout.startswith(
        "dance.py:1:5: name-taken LearnBlock already has a skill 'turn'"
    )
    assert "    def turn(robot): ...\n        ^^^^\n" in result.stdout
    (found,) = json.loads(run("blocks", "check", "dance.py", "--json").stdout)
    assert ("name-taken", 1, "error") == (found["code"], found["line"], found["severity"])


def test_a_file_without_errors_passes(run, own_home, tmp_path):
    custom_blocks.save("dance", DANCE)
    (tmp_path / "words.json").write_text(
        '{"type": "motor", "category": "D", "name": "gone", "shape": ["blockLeft"]}'
    )
    file = str(own_home / "skills" / "dance.py")

    assert (0, "") == (run("blocks", "check", file).exit_code, run("blocks", "check", file).stdout)
    result = run("blocks", "check", file, "--configuration", "words.json")
    assert 0 == result.exit_code
    assert "words.json:0:0: stale-configuration" in result.stdout


def test_a_block_leaves_the_same_trace_in_a_fresh_home(run, program, tmp_path, monkeypatch):
    custom_blocks.save("dance", DANCE)
    dancing = "main:\n    function.waltz(3)\nend\n"
    here = program(dancing, run)
    assert "Wrote dance.block.json" in run("blocks", "export", "dance").stdout

    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "fresh"))
    assert "There is no skill" in run("run", "program.bt").stderr
    assert "dance: function.waltz\n" == run("blocks", "import", "dance.block.json").stdout
    there = program(dancing, run)
    assert ("finished", here["trace_sha256"]) == (there["ended"], there["trace_sha256"])


def test_an_existing_block_is_replaced_only_on_request(run):
    custom_blocks.save("dance", DANCE)
    run("blocks", "export", "dance", "mine.json")
    refused = run("blocks", "import", "mine.json")

    assert (1, True) == (refused.exit_code, "already have a block 'dance'" in refused.stderr)
    assert 0 == run("blocks", "import", "mine.json", "--replace").exit_code


def test_an_error_in_a_block_names_its_own_line_and_the_one_that_called_it(run, program):
    custom_blocks.save("dance", DANCE.replace("base.stop()", "base.halt()"))
    report = program("main:\n    function.waltz(1)\nend\n", run)

    assert 2 == report["error"]["line"]
    within = report["error"]["within"]
    assert (10, "base.halt()") == (within["line"], within["text"])
    shown = run("run", "program.bt").stderr
    assert "program.bt:2: 'halt' does not exist for Base" in shown
    assert "AttributeError: 'Base' object has no attribute 'halt'" in shown
    assert "dance.py:10\n           base.halt()\n" in shown


@pytest.mark.parametrize(
    ("source", "line", "message"),
    [
        ("def waltz(robot): ...\n1 / 0\n", 2, "ZeroDivisionError: division by zero"),
        ("def waltz(robot): ...\nraise SystemExit\n", 2, "SystemExit"),
        ("def waltz(robot): ...\nfrom math import tau3\n", 2, "cannot import name 'tau3'"),
        ("def waltz(robot):\n    return [][1]\n", 2, "IndexError: list index out of range"),
    ],
)
def test_an_error_in_a_block_is_reported_with_its_line(run, program, source, line, message):
    custom_blocks.save("dance", source)
    report = program("main:\n    print(1)\n    function.waltz()\nend\n", run)

    assert ("error", 3) == (report["ended"], report["error"]["line"])
    assert message in report["error"]["message"]
    assert line == report["error"]["within"]["line"]


def test_a_syntax_error_affects_only_programs_that_use_the_block(run, program, own_home):
    custom_blocks.save("dance", DANCE)
    (own_home / "skills" / "bad.py").write_text("def tango(robot):\n    (\n")

    assert "finished" == program("main:\n    function.waltz()\nend\n", run)["ended"]
    report = program("main:\n    function.tango()\nend\n", run)
    assert "refused" == report["ended"]
    assert "bad.py, line 2: This is not valid Python" in report["error"]["message"]


def test_a_block_with_the_name_of_a_skill_does_not_hide_it(run, program, own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "mine.py").write_text("def stop_bot(robot):\n    print('mine')\n")

    assert "finished" == program("main:\n    function.stop_bot()\nend\n", run)["ended"]
    assert "LearnBlock already has a skill 'stop_bot'." in run("blocks").stdout


def test_a_block_asks_and_prints_like_its_program(run, tmp_path):
    custom_blocks.save("talk", "def greet(robot):\n    print('hello', input('name? '))\n")
    (tmp_path / "program.bt").write_text("main:\n    function.greet()\nend\n")
    result = CliRunner().invoke(main, ["run", "program.bt"], input="Ana\n")

    assert "name? hello Ana\n" == result.stdout


def test_a_block_does_not_run_in_the_process_of_the_host(run, program, own_home):
    source = "import os\nprint(os.getpid())\n\n\ndef waltz(robot): ...\n"
    custom_blocks.save("dance", source)
    program("main:\n    function.waltz()\nend\n", run)
    printed = run("run", "program.bt").stdout

    assert printed.strip().isdecimal()
    assert str(os.getpid()) != printed.strip()


def test_a_block_that_is_not_utf_8_is_refused(run, tmp_path):
    (tmp_path / "waltz.block.json").write_bytes(b'{"name": "\xf1"}')
    assert (
        "This file is not UTF-8. Save it as UTF-8."
        in run("blocks", "import", "waltz.block.json").output
    )
