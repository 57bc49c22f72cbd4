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
#: Without a definition, "My blocks" has no blocks.
OWN = """\
def greet():
    print("hello")
end
"""
SENTENCES = """\
main:
    wait until function.is_front_obstacle(200)
    function.turn(90)
end
"""
LOOSE = re.compile("lbLoose")
#: A number is white like its field, in any group.
PLAIN = ("math_number",)
#: The colours of the other blocks in the open group.
COLOURS = """(plain) => [...document.querySelectorAll(
        ".blocklyFlyout:not([style*='none']) .blocklyBlockCanvas > .blocklyDraggable")]
    .filter((block) => !plain.some((kind) => block.classList.contains(kind)))
    .map((block) => block.querySelector(":scope > .blocklyPath").getAttribute("fill"))"""


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program."""
    return sit_down(server, viewport={"width": 1600, "height": 900}, empty=True, flat=True)


def test_all_blocks_of_a_group_have_one_colour_and_the_groups_have_nine(pupil):
    pupil.write("blocktext", OWN)
    found = {}
    for name in pupil.groups():
        pupil.open_category(name)
        pupil.show_more_blocks()
        found[name] = set(pupil.page.evaluate(COLOURS, PLAIN))
    pupil.picture("palette")
    assert {name for name, colours in found.items() if len(colours) != 1} == set()
    assert len(set.union(*found.values())) == 9


def test_every_statement_begins_with_the_icon_of_its_group_and_no_value_does(pupil):
    pupil.write("blocktext", PRINTS)
    expect(pupil.blocks("text_print").locator("> .blocklyImageField")).to_have_count(1)
    expect(pupil.blocks("lb_main").locator("> .blocklyImageField")).to_have_count(1)
    expect(pupil.blocks("math_number").first.locator("> .blocklyImageField")).to_have_count(0)


def test_an_empty_place_says_what_belongs_there_until_it_is_filled(pupil):
    loop = pupil.take("Control", "controls_whileUntil")
    words = pupil.block(loop).locator("> .lbSlotWord")
    expect(words).to_have_text(["yes or no"])
    pupil.picture("empty")
    pupil.write("blocktext", "main:\n    while 1 < 2:\n        pass\n    end\nend\n")
    expect(pupil.blocks("logic_compare")).to_be_visible()
    filled = pupil.blocks("controls_whileUntil:not(.lbLoose)")
    expect(filled.locator("> .lbSlotWord")).to_have_count(0)


def test_help_explains_a_block_and_inserts_another_below_it(pupil):
    pupil.write("blocktext", PRINTS.replace("print(1)", "function.sleep(5)"))
    pupil.select_block(pupil.blocks("lb_skill_sleep"))
    pupil.page.keyboard.press("Control+i")
    panel = pupil.page.get_by_role("dialog", name=re.compile("^Help: wait"))
    expect(panel).to_contain_text("Wait before the next block.")
    pupil.picture("help")
    panel.get_by_role("button", name="Insert this block").click()
    expect(panel).to_have_count(0)
    pupil.sees("blocktext", "function.sleep(1)")


@pytest.mark.parametrize(
    ("language", "robot", "served"),
    [
        ("en", "Thymio II", "On this robot: the sensors under it"),
        ("es", "EBO", "En este robot: la cámara"),
    ],
)
def test_help_says_what_serves_the_sense_of_a_block_on_the_chosen_robot(
    own_server, sit_down, language, robot, served
):
    pupil = sit_down(own_server, empty=True, language=language)
    pupil.write("blocktext", "main:\n    x = function.is_center_black_line()\nend\n")
    pupil.choose("Robot", robot)
    pupil.select_block(pupil.blocks("lb_skill_is_center_black_line"))
    pupil.page.keyboard.press("Control+i")
    expect(pupil.page.locator(".lbHelp")).to_contain_text(served)
    pupil.picture(f"serves-{language}")


def test_help_says_what_the_chosen_robot_lacks_for_a_block(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", "main:\n    x = function.is_center_red_line()\nend\n")
    pupil.choose("Robot", "Thymio II")
    expect(pupil.page.locator(".robot-name")).to_contain_text("Thymio II")
    # The left corner of a hexagon is in the middle of its height.
    question = pupil.blocks("lb_skill_is_center_red_line").locator("> .blocklyPath").first
    question.click(position={"x": 12, "y": 20})
    pupil.page.keyboard.press("Control+i")
    expect(pupil.page.locator(".lbHelp")).to_contain_text("Thymio II has no camera")
    able = pupil.page.locator(".lbHelp p", has_text="Works on:")
    expect(able).to_contain_text("Cozmo")
    expect(able).not_to_contain_text("Thymio")


def test_help_shows_the_block_with_its_values_in_both_texts(pupil):
    pupil.write("blocktext", "main:\n    function.drive_distance(200, 80)\nend\n")
    pupil.select_block(pupil.blocks("lb_skill_drive_distance"))
    pupil.page.keyboard.press("Control+i")
    expect(pupil.page.locator(".lbHelp dd").first).to_have_text("a number, in mm")
    texts = pupil.page.locator(".lbTexts")
    expect(texts).to_contain_text("function.drive_distance(200, 80)")
    expect(texts).to_contain_text("robot.drive_distance(200, 80)")
    pupil.picture("help")


@pytest.mark.parametrize(
    ("language", "waiting", "turning"),
    [
        ("en", "wait until obstacle ahead within 200 mm", "turn right by 90 °"),
        ("es", "hay un obstáculo delante a menos de 200 mm", "girar 90 ° a la derecha"),
    ],
)
def test_a_screen_reader_reads_blocks_as_their_sentences(
    sit_down, server, language, waiting, turning
):
    pupil = sit_down(server, language=language, empty=True)
    pupil.write("blocktext", SENTENCES)
    pupil.select_block(pupil.blocks("lb_wait_until"))
    expect(focused(pupil)).to_have_accessible_name(re.compile(re.escape(waiting)))
    pupil.select_block(pupil.blocks("lb_skill_turn"))
    expect(focused(pupil)).to_have_accessible_name(re.compile(f"^{re.escape(turning)}"))


def test_a_screen_reader_hears_what_belongs_into_an_empty_place(pupil):
    waiting = pupil.take("Control", "lb_wait_until")
    pupil.select_block(pupil.block(waiting))
    expect(focused(pupil)).to_have_accessible_name(re.compile("wait until Empty: yes or no"))


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
    wait = pupil.take("Control", "lb_skill_sleep")
    expect(pupil.block(wait)).to_have_class(LOOSE)
    pupil.picture("loose")
    hat = pupil.blocks("lb_main").get_attribute("data-id")
    pupil.put_into(wait, hat)
    pupil.sees("blocktext", "function.sleep")
    expect(pupil.block(wait)).not_to_have_class(LOOSE)


def test_a_loose_block_is_explained_in_the_list_and_keeps_its_shape(pupil):
    wait = pupil.take("Control", "lb_skill_sleep")
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
    expect(note).to_contain_text("'int' from 'Maths'")
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


def focused(pupil):
    """The element with the focus."""
    return pupil.page.locator(".blocklyActiveFocus")
