"""Prints are sent in portions, and too many of them are shortened."""

from learnblock.server.messages import Printed, PrintedByRobots, PrintedPart
from learnblock.server.runs.console import MOST_AT_ONCE, MOST_KEPT, Console, message_of


def text(parts):
    return "".join(part.text for part in parts)


def test_output_is_returned_together_and_once():
    console = Console()
    console.printed("one\n")
    console.printed("two\n")
    assert (console.take(), console.take()) == ([PrintedPart("", "one\ntwo\n", 8)], [])


def test_the_end_of_too_much_output_is_shown():
    console = Console()
    console.printed("a" * MOST_AT_ONCE + "the end")
    shown = text(console.take())
    assert shown.startswith("[7 characters left out]\n")
    assert shown.endswith("the end")


def test_a_page_that_opens_later_sees_the_end_of_the_output():
    console = Console()
    for number in range(MOST_KEPT // 1000 + 5):
        console.printed(f"{number}" * 1000)
        console.take()
    assert len(text(console.kept)) == MOST_KEPT
    console.clear()
    assert not console.kept


def test_the_output_of_several_robots_keeps_its_order():
    console = Console()
    for robot, line in (("one", "a\n"), ("two", "b\n"), ("two", "c\n"), ("one", "d\n")):
        console.printed(line, robot)
    parts = [PrintedPart("one", "a\n", 2), PrintedPart("two", "b\nc\n", 4)]
    assert console.take() == [*parts, PrintedPart("one", "d\n", 4)]


def test_of_too_much_output_of_several_robots_the_end_is_shown():
    console = Console()
    console.printed("early", "one")
    console.printed("b" * (MOST_AT_ONCE - 2), "two")
    console.printed("c", "one")
    first, second, third = console.take()
    assert (first.robot, first.text) == ("one", "[4 characters left out]\ny")
    assert (second.robot, second.until) == ("two", MOST_AT_ONCE - 1)
    assert third == PrintedPart("one", "c", 8)


def test_only_robots_that_share_a_program_are_named():
    assert message_of([]) is None
    assert message_of([PrintedPart("", "hi\n", 3)]) == Printed("hi\n", 3)
    part = PrintedPart("one", "hi\n", 3)
    assert message_of([part]) == PrintedByRobots((part,))
