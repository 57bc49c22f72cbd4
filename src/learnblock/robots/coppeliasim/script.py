"""The functions of a script in CoppeliaSim's scene."""

from collections.abc import Callable
from typing import Any, TypeVar

from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.readings import NonsenseError
from learnblock.robots.coppeliasim.remote import RefusedError, Remote

T = TypeVar("T")


class Script:
    """A script that an object of the scene carries.

    Args:
        remote: where the scene is.
        path: the object's.
        advice: what to do when there is no such script.

    Raises:
        RobotConnectionError: there is no such script.
    """

    def __init__(self, remote: Remote, path: str, advice: str) -> None:
        self._remote = remote
        self._path = path
        # The same type of script under its name since version 4.7, and the one before.
        kind = remote.constant("scripttype_simulation", "scripttype_childscript")
        try:
            self._handle = remote.call("getScript", kind, path)
        except RefusedError:
            self._handle = -1
        if self._handle == -1:
            raise RobotConnectionError(
                f"the scene of {remote.place} has no object {path} with a script: {advice}"
            )

    def call(self, function: str, *arguments: Any) -> Any:
        """Call one of its functions.

        Raises:
            RefusedError: it has no such function, or that fails.
            RobotConnectionError: the link is gone.
        """
        try:
            return self._remote.call("callScriptFunction", function, self._handle, *arguments)
        except RefusedError as error:
            raise RefusedError(
                f"the script of {self._path} does not do `{function}`: was the simulation stopped?"
                f" ({error})"
            ) from None

    def ask(self, read: Callable[[Any], T], function: str, *arguments: Any) -> T:
        """Call one of its functions and understand its answer by `read`."""
        return understood(self._remote, read, function, self.call(function, *arguments))


def understood(remote: Remote, read: Callable[[Any], T], what: str, reply: Any) -> T:
    """An answer as `read` understands it.

    Raises:
        RobotConnectionError: it cannot be understood.
    """
    try:
        return read(reply)
    except NonsenseError as error:
        raise remote.nonsense(f"`{what}`", error) from None
