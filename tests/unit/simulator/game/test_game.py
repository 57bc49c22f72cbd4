"""Games in a world: what robots collect, enter, pass, touch and press."""

from collections.abc import Callable
from pathlib import Path

import pytest

from learnblock.errors import WorldError
from learnblock.scores import GameEvent, GameResult
from learnblock.simulator import World, load_robot, load_world

STAR = '[[collectable]]\nkind = "star"\nx = 300\ny = 0\n'


class Match:
    """A robot that drives east in a world with a game."""

    def __init__(self, folder: Path, text: str, *, seed: int = 0, robots: int = 1) -> None:
        file = folder / "world.toml"
        file.write_text(text)
        self.world = World(load_world(file), seed)
        self.robots = [
            self.world.add_robot(load_robot("ebo"), f"r{number}", (0.0, -400.0 * number, 0.0))
            for number in range(robots)
        ]
        for robot in self.robots:
            self.world.game.join(robot.name, 0.0)
        self.robots[0].drive(200, 0)
        self.events: list[GameEvent] = []

    def run(self, seconds: float, until: Callable[[], bool] = bool) -> "Match":
        for _ in range(round(seconds * 100)):
            if until() or self.world.game.is_over:
                break
            self.world.step()
            self.events += self.world.game.take_events()
        return self

    def happened(self, kind: str) -> list[GameEvent]:
        return [event for event in self.events if event.kind == kind]

    def score(self, robot: int = 0) -> float:
        return self.world.game.scores.standing(f"r{robot}", self.world.time).score

    def lives(self, robot: int = 0) -> int | None:
        return self.world.game.scores.standing(f"r{robot}", self.world.time).lives


Play = Callable[..., Match]


@pytest.fixture
def play(tmp_path: Path) -> Play:
    def played(text: str, seconds: float = 5, **options: int) -> Match:
        return Match(tmp_path, text, **options).run(seconds)

    return played


def test_a_robot_collects_a_thing_once_when_it_touches_it(play: Play) -> None:
    match = play(STAR + "score = 5")

    assert match.score() == 5
    (event,) = match.happened("collected")
    assert (event.player, event.thing, event.score, event.lives) == ("r0", "star 1", 5, None)
    # EBO's radius is 75 mm, the star's 40.
    assert event.time == pytest.approx((300 - 75 - 40) / 200, abs=0.4)


def test_a_collected_thing_is_there_again_later(play: Play) -> None:
    match = play(STAR + "returns_after = 0.2\nradius = 300")

    assert len(match.happened("collected")) > 5


