"""The templates of new files."""

from pathlib import Path
from string import Template

_FOLDER = Path(__file__).parent / "templates"


def fill(name: str, /, **values: object) -> str:
    """A filled-in template.

    Args:
        name: such as ``robot/client.py``.
        values: the values by their names in the template; the caller has checked them.
    """
    return Template(read(name)).substitute(values)


def has(name: str) -> bool:
    """Whether there is such a template."""
    return _path(name).is_file()


def read(name: str) -> str:
    """The text of a template."""
    return _path(name).read_text(encoding="utf-8")


def _path(name: str) -> Path:
    return _FOLDER / f"{name}.template"


def indented(lines: str, depth: int) -> str:
    """Lines indented by this many levels of Python."""
    return "\n".join(" " * 4 * depth + line if line else line for line in lines.splitlines())
