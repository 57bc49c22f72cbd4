"""CoppeliaSim's ZeroMQ remote API, by the vendor's own client with time limits and a lock."""

import math
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from types import ModuleType
from typing import Any

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require

#: What a client may be told to do instead of an answer: nothing, wait, or ask again.
_WAITS = (None, "_*wait*_", "_*repeat*_")
#: How often a request is sent before the link counts as lost. Repeating one does no harm: all of
#: ours either ask or set.
ATTEMPTS = 3


class RefusedError(RobotConnectionError):
    """CoppeliaSim answers that it cannot do what it was asked."""


class Remote:
    """CoppeliaSim as seen from here.

    Args:
        address: where it runs.
        port: where its remote API listens.
        patience: seconds in which it must have answered.

    Raises:
        MissingPackageError: the vendor's client is not installed.
    """

    def __init__(self, address: str, port: int, patience: float) -> None:
        library = require("coppeliasim_zmqremoteapi_client", "coppeliasim")
        self.place = f"CoppeliaSim at {address}:{port}"
        self._patience = patience
        self._zmq = library.zmq
        with _main_module_unchanged():
            self._client = _client_class(library)(address, port)
        self._prepare_socket(library.zmq)
        self._lock = threading.Lock()
        self._lost: str | None = None
        self._sim: Any = None

    def open(self) -> None:
        """Learn what it offers.

        Raises:
            RobotConnectionError: it does not answer, or is too old.
        """
        self._sim = self._asked(lambda: self._client.require("sim"))

    def call(self, function: str, *arguments: Any) -> Any:
        """Have a function of its API called, such as ``getObject``.

        Returns:
            What the function returns; several values as a tuple, None for none.

        Raises:
            RefusedError: the function fails, or is not there.
            RobotConnectionError: no answer, or none that can be understood; from then on every call
                fails at once.
        """
        called = getattr(self._sim, function, None)
        if called is None:
            raise RefusedError(
                f"{self.place} has no function sim.{function}: CoppeliaSim 4.6 or later has"
            )
        return self._asked(lambda: called(*arguments))

    def constant(self, *names: str) -> Any:
        """The value of the first of these constants that this version has.

        Raises:
            RefusedError: it has none of them.
        """
        for name in names:
            value = getattr(self._sim, name, None)
            if value is not None:
                return value
        raise RefusedError(f"{self.place} has no sim.{names[0]}: CoppeliaSim 4.6 or later has")

    @property
    def is_lost(self) -> bool:
        """Whether it has ceased to answer."""
        return self._lost is not None

    def nonsense(self, what: str, error: object) -> RobotConnectionError:
        """The error for an answer that has not the form it should have."""
        return RobotConnectionError(f"{self.place} answers {what} with nonsense: {error}")

    def close(self) -> None:
        """Let go; the second time it does nothing."""
        with self._lock:
            self._lost = self._lost or f"the connection to {self.place} is closed"
            self._client.socket.close(linger=0)
            self._client.context.term()

    def _prepare_socket(self, zmq: ModuleType) -> None:
        """Without these the client waits for ever when nobody listens, and again at its end."""
        options = {
            zmq.LINGER: 0,
            zmq.RCVTIMEO: round(1000 * self._patience / ATTEMPTS),
            zmq.SNDTIMEO: round(1000 * self._patience / ATTEMPTS),
            # A request may be sent again, and a late answer to the first one is dropped.
            zmq.REQ_RELAXED: 1,
            zmq.REQ_CORRELATE: 1,
        }
        for option, value in options.items():
            self._client.socket.setsockopt(option, value)

    def _asked(self, request: Callable[[], Any]) -> Any:
        with self._lock:
            if self._lost:
                raise RobotConnectionError(self._lost)
            for _ in range(ATTEMPTS):
                self._client.deadline = monotonic() + self._patience / ATTEMPTS
                try:
                    return request()
                except self._zmq.Again:
                    continue
                except Exception as error:
                    # The vendor's client raises a bare Exception for what CoppeliaSim refuses;
                    # any other one means that it could not read the answer.
                    if type(error) is Exception:
                        raise RefusedError(f"{self.place} refuses: {_first_line(error)}") from None
                    raise self._lose(
                        "answers nonsense: is it CoppeliaSim 4.6 or later that listens there?"
                    ) from error
            raise self._lose(
                f"has not answered for {self._patience:g} s: is CoppeliaSim running there, with its"
                " ZMQ remote API server?"
            )

    def _lose(self, why: str) -> RobotConnectionError:
        self._lost = f"{self.place} {why}"
        return RobotConnectionError(self._lost)


def _client_class(library: ModuleType) -> Any:
    """The vendor's client, which would wait as often as it is told to, and call what it is told."""

    class BoundedClient(library.RemoteAPIClient):  # type: ignore[misc, name-defined]
        #: By `monotonic`.
        deadline = math.inf

        def _recv(self) -> Any:
            if monotonic() > self.deadline:
                raise library.zmq.Again
            reply = super()._recv()
            if isinstance(reply, dict) and reply.get("func") not in _WAITS:
                raise ValueError(f"it calls {reply['func']!r:.80}, which is not here")
            return reply

    return BoundedClient


@contextmanager
def _main_module_unchanged() -> Iterator[None]:
    """The vendor's client puts a function `require` among the names of the user's program."""
    names = vars(sys.modules["__main__"])
    before = {"require": names["require"]} if "require" in names else {}
    try:
        yield
    finally:
        names.pop("require", None)
        names.update(before)


def _first_line(error: Exception) -> str:
    """What a script's error says, without the way the call took."""
    return str(error).partition("_=NL=_")[0].strip()[:300]
