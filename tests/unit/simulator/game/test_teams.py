"""Teams of a world, and goals that win its game."""

from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.errors import WorldError
from learnblock.monitor.games import game_now
from learnblock.scores import GameEvent, GameResult
from learnblock.simulator import World, load_robot, load_world, read_world, write_world
from learnblock.storage.toml_values import loads
from places import ROOT

STARTS = "".join(
    f'[[start]]\nname = "{name}"\nx = {x}\ny = {y}\n'
    for name, x, y in (("a", -500, 0), ("b", 300, 0), ("c", -500, 600))
)
TEAMS = (
    '[[team]]\nname = "Red"\ncolour = "red"\nrobots = ["a", "c"]\n'
    '[[team]]\nname = "Blue"\ncolour = [0, 0, 255]\nrobots = ["b"]\n'
)
BALL = '[[cylinder]]\nname = "ball"\nx = -300\ny = 0\nradius = 40\nmass = 0.03\n'


class Match:
    """Robots that start in a world in order; only the first one drives, east."""

    def __init__(self, folder: Path, text: str, *, robots: int = 2) -> None:
        file = folder / "world.toml"
        file.write_text(STARTS + text)
        self.world = World(load_world(file))
        for number in range(robots):
            name = f"r{number}"
            self.world.add_robot(load_robot("ebo"), name)
            self.world.game.join(name, 0.0)
        self.world.robots["r0"].drive(200, 0)
        self.events: list[GameEvent] = []

    def run(self, seconds: float = 5) -> "Match":
        for _ in range(round(seconds * 100)):
            if self.result:
                break
            self.world.step()
            self.events += self.world.game.take_events()
        return self

    @property
    def result(self) -> GameResult | None:
        return self.world.game.scores.result

    def reached(self) -> list[str]:
        return [goal.name for goal in self.world.goals if goal.reached_at is not None]


def goal(keys: str, kind: str = "reach") -> str:
    place = "x = 300\ny = 0\n" if kind == "reach" else ""
    return f"[[goal.{kind}]]\n{place}{keys}\n"


def test_a_goal_that_wins_ends_the_game_of_a_world_without_rules(tmp_path: Path) -> None:
    other = goal('name = "other"\nwins = true\nrobot = "r1"').replace("x = 300", "x = -900")
    match = Match(tmp_path, other + goal('name = "home"\nwins = true\nrobot = "r0"')).run()

    assert match.result == GameResult.of(
        match.world.time, "winning-goal", won=True, player="r0", thing="home"
    )
    assert [state.is_open for state in match.world.goals] == [True, False]


def test_the_line_of_the_trace_is_for_all_players_and_names_the_winner(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('name = "home"\nwins = true\nteam = "Red"')).run()
    (event,) = [event for event in match.events if event.kind == "won"]

    assert (event.player, event.thing) == ("", "home")
    assert (event.winner, event.team) == ("r0", "Red")


def test_the_robot_of_another_team_does_not_reach_a_goal(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('wins = true\nteam = "Red"')).run(0.5)

    # The second robot, of Blue, is in it from the start.
    assert match.reached() == []
    assert match.run().result is not None


def test_a_ball_in_the_goal_counts_for_its_team_whoever_has_pushed_it(tmp_path: Path) -> None:
    into = goal('object = "ball"\nwins = true\nteam = "Blue"').replace("x = 300", "x = 0")
    match = Match(tmp_path, TEAMS + BALL + into).run()

    assert match.result is not None
    assert (match.result.team, match.result.player) == ("Blue", "r1")


def test_a_team_wins_with_a_goal_for_everybody(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('wins = true\nrobot = "r0"')).run()

    assert match.result is not None
    assert match.result.team == "Red"


def test_together_means_all_robots_of_the_team(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('together = true\nteam = "Red"'), robots=3).run(5)
    assert match.world.goals[0].progress == 0.5
    match.world.robots["r2"].place(300, 200, 0)

    assert match.run(0.1).reached() == []
    match.world.robots["r2"].place(300, 140, 0)
    match.world.robots["r0"].place(300, -130, 0)
    match.world.robots["r0"].drive(0, 0)
    assert match.run(0.1).reached() == ["reach"]


@pytest.mark.parametrize(
    ("inside", "reached"),
    [((0,), True), ((0, 2), True), ((0, 1), False), ((1,), False), ((0, 1, 2), False)],
)
def test_alone_means_the_robots_of_the_team(
    tmp_path: Path, inside: Sequence[int], reached: bool
) -> None:
    match = Match(tmp_path, TEAMS + goal('alone = true\nradius = 250\nteam = "Red"'), robots=3)
    match.world.robots["r0"].drive(0, 0)
    for number in range(3):
        x = 300.0 if number in inside else -600.0
        match.world.robots[f"r{number}"].place(x, 170.0 * (number - 1), 0)

    assert bool(match.run(0.2).reached()) == reached


def test_a_shared_score_is_that_of_the_team(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('points = 5\ntogether = true\nteam = "Red"', "score"))
    match.world.game.scores.change("r1", "set-score", 9, 0.0)
    match.world.game.scores.change("r0", "set-score", 4, 0.0)
    assert match.run(0.2).reached() == []
    match.world.game.scores.change("r0", "set-score", 5, 0.0)

    assert match.run(0.2).reached() == ["score"]


