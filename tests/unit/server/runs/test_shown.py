"""A page receives what it does not show yet, and no more problems than it can list."""

from collections import Counter

from learnblock.blocks import builtin
from learnblock.i18n import Phrase
from learnblock.project.document.document import Document
from learnblock.project.document.shared import SharedProgram
from learnblock.server.runs.shown import MOST_PROBLEMS, ShownProgram

EBO = "learnblock.robots.sim_ebo"


def shown(text):
    document = Document.from_text(text, EBO, builtin())
    return ShownProgram().update(SharedProgram(document)).problems


def test_all_problems_of_an_ordinary_program_are_listed():
    problems = shown("main:\n" + "    x = nothing\n" * MOST_PROBLEMS + "end\n")
    assert Counter(one.view for one in problems) == {
        "blocktext": MOST_PROBLEMS,
        "python": MOST_PROBLEMS,
    }
    assert {one.code for one in problems} == {"unknown-name"}


def test_of_too_many_problems_the_first_are_listed_with_the_number_of_the_others():
    *problems, last = shown("main:\n" + "    x = nothing\n" * (MOST_PROBLEMS + 7) + "end\n")
    assert [one.line for one in problems if one.view == "blocktext"] == list(
        range(2, MOST_PROBLEMS + 2)
    )
    assert last.message == Phrase("server-more-problems", count=7)


def test_warnings_leave_no_error_out():
    loops = "    while True:\n        pass\n    end\n"
    *problems, last = shown(f"main:\n{loops * MOST_PROBLEMS}    x = nothing\nend\n")
    assert last.code == "more-problems"
    assert "error" in {one.severity for one in problems}


def test_a_page_learns_what_answers_the_questions_of_the_program():
    text = "main:\n    x = function.get_min_distance(left=True)\nend\n"
    document = Document.from_text(
        text, EBO, builtin(), equipment=frozenset({"DistanceSensors:left"})
    )
    shown = ShownProgram().update(SharedProgram(document))
    assert shown.asked == ("DistanceSensors:left",)
