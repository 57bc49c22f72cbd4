"""`learnblock run` of a plain program: host and program share one contained process."""

import json
import signal
import subprocess
import sys

import pytest

from learnblock import robots, running
from learnblock.running.job import Job
from learnblock.running.shared_run import can_share
from runs import EXAMPLES

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks")

LINE = EXAMPLES / "line-thymio.bt"
COUNT = "number = 0\nwhile number < 5:\n    number = number + 1\n    print(number)\nend\n"
ENDLESS = "while True:\n    function.move_straight()\n    print(1)\nend\n"
#: The command in a process of its own, where a line says which runs were shared.
COMMAND = """
import os, sys
from learnblock.cli import main
from learnblock.cli import reporting
from learnblock.running import making, shared_run

run = shared_run.SharedRun.run

def noted(shared):
    result = run(shared)
    print("shared" if result else "alone", file=sys.stderr)
    return result

shared_run.SharedRun.run = noted
CHANGE
main()
"""
NEVER = "reporting.can_share = lambda job: False"
DYING = """
printed = shared_run._Teller.printed
shared_run._Teller.printed = lambda self, text: "3" in text and os._exit(1) or printed(self, text)
"""
HANGING = """
import threading
shared_run.HANGING = 0.2
printed = shared_run._Teller.printed
shared_run._Teller.printed = (
    lambda self, text: threading.Event().wait() if "3" in text else printed(self, text)
)
"""
OPEN_FILES = """
made = making.made_together
def listed(job, prints, prepare):
    for number in os.listdir("/proc/self/fd"):
        try:
            prints.printed(os.readlink(f"/proc/self/fd/{number}").split(":")[0] + chr(10))
        except FileNotFoundError:
            # The listing itself.
            continue
    return made(job, prints, prepare)
making.made_together = listed
"""


def started(*arguments, change=""):
    command = [sys.executable, "-c", COMMAND.replace("CHANGE", change), "run", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def ran(*arguments, change=""):
    """The output of a run, what it says on the other stream, and the exit code."""
    process = started(*arguments, change=change)
    return *process.communicate(timeout=60), process.returncode


@pytest.fixture
def write(tmp_path):
    def write(text):
        path = tmp_path / "program.bt"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_a_plain_program_leaves_the_report_and_the_trace_that_it_leaves_alone(tmp_path):
    files = tmp_path / "shared.jsonl", tmp_path / "alone.jsonl"
    options = ("--robot", "sim-thymio", "--for", 3, "--json")
    shared, said, _ = ran(LINE, *options, "--trace", files[0])
    alone, other, _ = ran(LINE, *options, "--trace", files[1], change=NEVER)

    assert ("shared" in said, "shared" in other) == (True, False)
    assert json.loads(shared) == json.loads(alone)
    assert files[0].read_bytes() == files[1].read_bytes() != b""


@pytest.mark.parametrize("change", [DYING, HANGING], ids=["dies", "hangs"])
def test_a_run_whose_process_fails_is_made_again_alone_and_prints_nothing_twice(write, change):
    output, said, code = ran(write(COUNT), change=change)
    assert output == "1\n2\n3\n4\n5\n"
    assert ("alone" in said, code) == (True, 0)


def test_ctrl_c_ends_a_shared_run_with_its_report(write):
    process = started(write(ENDLESS), "--for", 1_000_000)
    assert process.stdout.readline() == "1\n"
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert ("shared" in said, "ended      stopped" in said) == (True, True)
    assert process.returncode == 130


def test_an_error_is_reported_at_its_line(write):
    _, said, code = ran(write("x = 0\nprint(1 / x)\n"))
    assert ("shared" in said, "program.bt:2: " in said, code) == (True, True, 3)


def test_the_shared_process_has_no_file_of_the_command_but_its_connection(write):
    output, _, _ = ran(write(COUNT), change=OPEN_FILES)
    opened = [line for line in output.splitlines() if not line.isdecimal()]
    assert sorted(opened) == ["/dev/null", "/dev/null", "/dev/null", "socket"]


@pytest.mark.parametrize("python", ["print(input('?'))", "import os", "print(open('x'))"])
def test_a_program_that_asks_or_is_not_plain_has_a_process_of_its_own(tmp_path, python):
    path = tmp_path / "program.py"
    path.write_text(
        f"from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n{python}\n",
        encoding="utf-8",
    )
    robot = robots.find("sim-ebo")
    assert not can_share(Job(running.program(running.read(path), robot), robot))
