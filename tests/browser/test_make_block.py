"""Own blocks are made and changed in one small dialog."""

import re

import pytest
from playwright.sync_api import expect

from browser.test_accessibility import faults

PROGRAM = """def dance(rounds):
    repeat rounds:
        function.turn(90)
    end
end

main:
    dance(3)
end
"""


def open_dialog(pupil):
    pupil.open_category("My blocks")
    pupil.page.locator(".blocklyFlyout:visible .lbMake").click()
    expect(pupil.dialog()).to_be_visible()
    return pupil.dialog()


def test_a_block_is_made_with_its_inputs_and_undone_in_one_step(sit_down, server):
    pupil = sit_down(server, stage="starter", empty=True, flat=True)
    dialog = open_dialog(pupil)
    keys = pupil.page.keyboard
    keys.type("dance")
    dialog.get_by_role("button", name="Number").click()
    keys.type("rounds")
    expect(dialog.locator(".block-picture").first).to_have_attribute(
        "aria-label", re.compile("dance.*rounds")
    )
    keys.press("Enter")
    expect(dialog).to_have_count(0)
    expect(pupil.blocks("procedures_defnoreturn")).to_be_in_viewport()
    pupil.open_category("My blocks")
    expect(pupil.page.get_by_role("option", name=re.compile("dance rounds 10"))).to_be_visible()
    pupil.show("Block-Text")
    pupil.sees("blocktext", "def dance(rounds):")
    pupil.press("Undo")
    pupil.lacks("blocktext", "dance")
    # A view that is not shown follows when it is.
    pupil.show("Blocks")
    expect(pupil.blocks("procedures_defnoreturn")).to_have_count(0)


def test_a_new_block_has_the_focus_before_the_next_frame(sit_down, server):
    pupil = sit_down(server, stage="starter", empty=True, flat=True)
    open_dialog(pupil)
    pupil.page.keyboard.type("dance")
    pupil.page.evaluate("globalThis.requestAnimationFrame = () => 0")
    pupil.page.keyboard.press("Enter")
    expect(pupil.blocks("procedures_defnoreturn").locator("> :focus")).to_be_visible()


@pytest.mark.parametrize(("stage", "python"), [("explorer", "x = 0"), ("starter", "global x")])
def test_variables_of_a_new_block_are_its_own_from_explorer_on(sit_down, server, stage, python):
    pupil = sit_down(server, stage=stage, empty=True, flat=True)
    pupil.show("Blocks")
    open_dialog(pupil)
    pupil.page.keyboard.type("count")
    pupil.page.keyboard.press("Enter")
    definition = pupil.blocks("procedures_defnoreturn")
    expect(definition).to_be_in_viewport()
    pupil.make_variable("x")
    hat = definition.get_attribute("data-id")
    pupil.set_variable("x", "0", to=lambda: pupil.inside(hat))
    expect(definition.locator(".variables_set")).to_be_visible()
    pupil.show("Python")
    pupil.sees("python", "def count():", f"    {python}")


@pytest.fixture
def dancer(sit_down, server):
    """A pupil with a block of the program and a call of it, in sight as blocks and text."""
    pupil = sit_down(server, empty=True, flat=True, viewport={"width": 1800, "height": 900})
    pupil.show("Blocks", "Block-Text")
    pupil.write("blocktext", PROGRAM)
    expect(pupil.blocks("procedures_defnoreturn")).to_be_visible()
    return pupil


def test_a_changed_block_is_changed_wherever_it_is_used(dancer):
    path = dancer.blocks("procedures_defnoreturn").locator("> .blocklyPath")
    path.dblclick(position={"x": 8, "y": 14})
    dialog = dancer.dialog()
    expect(dialog.get_by_role("textbox", name="Name", exact=True)).to_have_value("dance")
    dancer.page.keyboard.type("tango")
    dialog.get_by_role("button", name="Text").click()
    dialog.get_by_role("button", name="Move text up").click()
    dancer.picture("change")
    dialog.get_by_role("button", name="Change it").click()
    dancer.sees("blocktext", "def tango(text, rounds):", '    tango("hello", 3)')
    dancer.press("Undo")
    dancer.sees("blocktext", "def dance(rounds):", "    dance(3)")


def test_the_menu_of_a_block_opens_its_dialog(dancer):
    dancer.page.locator(".procedures_callnoreturn").last.click(
        button="right", position={"x": 8, "y": 14}
    )
    menu = dancer.page.locator(".blocklyContextMenu")
    dancer.picture("menu")
    menu.get_by_text("Change this block…").click()
    expect(dancer.dialog().get_by_role("textbox", name="Name", exact=True)).to_have_value("dance")


@pytest.mark.parametrize(("width", "theme"), [(1366, "light"), (1366, "dark"), (390, "dark")])
def test_the_whole_dialog_is_in_sight_and_accessible(sit_down, server, axe, width, theme):
    pupil = sit_down(server, stage="starter", empty=True, viewport={"width": width, "height": 844})
    pupil.page.emulate_media(color_scheme=theme)
    dialog = open_dialog(pupil)
    pupil.page.keyboard.type("while")
    expect(dialog).to_contain_text("is a word of the language")
    pupil.page.keyboard.type(" dancing")
    for kind in ("Number", "Text", "Yes or no"):
        dialog.get_by_role("button", name=kind, exact=True).click()
    pupil.picture(f"dialog-{width}-{theme}")
    inside = dialog.bounding_box()
    for field in dialog.locator("input, select, button").all():
        box = field.bounding_box()
        assert inside["x"] <= box["x"]
        assert box["x"] + box["width"] <= inside["x"] + inside["width"]
    assert faults(pupil, axe, "dialog") == []
