"""The templates of new files, and how they are filled in."""

from pathlib import Path
from string import Template

_FOLDER = Path(__file__).parents[1] / "templates"


def fill(name: str, /, **values: object) -> str:
    """A template with its places filled in; the caller has checked that the values fit there.

    Args:
        name: such as ``robot/client.py``.
        values: by the names of the places.
    """
    return Template(read(name)).substitute(values)


def read(name: str) -> str:
    """The text of a template."""
    return (_FOLDER / f"{name}.template").read_text(encoding="utf-8")


def indented(lines: str, depth: int) -> str:
    """Lines moved to the right by so many levels of Python."""
    return "\n".join(" " * 4 * depth + line if line else line for line in lines.splitlines())
