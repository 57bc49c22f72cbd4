"""Commands that are printed for a person to type."""

import shlex
import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock import shell
from learnblock.shell import command_line

words = st.lists(
    st.text(st.characters(exclude_characters="\0", exclude_categories=["Cs"])), min_size=1
)


@given(words)
def test_a_printed_command_has_the_words_that_were_meant(meant):
    assert shlex.split(command_line(*meant)) == meant


@pytest.mark.skipif(sys.platform == "win32", reason="There is no sh")
def test_a_shell_takes_a_command_as_it_is_printed():
    meant = ["my program.bt", "", "[10102, 10103]", "$HOME", "it's", "a;b|c>d", "*"]
    line = command_line("printf", r"%s\n", *meant)
    done = subprocess.run(["sh", "-c", line], stdout=subprocess.PIPE, text=True, check=True)

    assert done.stdout.splitlines() == meant


@pytest.mark.parametrize(
    ("word", "spelled"),
    [
        ("run", "run"),
        (r"C:\Users\Zoe\square.bt", r"C:\Users\Zoe\square.bt"),
        ("my program.bt", '"my program.bt"'),
        ("pyserial>=3.5", '"pyserial>=3.5"'),
        ("", '""'),
    ],
)
def test_windows_has_double_quotes(monkeypatch, word, spelled):
    monkeypatch.setattr(shell, "_is_windows", lambda: True)

    assert command_line(word) == spelled
