"""A short life of the monkey; `tests/browser/monkey.py` lets it live for as long as one likes."""

import re

from playwright.sync_api import expect

from browser.monkey import live


def test_the_page_bears_a_monkey(browser, tmp_path):
    diary = live(browser, tmp_path, seed=1, seconds=20)
    assert diary.failure is None, diary
    assert diary.answers


# What monkeys have found.


def test_a_robot_that_is_changed_while_its_sensors_are_hidden_has_its_own_when_shown(pupil):
    pupil.begin()
    sensors = pupil.tab("Sensors")
    for box in sensors.get_by_role("checkbox").all():
        box.check()
    plot = sensors.get_by_role("img")
    expect(plot).to_have_attribute(
        "aria-label", re.compile("Distance front 1, .*, Distance right 2")
    )
    pupil.tab("Console")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.choose("Robot", "Cozmo")
    pupil.robot_is("Cozmo at")
    pupil.tab("Sensors")
    expect(plot).to_have_attribute("aria-label", "Plot of the last minute: Ground central")
    pupil.picture("sensors")


def test_a_key_that_moves_blocks_does_nothing_to_one_that_the_mouse_holds(pupil):
    pupil.begin()
    pupil.write("blocktext", "main:\n    function.turn_right()\n    function.sleep(1)\nend\n")
    held = pupil.blocks("lb_skill_turn_right")
    box = held.bounding_box()
    with pupil.dragging(held, (box["x"] + 40, box["y"] + 250)):
        pupil.page.keyboard.press("m")
    expect(pupil.blocks("blocklyDragging")).to_have_count(0)
    pupil.lacks("blocktext", "sleep")
    pupil.take("Driving", "lb_skill_turn_left")


def test_the_views_are_chosen_also_where_they_have_as_little_room_as_can_be(pupil):
    pupil.page.get_by_role("separator", name="Divider between program and world").press("Home")
    pupil.show("Python")
    pupil.picture("narrow")
    pupil.show("Blocks", "Block-Text", "Python")
