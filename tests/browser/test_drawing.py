"""The pen and the screen of a simulated robot, as the world shows them."""

import cv2
import numpy as np
import pytest
from playwright.sync_api import expect

PROGRAM = """\
main:
    function.set_pen_color("green")
    function.set_pen_width(30)
    function.pen_down()
    function.drive_distance(300)
    function.pen_up()
    function.turn_90_left()
    function.drive_distance(250)
    function.show_text("¡Hola! Look at my line.")
end
"""
WAITS = "main:\n    function.clear_drawing()\n    function.show_number(7)\nend\n"
#: Pixels of a line that is clearly visible.
MANY = 100


def green(pupil):
    """The number of pixels of the world in the pen's colour."""
    canvas = pupil.page.locator(".world-view canvas")
    picture = cv2.imdecode(np.frombuffer(canvas.screenshot(), np.uint8), cv2.IMREAD_COLOR)
    blue, green, red = (picture[..., channel].astype(int) for channel in range(3))
    return int(np.count_nonzero((green > 130) & (green < 170) & (red < 60) & (blue < 80)))


@pytest.mark.parametrize("robot", ["EBO", "Thymio II", "LEGO EV3", "Cozmo"])
def test_a_line_and_a_text_appear_in_the_world(sit_down, server, robot):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.choose("Robot", robot)
    pupil.choose("World", "Drawing floor")
    pupil.write("blocktext", PROGRAM)
    expect(pupil.blocks("lb_skill_pen_down")).to_be_visible()
    assert green(pupil) == 0
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.expect_robot(r"showing “¡Hola! Look at my line.”")
    pupil.picture(f"oblique-{robot}")
    pupil.press("View from above")
    pupil.picture(f"above-{robot}")
    assert green(pupil) > MANY


def test_a_page_that_opens_later_shows_the_drawing_until_it_is_erased(sit_down, server):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.choose("World", "Drawing floor")
    pupil.write("blocktext", PROGRAM)
    expect(pupil.blocks("lb_skill_pen_down")).to_be_visible()
    pupil.choose("Speed", "Fastest")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.page.reload()
    pupil.expect_robot("showing")
    pupil.press("View from above")
    pupil.picture("after-reload")
    assert green(pupil) > MANY
    pupil.write("blocktext", WAITS)
    expect(pupil.blocks("lb_skill_clear_drawing")).to_be_visible()
    pupil.press("Run")
    pupil.expect_robot("showing “7”")
    assert green(pupil) == 0


def test_the_palette_has_a_tab_for_the_pen_and_one_for_the_screen(sit_down, server):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.write("blocktext", "main:\n    pass\nend\n")
    expect(pupil.blocks("lb_main")).to_be_visible()
    hat = pupil.blocks("lb_main").get_attribute("data-id")
    pupil.put_into(pupil.take("Show", "lb_skill_set_pen_color"), hat)
    pupil.sees("blocktext", 'function.set_pen_color("red")')
    pupil.write("blocktext", "main:\n    pass\nend\n")
    expect(pupil.blocks("lb_skill_set_pen_color")).to_have_count(0)
    pupil.put_into(pupil.take("Show", "lb_skill_clear_screen"), hat)
    pupil.sees("blocktext", "function.clear_screen()")
    pupil.picture("blocks")
