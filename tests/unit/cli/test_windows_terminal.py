"""Keys in a terminal of Windows, with a console of our own in place of the real one."""

import sys
from types import ModuleType

import pytest

from learnblock.cli.windows_terminal import WindowsTerminal


@pytest.fixture
def typed(monkeypatch):
    """Type bytes as Windows sends them; return the keys that the terminal reports."""

    def typed(*sent):
        waiting = list(sent)
        console = ModuleType("msvcrt")
        console.kbhit = lambda: bool(waiting)
        console.getch = lambda: waiting.pop(0)
        monkeypatch.setitem(sys.modules, "msvcrt", console)
        terminal = WindowsTerminal()
        with terminal.listening():
            return terminal.typed()

    return typed


@pytest.mark.parametrize(
    ("sent", "keys"),
    [
        ((b"a", b"W", b"7"), ["a", "w", "7"]),
        ((b" ", b"\r"), ["space", "enter"]),
        ((b"\xe0", b"H", b"\xe0", b"P"), ["up", "down"]),
        ((b"\x00", b"K", b"\x00", b"M"), ["left", "right"]),
        ((), []),
    ],
)
def test_characters_and_arrows_are_keys(typed, sent, keys):
    assert typed(*sent) == keys


def test_keys_that_programs_cannot_ask_for_are_skipped(typed):
    # F1, Home, Escape and a letter with an accent.
    assert typed(b"\x00", b";", b"\xe0", b"G", b"\x1b", b"\x82", b"x") == ["x"]


def test_an_accented_letter_that_is_sent_like_an_arrow_waits_for_no_second_byte(typed):
    assert typed(b"a", b"\xe0") == ["a"]
