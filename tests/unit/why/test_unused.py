"""What a program works out and does not use."""

import pytest

from asked import answered, run_of

COUNTS = """\
speed = 60
laps = 0
repeat 2:
    function.move_straight(speed)
    function.sleep(1)
    laps += 1
end
function.stop_bot()
"""


def never_read(given):
    sentences = (*given.sentences, *given.more)
    return [one.line for one in sentences if one.phrase.code == "why-never-read"]


@pytest.mark.parametrize(
    "question", ["at 1", "why did it drive straight", "why is speed 60", "why is laps 2"]
)
def test_a_counter_to_look_at_is_no_mistake(question, tmp_path):
    assert never_read(answered(run_of(tmp_path, COUNTS), question)) == []


@pytest.mark.parametrize(
    ("lines", "blamed"),
    [
        ("speed = 0\nsped = 60\n", [2]),
        ("speed = 0\nSpeed = 60\n", [2]),
        ("speed = 0\nfaster = speed + 60\n", [2]),
        ("speed = 0\nlength = 60\n", []),
        ("speed = 0\nspeeds = 0\nspeeds += 1\n", []),
    ],
)
def test_a_variable_that_no_line_reads_may_have_been_meant_for_another(lines, blamed, tmp_path):
    program = f"{lines}function.move_straight(speed)\nfunction.sleep(2)\n"
    assert never_read(answered(run_of(tmp_path, program), "why is speed 0")) == blamed


def test_a_flag_may_have_been_meant_for_another_flag(tmp_path):
    program = "done = False\nready = True\nif done:\n    print(1)\nend\nfunction.sleep(1)\n"
    assert never_read(answered(run_of(tmp_path, program), "not line 4")) == [2]


def test_the_robot_is_no_variable_that_a_line_has_to_read(tmp_path):
    program = 'score = 5\ntext = "score: " + score\nfunction.sleep(1)\n'
    assert 0 not in never_read(answered(run_of(tmp_path, program), "why did it crash"))
