import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Contained, Ended, Printed, Setup
from learnblock.runtime.process import ProcessWorker, one_processor

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks programs"),
]


@pytest.fixture(scope="module")
def server():
    server = ForkServer()
    server.begin()
    yield server
    server.end()


def setup(source):
    return Setup(source, "program.py", "", (), (), None, Limits())


def said(standby, source):
    """What a program prints in this process."""
    worker = ProcessWorker(standby)
    try:
        worker.link.send(setup(source))
        assert worker.link.receive(10) == Contained()
        text = ""
        while isinstance(message := worker.link.receive(10), Printed):
            text += message.text
        assert message == Ended()
        return text
    finally:
        worker.kill()


def test_a_forked_process_runs_a_program_and_is_gone_with_its_folder(server):
    standby = server.standby()
    assert said(standby, "print('hello')") == "hello\n"
    assert standby.process.poll() is not None
    assert not Path(standby.scratch.path).exists()


def test_a_program_leaves_nothing_to_the_next_one(server):
    changes = (
        "import builtins, json, os, sys, tempfile\n"
        "open('left', 'w').close()\n"
        "os.environ['LEFT'] = builtins.left = json.left = sys.left = tempfile.tempdir = 'left'\n"
    )
    look = (
        "import builtins, json, os, sys, tempfile\n"
        "print(os.listdir(), os.environ.get('LEFT'), tempfile.gettempdir() == os.getcwd(),"
        " [hasattr(one, 'left') for one in (builtins, json, sys)])"
    )
    assert said(server.standby(), changes) == ""
    assert said(server.standby(), look) == "[] None True [False, False, False]\n"


def test_a_forked_process_looks_to_its_program_as_one_started_for_it(server):
    look = (
        "import os, random, sys\n"
        "print(sorted(set(os.environ) - {'LEARNBLOCK_HOME'}), sys.argv[:1], sys.orig_argv[:-1],"
        " __file__, sys.flags, sorted(sys.modules),"
        " [hash(text) for text in 'abc'], sys.path)"
    )
    forked, started = said(server.standby(), look), said(None, look)
    assert forked == started


def test_a_process_has_nothing_of_one_that_has_ended_and_is_still_waited_for(server):
    ended = ProcessWorker(server.standby())
    ended.link.send(setup(""))
    assert ended.wait(10) == 0
    look = (
        "import os\n"
        "for handle in range(3, 64):\n"
        "    try:\n"
        "        os.fstat(handle)\n"
        "    except OSError:\n"
        "        continue\n"
        "    print('open')"
    )
    assert said(server.standby(), look) == "open\n"
    ended.kill()


def test_two_programs_have_random_numbers_of_their_own(server):
    look = "import random; print(random.random())"
    assert said(server.standby(), look) != said(server.standby(), look)


def test_a_forked_process_joins_its_host_on_one_processor(server):
    with server.standby() as standby, one_processor():
        worker = ProcessWorker(standby)
        assert os.sched_getaffinity(worker.process) == os.sched_getaffinity(0)


@pytest.mark.parametrize(
    ("source", "status"),
    [("import os; os._exit(3)", 3), ("import ctypes; ctypes.string_at(0)", -signal.SIGSEGV)],
)
def test_the_status_of_a_forked_process_is_known_to_its_host(server, source, status):
    worker = ProcessWorker(server.standby())
    worker.link.send(setup(source))
    assert worker.wait(10) == status
    worker.kill()


def test_a_forked_process_stops_when_it_is_asked_to_however_early(server):
    for _ in range(5):
        worker = ProcessWorker(server.standby())
        worker.interrupt()
        assert worker.link.receive(10) == Ended(stopped=True)
        assert worker.wait(10) == 0
        worker.kill()


def test_a_process_that_nobody_waits_for_any_more_is_killed(server):
    ours, theirs = os.pipe()
    if (host := os.fork()) == 0:
        worker = ProcessWorker(server.standby())
        os.write(theirs, worker.process.to_bytes(8))
        worker.link.send(setup("while True: pass"))
        signal.pause()
    os.close(theirs)
    process = int.from_bytes(os.read(ours, 8))
    handle = os.pidfd_open(process)
    os.kill(host, signal.SIGKILL)
    os.waitpid(host, 0)
    assert _has_ended(handle)
    os.close(ours)


def test_the_processes_of_a_fork_server_end_with_it():
    server = ForkServer()
    server.begin()
    with server.standby() as standby:
        handle = os.pidfd_open(standby.process.pid)
        ProcessWorker(standby).link.send(setup("while True: pass"))
        server._process.kill()
        server._process.wait()
        assert _has_ended(handle)
        assert standby.process.wait(10) == -signal.SIGKILL
    with pytest.raises(OSError, match=r"."):
        server.standby()
    server.begin()
    assert said(server.standby(), "print(1)") == "1\n"
    server.end()


def test_a_fork_server_ends_when_nobody_can_order_any_more():
    server = ForkServer()
    server.begin()
    server.let_go()
    assert server._process.wait(10) == 0
    server.end()


def test_a_system_without_what_it_needs_starts_a_process_for_each_program(monkeypatch):
    monkeypatch.delattr(os, "pidfd_open")
    server = ForkServer()
    server.begin()
    standby = server.standby()
    assert isinstance(standby.process, subprocess.Popen)
    assert said(standby, "print(1)") == "1\n"


def _has_ended(handle):
    try:
        return bool(select.select([handle], [], [], 10)[0])
    finally:
        os.close(handle)
