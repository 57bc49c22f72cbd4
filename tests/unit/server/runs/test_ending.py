"""A run ends after Stop, whatever its program and its robot do.

How long each measure may take is claimed in `tests/unit/runtime/test_escalation.py`.
"""

import contextlib
import os
import threading

import pytest

from learnblock.server.runs import playing
from pages import english
from waiting import wait_for

pytestmark = [pytest.mark.slow, pytest.mark.realtime]

#: A user's robot that hangs at one of its calls.
ROBOT = """
from pathlib import Path

from learnblock.client import Client
from learnblock.devices import Base

FIFO = {fifo!r}


class Robot(Client):
    def connect(self):
        self.hang("connect")
        self.add(Base(lambda adv, rot: self.hang("move")))

    def disconnect(self):
        self.hang("disconnect")

    def hang(self, call):
        if call == {call!r}:
            # Nobody ever writes to it.
            Path(FIFO).read_text()
"""
DRIVING = """\
main:
    function.move_straight(50)
    print("moves")
    while True:
        function.sleep(0.1)
    end
end
"""
#: It asks without end, and reads no answer, until its host can't send any more.
DEAF = """\
import gc
from learnblock.robots.sim_ebo import Robot
from learnblock.runtime import messages

robot = Robot()
link = [one for one in gc.get_objects() if type(one).__name__ == "SocketLink"][0]
devices = [index for index, one in enumerate(robot.devices()) if "Camera" in str(one)]
while True:
    link.send(messages.Ask(devices[0], "read", ()))
    link.flush()
"""


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home" / "robots").mkdir(parents=True)
    return tmp_path / "home"


def stopped(page):
    """Stop the program; return how it ended."""
    page.say("Stop")
    ended = page.hear("Ended")
    page.hear("RunState", state="ended")
    return ended


def writer_of(fifo):
    """Open a named pipe once a reader waits for it; the reader goes on when it is closed."""
    found = []

    def opens():
        with contextlib.suppress(OSError):
            found.append(os.open(fifo, os.O_WRONLY | os.O_NONBLOCK))
        return found

    wait_for(opens, "the robot hangs")
    return found[0]


@pytest.mark.parametrize("call", ["connect", "move", "disconnect"])
def test_a_robot_that_hangs_is_left_behind_and_the_page_says_so(home, server, tmp_path, call):
    fifo = tmp_path / "fifo"
    os.mkfifo(fifo)
    robot = home / "robots" / "mine.py"
    robot.write_text(ROBOT.format(fifo=str(fifo), call=call))
    with contextlib.ExitStack() as stack:
        page = stack.enter_context(server.visit())
        page.open(text=DRIVING)
        page.say("ChooseRobot", name="mine")
        page.say("Run")
        if call == "disconnect":
            page.hear("Printed")
        else:
            stack.callback(os.close, writer_of(fifo))
        assert stopped(page)["message"]["code"] == "play-given-up-real"
        # The page goes on as before.
        page.say("ChooseRobot", name="sim-ebo")
        page.type("main:\n    print(1)\nend\n")
        assert page.run()["ended"] == "finished"


def test_a_program_that_never_reads_its_answers_is_stopped(page):
    page.open()
    page.type(DEAF, "python")
    page.say("Run")
    page.hear("RunState", state="running")
    ended = stopped(page)
    assert ended["ended"] == "stopped", ended


def test_a_run_for_which_there_is_no_thread_is_taken_back_and_says_why(page, monkeypatch):
    page.open(text=DRIVING)
    start = threading.Thread.start

    def refuse(thread):
        if thread.name == "run":
            raise RuntimeError("can't start new thread")
        start(thread)

    monkeypatch.setattr(threading.Thread, "start", refuse)
    ended = page.run()
    assert ended["message"]["code"] == "play-not-started"
    assert "processes or threads" in english(ended["message"])
    monkeypatch.undo()
    page.say("Run")
    page.hear("RunState", state="running")
    assert stopped(page)["ended"] == "stopped"


def test_a_run_whose_thread_dies_without_a_word_is_over(page, monkeypatch):
    page.open(text=DRIVING)
    monkeypatch.setattr("threading.excepthook", lambda failed: None)

    def die(handed, runs):
        raise MemoryError

    monkeypatch.setattr(playing, "_followed", die)
    assert page.run()["message"]["code"] == "play-lost"


def test_a_run_is_over_even_if_its_end_can_not_be_kept(page, monkeypatch):
    page.open(text="main:\n    print(1)\nend\n")

    def fail(*_):
        raise MemoryError

    monkeypatch.setattr("learnblock.server.sessions.archive.Archive.keep_logs", fail)
    page.run()
    monkeypatch.undo()
    assert page.run()["ended"] == "finished"
