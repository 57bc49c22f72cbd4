"""Menus are shown whole and in front of everything, wherever their buttons are."""

import pytest
from playwright.sync_api import expect

SMALL = {"width": 1366, "height": 560}
#: The parts of a menu that something covers, or that are outside of the window.
COVERED = """list => [...list.querySelectorAll("[role^=menuitem]")].filter((item) => {
    item.scrollIntoView({ block: "nearest" });
    const { left, top, width, height } = item.getBoundingClientRect();
    return !item.contains(document.elementFromPoint(left + width / 2, top + height / 2));
}).map((item) => item.textContent)"""


def list_of(pupil):
    return pupil.page.get_by_role("menu")


@pytest.mark.parametrize("menu", ["World", "View and robot", "Robot", "Project"])
def test_no_pane_covers_an_item_of_a_menu_while_the_output_is_open(sit_down, server, menu):
    pupil = sit_down(server)
    expect(pupil.page.locator("#panel")).to_be_visible()
    pupil.menu(menu).click()
    pupil.picture(menu)
    assert list_of(pupil).evaluate(COVERED) == []


def test_the_last_world_is_chosen_with_two_clicks_in_a_low_window(sit_down, server):
    pupil = sit_down(server, viewport=SMALL)
    pupil.menu("World").click()
    last = pupil.page.get_by_role("menuitemradio").last
    name = last.text_content()
    last.click()
    pupil.expect_chosen("World", name)


def test_the_button_of_an_open_menu_hides_the_world_behind_it(sit_down, server):
    pupil = sit_down(server)
    pupil.menu("World").focus()
    pupil.page.keyboard.press("ArrowDown")
    expect(list_of(pupil)).to_be_visible()
    colour = pupil.menu("World").evaluate("one => getComputedStyle(one).backgroundColor")
    assert colour.startswith("rgb(")


def test_on_a_tablet_the_menu_of_languages_shows_their_names(sit_down, own_server):
    page = sit_down(own_server, start=True, viewport={"width": 820, "height": 1180}).page
    page.get_by_role("button", name="Language").click()
    items = page.get_by_role("menuitemradio").locator(".menu-text")
    expect(items).to_have_text(["English", "Español"])
    widths = [items.nth(place).bounding_box()["width"] for place in range(2)]
    assert min(widths) > 40


def test_a_menu_follows_its_button_when_the_window_changes_its_size(sit_down, server):
    pupil = sit_down(server)
    pupil.menu("View and robot").click()
    pupil.page.set_viewport_size({"width": 1200, "height": 700})
    pupil.page.wait_for_function(
        """([list, button]) => {
            const [menu, owner] = [list, button].map((one) => one.getBoundingClientRect());
            return Math.abs(menu.right - owner.right) < 2 && menu.top > owner.bottom;
        }""",
        arg=[
            list_of(pupil).element_handle(),
            pupil.menu("View and robot").element_handle(),
        ],
    )


def test_only_a_statement_offers_a_comment_which_the_texts_can_show(sit_down, server):
    pupil = sit_down(server, empty=True)
    pupil.write("blocktext", "main:\n    print(function.get_light() + 1)\nend\n")
    comment = list_of(pupil).get_by_role("menuitem", name="Add Comment")
    pupil.blocks("lb_skill_get_light").click(button="right", position={"x": 8, "y": 12})
    expect(list_of(pupil)).to_be_visible()
    expect(comment).to_have_count(0)
    pupil.page.keyboard.press("Escape")
    pupil.blocks("text_print").click(button="right", position={"x": 5, "y": 15})
    expect(comment).to_have_count(1)


def test_beside_two_texts_the_menu_of_a_block_is_whole(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True, viewport={"width": 1100, "height": 768})
    pupil.page.get_by_role("button", name="Python", exact=True).click(modifiers=["Shift"])
    hat = pupil.blocks("lb_main").first
    hat.click(button="right", position={"x": 20, "y": 20})
    menu = pupil.page.locator(".blocklyContextMenu")
    expect(menu).to_be_visible()
    assert menu.evaluate(COVERED) == []
