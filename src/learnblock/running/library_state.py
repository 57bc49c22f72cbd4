"""Whether a run has left our modules and classes, and Python's that it uses, as they were."""

import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

#: The packages whose code a run executes, and Python's modules that a plain program calls.
_PACKAGES = tuple(
    f"learnblock.{package}."
    for package in ("client", "devices", "perception", "robots", "runtime", "simulator", "skills")
)
_OF_PYTHON = ("builtins", "math", "random", "statistics", "time")
#: What msgspec adds to a class when it first encodes an object of it, and Python 3.14 (PEP 649)
#: when its annotations are first read.
_ADDED = frozenset({"__msgspec_cache__", "__annotate_func__", "__annotations_cache__"})
_MISSING = object()

_Names = Mapping[str, Any]


class LibraryState:
    """The values of the names in modules and in our classes.

    A run may add names to a module, such as that of a module that it loads, but replace none.
    """

    def __init__(self) -> None:
        self._modules = [(names, dict(names)) for names in _modules()]
        self._classes = [(names, dict(names)) for names in map(vars, _classes(self._modules))]

    def is_unchanged(self) -> bool:
        """Whether all names still have the same values."""
        return all(_keeps(*names) for names in self._modules) and all(
            _keeps(now, before) and (len(now) == len(before) or _adds_nothing(now, before))
            for now, before in self._classes
        )


def _keeps(now: _Names, before: _Names) -> bool:
    return all(now.get(name, _MISSING) is value for name, value in before.items())


def _adds_nothing(now: _Names, before: _Names) -> bool:
    return now.keys() - before.keys() <= _ADDED


def _modules() -> Iterator[_Names]:
    for name, module in sys.modules.copy().items():
        if name.startswith(_PACKAGES) or name in _OF_PYTHON:
            yield vars(module)


def _classes(modules: Sequence[tuple[_Names, _Names]]) -> set[type]:
    return {
        value
        for _, names in modules
        for value in names.values()
        if isinstance(value, type) and value.__module__.startswith(_PACKAGES)
    }
