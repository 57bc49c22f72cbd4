"""Turns of threads to send on the child's side of the link."""

import threading
from threading import get_ident

from learnblock.errors import LearnBlockError


class Turn:
    """A lock that can refuse a thread, and that no signal handler interrupts.

    A signal handler runs in the main thread, between any two steps. If it raised in the middle of a
    message, or before the lock is released, the link would be unusable; so the exception is
    postponed until the turn is over.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._main = threading.main_thread().ident
        #: The thread that may neither take a turn nor wait for one.
        self.forbidden_to: int | None = None
        #: Whether the main thread has the lock, or waits for it.
        self._main_inside = False
        self._postponed: BaseException | None = None

    def __enter__(self) -> None:
        self.require_permission()
        self.take()

    def __exit__(self, *error: object) -> None:
        self.give_back()

    def require_permission(self) -> None:
        """Refuse the thread that is forbidden to take a turn.

        Raises:
            LearnBlockError: it is this one.
        """
        if self.forbidden_to is not None and self.forbidden_to == get_ident():
            raise LearnBlockError("run-variable-uses-robot")

    def take(self, *, wait: bool = True) -> bool:
        """Take the turn; return whether it was free, if `wait` is false."""
        in_main = get_ident() == self._main
        if in_main:
            self._main_inside = True
        taken = self._lock.acquire(blocking=wait)
        if in_main and not taken:
            self._leave()
        return taken

    def give_back(self) -> None:
        """End the turn, and raise the postponed exception."""
        self._lock.release()
        if get_ident() == self._main:
            self._leave()

    def postpone(self, error: BaseException) -> bool:
        """Postpone `error` to the end of the turn; return False if it can be raised at once.

        The code that describes a variable belongs to the program, so a signal may interrupt it.
        """
        if not self._main_inside or self.forbidden_to == get_ident():
            return False
        self._postponed = error
        return True

    def _leave(self) -> None:
        self._main_inside = False
        postponed, self._postponed = self._postponed, None
        if postponed:
            raise postponed
