"""A short monkey test; `tests/browser/monkey.py` runs longer ones."""

import re

from playwright.sync_api import expect

from browser.monkey import run_monkey


def test_the_page_survives_random_input(browser, tmp_path):
    diary = run_monkey(browser, tmp_path, seed=1, seconds=20)
    assert diary.failure is None, diary
    assert diary.answers


# Bugs found by monkey tests.


def test_sensors_follow_a_change_of_robot_while_they_are_hidden(sit_down, server):
    pupil = sit_down(server, empty=True)
    sensors = pupil.tab("Sensors")
    boxes = sensors.get_by_role("checkbox")
    expect(boxes.first).to_be_visible()
    for box in boxes.all():
        box.check()
    plot = sensors.get_by_role("img")
    expect(plot).to_have_attribute(
        "aria-label", re.compile("Distance in front 1, .*, Distance on the right 2")
    )
    pupil.tab("Console")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.choose("Robot", "Cozmo")
    pupil.expect_robot("Cozmo at")
    pupil.tab("Sensors")
    expect(plot).to_have_attribute(
        "aria-label", "Plot of the last minute: Heading, Distance driven"
    )
    pupil.picture("sensors")


def test_the_move_key_does_nothing_to_a_block_dragged_by_the_mouse(sit_down, server):
    pupil = sit_down(server, empty=True)
    pupil.write("blocktext", "main:\n    function.turn_right()\n    function.sleep(1)\nend\n")
    held = pupil.blocks("lb_skill_turn_right")
    box = held.bounding_box()
    with pupil.dragging(held, (box["x"] + 40, box["y"] + 250)):
        pupil.page.keyboard.press("m")
    expect(pupil.blocks("blocklyDragging")).to_have_count(0)
    pupil.lacks("blocktext", "sleep")
    pupil.take("Move", "lb_skill_turn_left")


def test_the_views_can_be_chosen_at_the_smallest_width(pupil):
    pupil.page.get_by_role("separator", name="Divider between program and world").press("Home")
    pupil.show("Python")
    pupil.picture("narrow")
    pupil.show("Blocks", "Block-Text", "Python")
