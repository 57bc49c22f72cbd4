"""The palette on a phone, the buttons beside the program, and quick drops."""

import re

import pytest
from playwright.sync_api import expect

from browser.pupil import FIRST_IN_HAT, SCALE, WORKSPACE
from browser.test_tablet import PHONE, Finger, corner, inside, tap

SQUARE = """\
main:
    repeat 4:
        function.turn(90)
    end
end
"""
#: Makes each frame of the page come half a second later, as on a slow computer.
SLOW_FRAMES = """() => {
    const soon = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = act => soon(() => setTimeout(() => soon(act), 500));
}"""
#: Drags a block to where its corner is at a place and drops it, all before the next frame.
DROP_AT_ONCE = """([block, x, y]) => {
    const { left, top } = block.getBoundingClientRect();
    const [gripX, gripY] = [5, 14];
    const send = (kind, target, x, y) => target.dispatchEvent(new PointerEvent(kind, {
        bubbles: true, cancelable: true, pointerId: 1, pointerType: "mouse", isPrimary: true,
        button: 0, buttons: kind === "pointerup" ? 0 : 1, clientX: x + gripX, clientY: y + gripY,
    }));
    send("pointerdown", block, left, top);
    for (const part of [0.1, 0.3, 0.6, 0.9, 1]) {
        send("pointermove", document, left + part * (x - left), top + part * (y - top));
    }
    send("pointerup", document, x, y);
}"""


@pytest.fixture
def phone(sit_down, server):
    """A pupil with a phone and an empty program."""
    return sit_down(server, stage="starter", viewport=PHONE, has_touch=True, empty=True)


#: A window with the layout of a computer.
WIDE = {"width": 1024, "height": 768}

#: What a group offers; a pupil who has made no block yet finds only a button in *My blocks*.
OFFERED = ".blocklyBlockCanvas > .blocklyBlock, .blocklyFlyoutButton"
#: The sentences of those that the open palette does not show whole beside its scroll bar.
CUT = """(offered) => {
    const shown = [...document.querySelectorAll(".blocklyFlyout")];
    const palette = shown.find((one) => one.getBoundingClientRect().width > 0);
    const end = palette.getBoundingClientRect().right - 8;
    const outlineOf = (one) => one.querySelector(".blocklyPath") ?? one;
    return [...palette.querySelectorAll(offered)]
        .filter((one) => outlineOf(one).getBoundingClientRect().right > end)
        .map((one) => one.textContent);
}"""


def test_a_block_dropped_in_the_frame_in_which_it_arrives_snaps_in(sit_down, server):
    pupil = sit_down(server, empty=True)
    pupil.write("blocktext", SQUARE)
    pupil.open_category("Control")
    wait = pupil.page.locator(".blocklyFlyout:visible .lb_skill_sleep").first
    box = pupil.blocks("lb_main").locator("> .blocklyPath").bounding_box()
    x, y = (box[axis] + way * SCALE for axis, way in zip("xy", FIRST_IN_HAT, strict=True))
    wait.locator("> .blocklyPath").evaluate(
        f"(block, to) => ({DROP_AT_ONCE})([block, ...to])", [x, y]
    )
    pupil.sees("blocktext", "function.sleep(1)")
    assert [line.strip() for line in pupil.reads("blocktext")][:3] == [
        "main:",
        "function.sleep(1)",
        "repeat 4:",
    ]


def test_on_a_phone_a_tap_puts_blocks_at_the_end_of_the_program(phone):
    add(phone, "Move", "lb_skill_drive_distance")
    add(phone, "Move", "lb_skill_turn")
    tap(phone, ".areas button", "Block-Text")
    phone.sees("blocktext", "function.drive_distance(200", "function.turn(90, 120)")
    steps = [line.strip().split("(")[0] for line in phone.reads("blocktext")]
    assert steps[1:3] == ["function.drive_distance", "function.turn"]


def test_on_a_phone_a_tapped_value_goes_into_the_empty_place_of_the_selected_block(phone):
    add(phone, "Control", "lb_wait_until", words="until")
    add(phone, "Sense", "lb_skill_is_front_obstacle")
    waiting = phone.blocks("lb_wait_until")
    expect(waiting.locator("> .lb_skill_is_front_obstacle")).to_be_visible()


