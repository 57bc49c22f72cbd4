"""A client's connection to a component; it carries several calls at a time."""

import threading
from dataclasses import dataclass
from itertools import count

from learnblock.errors import IceEncodingError, IceLinkError
from learnblock.ice.encoding import Reader
from learnblock.ice.messages import MessageKind, message, read_reply, request
from learnblock.ice.stream import Stream
from learnblock.timing import Deadline


class NeverReadError(IceLinkError):
    """The connection ended before the component read the call."""


@dataclass
class _Call:
    """A call that is waiting for its reply."""

    reply: Reader | None = None
    failure: IceLinkError | None = None

    @property
    def is_over(self) -> bool:
        return self.reply is not None or self.failure is not None


class Connection:
    """One TCP connection; any number of threads may call at the same time.

    One of the waiting threads receives the replies for all, so that a single call needs no switch
    between threads.

    Args:
        host: the component's address.
        port: the component's port.
        deadline: the time limit.

    Raises:
        IceLinkError: no component answers.
    """

    def __init__(self, host: str, port: int, deadline: Deadline) -> None:
        self._stream = Stream(host, port, deadline)
        self._clock = deadline.clock
        self._numbers = count(1)
        self._sending = threading.Lock()
        self._turn = threading.Condition()
        self._calls: dict[int, _Call] = {}
        self._receives = False
        self._failure: IceLinkError | None = None
        self._await_validation(deadline)

    def is_usable(self, deadline: Deadline) -> bool:
        """Process everything received so far, and return whether a call can be attempted."""
        with self._turn:
            while not self._calls and self._failure is None and self._stream.has_news():
                try:
                    self._file(*self._stream.receive(deadline))
                except IceLinkError as error:
                    self._fail(error)
            return self._failure is None

    def call(self, opening: bytes, parameters: bytes, deadline: Deadline) -> Reader:
        """Make a call and wait for its reply.

        Args:
            opening: the part between its number and its parameters.
            parameters: the parameters, encapsulated.
            deadline: the time limit for the reply.

        Raises:
            NeverReadError: the component ended the connection before it read the call.
            IceLinkError: the connection broke, or the reply did not arrive in time.
        """
        number, call = self._enter()
        try:
            with self._sending:
                self._stream.send(request(number, opening, parameters), deadline)
            self._await(call, deadline)
        except IceLinkError as error:
            # A late reply could be confused with the reply to the next call.
            self._break(error)
            raise
        finally:
            with self._turn:
                self._calls.pop(number, None)
        if call.failure:
            raise call.failure
        assert call.reply is not None  # noqa: S101 - for the type checker
        return call.reply

    def close(self) -> None:
        """Say goodbye and close it; waiting calls fail. Calling it twice is harmless."""
        with self._turn:
            was_open = self._failure is None
            self._fail(IceLinkError("ice-closed"))
        if was_open:
            self._say_goodbye()
        self._stream.close()

    def _say_goodbye(self) -> None:
        if not self._sending.acquire(blocking=False):
            # Another thread is sending a message.
            return
        try:
            self._stream.send(message(MessageKind.CLOSE), Deadline.after(0, self._clock))
        except IceLinkError:
            # The component notices the end of the connection.
            pass
        finally:
            self._sending.release()

    def _await_validation(self, deadline: Deadline) -> None:
        try:
            kind, _ = self._stream.receive(deadline)
            if kind is not MessageKind.VALIDATE:
                raise IceLinkError("ice-unexpected-message", kind=kind.name)
        except IceLinkError:
            self._stream.close()
            raise

    def _enter(self) -> tuple[int, _Call]:
        call = _Call()
        with self._turn:
            if self._failure:
                raise self._failure
            number = next(self._numbers)
            self._calls[number] = call
        return number, call

    def _await(self, call: _Call, deadline: Deadline) -> None:
        while self._may_receive(call, deadline):
            try:
                kind, body = self._stream.receive(deadline)
                with self._turn:
                    self._file(kind, body)
            finally:
                self._pass_on()

    def _may_receive(self, call: _Call, deadline: Deadline) -> bool:
        """Wait until it is this thread's turn to receive, or its call has ended."""
        with self._turn:
            if not self._clock.wait_for(
                self._turn, lambda: call.is_over or not self._receives, deadline.left
            ):
                raise IceLinkError("ice-timeout")
            if call.is_over:
                return False
            self._receives = True
            return True

    def _pass_on(self) -> None:
        with self._turn:
            self._receives = False
            self._turn.notify_all()

    def _file(self, kind: MessageKind, body: bytes) -> None:
        if kind is MessageKind.REPLY:
            try:
                number, reply = read_reply(body)
            except IceEncodingError as error:
                raise IceLinkError("ice-garbled", reason=error.phrase) from error
            # A reply to a call that has timed out is dropped.
            if call := self._calls.get(number):
                call.reply = reply
        elif kind is MessageKind.CLOSE:
            # Ice sends it only after answering everything that it has read.
            self._fail(NeverReadError("ice-hung-up"))
        elif kind is not MessageKind.VALIDATE:
            raise IceLinkError("ice-unexpected-message", kind=kind.name)

    def _break(self, error: IceLinkError) -> None:
        with self._turn:
            self._fail(error)
        self._stream.close()

    def _fail(self, error: IceLinkError) -> None:
        if self._failure is None:
            self._failure = error
        for call in self._calls.values():
            call.failure = call.failure or error
        self._turn.notify_all()
