"""Two runs of a program are compared by their decisions, not by their noise."""

from click.testing import CliRunner

from learnblock.cli import main
from learnblock.i18n import translate
from learnblock.runtime.log.events import Op
from learnblock.why import comparison
from learnblock.why.comparison import compared, parting
from logged_runs import logged_example, logged_text
from runs import EXAMPLES

WAITING = (
    "main:\n    while not elapsedTime({seconds}):\n        function.sleep(0.1)\n    end\nend\n"
)


def test_the_same_run_twice_has_no_parting():
    runs = [logged_example("avoid.bt", "sim-ebo", seed=3, seconds=10).history for _ in range(2)]
    assert parting(*runs) is None


def test_another_seed_parts_where_a_reading_decides_otherwise():
    one, other = (
        logged_example("avoid.bt", "sim-ebo", world="obstacles", seed=seed, seconds=31).history
        for seed in (1, 2)
    )
    found = parting(one, other)
    texts = [translate(sentence.phrase, "en") for sentence in (found.first, found.second)]
    assert "was true: the front sensor measured 96 mm" in texts[0]
    assert "was not true: the front sensor measured 101 mm" in texts[1]
    assert found.first.line == found.second.line == 5


def test_turns_that_were_only_counted_are_compared_as_well():
    # In the world without noise all turns are alike.
    one, other = (
        logged_example("avoid.bt", "sim-ebo", seed=seed, seconds=3).history for seed in (1, 2)
    )
    assert parting(one, other) is None


def test_a_run_that_goes_on_for_longer_parts_at_the_end(tmp_path):
    one, other = (
        logged_text(tmp_path, WAITING.format(seconds=5), seconds=seconds).history
        for seconds in (2, 3)
    )
    found = parting(one, other)
    assert translate(found.first.phrase, "en") == "This run was over at 2 s."


DRIVING = """\
main:
    function.move_straight({speed})
    function.sleep(1)
    if function.is_front_obstacle({limit}):
        function.turn({angle})
    end
    function.sleep(1)
end
"""


def words(phrases):
    return [translate(phrase, "en") for phrase in phrases]


def edited(folder, before, after, **options):
    """Compare a run with one of the edited program, in the same world."""
    given = {"speed": 60, "limit": 100, "angle": 90}
    one, other = (
        logged_text(folder, DRIVING.format(**{**given, **change}), **options).history
        for change in (before, after)
    )
    return compared(one, other)


def test_an_edited_command_parts_where_the_robot_is_told_something_else(tmp_path):
    found = edited(tmp_path, {"speed": 60}, {"speed": 80})
    assert words(found.causes) == [
        "Line 2 was edited: function.move_straight(60) became function.move_straight(80)."
    ]
    assert found.parting.together == 0
    assert words([found.parting.second.phrase]) == [
        "At 0 s line 2, move_straight(80), told the robot what to do next."
    ]


def test_an_edited_limit_parts_where_it_decides_otherwise(tmp_path):
    found = edited(tmp_path, {"limit": 100}, {"limit": 1999}, world="arena")
    assert found.parting.together == 1
    [line] = words([found.parting.because])
    assert line.startswith(
        "At 1 s line 4, if is_front_obstacle(100), was not true in the first run"
    )
    assert "and true in the second, because the front sensor measured" in line


def test_an_edited_line_that_never_ran_makes_no_difference(tmp_path):
    found = edited(tmp_path, {"angle": 90}, {"angle": 45}, world="empty")
    assert found.parting is None
    assert words(found.causes) == ["Line 5 was edited: function.turn(90) became function.turn(45)."]


def test_added_and_removed_lines_are_named(tmp_path):
    text = DRIVING.format(speed=60, limit=100, angle=90)
    runs = [
        logged_text(tmp_path, one).history
        for one in (text, text.replace("    function.sleep(1)\n    if", "    if"))
    ]
    assert words(compared(*runs).causes) == ["Line 3 was removed: function.sleep(1)."]
    assert words(compared(*reversed(runs)).causes) == ["Line 3 was added: function.sleep(1)."]


def test_many_edits_are_counted(tmp_path):
    runs = [
        logged_text(tmp_path, "main:\n" + f"    x = {value}\n" * 6 + "end\n").history
        for value in (1, 2)
    ]
    assert words(compared(*runs).causes)[-1] == "3 more lines differ."


def test_another_seed_world_robot_and_place_are_causes(tmp_path):
    text = DRIVING.format(speed=60, limit=100, angle=90)
    base = {"world": "empty", "seed": 1, "robot": "sim-ebo"}
    one = logged_text(tmp_path, text, **base).history
    causes = {
        name: words(
            compared(one, logged_text(tmp_path, text, **{**base, name: value}).history).causes
        )
        for name, value in {
            "seed": 2,
            "world": "arena",
            "robot": "sim-cozmo",
            "start": (100.0, 0.0, 90.0),
        }.items()
    }
    assert causes == {
        "seed": [
            "The runs had different seeds, 1 and 2, so the noise of their sensors and wheels "
            "differed."
        ],
        "world": ["The first run was in the world empty, the second in arena."],
        "robot": ["The first run was on sim-ebo, the second on sim-cozmo."],
        "start": ["The robot was put at another place before the run."],
    }


def test_one_sentence_says_what_was_measured_in_both_runs():
    found = compared(
        *(
            logged_example("avoid.bt", "sim-ebo", world="obstacles", seed=seed, seconds=31).history
            for seed in (1, 2)
        )
    )
    assert words([found.parting.because]) == [
        "At 26.93 s line 5, if is_front_obstacle(100), was true in the first run, because the "
        "front sensor measured 96 mm, less than 100 mm, and not true in the second, because the "
        "front sensor measured 101 mm, not less than 100 mm."
    ]


def test_a_loop_that_a_damaged_log_repeats_for_ever_is_followed_for_a_while(monkeypatch, tmp_path):
    monkeypatch.setattr(comparison, "MOST_STEPS", 1000)
    text = "main:\n    forever:\n        if 1 > 2:\n            print(1)\n        end\n"
    text += "        function.sleep(0.1)\n    end\nend\n"
    runs = [logged_text(tmp_path, text, seconds=3).history for _ in range(2)]
    for run in runs:
        number = next(n for n, event in enumerate(run.events) if event[0] == Op.REPEATED)
        run.events[number] = (*run.events[number][:2], 10**12, *run.events[number][3:])
    assert parting(*runs) is None


def test_the_command_tells_both_decisions(tmp_path):
    logs = []
    for seed in ("1", "2"):
        log = tmp_path / f"{seed}.why"
        given = [str(EXAMPLES / "avoid.bt"), "--world", "obstacles", "--seed", seed, "--for", "31"]
        CliRunner().invoke(main, ["run", *given, "--why", str(log)])
        logs.append(str(log))
    output = CliRunner().invoke(main, ["compare", *logs]).output
    assert output.startswith("Both runs made the same decisions until 26.93 s.\n1.why: At 26.93 s")
    assert "2.why: At 26.93 s line 5, if is_front_obstacle(100), was not true" in output
