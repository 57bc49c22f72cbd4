"""Remote control from the command line."""

import os
import select
import subprocess
import sys
from contextlib import contextmanager

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.keyboard import HOLD, TerminalKeyboard, TerminalKeys
from learnblock.client.keyboard import KEYS
from runs import EXAMPLES
from waiting import SECONDS, wait_for

pytestmark = pytest.mark.realtime

termios = pytest.importorskip("termios", reason="Windows has no pseudo-terminals")

REMOTE = EXAMPLES / "remote-control.bt"
ASKING = """main:
    while not function.is_key_pressed("q"):
        if function.is_key_pressed("up"):
            print("going up")
            name = input("who? ")
            print("hello " + name)
        end
    end
end
"""
#: Makes the terminal on its standard input its own, and becomes the program in its arguments.
LOGIN = "import os, sys; os.login_tty(0); os.execv(sys.argv[1], sys.argv[1:])"


def call(*arguments):
    """Run a command in this process."""
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


class Terminal:
    """Programs in a terminal of their own, with a person who types."""

    def __init__(self, *arguments):
        self._ours, self._theirs = os.openpty()
        self._before = termios.tcgetattr(self._theirs)
        run = [sys.executable, "-m", "learnblock", "run", *map(str, arguments)]
        self.process = subprocess.Popen([sys.executable, "-c", LOGIN, *run], stdin=self._theirs)
        self._shown = ""

    def see(self, text):
        """Wait until the terminal shows a text."""
        # The state of the run is shown again and again, whatever else happens.
        wait_for(lambda: self._shows(text), f"{text!r} on the terminal")
        _, _, self._shown = self._shown.partition(text)

    def _shows(self, text):
        if select.select([self._ours], [], [], 0)[0]:
            self._shown += os.read(self._ours, 4096).decode()
        return text in self._shown

    def type(self, text):
        os.write(self._ours, text.encode())

    @property
    def is_as_before(self):
        return termios.tcgetattr(self._theirs) == self._before

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self._ours)
        os.close(self._theirs)


@pytest.fixture
def in_terminal(tmp_path):
    opened = []

    def open_(*texts):
        programs = [tmp_path / f"{name}.bt" for name in ("one", "two")[: len(texts)]]
        for program, text in zip(programs, texts, strict=True):
            program.write_text(text, encoding="utf-8")
        opened.append(Terminal(*programs, "--world", "empty"))
        return opened[-1]

    yield open_
    for terminal in opened:
        terminal.close()


def test_keys_and_answers_are_typed_in_the_terminal(in_terminal):
    terminal = in_terminal(ASKING)
    terminal.see("This program listens to the keyboard: ↑ q.")
    assert not terminal.is_as_before
    terminal.type("\x1b[A")
    terminal.see("going up")
    terminal.see("who? ")
    terminal.type("Ada\n")
    terminal.see("hello Ada")
    terminal.type("Q")
    terminal.see("ended      finished")
    assert terminal.process.wait() == 0
    assert terminal.is_as_before


def test_several_programs_share_the_keys_of_a_terminal(in_terminal):
    # The world of several robots stands still while one asks, and so do its keys.
    one = ASKING.replace("+ name)\n", "+ name)\n            function.sleep(0.1)\n")
    terminal = in_terminal(one, one.replace('"up"', '"w"').replace("going up", "going on"))
    terminal.see("The programs listen to the keyboard: one ↑ q; two q w. Ctrl-C ends them all.")
    terminal.type("\x1b[A")
    terminal.see("one: going up")
    terminal.see("one: who? ")
    terminal.type("Ada\n")
    terminal.see("one: hello Ada")
    terminal.type("w")
    terminal.see("two: going on")
    terminal.see("two: who? ")
    terminal.type("Bea\n")
    terminal.see("two: hello Bea")
    terminal.type("q")
    terminal.see("trace ")
    assert terminal.process.wait() == 0
    assert terminal.is_as_before


