"""A server that hangs saves everything and ends."""

from queue import SimpleQueue

import pytest

from learnblock.i18n import Phrase
from learnblock.server import last_resort
from learnblock.server.last_resort import Deadlines, LastResort
from waiting import SECONDS

LATE = Deadlines(ending=0.01)
NEVER = Deadlines(ending=SECONDS)


@pytest.fixture(autouse=True)
def no_alarm(monkeypatch):
    """It would end the tests."""
    monkeypatch.setattr(last_resort, "_end_by_the_system", lambda seconds: None)


class Process:
    """A process that hangs; it notes what happens to it."""

    def __init__(self, deadlines, save=lambda: (), **others):
        self._happened = SimpleQueue()
        self.last_resort = LastResort(
            lambda: (self._happened.put("saved"), save())[1],
            lambda phrase: self._happened.put(phrase.code),
            deadlines,
            end=self._happened.put,
            **others,
        )
        self.last_resort.start()

    def next(self, count):
        return [self._happened.get(timeout=SECONDS) for _ in range(count)]


def test_a_server_that_has_not_ended_in_time_saves_everything_and_ends():
    process = Process(LATE)
    process.last_resort.request()
    assert process.next(3) == ["server-ends-late", "saved", 1]


def test_at_a_second_request_a_server_saves_everything_and_ends_at_once():
    process = Process(NEVER)
    process.last_resort.request()
    process.last_resort.request()
    assert process.next(3) == ["server-ends-at-once", "saved", 1]


def test_a_server_that_hangs_ends_when_another_one_takes_over(monkeypatch):
    monkeypatch.setattr(last_resort, "_LOOK_FOR_OTHERS", 0.01)
    begun = []
    process = Process(LATE, is_asked=lambda: True, begin=lambda: begun.append(True))
    assert process.next(3) == ["server-ends-late", "saved", 1]
    assert begun == [True]


def test_what_could_not_be_saved_is_said():
    process = Process(LATE, lambda: [Phrase("system-disk")])
    process.last_resort.request()
    assert process.next(4)[2:] == ["system-disk", 1]


def test_a_server_that_can_not_save_ends_nevertheless(monkeypatch):
    monkeypatch.setattr("threading.excepthook", lambda failed: None)

    def fail():
        raise MemoryError

    process = Process(LATE, fail)
    process.last_resort.request()
    assert process.next(3)[-1] == 1