def test_on_a_phone_a_block_is_dragged_out_of_the_sheet_which_closes(phone):
    sheet = open_sheet(phone, "Move")
    Finger(phone.page).drag(
        corner(sheet.locator(".lb_skill_turn").first), inside(phone.blocks("lb_main"))
    )
    expect(phone.blocks("lb_main").locator(".lb_skill_turn")).to_be_visible()
    expect(sheet).to_be_hidden()


def test_on_a_phone_a_block_dragged_onto_the_strip_is_deleted(phone):
    add(phone, "Move", "lb_skill_turn")
    strip = phone.page.locator(".blocklyToolbox").bounding_box()
    Finger(phone.page).drag(
        corner(phone.blocks("lb_skill_turn")), (strip["x"] + 90, strip["y"] + strip["height"] / 2)
    )
    expect(phone.blocks("lb_skill_turn")).to_have_count(0)


@pytest.mark.parametrize("way", ["button", "swipe", "outside", "Escape", "world"])
def test_on_a_phone_the_sheet_of_a_group_closes(phone, way):
    sheet = open_sheet(phone, "Show")
    head = phone.page.locator(".lbSheetHead").bounding_box()
    middle = (head["x"] + head["width"] / 2, head["y"] + head["height"] / 2)
    if way == "button":
        sheet.get_by_role("button", name="Close").tap()
    elif way == "swipe":
        Finger(phone.page).drag(middle, (middle[0], middle[1] + 120))
    elif way == "outside":
        phone.page.touchscreen.tap(middle[0], head["y"] - 20)
    elif way == "world":
        phone.page.touchscreen.tap(middle[0], 180)
    else:
        phone.page.keyboard.press("Escape")
    expect(sheet).to_be_hidden()


def test_on_a_phone_the_sheet_is_a_dialog_that_takes_the_focus_and_returns_it(phone):
    sheet = open_sheet(phone, "Sound")
    expect(sheet).to_have_accessible_name("Blocks: Sound")
    assert sheet.evaluate("sheet => sheet.contains(document.activeElement)")
    phone.picture("sheet")
    phone.page.keyboard.press("Escape")
    expect(strip(phone, "Sound")).to_be_focused()


def test_on_a_phone_the_keyboard_goes_along_the_strip_and_up_into_the_sheet(phone):
    open_sheet(phone, "Move")
    phone.page.keyboard.press("Escape")
    expect(strip(phone, "Move")).to_be_focused()
    phone.page.keyboard.press("ArrowRight")
    expect(strip(phone, "Sense")).to_be_focused()
    phone.page.keyboard.press("ArrowUp")
    first = phone.page.locator(".blocklyFlyout:visible .lb_skill_is_front_obstacle > .blocklyPath")
    expect(first.first).to_be_focused()


def test_on_a_phone_the_search_finds_a_block_and_a_tap_adds_it(phone):
    add(phone, "Search", "lb_skill_sleep", words="wait")
    expect(phone.blocks("lb_main").locator(".lb_skill_sleep")).to_be_visible()


def test_on_a_wide_screen_the_palette_is_beside_the_program_again(phone):
    add(phone, "Move", "lb_skill_turn")
    phone.page.set_viewport_size(WIDE)
    expect(phone.page.locator(".blocklyToolbox[layout=v]")).to_be_visible()
    expect(phone.blocks("lb_main").locator(".lb_skill_turn")).to_be_visible()


def test_widened_right_after_an_edit_the_program_keeps_it(phone):
    phone.page.evaluate(SLOW_FRAMES)
    add(phone, "Move", "lb_skill_turn")
    phone.page.set_viewport_size(WIDE)
    expect(phone.page.locator(".blocklyToolbox[layout=v]")).to_be_visible()
    expect(phone.page.get_by_role("region", name="Same step")).to_contain_text("turn")
    expect(phone.blocks("lb_main").locator(".lb_skill_turn")).to_be_visible()


