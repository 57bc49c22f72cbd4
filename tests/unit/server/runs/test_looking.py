"""A page looks back at a run: any moment, what called what, and why."""

import pytest

from pages import english

pytestmark = pytest.mark.slow

COUNTING = """\
count = 0
main:
    repeat 3:
        count += 1
        function.move_straight(60)
        function.sleep(1)
    end
    function.stop_bot()
    print(count)
end
"""


@pytest.fixture
def ran(page):
    """A page whose program has run."""
    page.open()
    page.say("SetSpeed", factor=None)
    page.type(COUNTING)
    page.run()
    return page


def test_the_timeline_tells_its_end_its_marks_and_the_way(ran):
    ran.say("ReadTimeline")
    timeline = ran.hear("Timeline")
    assert timeline["end"] == 3
    assert timeline.get("exact", True)
    assert [mark["text"] for mark in timeline["marks"]] == ["3"]
    times, xs, _ = zip(*timeline["way"], strict=True)
    assert (times[0], times[-1]) == (0, 3)
    assert xs[-1] - xs[0] == pytest.approx(180, abs=10)


def test_the_timeline_tells_where_the_first_goal_was_missed(page):
    page.open(robot="sim-ev3", world="square")
    page.say("SetSpeed", factor=None)
    page.type("main:\n    function.drive_distance(100)\nend\n")
    page.run()
    page.say("ReadTimeline")
    missed = page.hear("Timeline")["missed"]
    assert english(missed["words"]) == "The first corner: 100 mm short."
    assert missed["place"] == [100, 100]


def test_without_a_run_the_timeline_is_empty(page):
    page.open()
    page.say("ReadTimeline")
    assert page.hear("Timeline")["end"] == 0
    page.say("LookBack", time=1)
    assert english(page.hear("Failed")["message"]).endswith("Run the program first.")


def test_a_moment_has_its_variables_its_line_and_its_world(ran):
    ran.say("LookBack", time=1.5)
    past = ran.hear("Past")
    assert past["variables"]["shared"]["count"] == "2"
    assert past["line"]["block"]
    assert past["telemetry"]["time"] == 1.5
    start = ran_start(ran)
    assert past["telemetry"]["robots"][0]["x"] - start == pytest.approx(90, abs=5)


def ran_start(page):
    page.say("LookBack", time=0)
    return page.hear("Past")["telemetry"]["robots"][0]["x"]


def test_one_steps_to_the_line_before_and_after(ran):
    ran.say("LookBack", time=1.5, step=-1)
    assert ran.hear("Past")["time"] == 1
    ran.say("LookBack", time=1.5, step=1)
    assert ran.hear("Past")["time"] == 2


def test_a_moment_behind_the_end_is_the_end(ran):
    ran.say("LookBack", time=1000)
    assert ran.hear("Past")["time"] == 3


def test_calls_are_those_of_the_part_that_is_asked_for(ran):
    ran.say("ReadCalls", last=1.5)
    graph = ran.hear("CallGraph")
    counts = {one["name"]: one["count"] for one in graph["functions"]}
    assert counts["move_straight"] == 2
    assert {edge["caller"] for edge in graph["edges"]} >= {0}


def test_a_question_is_answered_with_blocks_and_moments(ran):
    ran.say("ReadQuestions")
    asked = ran.hear("Questions")["questions"]
    [question] = [
        one["question"]
        for one in asked
        if one["question"]["ask"] == "value" and one["question"]["subject"] == "count"
    ]
    ran.say("AskWhy", question=question)
    sentences = ran.hear("WhyAnswer")["sentences"]
    assert sentences[0]["time"] == 2
    assert sentences[0]["block"]


def test_a_block_is_asked_about_its_own_lines_only(ran):
    ran.say("LookBack", time=0.5)
    block = ran.hear("Past")["line"]["block"]
    ran.say("ReadQuestions", block=block)
    asked = ran.hear("Questions")["questions"]
    assert {one["question"]["ask"] for one in asked} <= {"line", "not-line", "print", "not-print"}
    assert len({one["question"]["subject"] for one in asked}) == 1


def test_another_world_forgets_the_run(ran):
    ran.say("ChooseWorld", name="line")
    ran.hear("Scene")
    ran.say("ReadTimeline")
    assert ran.hear("Timeline")["end"] == 0


def test_values_are_told_by_block(ran):
    ran.say("LookBack", time=1.5)
    past = ran.hear("Past")
    assert [(one["name"], one["value"]) for one in past["values"]] == [("count", "2")]
    assert past["values"][0]["block"]


def test_lines_of_one_moment_are_gone_through_one_by_one(ran):
    blocks, event = [], None
    for _ in range(3):
        ran.say("LookBack", time=1, event=event, step=-1)
        past = ran.hear("Past")
        event = past["event"]
        blocks.append(past["line"]["line"])
    assert len(set(blocks)) == 3


def test_one_goes_to_a_change_a_run_a_turn_and_a_mark(ran):
    ran.say("LookBack", time=1.5, step=1, to="change", subject="count")
    changed = ran.hear("Past")
    assert (changed["time"], changed["variables"]["shared"]["count"]) == (2, "3")
    ran.say("LookBack", time=1.5, step=-1, to="run", subject=changed["line"]["block"])
    assert ran.hear("Past")["time"] == 1
    ran.say("LookBack", time=0.5, step=1, to="turn")
    assert ran.hear("Past")["time"] == 1
    ran.say("LookBack", time=0.5, step=1, to="mark", subject="print")
    assert ran.hear("Past")["time"] == 3


def test_a_call_is_gone_to_at_its_own_line_even_if_more_happened_then(ran):
    ran.say("ReadCalls")
    graph = ran.hear("CallGraph")
    shown = {}
    for edge in graph["edges"]:
        ran.say("LookBack", time=edge["first"], event=edge["event"] - 1, step=1)
        name = graph["functions"][edge["callee"]]["name"]
        shown.setdefault(name, ran.hear("Past")["line"])
    assert shown["move_straight"] == shown["device(Base)"]
    assert shown["sleep"]["line"] == shown["move_straight"]["line"] + 1
    assert shown["sleep"]["block"] != shown["move_straight"]["block"]


def test_where_there_is_nothing_to_go_to_the_moment_stays(ran):
    ran.say("LookBack", time=1.5, step=1, to="mark", subject="bump")
    past = ran.hear("Past")
    assert (past["time"], past["found"]) == (1.5, False)
