"""Repeating forever, waiting, and the newer kinds of values, in all three views."""

import pytest
from playwright.sync_api import expect

ALL = ("Blocks", "Block-Text", "Python")
PROGRAM = """\
main:
    ages = {"Ana": 10, "Luis": 11}
    ages["Eva"] = 9
    for name in keys(ages):
        print(f"{name} is {ages[name]}, " + ("young" if ages[name] < 11 else "old"))
    end
    forever:
        function.turn_right()
        wait until function.is_front_obstacle()
    end
end
"""
PYTHON = """\
# main
ages = {"Ana": 10, "Luis": 11}
ages["Eva"] = 9
for name in list(ages.keys()):
    print(f"{name} is {ages[name]}, " + ("young" if ages[name] < 11 else "old"))
while True:
    robot.turn_right()
    robot.wait_until(lambda: robot.is_front_obstacle())
"""
KINDS = ("lb_dictionary", "lb_dictionary_set", "lb_dictionary_keys", "text_join", "logic_ternary")


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program in all three views on a wide screen."""
    pupil = sit_down(server, viewport={"width": 1800, "height": 900}, empty=True)
    pupil.show(*ALL)
    return pupil


def test_a_loop_that_waits_is_built_from_blocks_and_shown_in_both_texts(pupil):
    pupil.show("Blocks")
    loop = pupil.take("Control", "lb_forever")
    pupil.put_into(loop, pupil.blocks("lb_main").get_attribute("data-id"))
    wait = pupil.take("Control", "lb_wait_until")
    pupil.put_into_loop(wait, loop)
    question = pupil.take("Sense", "lb_skill_is_front_obstacle")
    pupil.put_on(question, pupil.hole(wait))

    pupil.show(*ALL)
    pupil.sees("blocktext", "forever:", "wait until function.is_front_obstacle(200)")
    pupil.sees("python", "while True:", "robot.wait_until(lambda: robot.is_front_obstacle(200))")
    pupil.picture("waits")
    assert pupil.foreign == []


def test_values_typed_in_block_text_are_blocks_and_python(pupil):
    pupil.write("blocktext", PROGRAM)
    pupil.sees("python", *PYTHON.splitlines())
    for kind in (*KINDS, "lb_forever", "lb_wait_until"):
        expect(pupil.blocks(kind)).to_have_count(1)
    expect(pupil.blocks("lb_dictionary_get")).to_have_count(2)
    pupil.picture("values")

    # A change is only read from blocks that have kept all their values.
    dictionary = pupil.blocks("lb_dictionary")
    pupil.fill(dictionary.locator(".math_number", has_text="10"), "12")
    pupil.sees(
        "blocktext", 'ages = {"Ana": 12, "Luis": 11}', '"young" if ages[name] < 11 else "old"'
    )
    assert pupil.foreign == []


def test_values_typed_in_python_are_blocks_and_run(pupil):
    pupil.write("python", pupil.text("python").replace("pass", "").rstrip() + "\n" + PYTHON)
    pupil.sees("blocktext", "forever:", 'print(f"{name} is {ages[name]}, "')
    expect(pupil.blocks("lb_python")).to_have_count(0)
    expect(pupil.blocks("text_join")).to_have_count(1)
    pupil.press("Run")
    expect(pupil.tab("Console")).to_contain_text("Luis is 11, old")
    pupil.press("Stop")
    assert pupil.foreign == []


UNPACKING = """\
main:
    points = {"home": [0, 0], "corner": [200, 100]}
    for name, place in items(points):
        print(f"{name}: {place}")
    end
    function.drive_arc(200, -90)
    function.turn(90, 60)
end
"""


def test_a_loop_that_takes_values_apart_gets_another_variable_on_its_block(pupil):
    pupil.write("blocktext", UNPACKING)
    pupil.sees("python", "for name, place in points.items():", "robot.turn(90, 60)")
    loop = pupil.blocks("lb_for_unpacking")
    expect(loop).to_contain_text("place")
    expect(pupil.blocks("lb_dictionary_items")).to_have_count(1)
    pupil.picture("unpacking")

    pupil.click_on(loop.locator("image").nth(1))
    pupil.sees("blocktext", "for name, place, z in items(points):")
    pupil.sees("python", "for name, place, z in points.items():")
    pupil.click_on(loop.locator("image").nth(2))
    pupil.sees("blocktext", "for name, place in items(points):")
    pupil.press("Run")
    expect(pupil.tab("Console")).to_contain_text("corner: [200, 100]")
    pupil.press("Stop")
    assert pupil.foreign == []
