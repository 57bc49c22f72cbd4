"""Listing 4 of the paper: built by dragging blocks, shown in both texts, and run."""

import pytest
from playwright.sync_api import expect

SQUARE = """\
main:
    times = 0
    angle = 90
    function.reset_orientation("Z_AXIS")
    while times < 4:
        function.move_straight(40)
        function.sleep(5)
        function.stop_bot()
        function.set_orientation(angle)
        times += 1
        angle += 90
    end
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with room beside the program."""
    return sit_down(server, stage="starter", viewport={"width": 1920, "height": 1080})


def test_listing_4_is_built_by_dragging_blocks_and_the_robot_closes_the_square(pupil):
    pupil.begin()
    pupil.choose("Robot", "Cozmo")
    build_listing_4(pupil)
    pupil.picture("built")
    pupil.press("Block-Text")
    expect(pupil.lines("blocktext")).to_have_text(SQUARE.split("\n"))
    assert pupil.reads("blocktext") == SQUARE.split("\n")
    pupil.press("Python")
    pupil.sees("python", "times += 1", "angle += 90")
    assert pupil.reads("python")[-4:] == [
        "    robot.set_orientation(angle)",
        "    times += 1",
        "    angle += 90",
        "",
    ]
    pupil.press("Blocks")
    pupil.choose("Speed", "20×")
    pupil.note_running_blocks()
    pupil.press("Run")
    pupil.have_run("lb_skill_sleep", "lb_skill_set_orientation", "lb_skill_sleep")
    pupil.picture("running")
    pupil.wait_for_the_end()
    pupil.picture("closed")
    x, y = pupil.place_of_robot()
    assert abs(x) < 10
    assert abs(y) < 10


def build_listing_4(pupil):
    for name in ("angle", "times"):
        pupil.make_variable(name)
    times = pupil.set_variable("times", "0")
    pupil.put_into(times, pupil.blocks("lb_main").get_attribute("data-id"))
    angle = pupil.set_variable("angle", "90")
    pupil.put_below(angle, times)
    reset = pupil.take("Move", "lb_skill_reset_orientation")
    pupil.put_below(reset, angle)
    loop = pupil.take("Control", "controls_whileUntil")
    pupil.put_below(loop, reset)
    fewer_than_four(pupil, loop)
    turn_a_corner(pupil, loop)


def fewer_than_four(pupil, loop):
    comparison = pupil.take("Maths", "logic_compare")
    pupil.put_on(comparison, pupil.hole(loop))
    pupil.choose_in(comparison, "<")
    times = pupil.take("Variables", "variables_get", "times")
    pupil.put_on(times, pupil.hole(comparison))
    pupil.put_number(comparison, "4")


def turn_a_corner(pupil, loop):
    ahead = pupil.take("Move", "lb_skill_move_straight")
    pupil.put_into_loop(ahead, loop)
    wait = pupil.take("Control", "lb_skill_sleep")
    pupil.put_below(wait, ahead)
    pupil.fill(pupil.hole(wait), "5")
    stop = pupil.take("Move", "lb_skill_stop_bot")
    pupil.put_below(stop, wait)
    turn = pupil.take("Move", "lb_skill_set_orientation")
    pupil.put_below(turn, stop)
    pupil.put_on(pupil.take("Variables", "variables_get", "angle"), pupil.hole(turn))
    for name, change in (("angle", "90"), ("times", "1")):
        count = pupil.take("Variables", "math_change")
        pupil.put_below(count, turn)
        pupil.choose_in(count, name)
        pupil.fill(pupil.hole(count), change)
