"""A class closes when the teacher wants it to, whatever its pupils' programs and servers do."""

import contextlib
import http.client
import os
import resource
import signal
import socket
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest

from classes import Class, opened
from learnblock.classroom.nursery import Nursery, Patience
from learnblock.i18n import Phrase
from waiting import SECONDS, wait_for

pytestmark = [
    pytest.mark.slow,
    pytest.mark.certain,
    pytest.mark.skipif(sys.platform != "linux", reason="limits of another process are Linux's"),
]

ENDLESS = "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n"


@pytest.fixture
def room(tmp_path):
    """A class that its test closes."""
    room = Class(tmp_path)
    yield room
    if room.process.poll() is None:
        room.kill()
    room.process.stdout.close()


def children(process):
    tasks = Path(f"/proc/{process}/task").iterdir()
    return [int(one) for task in tasks for one in (task / "children").read_text().split()]


def server_of(room):
    """The process of the only pupil's server."""
    (nursery,) = children(room.process.pid)
    (server,) = children(nursery)
    return server


def say_nothing_more(room):
    """Return what the class still prints until it has closed, and the seconds that took."""
    began = monotonic()
    with room.process.stdout as output:
        said = output.read()
    room.process.wait(SECONDS)
    return said, monotonic() - began


def saved(pupil, name):
    (file,) = pupil.folder.rglob(f"{name}.learnblock")
    return file.read_text("utf-8")


def test_a_class_says_that_it_saves_and_closes(room):
    pupil = room.pupil("Ada")
    with pupil.page() as page:
        page.open("mine", ENDLESS)
        page.say("Run")
        page.hear("RunState", state="running")
        page.type(ENDLESS + "# edited\n")
        room.process.send_signal(signal.SIGINT)
        said, seconds = say_nothing_more(room)
    assert "Saving everything" in said
    assert "is closed" in said
    assert (room.process.returncode, seconds < 10) == (0, True)
    assert "# edited" in saved(pupil, "mine")


def is_saved(pupil, number):
    return "# edited" in saved(pupil, f"program {number}")


def test_a_class_closes_although_a_pupils_server_has_no_memory_left(room):
    pupil = room.pupil("Ada")
    with contextlib.ExitStack() as pages:
        opened = [pages.enter_context(pupil.page()) for _ in range(4)]
        for number, page in enumerate(opened):
            page.open(f"program {number}", ENDLESS)
        opened[0].say("Run")
        opened[0].hear("RunState", state="running")
        for page in opened[1:]:
            # Its edit is kept, whatever becomes of it.
            page.type(ENDLESS + "# edited\n")
        wait_for(lambda: all(is_saved(pupil, number) for number in (1, 2, 3)), "saved edits")
        server = server_of(room)
        used = Path(f"/proc/{server}/status").read_text().partition("VmData:")[2].split()[0]
        resource.prlimit(server, resource.RLIMIT_DATA, (int(used) * 1024,) * 2)
        for page in opened[1:]:
            page.say("Run")
        room.process.send_signal(signal.SIGINT)
        said, seconds = say_nothing_more(room)
    # By its own time limits, 8 s together: it was not killed, and had saved before.
    assert ("Everything is saved" in said, seconds < Patience().asked) == (True, True)
    assert all(is_saved(pupil, number) for number in (1, 2, 3))


def test_a_second_ctrl_c_closes_a_class_with_a_server_that_hangs(room):
    pupil = room.pupil("Ada")
    with pupil.page() as page:
        page.open("mine", ENDLESS)
        os.kill(server_of(room), signal.SIGSTOP)
        room.process.send_signal(signal.SIGINT)
        wait_for(lambda: "closes" in room.process.stdout.readline(), "the class closes")
        room.process.send_signal(signal.SIGINT)
        said, seconds = say_nothing_more(room)
    assert "ending at once" in said
    assert seconds < 10


def test_whoever_waits_for_a_server_is_told_that_the_class_closes(tmp_path):
    with (
        (tmp_path / "errors").open("w+") as errors,
        opened(tmp_path, errors=errors) as room,
        socket.create_connection(("127.0.0.1", room.port), SECONDS) as waiting,
    ):
        pupil = room.pupil("Ada")
        (nursery,) = children(room.process.pid)
        # It starts no server meanwhile.
        os.kill(nursery, signal.SIGSTOP)
        waiting.sendall(
            f"GET /{pupil.address}palette/en.json HTTP/1.1\r\nHost: 127.0.0.1\r\n"
            f"Cookie: {pupil.cookie}\r\n\r\n".encode()
        )
        # A later request is answered, so that this one has been read.
        assert room.ask("/about.json").status == 200
        room.process.send_signal(signal.SIGINT)
        answer = http.client.HTTPResponse(waiting)
        answer.begin()
        assert (answer.status, answer.read()) == (503, f"{Phrase('class-ends')}\n".encode())
        os.kill(nursery, signal.SIGCONT)
        said, _ = say_nothing_more(room)
        errors.seek(0)
        assert ("Everything is saved" in said, errors.read()) == (True, "")


def test_a_server_that_does_not_end_is_killed():
    ours, theirs = socket.socketpair()
    with theirs, subprocess.Popen(["sleep", "60"]) as hanging:
        hanging.send_signal(signal.SIGSTOP)
        nursery = Nursery(theirs, Patience(asked=0.05))
        nursery.servers[hanging.pid] = "ada"
        ours.close()
        nursery.run()
        with pytest.raises(ProcessLookupError):
            os.kill(hanging.pid, 0)
        # The nursery has waited for it.
        hanging.returncode = -signal.SIGKILL