def test_ctrl_c_ends_a_program_that_listens_and_restores_the_terminal(in_terminal):
    terminal = in_terminal(ASKING)
    terminal.see("x real time")
    terminal.type("\x03")
    terminal.see("ended      stopped")
    assert terminal.process.wait() == 130
    assert terminal.is_as_before


def test_the_terminal_is_restored_after_an_error(in_terminal):
    terminal = in_terminal('main:\n    x = function.is_key_pressed("up")\n    y = 1 / 0\nend\n')
    terminal.see("ZeroDivisionError")
    assert terminal.process.wait() == 3
    assert terminal.is_as_before


@pytest.mark.parametrize(
    ("sent", "keys"),
    [
        ("a\x1b[A", ["a", "up"]),
        ("\x1bOD", ["left"]),
        ("W", ["w"]),
        ("\r", ["enter"]),
        ("\x1b[5~", []),
        ("", []),
    ],
)
def test_the_keys_in_what_a_terminal_has_sent_are_found(sent, keys):
    from learnblock.cli.terminal import keys_in

    assert keys_in(sent) == keys


def test_a_terminal_reports_the_keys_typed_since_it_was_asked_last():
    from learnblock.cli.terminal import PosixTerminal

    ours, theirs = os.openpty()
    terminal = PosixTerminal(theirs)
    with terminal.listening():
        os.write(ours, b"a\x1b[B")
        select.select([theirs], [], [], SECONDS)
        assert terminal.typed() == ["a", "down"]
        assert terminal.typed() == []
    os.close(ours)
    os.close(theirs)


class Typist:
    """A terminal in which a test types."""

    def __init__(self):
        self.keys, self.by_line = [], False

    @contextmanager
    def typing(self):
        self.by_line = True
        yield
        self.by_line = False

    def typed(self):
        keys, self.keys = self.keys, []
        return keys


@pytest.fixture
def typist():
    return Typist()


@pytest.fixture
def now():
    return [0.0]


@pytest.fixture
def keys(typist, now):
    return TerminalKeys(typist, lambda: now[0])


def test_a_key_in_a_terminal_counts_as_held_for_a_moment_or_until_the_next_one(typist, now, keys):
    keyboard = TerminalKeyboard(keys, KEYS)
    typist.keys = ["a"]
    assert keyboard.held(0) == ("a",)
    now[0] = HOLD - 0.01
    assert keyboard.held(0) == ("a",)
    typist.keys = ["b"]
    assert keyboard.held(0) == ("b",)
    now[0] += HOLD
    assert keyboard.held(0) == ()


def test_programs_that_share_a_terminal_each_find_the_newest_of_their_own_keys(typist, now, keys):
    left, right = TerminalKeyboard(keys, {"up", "down"}), TerminalKeyboard(keys, {"w", "s"})
    typist.keys = ["up", "w", "s"]
    assert (left.held(0), right.held(0)) == (("up",), ("s",))
    now[0] = HOLD / 2
    typist.keys = ["down"]
    assert (left.held(0), right.held(0)) == (("down",), ("s",))
    now[0] = HOLD
    assert (left.held(0), right.held(0)) == (("down",), ())


def test_letters_of_an_answer_are_no_keys_for_other_programs(typist, keys):
    asking, other = TerminalKeyboard(keys, {"a"}), TerminalKeyboard(keys, {"w"})
    typist.keys = ["w"]
    assert other.held(0) == ("w",)
    with asking.typing():
        assert typist.by_line
        typist.keys = ["w"]
        assert other.held(0) == ()
        assert typist.keys == ["w"]
    assert not typist.by_line
    assert other.held(0) == ("w",)


def test_a_file_of_keys_drives_the_robot():
    keys = REMOTE.with_suffix(".jsonl")
    result = call("run", REMOTE, "--world", "square", "--keys", keys)
    assert "back at the start: reached" in result.stderr
    assert result.exit_code == 0
