"""Pages receive only what a drawing has gained."""

import pytest

from learnblock.server.runs.telemetry import Drawn
from learnblock.simulator import PenStroke

RED = (200, 0, 0)


@pytest.fixture
def drawn():
    return Drawn()


def stroke(*points):
    return PenStroke("robot", RED, 6.0, list(points))


def parts(message):
    return [(part.stroke, part.points) for part in message.parts]


def test_the_first_message_has_the_whole_drawing(drawn):
    news = drawn.news([stroke((0, 0), (3, 0)), stroke((9, 9))])
    assert news.fresh
    assert parts(news) == [(0, ((0, 0), (3, 0))), (1, ((9, 9),))]
    assert (news.parts[0].color, news.parts[0].width) == (RED, 6.0)


def test_an_empty_floor_is_reported_once(drawn):
    news = drawn.news([])
    assert news.fresh
    assert news.parts == ()
    assert drawn.news([]) is None


def test_later_messages_have_only_the_new_points(drawn):
    first = stroke((0, 0))
    drawn.news([first])
    first.points.append((3, 0))
    news = drawn.news([first, stroke((9, 9))])
    assert not news.fresh
    assert parts(news) == [(0, ((3, 0),)), (1, ((9, 9),))]
    assert drawn.news([first]) is not None


def test_nothing_is_sent_while_nothing_is_drawn(drawn):
    strokes = [stroke((0, 0))]
    drawn.news(strokes)
    assert drawn.news(strokes) is None


def test_an_erased_drawing_is_sent_anew(drawn):
    kept, erased = stroke((0, 0)), stroke((5, 5))
    drawn.news([erased, kept])
    news = drawn.news([kept])
    assert news.fresh
    assert parts(news) == [(0, ((0, 0),))]


def test_a_page_that_joins_receives_everything(drawn):
    strokes = [stroke((0, 0), (3, 0))]
    drawn.news(strokes)
    drawn.forget()
    assert drawn.news(strokes).fresh
