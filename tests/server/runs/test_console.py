"""Prints are handed out in portions, and a flood of them is cut."""

from learnblock.server.runs.console import MOST_AT_ONCE, MOST_KEPT, Console


def test_prints_are_handed_out_together_and_once():
    console = Console()
    console.printed("one\n")
    console.printed("two\n")
    assert (console.take(), console.take()) == ("one\ntwo\n", "")


def test_the_last_of_a_flood_is_shown():
    console = Console()
    console.printed("a" * MOST_AT_ONCE + "the end")
    shown = console.take()
    assert shown.startswith("[7 characters left out]\n")
    assert shown.endswith("the end")


def test_a_page_that_comes_later_sees_the_last_of_all():
    console = Console()
    for number in range(MOST_KEPT // 1000 + 5):
        console.printed(f"{number}" * 1000)
        console.take()
    assert len(console.kept) == MOST_KEPT
    console.clear()
    assert console.kept == ""
