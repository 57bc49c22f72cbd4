"""Why something happened."""

from asked import answered, run_of, told

TWICE = "    function.move_straight(60)\n    function.sleep(1)\nend\n"


def test_the_turns_of_a_loop_decide_about_what_comes_after_it(tmp_path):
    program = f"laps = 3\nfor lap from 1 to laps:\n{TWICE}function.stop_bot()\n"
    given = answered(run_of(tmp_path, program), "why did it stop?")
    assert told(given) == [("why-moved", 5 + 1), ("why-turns-over", 2), ("why-set", 1)]
    assert "after 3 turns" in given.words("en")[1]


def test_the_turns_of_a_loop_in_a_function_decide_about_what_comes_after_its_call(tmp_path):
    body = TWICE.replace("    ", "        ").replace("end", "    end")
    program = f"def go():\n    repeat 1:\n{body}end\ngo()\nfunction.stop_bot()\n"
    given = answered(run_of(tmp_path, program), "why did it stop?")
    assert told(given) == [("why-moved", 8), ("why-turns-over", 2)]
    assert given.words("en")[1].endswith("was over at 1 s, after one turn.")


def test_a_loop_that_took_no_time_is_no_news(tmp_path):
    program = "repeat 3:\n    x = 1\nend\nfunction.stop_bot()\nfunction.sleep(1)\n"
    assert told(answered(run_of(tmp_path, program), "why did it stop?")) == [("why-moved", 4)]


def test_the_turns_of_a_loop_within_another_are_those_of_its_last_time(tmp_path):
    program = (
        "for x in [1, 2, 3]:\n    for y in [5, 5]:\n        function.sleep(0.5)\n    end\n"
        "    function.turn_left()\n    function.sleep(0.5)\nend\n"
    )
    given = answered(run_of(tmp_path, program), "why did it turn left at 4.2?")
    assert ("why-turns-over", 2) in told(given)
    assert "after 2 turns" in next(one for one in given.words("en") if "line 2" in one)
