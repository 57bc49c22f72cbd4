"""What counts in a game."""

import pytest

from learnblock.scores import ANYTHING, MOST_WAITING, TIME_UP, GameResult, Scores, Tally


def scores(lives=None, players=("ada",)):
    game = Scores(lives)
    for player in players:
        game.join(player)
    return game


def kinds(game):
    return [event.kind for event in game.take_events()]


def test_points_are_added_up_for_each_player():
    game = scores(players=("ada", "ben"))
    game.change("ada", "change-score", 2, 1.0)
    game.change("ada", "change-score", -0.5, 2.0)
    game.change("ben", "set-score", 7, 3.0)

    assert [game.standing(name, 3.0).score for name in ("ada", "ben")] == [1.5, 7]
    assert [event.score for event in game.take_events()] == [2, 1.5, 7]


def test_ten_tenths_are_a_whole_number():
    game = scores()
    for _ in range(10):
        game.change("ada", "change-score", 0.1, 0.0)

    assert repr(game.standing("ada", 0.0).score) == "1"


@pytest.mark.parametrize("amount", [1e300, -1e300])
def test_a_score_has_limits(amount):
    game = scores()
    game.change("ada", "change-score", amount, 0.0)

    assert abs(game.standing("ada", 0.0).score) == 1_000_000_000


def test_a_game_without_lives_begins_with_three_when_one_is_lost():
    game = scores()
    assert game.standing("ada", 0.0) == Tally(0, None, None)
    game.change("ada", "change-lives", -1, 1.0)

    assert game.standing("ada", 1.0).lives == 2
    assert game.of("ada").lost_lives == 1


def test_setting_lives_loses_none():
    game = scores(lives=5)
    game.change("ada", "set-lives", 2, 1.0)

    assert game.standing("ada", 1.0).lives == 2
    assert game.of("ada").lost_lives == 0


def test_a_game_is_over_when_no_player_has_lives_left():
    game = scores(lives=1, players=("ada", "ben"))
    game.change("ada", "change-lives", -1, 1.0)
    assert game.result is None
    assert not game.plays("ada")
    game.change("ben", "change-lives", -3, 2.0)

    assert game.result == GameResult.of(2.0, "lives", won=False, player="ben")
    assert game.standing("ben", 2.0).lives == 0


def test_the_first_end_counts_and_nothing_changes_after_it():
    game = scores()
    game.change("ada", "win", 0, 1.0)
    game.change("ada", "lose", 0, 2.0)
    game.change("ada", "change-score", 1, 2.0)

    assert game.result == GameResult.of(1.0, "program", won=True, player="ada")
    assert kinds(game) == ["won"]


def test_a_countdown_ends_once():
    game = scores()
    game.change("ada", "countdown", 2, 1.0)
    left = [game.standing("ada", time).time_left for time in (1.0, 2.5, 3.0, 9.0)]

    assert left == [2, 0.5, 0, 0]
    assert [game.look(time) for time in (2.99, 3.0, 3.01)] == [False, True, False]
    assert game.collect("ada") == [TIME_UP]
    assert kinds(game) == ["countdown", "time-up"]


def test_a_new_countdown_replaces_the_one_before():
    game = scores()
    game.change("ada", "countdown", 2, 0.0)
    game.change("ada", "countdown", 5, 1.0)

    assert not game.look(3.0)
    assert game.look(6.0)


def test_a_collected_thing_is_news_by_its_kind_and_as_anything():
    game = scores()
    game.keep("ada", "star")
    game.keep("ada", "bug")

    assert game.collect("ada") == ["star", ANYTHING, "bug", ANYTHING]
    assert game.collect("ada") == []
    assert game.of("ada").collected == {"star": 1, "bug": 1, ANYTHING: 2}


def test_news_that_nobody_takes_do_not_grow_without_limit():
    game = scores()
    for _ in range(MOST_WAITING):
        game.keep("ada", "star")

    assert len(game.collect("ada")) == MOST_WAITING
