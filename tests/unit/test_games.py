"""Programs that play a game in a world, from the first star to the end."""

import pytest

from learnblock import language
from learnblock.blocks import builtin
from learnblock.running.replay import replay
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker, ThreadWorker
from runs import TWINS, run_file

WORLD = """
[game]
lives = 2
countdown = 10
time_up = "program"

[[collectable]]
kind = "star"
x = 300
y = 0

[[collectable]]
kind = "ghost"
x = 0
y = 500
wander = 100
speed = 300

[[collectable]]
kind = "bug"
x = 600
y = 0
lives = -1
"""

PROGRAM = """
when star = function.collected("star"):
    function.change_score(2)
    print(function.get_score(), function.get_lives())
end

when bug = function.collected("bug"):
    print(function.get_lives())
end

when up = function.is_time_up():
    if function.get_score() > 1:
        function.win_game()
    else:
        function.game_over()
    end
end

main:
    function.move_straight(100)
end
"""


@pytest.fixture
def play(tmp_path):
    def played(program=PROGRAM, world=WORLD, robot="sim-ebo", **options):
        (tmp_path / "game.toml").write_text(world)
        (tmp_path / "game.bt").write_text(program)
        found = {"world": str(tmp_path / "game.toml"), "seconds": 30, **options}
        return run_file(tmp_path / "game.bt", robot, **found)

    return played


def game_lines(finished):
    return [(line["game"], line.get("thing")) for line in finished.entries("game")]


@pytest.mark.parametrize("robot", TWINS)
def test_a_game_is_played_and_won_on_every_twin(play, robot):
    finished = play(robot=robot)

    assert finished.report.error is None
    assert finished.report.ended == "finished"
    assert finished.report.time == 10
    assert [line["print"] for line in finished.entries("print")] == ["2 2", "1"]
    assert game_lines(finished) == [
        ("countdown", "world"),
        ("collected", "star 1"),
        ("score", None),
        ("collected", "bug 3"),
        ("time-up", None),
        ("won", "program"),
    ]


def test_a_game_has_one_trace_however_it_is_run(play):
    thread, process, inline = (
        play(worker=worker) for worker in (ThreadWorker, ProcessWorker, InlineWorker)
    )

    assert thread.trace == process.trace == inline.trace


@pytest.mark.parametrize("worker", [ThreadWorker, InlineWorker])
def test_a_world_that_ends_its_game_ends_the_program_at_that_moment(play, worker):
    world = WORLD.replace('"program"', '"lose"').replace("countdown = 10", "countdown = 1.5")
    finished = play("main:\n    function.sleep(20)\n    print(1)\nend\n", world, worker=worker)

    assert finished.report.time == 1.5
    assert finished.report.ended == "finished"
    assert finished.entries("print") == []
    assert game_lines(finished)[-1] == ("lost", "time")


def test_a_program_counts_in_a_world_without_a_game(play):
    count = "    function.change_score(1)\n    function.sleep(0.1)\n"
    finished = play(f"main:\n{count * 3}    print(function.get_score())\nend\n", "")

    assert [line["print"] for line in finished.entries("print")] == ["3"]
    assert [line["score"] for line in finished.entries("game")] == [1, 2, 3]


def test_a_world_without_a_game_has_no_line_about_it(play):
    assert play("main:\n    function.sleep(1)\nend\n", "").entries("game") == []


@pytest.mark.parametrize(
    ("condition", "hat"),
    [('collected("bug")', "lb_when_collected"), ("is_time_up()", "lb_when_is_time_up")],
)
def test_an_event_of_a_game_is_a_ready_hat_and_comes_back_from_it(condition, hat):
    text = f"when x = function.{condition}:\n    function.change_score(1)\nend\n"
    program = language.parse(text)
    workspace = language.to_workspace(program, builtin()).workspace

    assert workspace.stacks[0][0].type == hat
    assert language.from_workspace(workspace, builtin()).program == program


LIVES = """
when star = function.collected("star"):
    function.change_lives(-1)
end

main:
    function.set_lives(5)
    function.start_countdown(4)
    function.change_score(0.5)
    function.move_straight(100)
    function.sleep(6)
    function.game_over()
end
"""


def test_a_game_is_replayed_from_its_trace(play, tmp_path):
    goals = "[[goal.score]]\npoints = 0.5\n[[goal.collect]]\nkind = 'bug'\nlose_nothing = true\n"
    finished = play(LIVES, WORLD.replace("[game]", "[game]\ngoals_win = false") + goals)
    states = {goal.name: goal.state for goal in finished.report.goals}
    repeated = replay(finished.trace, str(tmp_path / "game.toml"))

    assert states == {"score": "reached", "collect": "failed"}
    assert repeated.is_true
    assert any("goal" in seen for seen in repeated.repeated)
