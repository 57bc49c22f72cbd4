"""The look of blocks: their colours, and those that do not run."""

import re

import pytest
from playwright.sync_api import expect

PRINTS = """\
main:
    print(1)
    print(1, 2)
end

# the end
"""
#: What is typed in is text.
ANSWER = """\
main:
    n = input("How often?")
    repeat n:
        function.turn(90)
    end
end
"""
LOOSE = re.compile("lbLoose")
#: Comments and Python code are grey, and a number is white like its field, in any tab.
PLAIN = ("lb_comment", "lb_python", "lb_python_value", "math_number")
#: The colours of the other blocks in the open tab.
COLOURS = """(plain) => [...document.querySelectorAll(
        ".blocklyFlyout:not([style*='none']) .blocklyBlockCanvas > .blocklyDraggable")]
    .filter((block) => !plain.some((kind) => block.classList.contains(kind)))
    .map((block) => block.querySelector(":scope > .blocklyPath").getAttribute("fill"))"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program."""
    return sit_down(server, viewport={"width": 1600, "height": 900}, empty=True)


def test_all_blocks_of_a_tab_have_one_colour(pupil):
    many = {}
    for row in pupil.page.locator(".blocklyToolboxCategory:not(:has(input))").all():
        row.click()
        colours = pupil.page.evaluate(COLOURS, PLAIN)
        if len(set(colours)) > 1:
            many[row.inner_text()] = colours
    pupil.picture("palette")
    assert many == {}


def test_a_call_has_the_colour_of_its_function_however_many_arguments_it_has(pupil):
    pupil.write("blocktext", PRINTS)
    fills = [
        pupil.blocks(kind).locator("> .blocklyPath").first.get_attribute("fill")
        for kind in ("text_print", "lb_call")
    ]
    assert fills[0] == fills[1]


def test_a_comment_at_the_end_is_a_comment_without_a_hat(pupil):
    pupil.write("blocktext", PRINTS)
    comment = pupil.blocks("lb_comment")
    expect(comment).to_contain_text("the end")
    expect(pupil.blocks("lb_start")).to_have_count(0)
    expect(comment).not_to_have_class(LOOSE)
    pupil.picture("comment")
    pupil.fill(comment.locator(".blocklyInputField"), "over")
    pupil.sees("blocktext", "# over")


def test_blocks_that_do_not_run_are_drawn_as_inactive_until_they_are_connected(pupil):
    wait = pupil.take("Waiting", "lb_skill_sleep")
    expect(pupil.block(wait)).to_have_class(LOOSE)
    pupil.picture("loose")
    hat = pupil.blocks("lb_main").get_attribute("data-id")
    pupil.put_into(wait, hat)
    pupil.sees("blocktext", "function.sleep")
    expect(pupil.block(wait)).not_to_have_class(LOOSE)


def test_a_loose_block_is_explained_in_the_list_and_keeps_its_shape(pupil):
    wait = pupil.take("Waiting", "lb_skill_sleep")
    words = "not connected to the program"
    expect(pupil.tab("Problems").locator(".problem.warning")).to_contain_text(words)
    expect(pupil.block(wait).locator("> .blocklyIconGroup")).to_have_count(0)
    pupil.picture("loose")
    pupil.put_into(wait, pupil.blocks("lb_main").get_attribute("data-id"))
    pupil.sees("blocktext", "function.sleep")
    expect(pupil.page.locator(".problem")).to_have_count(0)


def test_a_mistake_is_worded_for_blocks_on_its_block_and_for_text_in_the_list(pupil):
    pupil.write("blocktext", ANSWER)
    answer = pupil.blocks("controls_repeat_ext").locator(".variables_get")
    expect(answer).to_have_class(re.compile("lbError"))
    expect(pupil.tab("Problems").locator(".problem.error")).to_contain_text("Write 'int(n)'")
    note = opened_note(pupil, answer.get_attribute("data-id"))
    expect(note).to_contain_text("'int' from the tab")
    pupil.picture("worded-for-blocks")


def opened_note(pupil, block):
    """The open note with the problems of a block."""
    pupil.block(block).locator("> .blocklyIconGroup").click()
    return pupil.page.locator(".blocklyBubbleCanvas .blocklyText")


def test_values_of_two_kinds_that_a_program_compares_stay_when_a_block_is_edited(pupil):
    pupil.write("blocktext", 'main:\n    print("a" == 3)\n    y = 5\nend\n')
    number = pupil.blocks("variables_set").locator(".math_number")
    pupil.fill(number, "6")
    pupil.sees("blocktext", "y = 6", 'print("a" == 3)')
