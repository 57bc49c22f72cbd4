import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from learnblock.errors import ProgramStopped
from learnblock.runtime import child as child_module
from learnblock.runtime import process
from learnblock.runtime.child import run
from learnblock.runtime.limits import Limits
from learnblock.runtime.link import SocketLink
from learnblock.runtime.messages import (
    Answer,
    Contained,
    Ended,
    FromChild,
    FromHost,
    Input,
    Printed,
    Setup,
)
from learnblock.runtime.process import ProcessWorker, ThreadWorker

pytestmark = pytest.mark.realtime


def setup(source):
    return Setup(
        source=source,
        filename="program.py",
        folder="",
        skills=(),
        robots=(),
        debug=None,
        limits=Limits(),
    )


@pytest.fixture(params=[ProcessWorker, ThreadWorker])
def worker(request):
    worker = request.param()
    yield worker
    worker.kill()


def heard(worker):
    """Return all messages of a program."""
    assert worker.link.receive(10) == Contained()
    return rest(worker)


def rest(worker):
    """Return all messages until the last."""
    messages = []
    while not messages or not isinstance(messages[-1], Ended):
        message = worker.link.receive(10)
        assert message is not None
        messages.append(message)
    return messages


def test_a_program_runs_and_sends_messages(worker):
    worker.link.send(setup("print('hello')"))
    assert heard(worker) == [Printed("hello\n"), Ended()]
    assert worker.wait(10) == 0


@pytest.mark.skipif(sys.platform == "win32", reason="only POSIX limits how long sending takes")
def test_a_program_that_reads_nothing_does_not_keep_its_host_waiting(monkeypatch):
    monkeypatch.setattr(process, "LONGEST_SENDING", 1)
    worker = ProcessWorker()
    try:
        worker.link.send(setup("import time\ntime.sleep(60)"))
        with pytest.raises(EOFError):
            # More than the system holds for it.
            worker.link.send(Answer(b"x" * 4_000_000))
    finally:
        worker.kill()


def test_an_aborted_program_is_noticed_at_once_even_in_a_call(worker):
    worker.link.send(setup("input()"))
    assert worker.link.receive(10) == Contained()
    assert worker.link.receive(10) == Input("")
    worker.abort()
    with pytest.raises(EOFError):
        worker.link.receive(10)


def test_an_aborted_process_is_noticed_at_once_even_if_it_computes():
    # A thread would compute beside all later tests.
    worker = ProcessWorker()
    try:
        worker.link.send(setup("while True:\n    pass"))
        worker.abort()
        with pytest.raises(EOFError):
            worker.link.receive(10)
    finally:
        worker.kill()


def test_an_interrupted_program_reports_its_line(worker):
    worker.link.send(setup("print('go')\nwhile True:\n    pass"))
    assert worker.link.receive(10) == Contained()
    assert worker.link.receive(10) == Printed("go\n")
    worker.interrupt()
    ended = rest(worker)[-1]
    assert ended.stopped
    assert ended.lines[-1] in {1, 2, 3}


def test_a_program_stopped_before_its_start_reports_it():
    host, child = socket.socketpair()

    def stopped(limits):
        raise ProgramStopped("stopped")

    with host, child:
        link = SocketLink(host, FromChild)
        link.send(setup("print('never')"))
        run(SocketLink(child, FromHost), stopped)
        assert link.receive(10) == Ended(stopped=True)


def test_a_running_worker_has_no_status(worker):
    assert worker.wait(0) is None


def test_killing_twice_does_nothing(worker):
    worker.kill()
    worker.kill()


def test_a_process_ends_when_its_host_closes_the_link():
    worker = ProcessWorker()
    worker.link.close()
    assert worker.wait(10) is not None


def test_output_of_a_thread_do_not_reach_the_hosts_output(capsys):
    worker = ThreadWorker()
    worker.link.send(setup("print('inside')"))
    assert heard(worker)[0] == Printed("inside\n")
    worker.kill()
    assert capsys.readouterr().out == ""


@pytest.mark.certain
def test_a_set_of_words_has_the_same_order_in_every_process():
    orders = set()
    for _ in range(3):
        worker = ProcessWorker()
        worker.link.send(setup("print([*{'red', 'green', 'blue', 'black', 'white'}])"))
        orders.add(heard(worker)[0].text)
        worker.kill()
    assert len(orders) == 1


@pytest.mark.skipif(sys.platform != "linux", reason="prctl is Linux's")
def test_a_process_dies_with_its_host():
    source = (
        "from learnblock.runtime.process import ProcessWorker\n"
        "from learnblock.runtime.limits import Limits\n"
        "from learnblock.runtime.messages import Setup\n"
        "import os\n"
        "w = ProcessWorker()\n"
        "w.link.send(Setup('print(1)\\nwhile True: pass', 'p', '', (), (), None, Limits()))\n"
        "w.link.receive(10)\n"
        "print(w.process, flush=True)\n"
        "os.kill(os.getpid(), 9)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", source], capture_output=True, text=True, check=False
    )
    assert ended(int(done.stdout))


def ended(process):
    """Wait until a process is gone, or is a zombie."""
    pause = threading.Event()
    status = Path(f"/proc/{process}/stat")
    for _ in range(500):
        if not status.exists() or status.read_text().split()[2] == "Z":
            return True
        pause.wait(0.01)
    return False


def test_a_program_that_is_stopped_while_it_loads_says_only_that(monkeypatch):
    def stopped():
        raise ProgramStopped("stopped")

    host, child = socket.socketpair()
    monkeypatch.setattr(child_module.fence, "prepare", stopped)
    monkeypatch.setattr(child_module.signal, "signal", lambda *_: None)
    monkeypatch.setattr(sys, "argv", ["child", str(child.detach())])
    child_module.main()

    with host:
        assert SocketLink(host, FromChild).receive() == Ended(stopped=True)
