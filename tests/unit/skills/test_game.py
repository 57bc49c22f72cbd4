"""The skills of games, on a robot without a world."""

import pytest

from learnblock.client import Witness
from learnblock.client.game import Game, OwnPlay
from learnblock.errors import DeviceValueError
from learnblock.scores import Tally


class Things(OwnPlay):
    """A game whose news a test gives."""

    def __init__(self, robot, news):
        super().__init__(robot.clock.time)
        self._things = news

    def collect(self):
        yield from super().collect()
        while self._things:
            yield self._things.pop(0)


def test_a_score_is_changed_set_and_shown(robot):
    robot.change_score()
    robot.change_score(2.5)
    assert robot.get_score() == 3.5
    robot.set_score(7)
    robot.show_score()

    assert robot.get_score() == 7
    assert robot.commands == [("Screen.show_text", "7")]


def test_lives_begin_with_three(robot):
    assert robot.get_lives() == 3
    robot.change_lives()
    assert robot.get_lives() == 2
    robot.set_lives(9)
    assert robot.get_lives() == 9


def test_what_is_no_number_is_refused(robot):
    with pytest.raises(DeviceValueError):
        robot.change_score("many")


def test_a_countdown_ends_once(robot):
    assert robot.get_time_left() == 0
    robot.start_countdown(2)
    assert 1.9 < robot.get_time_left() <= 2
    assert not robot.is_time_up()
    robot.sleep(2)

    assert robot.get_time_left() == 0
    assert robot.is_time_up()
    assert not robot.is_time_up()


def test_each_thing_is_collected_once_and_by_every_event(robot):
    robot.game = Game(Things(robot, ["bug", "star", "star"]))
    heard = []

    @robot.when(lambda: robot.collected("star"))
    def star():
        heard.append("star")

    @robot.when(lambda: robot.collected("star"))
    def star_too():
        heard.append("too")

    @robot.when(lambda: robot.time() > 1)
    def end():
        robot.stop()

    robot.run()
    assert heard == ["star", "too", "star", "too"]


@pytest.mark.parametrize(("skill", "won"), [("win_game", True), ("game_over", False)])
def test_the_end_of_a_game_ends_the_program(robot, skill, won):
    with pytest.raises(SystemExit):
        getattr(robot, skill)()

    assert robot.game.play.result[:3] == (won, "robot", "program")


def test_without_lives_a_game_is_over(robot):
    robot.set_lives(1)
    robot.change_lives(-1)

    assert robot.game.standing == Tally(0, 0, None)
    assert not robot.game.play.result.won


def test_a_robot_without_a_world_reports_its_game_and_shows_how_it_stands(robot):
    kinds = []

    class Listener(Witness):
        def game(self, event):
            kinds.append(event.kind)

    robot.observe(Listener())
    assert robot.game.play.seen is None
    robot.change_score()
    robot.start_countdown(1)
    robot.sleep(1)
    robot.is_time_up()

    assert kinds == ["score", "countdown", "time-up"]
    assert robot.game.play.seen == Tally(1, None, 0)
