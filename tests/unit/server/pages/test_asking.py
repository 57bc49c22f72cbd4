"""Which robots can run the program that a page shows."""


def verdicts(page):
    page.say("ReadRunsOn")
    return {one["robot"]: one for one in page.hear("RunsOn")["robots"]}


def test_a_page_learns_which_robots_can_run_its_program(page):
    page.open(text="x = function.is_left_obstacle()\n")
    found = verdicts(page)

    assert found["sim-ebo"]["state"] == "runs"
    assert found["sim-ev3"]["state"] == "refused"
    assert found["sim-ev3"]["message"]["code"] == "check-robot-refused"
    assert found["coppeliasim"]["state"] == "unknown"


def test_decoration_that_a_robot_lacks_does_not_refuse_a_program(page):
    page.open(text='function.say_Text("hi")\n')

    assert verdicts(page)["sim-thymio"]["state"] == "without"
