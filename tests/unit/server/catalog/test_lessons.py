"""The lessons that the page offers."""

from learnblock.lessons import reading
from learnblock.server.catalog import lesson_choices


def test_a_lesson_of_ours_that_cannot_be_read_is_reported_and_the_others_are_offered(monkeypatch):
    ours = reading.shipped()
    monkeypatch.setattr(reading, "shipped", lambda: ("0-00-damaged", *ours))
    choices, (problem,) = lesson_choices()
    assert {choice.name for choice in choices if not choice.own} == {*ours}
    assert (problem.code, problem.values["name"]) == ("server-lesson-file", "0-00-damaged")
