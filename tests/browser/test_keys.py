"""Remote control: keys reach the running program, and nothing else loses them."""

import re

import pytest
from playwright.sync_api import expect

LISTENING = """main:
    while not function.is_key_pressed("space"):
        if function.is_key_pressed("up"):
            function.move_straight(100)
        else:
            function.stop_bot()
        end
        function.sleep(0.05)
    end
    function.stop_bot()
end
"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with a program that listens to two keys, on an empty floor."""
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.write("blocktext", LISTENING)
    expect(pupil.blocks("lb_skill_is_key_pressed")).to_have_count(2)
    return pupil


def hint(pupil):
    return pupil.page.locator(".world-hint")


def console(pupil):
    return pupil.page.locator(".console-lines")


def place_of_rest(pupil):
    """Return where the robot is once it has stopped, a moment after the key was released."""
    before, seconds = "", pupil.seconds()
    while (place := pupil.where_is_the_robot()) != before or pupil.seconds() < seconds + 0.5:
        before = place
    return place


def test_the_robot_drives_while_a_key_is_held_and_the_page_says_which_keys_it_hears(pupil):
    pupil.press("Run")
    expect(hint(pupil)).to_have_text("The program listens to ↑ space.")
    pupil.page.keyboard.down("ArrowUp")
    pupil.expect_robot(r"at [1-9]\d+ mm east")
    pupil.picture("driven by keys")
    pupil.page.keyboard.up("ArrowUp")
    # A busy computer may not look at the keys within a short press.
    pupil.page.keyboard.down("Space")
    pupil.state("Ended")
    pupil.page.keyboard.up("Space")
    expect(hint(pupil)).to_be_hidden()


def test_the_hint_about_keys_covers_no_chip_of_the_world(pupil):
    pupil.press("Run")
    expect(hint(pupil)).to_be_visible()
    pupil.picture("hint")
    words = hint(pupil).bounding_box()
    for chip in pupil.page.locator(".world-bottom .chip").all():
        assert chip.bounding_box()["y"] >= words["y"] + words["height"]


def test_other_keys_keep_their_meaning_in_the_world(pupil):
    pupil.press("Run")
    expect(hint(pupil)).to_be_visible()
    pupil.page.keyboard.press("t")
    pupil.expect_view("View from above")


def test_keys_typed_in_an_editor_stay_there_and_held_ones_are_released(pupil):
    pupil.press("Run")
    expect(hint(pupil)).to_be_visible()
    pupil.page.keyboard.down("ArrowUp")
    pupil.expect_robot(r"at [1-9]\d+ mm east")
    pupil.editor("blocktext").click()
    expect(hint(pupil)).to_have_text(re.compile("Click the world"))
    pupil.picture("typing")
    stopped_at = place_of_rest(pupil)
    pupil.editor("blocktext").focus()
    pupil.page.keyboard.press("Control+End")
    pupil.page.keyboard.type("# up and space")
    pupil.sees("blocktext", "# up and space")
    assert pupil.where_is_the_robot() == stopped_at
    pupil.state("Running")


ONE_KEY = """main:
    wait until function.is_key_pressed("{key}")
    print("{key} pressed")
    wait until function.is_key_pressed("space")
end
"""


def test_two_players_share_a_keyboard_whichever_tab_is_open(pupil):
    pupil.write("blocktext", ONE_KEY.format(key="up"))
    pupil.add_robot("Thymio II")
    pupil.write("blocktext", ONE_KEY.format(key="w"))
    pupil.page.get_by_role("tab", name="Console").click()
    pupil.press("Run")
    expect(hint(pupil)).to_have_text("The programs listen to ↑ space W.")
    pupil.picture("two players")
    pupil.page.keyboard.down("w")
    pupil.page.keyboard.down("ArrowUp")
    expect(console(pupil)).to_contain_text("w pressed")
    pupil.page.get_by_role("tab", name=re.compile("^program")).click()
    expect(console(pupil)).to_contain_text("up pressed")
    expect(hint(pupil)).to_have_text(re.compile("^The programs listen to ↑ space W. Click"))
    pupil.page.keyboard.up("w")
    pupil.page.keyboard.up("ArrowUp")
    pupil.page.locator("#world canvas").click()
    # A busy computer may not look at the keys within a short press.
    pupil.page.keyboard.down("Space")
    expect(hint(pupil)).to_be_hidden()
    pupil.state("Ended")
    pupil.page.keyboard.up("Space")
    assert pupil.errors == []
