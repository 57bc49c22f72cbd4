r"""Indent raw Python inside Block-Text, and keep it byte for byte.

Each line is indented like the block. A ``\`` at the start of a line is an escape: it is removed,
and the rest of the line is kept. It comes before a line that reads ``end``, a line that begins with
a ``\``, and white space that would otherwise count as indentation. A last line that is only a
``\`` means that the file has no line feed at its end.
"""

import re

_NEEDS_ESCAPE = re.compile(r"[ \t]*end\b[ \t]*(?:#.*)?\r?|\\.*|[ \t]+", re.DOTALL)
_INDENT = re.compile(r"[ \t]*")


def written(text: str, indent: str) -> list[str]:
    """The lines of a block with the raw Python `text`, indented by `indent`."""
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
    """The raw Python in the lines between ``python:`` and ``end``."""
    lines = block.split("\n")[:-1] if block.endswith("\n") else block.split("\n") if block else []
    first = next((line for line in lines if line.strip(" \t")), "")
    indent = _indent(first)
    plain = [_read_line(line, indent) for line in lines]
    if lines and lines[-1].lstrip(" \t") == "\\":
        return "\n".join(plain[:-1])
    return "".join(line + "\n" for line in plain)


def code_lines(text: str) -> bool:
    """Whether raw Python contains more than comments and blank lines."""
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
