"""Why a statement was not reached."""

import pytest

from asked import answered, run_of, told
from places import ROOT

SQUARE = ROOT / "lessons/1-03-square/teacher/solutions/step-2.bt"
REPEATED = (
    "repeat 2:\n    function.move_straight(80)\n    function.sleep(2)\nend\n"
    "function.stop_bot()\nfunction.sleep(10)\n"
)


def test_a_loop_does_not_come_after_itself(tmp_path):
    history = run_of(tmp_path, SQUARE.read_text("utf-8"))
    given = answered(history, "why did the robot not drive straight ahead at 8")
    every = (*given.sentences, *given.more)
    assert all(str(one.line) != one.phrase.values.get("inner") for one in every)


def test_a_loop_that_is_over_is_said_to_be_and_had_something_to_go_through(tmp_path):
    given = answered(run_of(tmp_path, REPEATED), "why not drive straight at 6")
    assert told(given) == [
        ("why-it-did", 2),
        ("why-overridden-later", 5),
        ("why-turns-over", 1),
        ("why-busy", 6),
    ]
    assert given.words("en")[2] == ("The loop in line 1, repeat 2, was over at 4 s, after 2 turns.")
    assert given.words("es")[2] == (
        "El bucle de la línea 1, repeat 2, acabó en el segundo 4, después de 2 vueltas."
    )


@pytest.mark.parametrize(
    ("lists", "answer"),
    [
        ("[[], []]", [("why-nothing-to-repeat", 3), ("why-set", 2)]),
        ("[[1], []]", [("why-nothing-to-repeat", 3), ("why-set", 2)]),
    ],
)
def test_a_loop_with_nothing_to_go_through_is_named(lists, answer, tmp_path):
    program = (
        f"for way in {lists}:\n    steps = way\n    for step in steps:\n"
        "        function.move_straight(50)\n        function.sleep(1)\n    end\n"
        "    function.stop_bot()\n    function.sleep(3)\nend\n"
    )
    given = answered(run_of(tmp_path, program), "why not drive straight at 5.9")
    assert [one for one in told(given) if one in answer] == answer


def test_the_turn_that_a_loop_is_busy_with_is_told(tmp_path):
    program = "repeat 2:\n    function.expressJoy()\n    function.sleep(9)\nend\n"
    given = answered(run_of(tmp_path, program), "not look happy at 8")
    assert told(given)[-1] == ("why-busy", 3)
    assert "why-turns-over" not in [code for code, _ in told(given)]
