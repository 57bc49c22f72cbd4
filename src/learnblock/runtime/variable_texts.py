"""A program's own variables as text, with the parts of its objects."""

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from types import GetSetDescriptorType, MemberDescriptorType, ModuleType
from typing import Any

from learnblock.client import Client
from learnblock.runtime.messages import LONGEST_NAME
from learnblock.runtime.values import described, encodable, shortened, without_module

#: The most bytes of a function's variables, and of the program's, that are described.
MOST_DESCRIBED = 24 * 1024
#: How many objects within objects are opened.
DEEPEST_OBJECT = 3


def described_variables(variables: Mapping[str, Any]) -> dict[str, str]:
    """The variables as text, as many as fit into a message; `driver.speed` is a part of `driver`.

    What is imported, the robot, functions and classes are no variables.
    """
    texts: dict[str, str] = {}
    left = MOST_DESCRIBED
    for name, value in _opened(variables):
        shown, text = shortened(encodable(name), LONGEST_NAME - 3), _described(value)
        left -= len(shown.encode()) + len(text.encode())
        if left < 0:
            break
        texts[shown] = text
    return texts


def _opened(variables: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """The variables by name, each followed by its parts."""
    for name, value in list(variables.items()):
        if not name.startswith("__") and _is_variable(value):
            yield name, value
            yield from _parts(name, value, ())


def _is_variable(value: object) -> bool:
    return not (isinstance(value, Client | ModuleType) or callable(value))


def _parts(name: str, value: object, around: tuple[object, ...]) -> Iterator[tuple[str, Any]]:
    """The attributes of an object of one of the program's own classes, and theirs."""
    is_inside_itself = any(value is outer for outer in around)
    if is_inside_itself or len(around) >= DEEPEST_OBJECT or type(value).__module__ != "__main__":
        return
    for attribute, part in _attributes(value):
        if _is_variable(part):
            yield f"{name}.{attribute}", part
            yield from _parts(f"{name}.{attribute}", part, (*around, value))


def _attributes(value: object) -> Iterator[tuple[str, Any]]:
    """What an object holds, without running code of its class."""
    for kind in type(value).__mro__:
        for name, member in vars(kind).items():
            if isinstance(member, GetSetDescriptorType) and name == "__dict__":
                yield from list(member.__get__(value).items())
            elif isinstance(member, MemberDescriptorType):
                # An attribute in `__slots__`, which may have no value yet.
                with suppress(AttributeError):
                    yield name, member.__get__(value)


def _described(value: object) -> str:
    text = described(value)
    # A path of this computer is in descriptions of files and the like.
    is_path = text.startswith("<") and re.search(r"[/\\]", text)
    return type(value).__name__ if is_path else without_module(text)
