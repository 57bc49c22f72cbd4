r"""Raw Python inside Block-Text: how its lines are indented, and how they are kept byte for byte.

Each line stands as it is behind the block's indentation. A ``\`` at the start of a line is dropped
and what follows is taken as it stands; so it goes before a line that reads ``end``, one that begins
with a ``\`` itself, and white space that would otherwise pass for indentation. A last line of
nothing but a ``\`` says that the file has no line feed at its end.
"""

import re

_NEEDS_ESCAPE = re.compile(r"[ \t]*end\b[ \t]*(?:#.*)?\r?|\\.*|[ \t]+", re.DOTALL)
_INDENT = re.compile(r"[ \t]*")


def written(text: str, indent: str) -> list[str]:
    """The lines of the block of raw Python `text`, for lines that begin with `indent`."""
    lines = text.split("\n")
    unfinished = lines.pop()
    result: list[str] = []
    first = True
    for line in [*lines, *([unfinished] if unfinished else [])]:
        result.append(_written_line(line, indent, first=first))
        first = first and not line
    if unfinished:
        result.append(indent + "\\")
    return result


def read(block: str) -> str:
    """The raw Python between the lines ``python:`` and ``end``, each of which ends with a feed."""
    lines = block.split("\n")[:-1] if block.endswith("\n") else block.split("\n") if block else []
    first = next((line for line in lines if line.strip(" \t")), "")
    indent = _indent(first)
    plain = [_read_line(line, indent) for line in lines]
    if lines and lines[-1].lstrip(" \t") == "\\":
        return "\n".join(plain[:-1])
    return "".join(line + "\n" for line in plain)


def code_lines(text: str) -> bool:
    """Whether raw Python holds anything but comments and blank lines."""
    return any(line.strip() and not line.lstrip().startswith("#") for line in text.split("\n"))


def _written_line(line: str, indent: str, *, first: bool) -> str:
    if not line:
        return ""
    indented = first and line[0] in " \t"
    return indent + ("\\" if indented or _NEEDS_ESCAPE.fullmatch(line) else "") + line


def _indent(line: str) -> str:
    match = _INDENT.match(line)
    return match[0] if match else ""


def _read_line(line: str, indent: str) -> str:
    rest = line[len(indent) :] if line.startswith(indent) else line.lstrip(" \t")
    if rest.startswith("\\"):
        return rest[1:]
    return rest if rest.strip(" \t") else ""
