"""Hints are given one level after the other."""

from learnblock.i18n import Phrase
from learnblock.lessons.hints import Hint
from learnblock.server.sessions.hint_series import HintSeries


def hint(*codes):
    return Hint("hint", tuple(map(Phrase, codes)), Phrase("because"))


def test_each_level_is_given_once_and_those_of_a_hint_stay_together():
    series = HintSeries((hint("look", "part"), hint("how")))
    given = []
    while series.has_more:
        series = series.longer()
        given.append([[level.phrase.code for level in shown.levels] for shown in series.shown()])
    assert given == [[["look"]], [["look", "part"]], [["look", "part"], ["how"]]]


def test_without_hints_none_is_left():
    assert not HintSeries().has_more
    assert list(HintSeries().shown()) == []