@pytest.mark.parametrize(
    ("language", "names"),
    [
        ("en", ["Zoom in", "Zoom out", "Reset zoom"]),
        ("es", ["Acercar", "Alejar", "Tamaño normal"]),
    ],
)
def test_the_buttons_of_the_zoom_are_named_and_work_with_the_keyboard(
    sit_down, server, language, names
):
    pupil = sit_down(server, language=language, empty=True)
    canvas = pupil.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas")
    for name, scale in zip(names, (SCALE * 1.2, SCALE, SCALE), strict=True):
        pupil.page.get_by_role("button", name=name).focus()
        pupil.page.keyboard.press("Enter")
        expect(canvas).to_have_attribute("transform", re.compile(rf"scale\({scale:.4g}\)"))


def test_the_bin_is_there_while_a_block_is_dragged_and_once_one_has_been_thrown_away(
    sit_down, server
):
    pupil = sit_down(server, empty=True)
    trash = pupil.page.locator(".lbTool.blocklyTrash")
    pupil.put_into(
        pupil.take("Move", "lb_skill_turn"), pupil.blocks("lb_main").get_attribute("data-id")
    )
    expect(trash).to_be_hidden()
    with pupil.dragging(pupil.blocks("lb_skill_turn"), (300, 200)):
        expect(trash).to_be_visible()
    expect(trash).to_be_hidden()
    pupil.select_block(pupil.blocks("lb_skill_turn"))
    pupil.page.keyboard.press("Delete")
    expect(trash).to_be_visible()
    expect(trash).to_have_accessible_name(re.compile("."))


def test_the_buttons_of_the_zoom_are_large_enough_for_a_finger(sit_down, server):
    tablet = {"width": 1024, "height": 768}
    pupil = sit_down(server, stage="starter", viewport=tablet, has_touch=True, empty=True)
    buttons = pupil.page.locator(".zoom-buttons button, .lbToolFace")
    expect(buttons).to_have_count(4)
    for button in buttons.all():
        box = button.bounding_box()
        assert box["width"] >= 44
        assert box["height"] >= 44


@pytest.mark.parametrize("language", ["en", "es"])
@pytest.mark.parametrize("width", [820, 1024, 1366])
def test_the_buttons_of_the_zoom_are_beside_the_program_and_not_over_it(
    sit_down, server, language, width
):
    view = {"width": width, "height": 768}
    pupil = sit_down(
        server, stage="starter", language=language, viewport=view, empty=True, flat=True
    )
    head = pupil.page.locator(".program-head").bounding_box()
    blocks = pupil.page.locator("[data-region=blocks]").bounding_box()
    # A narrow head leaves the third to the menu of the program.
    buttons = pupil.page.locator(".zoom-buttons button:visible")
    expect(buttons).to_have_count(2 if width == 820 else 3)
    for button in buttons.all():
        box = button.bounding_box()
        assert box["x"] + box["width"] <= head["x"] + head["width"]
        assert box["y"] + box["height"] <= blocks["y"]


@pytest.mark.parametrize("language", ["en", "es"])
@pytest.mark.parametrize("size", [(1366, 768), (1024, 768), (820, 1180), (390, 844)])
def test_the_first_blocks_of_each_group_are_whole_beside_the_scroll_bar(
    sit_down, server, language, size
):
    view = dict(zip(("width", "height"), size, strict=True))
    pupil = sit_down(
        server, stage="starter", language=language, viewport=view, empty=True, flat=True
    )
    expect(pupil.page.locator(".lbGroupIcon").first).to_be_visible()
    cut = []
    groups = pupil.page.locator(".blocklyToolboxCategoryContainer:not(.lbSearch):visible")
    for group in groups.all():
        group.click()
        expect(pupil.page.locator(f".blocklyFlyout:visible :is({OFFERED})").first).to_be_visible()
        assert pupil.page.locator(".lbPaletteTitle:visible").inner_text() == group.inner_text()
        cut += pupil.page.evaluate(CUT, OFFERED)
        pupil.page.keyboard.press("Escape")
    assert cut == []


def test_a_palette_without_room_leaves_no_piece_of_its_head(sit_down, server):
    pupil = sit_down(server, empty=True)
    expect(pupil.page.locator(".blocklyToolbox")).to_be_visible()
    expect(pupil.page.locator(".lbPaletteHead")).to_be_hidden()


