"""Calls the functions of a script in CoppeliaSim's scene."""

from collections.abc import Callable
from typing import Any, TypeVar

from learnblock.errors import RobotConnectionError, SceneCallError
from learnblock.robots.coppeliasim.readings import BadReplyError
from learnblock.robots.coppeliasim.remote import Remote

T = TypeVar("T")


class Script:
    """A script attached to an object of the scene.

    Args:
        remote: the connection to CoppeliaSim.
        path: the object's path.
        missing: the code of the error for a missing script; its words show the path.

    Raises:
        RobotConnectionError: there is no such script.
    """

    def __init__(self, remote: Remote, path: str, *, missing: str) -> None:
        self._remote = remote
        self._path = path
        # The names of the same type of script since version 4.7, and before.
        kind = remote.constant("scripttype_simulation", "scripttype_childscript")
        try:
            self._handle = remote.call("getScript", kind, path)
        except SceneCallError:
            self._handle = -1
        if self._handle == -1:
            raise RobotConnectionError(missing, path=path)

    def call(self, function: str, *arguments: Any) -> Any:
        """Call one of its functions.

        Raises:
            SceneCallError: the function fails or does not exist.
            RobotConnectionError: the connection is lost.
        """
        try:
            return self._remote.call("callScriptFunction", function, self._handle, *arguments)
        except SceneCallError as error:
            reason = error.phrase.values.get("reason", error.phrase)
            raise SceneCallError(
                "coppeliasim-script-failed", path=self._path, function=function, reason=reason
            ) from None

    def ask(self, read: Callable[[Any], T], function: str, *arguments: Any) -> T:
        """Call one of its functions and convert the answer with `read`."""
        return understood(self._remote, read, function, self.call(function, *arguments))


def understood(remote: Remote, read: Callable[[Any], T], what: str, reply: Any) -> T:
    """An answer converted by `read`.

    Raises:
        RobotConnectionError: it does not have the expected form.
    """
    try:
        return read(reply)
    except BadReplyError as error:
        raise remote.bad_answer(what, error) from None
