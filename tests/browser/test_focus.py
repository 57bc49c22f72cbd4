"""Whatever opens has the focus where one types next, and no letter typed there is a shortcut."""

import re

from playwright.sync_api import expect

from browser.pupil import WORKSPACE
from waiting import wait_for

#: What a menu's command ends with if it opens something.
OPENS = re.compile(r"…$")
MENUS = "header [aria-haspopup=menu], .world-place [aria-haspopup=menu]"
#: Letters that are shortcuts of Blockly: palette, workspace, move, duplicate, clean up, next stack.
LETTERS = "twmdcn"
#: The first field of a dialog that is in sight, and where the focus is.
TYPING = """() => {
    const dialog = document.querySelector("dialog[open]");
    const all = "input:not([type=checkbox], [type=radio], [type=range], [type=color],"
        + " [type=file]), select, textarea, [contenteditable=true]";
    const bottom = dialog.getBoundingClientRect().bottom;
    const fields = [...dialog.querySelectorAll(all)].filter((field) => {
        return field.checkVisibility() && field.getBoundingClientRect().top < bottom;
    });
    const { activeElement } = document;
    const text = activeElement.value ?? activeElement.textContent;
    return { fields: fields.length, typing: fields.includes(activeElement), text };
}"""
#: The blocks of the program with their places.
PLACES = f"""() => [...document.querySelectorAll("{WORKSPACE} > .blocklyBlockCanvas [data-id]")]
    .map((block) => [block.dataset.id, block.getAttribute("transform")])"""


def opening_commands(page):
    """Return the menus of the page, each with the commands that open something."""
    for menu in page.locator(MENUS).all():
        if not menu.is_visible():
            continue
        menu.click()
        items = page.locator("[role=menu] [role=menuitem]", has_text=OPENS)
        texts = [item.get_attribute("aria-label") for item in items.all()]
        page.keyboard.press("Escape")
        yield menu, texts


#: Dialogs that need no typing: Enter takes what is preset.
PRESET = {"New…"}


def test_every_dialog_of_the_menus_has_the_focus_in_its_first_field(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True, stage="coder")
    page = pupil.page
    expect(page.locator(".lbGroupIcon").first).to_be_visible()
    before = page.evaluate(PLACES)
    lost, opened, choosers = [], 0, []
    dialog = page.locator("dialog[open]")
    page.on("filechooser", lambda _: choosers.append("chooser"))
    for menu, commands in opening_commands(page):
        for command in commands:
            menu.click()
            page.get_by_role("menuitem", name=command, exact=True).click()
            # A command may open a window of the system instead, which a page cannot see.
            wait_for(lambda: dialog.count() or choosers, command)
            if choosers:
                choosers.clear()
                continue
            opened += 1
            if page.evaluate(TYPING)["fields"] and command not in PRESET:
                expect(page.locator("dialog[open] :focus"), command).to_be_editable()
                page.keyboard.type(LETTERS)
                typed = page.evaluate(TYPING)
                # A number takes no letters, and a name that is already there is replaced.
                if not typed["typing"]:
                    lost.append((command, typed))
            else:
                page.keyboard.type(LETTERS)
            assert dialog.count() == 1, command
            while dialog.count():
                page.keyboard.press("Escape")
            expect(dialog).to_have_count(0)
    assert lost == []
    assert opened > 15
    assert page.evaluate(PLACES) == before


def test_a_click_on_the_search_is_followed_by_its_words(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True)
    page = pupil.page
    page.locator(".lbSearch").click()
    page.keyboard.type("list")
    field = page.locator(".lbSearchHead input")
    expect(field).to_have_value("list")
    expect(page.locator(".lbPaletteHead .lbSearchHead")).to_be_visible()
    page.keyboard.press("Control+a")
    page.keyboard.type("pen")
    expect(field).to_have_value("pen")
    expect(page.locator(".blocklyFlyout .lb_skill_pen_down")).to_be_visible()
