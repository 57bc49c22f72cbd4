"""Messages between the robots of one run."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import msgspec

from learnblock.errors import DeviceValueError

#: The most messages that wait for a robot; when one more arrives, the oldest is lost.
MOST_WAITING = 1000
#: Characters of a message's name.
LONGEST_NAME = 100
#: Bytes of a message's value, as JSON.
LARGEST_VALUE = 4096
#: Lists and dictionaries within each other.
DEEPEST_VALUE = 20

_WHOLE = range(-(2**63), 2**63)

Message = tuple[str, Any]


def _send_to_nobody(name: str, value: Any) -> None:
    """A robot that is alone may send, too."""


class Mailbox:
    """A robot's messages; without arguments those of a robot that is alone.

    Args:
        send: sends a message to all other robots of the run.
        collect: returns the messages that have arrived since the last call, oldest first.
    """

    def __init__(
        self,
        send: Callable[[str, Any], object] = _send_to_nobody,
        collect: Callable[[], Iterable[Message]] = tuple,
    ) -> None:
        self._send = send
        self._collect = collect
        self._waiting: deque[Message] = deque(maxlen=MOST_WAITING)
        #: The value of the last message taken, by name.
        self._values: dict[str, Any] = {}
        #: The answers that stay the same during a snapshot.
        self._answers: dict[str, bool] | None = None

    def send(self, name: str, value: Any = None) -> None:
        """Send a message to all other robots.

        Raises:
            DeviceValueError: the name or the value is not possible.
        """
        self._send(*checked(name, value))

    def take(self, name: str) -> bool:
        """Take the oldest message with this name; return whether there was one."""
        if self._answers is None:
            return self._take(name)
        if name not in self._answers:
            self._answers[name] = self._take(name)
        return self._answers[name]

    def value(self, name: str) -> Any:
        """The value of the message with this name that was taken last; None before the first."""
        return self._values.get(name)

    @contextmanager
    def snapshot(self) -> Iterator[None]:
        """Take at most one message of a name while the context is open, however often asked."""
        self._answers = {}
        try:
            yield
        finally:
            self._answers = None

    def _take(self, name: str) -> bool:
        self._waiting.extend(self._collect())
        for index, (waiting, value) in enumerate(self._waiting):
            if waiting == name:
                del self._waiting[index]
                self._values[name] = value
                return True
        return False


def checked(name: object, value: object) -> Message:
    """A message that may be sent: its name, and its value as plain data.

    Raises:
        DeviceValueError: the name or the value is not possible.
    """
    if not _is_text(name) or not 0 < len(str(name)) <= LONGEST_NAME:
        raise DeviceValueError("robot-message-name", limit=LONGEST_NAME)
    plain = _plain(value, DEEPEST_VALUE)
    size = len(msgspec.json.encode(plain))
    if size > LARGEST_VALUE:
        raise DeviceValueError(
            "robot-message-too-large", message=str(name), size=size, limit=LARGEST_VALUE
        )
    return str(name), plain


def _is_text(value: object) -> bool:
    """Whether it is a text that can be written to a file."""
    try:
        return isinstance(value, str) and value.encode() is not None
    except UnicodeEncodeError:
        return False


def _plain(value: object, levels: int) -> Any:
    match value:
        case None | bool():
            return value
        case int() if value in _WHOLE:
            return int(value)
        case float():
            return float(value)
        case str() if _is_text(value):
            return str(value)
        case list() | tuple() if levels:
            return [_plain(item, levels - 1) for item in value]
        case dict() if levels and all(map(_is_text, value)):
            return {str(key): _plain(item, levels - 1) for key, item in value.items()}
    raise DeviceValueError("robot-message-value", type=type(value).__name__)
