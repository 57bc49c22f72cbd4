"""The possible values of an argument, if there are only a few."""

from collections.abc import Iterator

from learnblock.blocks import Parameter
from learnblock.errors import TagNamesError
from learnblock.perception.tag_names import tag_names
from learnblock.project.help.completion import Completion


def value_options(parameter: Parameter) -> Iterator[Completion]:
    """The parameter's choices, or the user's tag names."""
    for value in parameter.choices:
        yield Completion(_quoted(value), _quoted(value), "variable")
    if parameter.type == "apriltext":
        yield from _tags()


def _tags() -> Iterator[Completion]:
    try:
        names = tag_names()
    except TagNamesError:
        # The error is reported when the tag names are opened.
        return
    for name, number in names.items():
        yield Completion(_quoted(name), _quoted(name), "variable", detail=str(number))


def _quoted(text: str) -> str:
    """A value as written in both notations."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
