"""Two servers on one folder of projects, each in its own process."""

import os
import pty
import re
import select
import signal
import subprocess
import sys
from contextlib import contextmanager

import pytest
from click.testing import CliRunner
from websockets.sync.client import connect

from learnblock.cli import claiming, main
from pages import TIMEOUT, TOKEN, Visitor
from waiting import wait_for

pytestmark = [pytest.mark.certain, pytest.mark.slow, pytest.mark.realtime]


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "projects"


def command(folder, *options):
    return [
        sys.executable, "-m", "learnblock", "--language", "en", "--no-browser", "--port", "0",
        "--projects", str(folder), *options,
    ]  # fmt: skip


@contextmanager
def learnblock(folder, *options):
    """A server, with the lines that it prints."""
    process = subprocess.Popen(
        command(folder, *options),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "LEARNBLOCK_TOKEN": TOKEN},
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


@contextmanager
def visit(process):
    """A page of a server."""
    place = process.stdout.readline().split("/")[2]
    with connect(f"ws://{place}/ws", subprotocols=["learnblock", TOKEN]) as opened:
        yield Visitor(opened)


def refused(folder, *options):
    """What the command prints, without a terminal, when it starts no server."""
    ended = CliRunner().invoke(main, command(folder, *options)[3:])
    assert ended.exit_code == 2
    return ended.stderr


def test_a_second_server_names_the_first_and_both_ways_out(folder):
    with learnblock(folder) as first:
        address = first.stdout.readline().split()[-1].partition("?")[0]
        said = refused(folder)
        for part in (f"process {first.pid}", address, "--take-over", "--read-only"):
            assert part in said
        assert TOKEN not in said


def test_after_a_crash_the_folder_is_free(folder):
    with learnblock(folder) as first:
        first.stdout.readline()
        first.kill()
        first.wait()
        with learnblock(folder) as second:
            assert "is running at" in second.stdout.readline()


def test_taking_over_loses_no_letter(folder):
    with learnblock(folder) as first, visit(first) as page:
        page.open(text="main:\n    pass\nend\n")
        page.type("main:\n    pass\nend\n# typed just now\n")
        with learnblock(folder, "--take-over") as second, visit(second) as other:
            assert first.wait(TIMEOUT) == 0
            assert "takes over" in first.stdout.read()
            other.say("Open", name="program")
            assert "# typed just now" in other.hear("Document")["blocktext"]


def test_one_that_does_not_end_is_named_with_what_to_do(folder, monkeypatch):
    monkeypatch.setattr(claiming, "PATIENCE", 0.2)
    with learnblock(folder) as first:
        first.stdout.readline()
        first.send_signal(signal.SIGSTOP)
        said = refused(folder, "--take-over")
    assert re.search(rf"has not ended: process {first.pid}.* End that process", said)


def test_both_ways_out_at_once_are_refused(folder):
    assert "either --take-over or --read-only" in refused(folder, "--take-over", "--read-only")


def test_a_reader_opens_and_runs_projects_and_writes_nothing(folder):
    with learnblock(folder) as first, visit(first) as page:
        page.open("shared", 'main:\n    print("hello")\nend\n')
        page.hear("Saved", edit=1)
        before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        with learnblock(folder, "--read-only") as second, visit(second) as reader:
            assert reader.hear("Welcome")["read_only"]["code"] == "server-reading-beside"
            reader.say("Open", name="shared")
            reader.hear("Document")
            reader.say("ChooseWorld", name="walls")
            assert reader.run()["ended"] == "finished"
            reader.say("EditText", edit=1, notation="blocktext", text="")
            assert reader.hear("Failed")["message"]["code"] == "server-read-only"
        assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


def test_a_reader_follows_what_the_writer_saves(folder):
    with learnblock(folder) as first, visit(first) as page:
        page.open("shared", "main:\n    pass\nend\n")
        page.hear("Saved", edit=1)
        with learnblock(folder, "--read-only") as second, visit(second) as reader:
            reader.say("Open", name="shared")
            reader.hear("Document")
            for line in ("x = 1", "x = 2"):
                page.type(f"main:\n    {line}\nend\n")
                while line not in reader.hear("Document").get("blocktext", ""):
                    pass


def test_a_reader_copies_no_file_into_the_folder(folder, tmp_path):
    (tmp_path / "mine.bt").write_text("main:\n    pass\nend\n", "utf-8")
    command = [
        "--language", "en", "open", str(tmp_path / "mine.bt"),
        "--no-browser", "--projects", str(folder), "--read-only",
    ]  # fmt: skip
    ended = CliRunner().invoke(main, command)
    assert ended.exit_code == 2
    assert "Leave out --read-only" in ended.stderr
    assert not folder.exists()


@contextmanager
def on_terminal(folder):
    """A server whose user has a terminal: a function that waits for output, and the terminal."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        command(folder), stdin=theirs, stdout=theirs, stderr=theirs, close_fds=True
    )
    os.close(theirs)
    shown = ""

    def read_until(words):
        nonlocal shown

        def are_shown():
            nonlocal shown
            if select.select([ours], [], [], 0)[0]:
                shown += os.read(ours, 10_000).decode()
            return words in shown

        wait_for(are_shown, f"{words!r} on the terminal")
        return shown

    try:
        yield read_until, ours
    finally:
        process.kill()
        process.wait()
        os.close(ours)


@pytest.mark.parametrize(("answer", "outcome"), [("1", "is running at"), ("2", "Read only")])
def test_on_a_terminal_it_asks(folder, answer, outcome):
    with learnblock(folder) as first:
        first.stdout.readline()
        with on_terminal(folder) as (read_until, terminal):
            assert f"process {first.pid}" in read_until("1 or 2")
            os.write(terminal, f"{answer}\n".encode())
            read_until(outcome)
            if answer == "1":
                assert first.wait(TIMEOUT) == 0


def test_a_folder_without_locks_works_with_a_warning(folder):
    script = (
        "import errno, fcntl, sys\n"
        "def refused(*_): raise OSError(errno.ENOLCK, 'No locks available')\n"
        "fcntl.flock = refused\n"
        "from learnblock.cli import main\nmain()\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", script, *command(folder)[3:]],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert "can't lock the folder" in process.stderr.readline()
        assert "is running at" in process.stdout.readline()
    finally:
        process.kill()
        process.communicate()