#: The height of the search and of a group in the rail, px.
SEARCH, GROUP = 44, 40


@pytest.mark.parametrize("language", ["en", "es"])
@pytest.mark.parametrize("size", [(1366, 768), (1024, 600)])
def test_on_a_laptop_all_groups_are_whole_in_the_rail(sit_down, server, language, size):
    view = dict(zip(("width", "height"), size, strict=True))
    pupil = sit_down(
        server, stage="starter", language=language, viewport=view, empty=True, flat=True
    )
    rail = pupil.page.locator(".blocklyToolboxCategoryGroup").bounding_box()
    rows = pupil.page.locator(".blocklyToolboxCategoryLabel:visible")
    expect(rows).to_have_count(9)
    # A game has a tenth.
    assert rail["height"] >= SEARCH + 10 * GROUP
    for row in rows.all():
        box = row.bounding_box()
        assert box["y"] + box["height"] <= rail["y"] + rail["height"]
        assert box["x"] + box["width"] <= rail["x"] + rail["width"]


def test_an_empty_program_invites_to_drag_a_block_until_there_is_one(sit_down, server):
    pupil = sit_down(server, stage="starter", empty=True)
    invitation = pupil.page.locator(".lbInvitation")
    expect(invitation).to_contain_text("Drag a block into the yellow one")
    pupil.picture("invitation")
    pupil.put_into(
        pupil.take("Move", "lb_skill_stop_bot"), pupil.blocks("lb_main").get_attribute("data-id")
    )
    expect(invitation).to_be_hidden()


def strip(pupil, group):
    """The group's button in the strip."""
    return pupil.page.get_by_role("treeitem", name=group)


def open_sheet(pupil, group):
    """Tap a group; return its sheet."""
    strip(pupil, group).tap()
    sheet = pupil.page.locator(".lbSheet.lbOpen")
    expect(pupil.page.locator(".lbSheetHead")).to_be_visible()
    return sheet


def add(pupil, group, kind, words=""):
    """Tap a block in the sheet of its group, or of the search for words."""
    sheet = open_sheet(pupil, "Search" if words else group)
    if words:
        expect(pupil.page.get_by_role("searchbox", name="Search for blocks")).to_be_focused()
        pupil.page.keyboard.type(words)
    sheet.locator(f".{kind} > .blocklyPath").first.tap(position={"x": 5, "y": 14})
    expect(pupil.blocks(kind)).to_be_visible()
    expect(sheet).to_have_count(0)


def test_a_ready_event_is_an_event_with_its_condition(sit_down, server):
    pupil = sit_down(server, stage="starter", empty=True, flat=True)
    pupil.take("Events", "lb_when_is_key_pressed")
    pupil.page.locator(".areas").get_by_role("button", name="Block-Text").click()
    pupil.sees("blocktext", 'when key_pressed = function.is_key_pressed("space"):')


@pytest.mark.parametrize(("stage", "count"), [("starter", 0), ("explorer", 0), ("coder", 1)])
def test_events_are_named_before_they_are_made_from_coder_on(sit_down, server, stage, count):
    pupil = sit_down(server, stage=stage, empty=True, flat=True)
    pupil.open_category("Events")
    expect(
        pupil.page.locator(".blocklyFlyout:visible .lb_when_is_key_pressed").first
    ).to_be_visible()
    button = pupil.page.locator(".blocklyFlyout:visible .blocklyFlyoutButton")
    expect(button.filter(has_text="New event")).to_have_count(count)


@pytest.mark.parametrize(
    ("language", "words"), [("en", "repeat 10"), ("es", "repetir 10"), ("es", "girar 90")]
)
def test_a_block_is_found_by_its_words_with_its_usual_value(sit_down, server, language, words):
    pupil = sit_down(server, empty=True, flat=True, language=language)
    page = pupil.page
    page.locator(".lbSearch").click()
    page.keyboard.type(words)
    kind = "controls_repeat_ext" if words.endswith("10") else "lb_skill_turn"
    expect(page.locator(f".blocklyFlyout:visible .{kind}").first).to_be_visible()
