"""Commands as a person types them into a shell."""

import os
import re
import shlex

#: What Windows' shells take without quotes.
_PLAIN = re.compile(r"[\w@%+=:,./\\-]+")


def command_line(*words: object) -> str:
    """A command that this computer's shell takes as it is printed: what needs quotes has them.

    >>> command_line("learnblock", "run", "my program.bt")
    "learnblock run 'my program.bt'"
    """
    spelled = [str(word) for word in words]
    return " ".join(map(_quoted, spelled)) if _is_windows() else shlex.join(spelled)


def _is_windows() -> bool:
    return os.name == "nt"


def _quoted(word: str) -> str:
    """A word for cmd and PowerShell."""
    if _PLAIN.fullmatch(word):
        return word
    escaped = word.replace('"', '\\"')
    return f'"{escaped}"'
