"""Functions of a module that differ by program, although there is only one such module."""

import threading
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from types import ModuleType
from typing import Any

from greenlet import getcurrent, greenlet

Functions = Mapping[str, Callable[..., Any]]


class OwnFunctions:
    """Functions of a module that a program can have to itself.

    The module is the interpreter's only one, so its functions are replaced for all: each program
    gets its own, and everyone else the original ones. Programs that take turns in one thread are
    told apart by their greenlets.

    Args:
        module: the module.
        names: the functions.
    """

    def __init__(self, module: ModuleType, names: Iterable[str]) -> None:
        self._module = module
        self._originals: Functions = {name: getattr(module, name) for name in names}
        self._replacements: Functions = {
            name: partial(self._call, name) for name in self._originals
        }
        #: The functions of each program, the newest last.
        self._owned: dict[greenlet, list[Functions]] = {}
        self._lock = threading.Lock()

    def use(self, functions: Functions) -> Callable[[], None]:
        """Give the calling program its own functions; return the function that undoes it.

        Other threads, and modules that imported the functions directly, keep the originals. The
        returned function may be called from any thread, and twice.
        """
        program = getcurrent()
        with self._lock:
            self._owned.setdefault(program, []).append(functions)
            self._put(self._replacements)
        return lambda: self._restore(program, functions)

    def _restore(self, program: greenlet, functions: Functions) -> None:
        with self._lock:
            owned = self._owned.get(program, [])
            if functions in owned:
                owned.remove(functions)
            if not owned:
                self._owned.pop(program, None)
            if not self._owned:
                self._put(self._originals)

    def _put(self, functions: Functions) -> None:
        for name, function in functions.items():
            setattr(self._module, name, function)

    def _call(self, name: str, *args: Any, **kwargs: Any) -> Any:
        owned = self._owned.get(getcurrent())
        return (owned[-1] if owned else self._originals)[name](*args, **kwargs)
