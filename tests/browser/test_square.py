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


#: Where the robot is, in mm.
PLACE = """() => {
    const [robot] = learnblock.context.running.telemetry.value.robots;
    return [robot.x, robot.y];
}"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program and room beside it, whose page says where the robot is."""
    viewport = {"width": 1920, "height": 1080}
    pupil = sit_down(server, start=True, flat=True, viewport=viewport)
    project = server.address_of_new_project().partition("#")[2]
    pupil.page.goto(f"{pupil.page.url}?test#{project}")
    expect(pupil.all_blocks()).to_have_count(1)
    return pupil


def test_listing_4_is_built_by_dragging_blocks_and_the_robot_closes_the_square(pupil):
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
    x, y = pupil.page.evaluate(PLACE)
    assert abs(x) < 10
    assert abs(y) < 10


def build_listing_4(pupil):
    for name in ("angle", "times"):
        pupil.make_variable(name)
    main = pupil.blocks("lb_main").get_attribute("data-id")
    times = pupil.set_variable("times", "0", to=lambda: pupil.inside(main))
    angle = pupil.set_variable("angle", "90")
    # Most are dragged to where they belong at once; this one is moved later.
    pupil.put_below(angle, times)
    reset = pupil.take("Move", "lb_skill_reset_orientation", to=lambda: pupil.below(angle))
    loop = pupil.take("Control", "controls_whileUntil", to=lambda: pupil.below(reset))
    fewer_than_four(pupil, loop)
    turn_a_corner(pupil, loop)


def fewer_than_four(pupil, loop):
    comparison = pupil.take("Maths", "logic_compare", to=lambda: pupil.on(pupil.hole(loop)))
    pupil.choose_in(comparison, "<")
    left = pupil.hole(comparison)
    pupil.take("Variables", "variables_get", "times", to=lambda: pupil.on(left))
    pupil.put_number(comparison, "4")


def turn_a_corner(pupil, loop):
    ahead = pupil.take("Move", "lb_skill_move_straight", to=lambda: pupil.inside_loop(loop))
    stop = pupil.take("Move", "lb_skill_stop_bot", to=lambda: pupil.below(ahead))
    turn = pupil.take("Move", "lb_skill_set_orientation", to=lambda: pupil.below(stop))
    wait = pupil.take("Control", "lb_skill_sleep", to=lambda: pupil.below(ahead))
    pupil.fill(pupil.hole(wait), "5")
    direction = pupil.hole(turn)
    pupil.take("Variables", "variables_get", "angle", to=lambda: pupil.on(direction))
    for name, change in (("angle", "90"), ("times", "1")):
        count = pupil.take("Variables", "math_change", to=lambda: pupil.below(turn))
        pupil.choose_in(count, name)
        pupil.fill(pupil.hole(count), change)
