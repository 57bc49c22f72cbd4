"""The values that an argument could have, where these are a few."""

from collections.abc import Iterator

from learnblock.blocks import Parameter
from learnblock.errors import TagNamesError
from learnblock.perception.tag_names import tag_names
from learnblock.server.messages import Completion


def value_options(parameter: Parameter) -> Iterator[Completion]:
    """The choices that there are, or the user's names of tags."""
    for value in parameter.choices:
        yield Completion(_quoted(value), _quoted(value), "variable")
    if parameter.type == "apriltext":
        yield from _tags()


def _tags() -> Iterator[Completion]:
    try:
        names = tag_names()
    except TagNamesError:
        # Whoever opens the dictionary is told what is wrong with it.
        return
    for name, number in names.items():
        yield Completion(_quoted(name), _quoted(name), "variable", detail=str(number))


def _quoted(text: str) -> str:
    """As both texts write it."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