def test_a_robot_without_a_program_collects_nothing(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text(STAR)
    world = World(load_world(tmp_path / "w.toml"))
    world.add_robot(load_robot("ebo")).drive(200, 0)
    for _ in range(300):
        world.step()

    assert world.game.take_events() == []
    assert [thing.is_there for thing in world.game.lying] == [True]


def test_two_lives_are_not_lost_within_two_seconds(play: Play) -> None:
    bug = '[[collectable]]\nkind = "bug"\nlives = -1\nradius = 20\ny = 0\nx = '
    match = play("[game]\nlives = 3\n" + "\n".join(bug + str(x) for x in (200, 300, 800)), 5)

    assert [event.lives for event in match.happened("collected")] == [2, None, 1]


def test_a_game_is_over_without_lives(play: Play) -> None:
    match = play('[game]\nlives = 1\n[[collectable]]\nkind = "bug"\nlives = -1\nx = 300\ny = 0\n')

    assert match.world.game.scores.result == GameResult.of(
        match.world.time, "lives", won=False, player="r0", thing="bug 1"
    )
    assert [event.kind for event in match.events] == ["collected", "lost"]


def test_a_zone_counts_each_time_that_a_robot_enters_it(play: Play) -> None:
    zone = "[[zone]]\nx = 300\ny = 0\nradius = 100\nscore = 2\n"
    match = play(zone, 3)
    match.robots[0].drive(-200, 0)
    match.run(3)

    assert [event.score for event in match.happened("entered")] == [2, 4]


def test_a_zone_may_count_when_a_robot_or_an_object_leaves_it(play: Play) -> None:
    match = play(
        '[[cylinder]]\nname = "barrel"\nx = 200\ny = 0\nradius = 30\nmass = 0.05\n'
        '[[zone]]\nx = 0\ny = 0\nradius = 400\nobject = "barrel"\nwhen = "left"\nscore = 3\n'
        '[[zone]]\nx = 0\ny = 0\nradius = 400\nwhen = "left"\nlives = -1\nname = "ring"\n'
        "[game]\nlives = 2\n",
        4,
    )

    left = [(event.thing, event.score, event.lives) for event in match.happened("left")]
    assert left == [("zone", 3, None), ("ring", None, 1)]
    assert not match.happened("entered")


def test_a_zone_may_count_only_once_and_for_one_robot_only(play: Play) -> None:
    zone = "[[zone]]\nx = 300\ny = 0\nradius = 100\nscore = 2\nagain = false\n"
    match = play(zone + '[[zone]]\nrobot = "r1"\nx = 300\ny = 0\nscore = 9\n', 3)
    match.robots[0].drive(-200, 0)
    match.run(3)

    assert match.score() == 2


@pytest.mark.parametrize(("ends", "won"), [("win", True), ("lose", False)])
def test_a_zone_ends_the_game(play: Play, ends: str, won: bool) -> None:
    match = play(f'[[zone]]\nx = 300\ny = 0\nradius = 100\nends = "{ends}"\nname = "home"')

    assert match.world.game.scores.result is not None
    assert match.world.game.scores.result[:4] == (won, "r0", "zone", "home")


def test_an_object_in_a_zone_scores_for_the_nearest_robot_and_goes_back(play: Play) -> None:
    match = play(
        '[[cylinder]]\nname = "ball"\nx = 200\ny = 0\nradius = 30\nmass = 0.05\n'
        '[[zone]]\nobject = "ball"\nx = 500\ny = 0\nradius = 60\nscore = 1\nreturns = true\n',
        3,
        robots=2,
    )

    assert (match.score(0), match.score(1)) == (1, 0)
    assert match.world.physics.pushed[0].pose.x < 260


def test_gates_count_in_their_order_and_in_their_direction(play: Play) -> None:
    gates = "".join(
        f'[[gate]]\nname = "{name}"\nx = {x}\ny = 0\nheading = {heading}\nscore = 1\n'
        for name, x, heading in (("a", 200, 0), ("b", 100, 180), ("c", 300, 0))
    )
    match = play(gates + "[[goal.gates]]\n", 2)
    match.robots[0].drive(-200, 0)
    match.run(2)
    match.robots[0].drive(200, 0)
    match.run(3)

    assert [event.thing for event in match.happened("passed")] == ["a", "b", "c"]
    assert match.world.goals[0].reached_at is not None


def test_a_gate_beside_the_way_is_not_passed(play: Play) -> None:
    assert play("[[gate]]\nx = 200\ny = 200\nwidth = 300\nscore = 1\n").score() == 0


def test_a_moving_solid_takes_a_life_and_pushes_the_robot(play: Play) -> None:
    match = play(
        "[game]\nlives = 3\n[[mover]]\nx = 600\ny = 0\npath = [[-600, 0]]\nspeed = 300\n"
        "lives = -1\n",
        2.5,
    )

    assert [event.lives for event in match.happened("touched")] == [2]
    assert match.robots[0].pose[0] < 150


def test_a_door_is_a_wall_until_its_switch_is_pressed(play: Play) -> None:
    door = "[[door]]\nx = 400\ny = 0\nheading = 90\nlength = 600\n"
    switch = "[[switch]]\nx = 200\ny = 0\nradius = 50\n"
    closed, opened = play(door, 5), play(door + switch, 5)

    assert closed.robots[0].pose[0] < 330
    assert opened.robots[0].pose[0] > 600
    assert [event.kind for event in opened.events] == ["pressed", "opened"]


def test_a_door_closes_again_but_not_on_a_robot(play: Play) -> None:
    door = "[[door]]\nx = 400\ny = 0\nheading = 90\nlength = 600\n"
    switch = "[[switch]]\nx = 300\ny = 0\nradius = 50\nseconds = 0.1\n"
    match = play(door + switch, 6)
    closed_at = match.happened("closed")[0].time

    assert closed_at > (400 + 75 + 10) / 200
    assert not match.world.game.doors[0].is_open


def test_distance_sensors_and_cameras_notice_solid_things_only(play: Play) -> None:
    match = play(STAR + "[[mover]]\nx = 800\ny = 0\nradius = 200\n[[door]]\nx = 0\ny = 700\n", 0.1)
    names = {surface.name for surface in match.world.surfaces()}

    assert 500 < min(match.robots[0].distances()["front"]) < 640
    assert {"mover", "door"} < names
    assert "star 1" not in names


@pytest.mark.parametrize(("means", "won"), [("lose", False), ("win", True), ("program", None)])
def test_the_end_of_the_countdown_means_what_the_world_says(
    play: Play, means: str, won: bool | None
) -> None:
    match = play(f'[game]\ncountdown = 1\ntime_up = "{means}"', 3)
    result = match.world.game.scores.result

    assert (None if result is None else result.won) is won
    assert match.happened("time-up")[0].time == 1


def test_a_game_is_won_with_the_last_goal_and_lost_with_a_missed_one(play: Play) -> None:
    game = "[game]\n[[goal.score]]\npoints = 1\n"
    won = play(game + STAR + "score = 1").world.game.scores.result
    lost = play(game + "time_limit = 1\n").world.game.scores.result

    assert won is not None
    assert won[:3] == (True, "r0", "goals")
    assert lost is not None
    assert lost[:4] == (False, "", "goal-failed", "score")


def test_a_world_without_rules_ends_with_no_goal(play: Play) -> None:
    match = play("[[goal.reach]]\nx = 0\ny = 0\n", 1)

    assert match.world.goals[0].reached_at is not None
    assert not match.world.game.is_over


def test_a_goal_to_lose_nothing_fails_with_the_first_lost_life(play: Play) -> None:
    bug = '[[collectable]]\nkind = "bug"\nlives = -1\nx = 300\ny = 0\n'
    match = play(STAR + bug + '[[goal.collect]]\nkind = "star"\ncount = 2\nlose_nothing = true\n')

    assert match.world.goals[0].failed_at is not None


def test_robots_share_a_goal_together(play: Play) -> None:
    star = '[[collectable]]\nkind = "star"\nscore = 1\nx = 300\ny = '
    goal = "[[goal.score]]\npoints = 2\ntogether = true\n"
    match = play(goal + f"{star}0\n{star}-400\n", 2, robots=2)
    assert match.world.goals[0].progress == 0.5
    match.robots[1].drive(200, 0)

    assert match.run(2).world.goals[0].reached_at is not None


MANY = "[floor]\nsize = [4000, 4000]\n" + "".join(
    f'[[collectable]]\nkind = "ghost"\nx = {x}\ny = {y}\nwander = 200\nreturns_after = 1\n'
    for x in range(-1200, 1201, 600)
    for y in range(-900, 901, 600)
)


def test_a_seed_decides_about_random_ways_and_a_copy_goes_on_alike(play: Play) -> None:
    first, again, other = (play(MANY, 3, seed=seed) for seed in (1, 1, 2))
    copied = first.world.copy()
    for _ in range(100):
        first.world.step()
        copied.step()

    assert again.world.game.state != other.world.game.state
    assert copied.game.state == first.world.game.state
    assert play(MANY, 3, seed=1).world.game.state == again.world.game.state


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("[[switch]]\nx = 0\ny = 0\ndoor = 'gate'\n[[door]]\nx = 0\ny = 0", "no door 'gate'"),
        ("[[zone]]\nx = 0\ny = 0\nobject = 'ball'", "no object with a mass 'ball'"),
        ("[[collectable]]\nkind = 'star'\nx = 5000\ny = 0", "outside the floor"),
        ("[[goal.gates]]", r"no \[\[gate\]\]"),
        (STAR + "[[goal.collect]]\nkind = 'coin'", "no such"),
        (STAR + "path = [[0, 0]]\nwander = 10", "'path' or it wanders"),
        ("[game]\nlives = 0", "lives"),
    ],
)
def test_a_mistake_in_a_file_is_reported(tmp_path: Path, text: str, problem: str) -> None:
    (tmp_path / "w.toml").write_text(text)

    with pytest.raises(WorldError, match=problem):
        load_world(tmp_path / "w.toml")
