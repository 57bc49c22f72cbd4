"""A lesson that a pupil's server refuses is reported to the teacher."""

import msgspec
import pytest

from learnblock.classroom.gift import Gift
from learnblock.i18n import Phrase
from learnblock.server.messages import Failed, GiveLesson, StartLesson

GIVE, START = "GiveLesson", "StartLesson"


def failed(kind):
    return msgspec.json.encode(Failed(Phrase("lesson-unknown"), kind)).decode()


@pytest.fixture
def refusals():
    return []


@pytest.fixture
def gift(refusals):
    gift = Gift(lambda: refusals.append("refused"))
    gift.note(GiveLesson("small", b"x"))
    gift.note(StartLesson("small", "Mine"))
    return gift


def test_a_refused_lesson_and_its_start_are_for_the_teacher(gift, refusals):
    assert gift.takes(failed(GIVE))
    assert gift.takes(failed(START))
    assert refusals == ["refused"]


def test_the_pupil_hears_why_a_lesson_that_has_come_does_not_start(gift, refusals):
    assert not gift.takes(failed(START))
    assert refusals == []


def test_a_lesson_can_be_refused_once(gift, refusals):
    assert gift.takes(failed(GIVE))
    assert not gift.takes(failed(GIVE))
    assert refusals == ["refused"]


@pytest.mark.parametrize("text", [failed("Run"), '{"kind":"Done","request":1}', "", "{"])
def test_all_else_is_for_the_pupil(gift, refusals, text):
    assert not gift.takes(text)
    assert refusals == []


def test_nothing_is_taken_from_a_pupil_who_was_given_no_lesson(refusals):
    gift = Gift(lambda: refusals.append("refused"))
    gift.note(StartLesson("1-03-square", "Square"))
    assert not gift.takes(failed(GIVE))
    assert not gift.takes(failed(START))
    assert refusals == []