def test_the_game_is_over_when_no_goal_can_win_it_any_more(tmp_path: Path) -> None:
    far = goal('wins = true\nteam = "{0}"\nname = "{0}"\ntime_limit = {1}').replace(
        "y = 0", "y = 900"
    )
    match = Match(tmp_path, TEAMS + far.format("Red", 1) + far.format("Blue", 2)).run()

    assert match.result == GameResult.of(2.0, "goal-failed", won=False, thing="Blue")


def test_another_goal_neither_wins_nor_loses_such_a_game(tmp_path: Path) -> None:
    missed = goal('name = "missed"\ntime_limit = 1').replace("y = 0", "y = 900")
    match = Match(tmp_path, "[game]\n" + missed + goal('wins = true\nrobot = "r0"')).run()

    assert match.result is not None
    assert match.result.reason == "winning-goal"


def test_no_goal_is_reached_after_the_game_has_been_won(tmp_path: Path) -> None:
    stand = '[[goal.stop]]\nrobot = "r1"\nx = 300\ny = 0\nradius = 400\nseconds = 60\n'
    match = Match(tmp_path, stand + goal('wins = true\nrobot = "r0"')).run()
    # Its program ends with the game, and it stands there.
    match.world.finish("r1")

    assert match.reached() == ["reach"]


def test_a_robot_more_than_there_are_starts_has_no_team(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS, robots=4)

    assert [*match.world.game.teams.robots.values()] == ["Red", "Blue", "Red", ""]


def test_a_robot_has_the_team_of_the_start_that_it_asks_for(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text(STARTS + TEAMS)
    world = World(load_world(tmp_path / "w.toml"))
    world.add_robot(load_robot("ebo"), "late", "b")

    assert world.game.teams.robots == {"late": "Blue"}


def test_the_page_gets_the_teams_and_the_winner(tmp_path: Path) -> None:
    match = Match(tmp_path, TEAMS + goal('name = "home"\nwins = true\nteam = "Red"'))
    before = game_now(match.world.game, 0.0)
    match.run()
    after = game_now(match.world.game, match.world.time)

    assert before is not None
    assert ([player.team for player in before.players], before.counts) == (["Red", "Blue"], False)
    assert after is not None
    assert (after.won, after.reason, after.winner, after.team) == (True, "home", "r0", "Red")


@pytest.mark.parametrize(
    ("text", "line", "parts"),
    [
        (TEAMS.replace('"c"', '"d"'), 16, ("'d'", "a, b, c")),
        (TEAMS.replace('["b"]', '["c"]'), 20, ("'c'", "'Red'", "'Blue'")),
        (TEAMS.replace('"c"', '"a"'), 16, ("'a' twice", "'Red'")),
        (TEAMS.replace("Blue", "Red"), 18, ("Two teams", "'Red'")),
        (TEAMS + goal('team = "Rot"'), 24, ("'Rot'", "Red, Blue")),
        (TEAMS.replace('["b"]', '"b"'), 20, ("team[2].robots", "a list of 0 to 30 items")),
        (TEAMS.replace('colour = "red"\n', ""), 13, ("colour",)),
        (TEAMS + goal('wins = "yes"'), 24, ("goal.reach[1].wins", "yes")),
        (TEAMS.replace('"Blue"', f'"{"x" * 41}"'), 18, ("team[2].name", "40")),
        (
            "".join(f'[[team]]\nname = "{n}"\ncolour = "red"\nrobots = ["a"]\n' for n in range(11)),
            13,
            ("team", "10"),
        ),
    ],
)
def test_a_mistake_has_its_line_and_its_value(
    tmp_path: Path, text: str, line: int, parts: Sequence[str]
) -> None:
    file = tmp_path / "world.toml"
    file.write_text(STARTS + text)
    with pytest.raises(WorldError) as refused:
        load_world(file)
    (diagnostic,) = refused.value.diagnostics

    assert diagnostic.line == line
    assert all(part in str(refused.value) for part in ("world.toml", *parts))


NAMES = st.text(
    st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"]), min_size=1, max_size=9
)


@st.composite
def team_worlds(draw: st.DrawFn) -> dict[str, object]:
    """The values of a world with teams, each start in at most one of them."""
    starts = draw(st.lists(NAMES, min_size=2, max_size=6, unique=True))
    names = draw(st.lists(NAMES, min_size=1, max_size=len(starts), unique=True))
    numbers = draw(st.permutations(range(len(starts))))
    teams = [
        {
            "name": name,
            "colour": draw(st.sampled_from(["red", "blue", (1, 2, 3)])),
            "robots": [starts[number] for number in numbers[index :: len(names)]],
        }
        for index, name in enumerate(names)
    ]
    goals = draw(st.lists(st.tuples(NAMES, st.sampled_from([None, *names]), st.booleans())))
    unique = {goal_name: (team, wins) for goal_name, team, wins in goals}
    reach = [
        {"name": goal_name, "x": 0, "y": 0, "wins": wins, **({"team": team} if team else {})}
        for goal_name, (team, wins) in unique.items()
    ]
    places = [{"name": name, "x": 0, "y": 0} for name in starts]
    return {"start": places, "team": teams, "goal": {"reach": reach}}


@settings(max_examples=50)
@given(team_worlds())
def test_a_world_with_teams_is_written_and_read_back_unchanged(values: dict[str, object]) -> None:
    world = read_world(values, ROOT)

    assert read_world(loads(write_world(world, "w")), ROOT) == world
