"""Prints are sent in portions, and too many of them are shortened."""

from learnblock.server.runs.console import MOST_AT_ONCE, MOST_KEPT, Console


def test_output_is_returned_together_and_once():
    console = Console()
    console.printed("one\n")
    console.printed("two\n")
    assert (console.take(), console.take()) == ("one\ntwo\n", "")


def test_the_end_of_too_much_output_is_shown():
    console = Console()
    console.printed("a" * MOST_AT_ONCE + "the end")
    shown = console.take()
    assert shown.startswith("[7 characters left out]\n")
    assert shown.endswith("the end")


def test_a_page_that_opens_later_sees_the_end_of_the_output():
    console = Console()
    for number in range(MOST_KEPT // 1000 + 5):
        console.printed(f"{number}" * 1000)
        console.take()
    assert len(console.kept) == MOST_KEPT
    console.clear()
    assert console.kept == ""
