"""CoppeliaSim's ZeroMQ remote API: the vendor's client with time limits and a lock."""

import math
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

from learnblock.errors import RobotConnectionError, SceneCallError
from learnblock.i18n import Phrase
from learnblock.robots.real import require
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: The allowed commands in a reply: none, wait, or repeat.
_WAITS = (None, "_*wait*_", "_*repeat*_")
#: How often a request is sent before the connection counts as lost. All our requests either read
#: or set a value, so repeating one is harmless.
ATTEMPTS = 3


class Remote:
    """A connection to CoppeliaSim.

    Args:
        address: the computer on which it runs.
        port: the port of its remote API.
        timeout: how long to wait for an answer, in seconds.
        clock: the clock of this limit.

    Raises:
        MissingPackageError: the vendor's client is not installed.
    """

    def __init__(
        self, address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        library = require("coppeliasim_zmqremoteapi_client", "coppeliasim")
        self.place = f"{address}:{port}"
        self._timeout = timeout
        self._clock = clock
        self._zmq = library.zmq
        with _main_module_unchanged():
            self._client = _client_class(library)(address, port)
        self._prepare_socket(library.zmq)
        self._lock = threading.Lock()
        self._lost: Phrase | None = None
        self._sim: Any = None

    def open(self) -> None:
        """Connect, and load the list of its functions.

        Raises:
            RobotConnectionError: CoppeliaSim does not respond, or is too old.
        """
        self._sim = self._asked(lambda: self._client.require("sim"))

    def call(self, function: str, *arguments: Any) -> Any:
        """Call a function of its API, such as ``getObject``.

        Returns:
            The function's result; several values as a tuple, None for none.

        Raises:
            SceneCallError: the function fails or does not exist.
            RobotConnectionError: there is no valid answer; all later calls fail at once.
        """
        called = getattr(self._sim, function, None)
        if called is None:
            raise SceneCallError("coppeliasim-too-old", place=self.place, name=f"sim.{function}")
        return self._asked(lambda: called(*arguments))

    def constant(self, *names: str) -> Any:
        """The value of the first of these constants that this version has.

        Raises:
            SceneCallError: none of them exists.
        """
        for name in names:
            value = getattr(self._sim, name, None)
            if value is not None:
                return value
        raise SceneCallError("coppeliasim-too-old", place=self.place, name=f"sim.{names[0]}")

    @property
    def is_lost(self) -> bool:
        """Whether the connection is lost or closed."""
        return self._lost is not None

    def bad_answer(self, name: str, answer: object) -> RobotConnectionError:
        """The error for an answer that does not have the expected form."""
        return RobotConnectionError(
            "coppeliasim-bad-answer", place=self.place, name=name, answer=str(answer)
        )

    def close(self) -> None:
        """Close the connection; calling it twice is harmless."""
        with self._lock:
            self._lost = self._lost or Phrase("coppeliasim-closed", place=self.place)
            self._client.socket.close(linger=0)
            self._client.context.term()

    def _prepare_socket(self, zmq: ModuleType) -> None:
        """Set timeouts: without them the client waits forever if nothing responds."""
        options = {
            zmq.LINGER: 0,
            zmq.RCVTIMEO: round(1000 * self._timeout / ATTEMPTS),
            zmq.SNDTIMEO: round(1000 * self._timeout / ATTEMPTS),
            # A request may be sent again, and a late answer to the first one is dropped.
            zmq.REQ_RELAXED: 1,
            zmq.REQ_CORRELATE: 1,
        }
        for option, value in options.items():
            self._client.socket.setsockopt(option, value)

    def _asked(self, request: Callable[[], Any]) -> Any:
        with self._lock:
            if self._lost:
                raise RobotConnectionError(self._lost.code, **self._lost.values)
            for _ in range(ATTEMPTS):
                self._client.deadline = Deadline.after(self._timeout / ATTEMPTS, self._clock)
                try:
                    return request()
                except self._zmq.Again:
                    continue
                except Exception as error:
                    # The vendor's client raises a bare Exception for an error in CoppeliaSim; any
                    # other exception means that it could not read the answer.
                    if type(error) is Exception:
                        raise SceneCallError(
                            "coppeliasim-refused", place=self.place, reason=_first_line(error)
                        ) from None
                    raise self._lose("coppeliasim-not-coppeliasim") from error
            raise self._lose("coppeliasim-no-answer")

    def _lose(self, code: str) -> RobotConnectionError:
        self._lost = Phrase(code, place=self.place)
        return RobotConnectionError(self._lost.code, **self._lost.values)


def _client_class(library: ModuleType) -> Any:
    """The vendor's client with limits: the original waits forever and runs any command it gets."""

    class BoundedClient(library.RemoteAPIClient):  # type: ignore[misc, name-defined]
        #: The limit of the request that is being made.
        deadline = Deadline(MONOTONIC, math.inf)

        def _recv(self) -> Any:
            if self.deadline.is_over:
                raise library.zmq.Again
            reply = super()._recv()
            if isinstance(reply, dict) and reply.get("func") not in _WAITS:
                raise ValueError(f"unexpected command {reply['func']!r:.80}")
            return reply

    return BoundedClient


@contextmanager
def _main_module_unchanged() -> Iterator[None]:
    """Remove the function `require` that the vendor's client adds to the user's program."""
    names = vars(sys.modules["__main__"])
    before = {"require": names["require"]} if "require" in names else {}
    try:
        yield
    finally:
        names.pop("require", None)
        names.update(before)


def _first_line(error: Exception) -> str:
    """A script's error without its traceback."""
    return str(error).partition("_=NL=_")[0].strip()[:300]
