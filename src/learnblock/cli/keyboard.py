"""The keyboard of a run on the command line: the terminal, or a file with recorded keys."""

import os
import sys
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext
from threading import Lock
from time import monotonic
from typing import Protocol

import click

from learnblock.cli.console import text
from learnblock.client.keyboard import KEYS
from learnblock.i18n import Phrase
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.program import KEY_SKILL, Program

#: Seconds for which a key counts as held after a terminal has reported it: terminals do not report
#: that a key is released, and repeat one that is held only after about half a second.
HOLD = 0.6

_ARROWS = {"up": "↑", "down": "↓", "left": "←", "right": "→"}


class HeldKeys(Protocol):
    """The keys that a program finds held down."""

    def held(self, time: float) -> Collection[str]:
        """The keys that are held down at this time of the robot, in seconds."""

    def typing(self) -> AbstractContextManager[None]:
        """Let the person type a line while the context is open."""


class NoKeys:
    """A keyboard without pressed keys."""

    def held(self, time: float) -> Collection[str]:
        del time
        return ()

    def typing(self) -> AbstractContextManager[None]:
        return nullcontext()


class RecordedKeyboard(NoKeys):
    """Presses recorded keys."""

    def __init__(self, keys: RecordedKeys) -> None:
        self.keys = keys

    def held(self, time: float) -> Collection[str]:
        return self.keys.held(time)


class Terminal(Protocol):
    """The terminal of one operating system."""

    def listening(self) -> AbstractContextManager[None]:
        """Receive every key at once while the context is open."""

    def typing(self) -> AbstractContextManager[None]:
        """Let the person type a line while the context is open."""

    def typed(self) -> Sequence[str]:
        """The keys typed since the last call that programs can ask for, in order."""


class TerminalKeys:
    """The keys of a terminal, which several programs may share.

    Args:
        terminal: the terminal.
        now: returns seconds.
    """

    def __init__(self, terminal: Terminal, now: Callable[[], float] = monotonic) -> None:
        self._terminal = terminal
        self._now = now
        #: When each key stops counting as held, the one typed last at the end.
        self._until: dict[str, float] = {}
        #: Real robots of one run are each served by a thread.
        self._reading = Lock()

    def newest(self, keys: Collection[str]) -> tuple[str, ...]:
        """The key among these that was typed last, if it still counts as held."""
        # While a person types an answer, its letters don't count as keys of other programs.
        if self._reading.acquire(blocking=False):
            try:
                self._read()
            finally:
                self._reading.release()
        until = self._until
        newest = next((key for key in reversed(tuple(until)) if key in keys), "")
        return (newest,) if self._now() < until.get(newest, 0.0) else ()

    @contextmanager
    def typing(self) -> Iterator[None]:
        """Let the person type a line while the context is open."""
        with self._reading, self._terminal.typing():
            # The key that led to the question will have been released.
            self._until = {}
            yield

    def _read(self) -> None:
        for key in self._terminal.typed():
            # Another thread may be looking at the dictionary.
            others = {other: until for other, until in self._until.items() if other != key}
            self._until = {**others, key: self._now() + HOLD}


class TerminalKeyboard:
    """The terminal as the keyboard of one program: the newest of its keys counts as held."""

    def __init__(self, terminal: TerminalKeys, keys: Collection[str]) -> None:
        self._terminal = terminal
        self._keys = keys

    def held(self, time: float) -> tuple[str, ...]:
        del time
        return self._terminal.newest(self._keys)

    def typing(self) -> AbstractContextManager[None]:
        return self._terminal.typing()


@contextmanager
def terminal_keyboard(program: Program) -> Iterator[HeldKeys]:
    """The terminal's keys, if the program asks for keys; otherwise none is pressed."""
    if not listens_to_terminal(program):
        yield NoKeys()
        return
    with _listening(Phrase("report-listens", keys=shown(program.keys))) as terminal:
        yield TerminalKeyboard(terminal, KEYS)


@contextmanager
def shared_keyboard(programs: Mapping[str, Program]) -> Iterator[Mapping[str, HeldKeys]]:
    """The terminal's keys for those of several programs that ask for keys, by their names."""
    listening = {
        name: program for name, program in programs.items() if listens_to_terminal(program)
    }
    if not listening:
        yield {}
        return
    listeners = "; ".join(f"{name} {shown(program.keys)}" for name, program in listening.items())
    with _listening(Phrase("report-team-listens", programs=listeners)) as terminal:
        yield {
            name: TerminalKeyboard(terminal, program.keys) for name, program in listening.items()
        }


@contextmanager
def _listening(announcement: Phrase) -> Iterator[TerminalKeys]:
    terminal = _terminal()
    with terminal.listening():
        click.echo(text(announcement), err=True)
        yield TerminalKeys(terminal)


def _terminal() -> Terminal:
    if sys.platform == "win32":
        from learnblock.cli.windows_terminal import WindowsTerminal  # noqa: PLC0415 - only there

        return WindowsTerminal()
    from learnblock.cli.terminal import PosixTerminal  # noqa: PLC0415 - not on Windows

    return PosixTerminal(sys.stdin.fileno())


def listens_to_terminal(program: Program) -> bool:
    """Whether a program asks for keys, and a person can press them in the terminal."""
    if KEY_SKILL not in program.names or not sys.stdin.isatty():
        return False
    # In the background, a program that reads from its terminal is stopped, except on Windows.
    return sys.platform == "win32" or os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()


def shown(keys: Collection[str]) -> str:
    """Names of keys, for a person.

    >>> shown(["up", "space", "w"])
    '↑ space w'
    """
    return " ".join(_ARROWS.get(key, key) for key in keys)
