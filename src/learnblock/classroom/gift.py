"""A lesson of the teacher's own on its way to a pupil's server at a hub."""

from collections.abc import Callable

import msgspec

from learnblock.server import messages

_failed = msgspec.json.Decoder(messages.Failed)
#: Our servers put the kind first.
_FAILED = f'{{"kind":"{messages.Failed.__name__}"'
_GIVE, _START = messages.GiveLesson.__name__, messages.StartLesson.__name__


class Gift:
    """Tells the teacher, who can do something about it, when a pupil's server refuses a lesson.

    A pupil who controls the server can refuse each lesson once, and send no words to the wall.

    Args:
        refused: called when the server has refused the lesson.
    """

    def __init__(self, refused: Callable[[], object]) -> None:
        self._refused = refused
        #: The messages that may still fail.
        self._pending: set[str] = set()

    def note(self, order: messages.Message) -> None:
        """Note what the server is sent."""
        if isinstance(order, messages.GiveLesson):
            self._pending = {_GIVE, _START}

    def takes(self, text: str) -> bool:
        """Whether a message of the server is about the lesson, and not for the pupil."""
        if not self._pending or not text.startswith(_FAILED):
            return False
        kind = _failed.decode(text).refused
        if kind not in self._pending:
            return False
        self._pending.remove(kind)
        if kind == _GIVE:
            self._refused()
            return True
        # A lesson that has not arrived can't be opened either.
        return _GIVE not in self._pending
