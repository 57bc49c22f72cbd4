"""The pieces of puzzles, and the orders that solve them."""

import pytest

import small_lesson
from learnblock.errors import LessonError
from learnblock.lessons.puzzles import judge, pieces, right_orders
from learnblock.lessons.reading import read_files, shipped
from lesson_tries import read_once

LOOP = """main:
    repeat 2:
        function.turn(90)
    end
    function.stop_bot()
end
"""
FUNCTION = """def go():
    repeat 2:
        function.turn(90)
    end
end

main:
    go()
end
"""
SWAPPED = """main:
    function.sleep(1)
    function.expressJoy()
    function.stop_bot()
end
"""
PUZZLES = [
    (name, number)
    for name in shipped()
    for number, step in enumerate(read_once(name).lesson.step, 1)
    if step.puzzle
]


def lesson(also):
    """The small lesson, with another right order of its puzzle."""
    text = f"[step.puzzle]\nalso = ['''\n{also}''']"
    files = {
        **small_lesson.FILES,
        "lesson.toml": small_lesson.LESSON.replace("[step.puzzle]", text),
    }
    return read_files("small", {path: content.encode() for path, content in files.items()})


def test_an_end_is_a_piece_only_where_something_follows_it():
    assert pieces(LOOP) == ("repeat 2:", "function.turn(90)", "end", "function.stop_bot()")
    assert "end" not in pieces(FUNCTION)


def test_the_frame_of_main_is_no_piece_unless_there_is_more():
    assert "main:" not in pieces(LOOP)
    assert pieces(FUNCTION)[3:] == ("main:", "go()")


def test_every_right_order_solves_a_puzzle():
    opened = lesson(SWAPPED)
    orders = right_orders(opened, opened.step(3).puzzle)
    assert [judge(order, orders).right for order in orders] == [True, True]
    assert orders[1][0] == "function.sleep(1)"


@pytest.mark.parametrize(
    ("given", "good"), [("ab", 2), ("ba", 2), ("bca", 2), ("cab", 0), ("", 0), ("abx", 2)]
)
def test_the_good_pieces_are_those_of_the_order_that_begins_most_alike(given, good):
    judged = judge(list(given), [tuple("abc"), tuple("bac")])
    assert (judged.right, judged.good) == (False, good if given != "bca" else 1)


def test_ends_that_are_not_needed_are_right_too():
    assert judge(
        ["repeat 2:", "function.turn(90)", "end"], [("repeat 2:", "function.turn(90)")]
    ).right


@pytest.mark.parametrize(
    ("also", "words"),
    [
        (SWAPPED.replace("sleep(1)", "sleep(2)"), "has other pieces than 'puzzle.bt'"),
        ("main:\n    repeat\nend\n", "is not a program in Block-Text"),
    ],
)
def test_another_order_needs_the_same_pieces(also, words):
    with pytest.raises(LessonError, match=words) as refused:
        lesson(also)
    assert refused.value.diagnostics[0].line > 0


@pytest.mark.parametrize(("name", "number"), PUZZLES)
def test_pupils_of_the_first_levels_get_no_bare_end(name, number):
    opened = read_once(name)
    for order in right_orders(opened, opened.step(number).puzzle):
        assert opened.lesson.level > 2 or "end" not in order
