"""A run whose process dies is made again, and told from a run that its program ended."""

import os
import signal
import socket
import subprocess
import sys
from contextlib import contextmanager
from dataclasses import replace
from threading import Event, Thread

import pytest

from attacks import children
from learnblock import robots
from learnblock.running import Options, warm
from learnblock.running.batch import Batch, WarmProcess
from learnblock.running.job import Job, packed
from learnblock.runtime.ending import How
from learnblock.runtime.program import Program

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.certain,
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks"),
]
HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"


def job(python):
    program = Program("program.py", HEAD + python + "\n", python)
    return Job(program, robots.find("sim-ebo"), Options(world="empty", seconds=3))


DRIVING = job("robot.move_straight(40)\nwhile True:\n    robot.sleep(0.01)")


@pytest.fixture
def kept():
    process = WarmProcess()
    yield process
    process.end()


@contextmanager
def killer(process, times, spared=()):
    """Kill the first children that a process has from now on, or waiting, other than these."""

    def kill():
        killed = set()
        while len(killed) < times and not over.is_set():
            for child in set(children(process)) - killed - set(spared):
                killed.add(child)
                os.kill(child, signal.SIGKILL)

    over = Event()
    thread = Thread(target=kill)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


@pytest.mark.parametrize("isolated", [False, True])
def test_a_run_whose_process_is_killed_is_made_again(kept, isolated):
    driving = replace(DRIVING, isolated=isolated)
    [(_, whole)] = Batch([driving], kept=kept).results()
    # The fork server.
    with killer(kept, 1, children(kept) if isolated else ()):
        [(_, result)] = Batch([driving], 1, kept=kept).results()
    assert result == whole
    assert result.isolated == isolated
    assert result.report.ended == How.TIME_LIMIT


def test_a_run_whose_process_is_killed_twice_is_lost_and_no_failure_of_its_program(kept):
    driving = replace(DRIVING, isolated=True)
    [*Batch([driving], kept=kept).results()]
    with killer(kept, 2, children(kept)):
        [(_, result)] = Batch([driving], 1, kept=kept).results()
    assert result.lost == "Killed"
    assert "not the fault of the program" in str(result.report.error["message"])


def test_runs_go_on_if_the_fork_server_of_their_programs_is_killed(kept):
    driving = replace(DRIVING, isolated=True)
    [(_, whole)] = Batch([driving], kept=kept).results()
    [server] = children(kept)
    os.kill(server, signal.SIGKILL)
    [(_, result)] = Batch([driving], kept=kept).results()
    assert result == whole


def test_runs_go_on_in_another_process_if_the_one_that_forks_them_is_killed(kept):
    jobs = [job(f"print({number})\nrobot.sleep(1)") for number in range(4)]
    found = []
    for _, result in Batch(jobs, 1, kept=kept).results():
        found.append(result.report.output)
        if len(found) == 1:
            os.kill(kept._process.pid, signal.SIGKILL)
    assert sorted(found) == [f"{number}\n" for number in range(4)]


def test_the_process_ends_quietly_if_nobody_wants_its_results():
    ours, theirs = socket.socketpair()
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", warm.__name__, str(theirs.fileno())],
        pass_fds=(theirs.fileno(),),
        stderr=subprocess.PIPE,
    )
    jobs = packed([DRIVING], 1)
    with ours, theirs:
        ours.sendall(len(jobs).to_bytes(8) + jobs)
    _, said = process.communicate(timeout=60)
    assert (process.returncode, said) == (0, b"")
