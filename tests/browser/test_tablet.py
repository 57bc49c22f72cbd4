"""The page on touch screens: tablets and a phone."""

import re

import pytest
from playwright.sync_api import expect

from browser.pupil import FIRST_IN_HAT, SCALE

TABLET = {"width": 1024, "height": 768}
UPRIGHT = {"width": 800, "height": 1280}
PHONE = {"width": 390, "height": 844}
ANDROID = (
    "Mozilla/5.0 (Linux; Android 14; SM-X200) AppleWebKit/537.36 (KHTML, like Gecko) "
    "Chrome/140.0.0.0 Safari/537.36"
)
#: An element of each part of the page, visible once that part is loaded.
SHOWN = {
    "Blocks": ".blocklyToolbox",
    "Block-Text": "[data-region=blocktext] .cm-content",
    "Python": "[data-region=python] .cm-content",
    "World": ".world-view canvas",
    "Output": "[role=tabpanel]:visible",
}
#: The point where a block is held, right of and below its corner; no field is there.
GRIP = (5, 14)
#: The name and position of each visible control after scrolling to it.
CONTROLS = """() => {
    const all = "button, select, input, a[href], [role=tab], .blocklyToolboxCategory";
    return [...document.querySelectorAll(all)]
        .filter((one) => one.checkVisibility({ visibilityProperty: true }))
        .filter((one) => getComputedStyle(one).pointerEvents !== "none")
        .map((one) => {
            one.scrollIntoView({ block: "nearest", inline: "nearest" });
            const { left, top, right, bottom } = one.getBoundingClientRect();
            const name = one.ariaLabel || one.textContent || one.className;
            return { name, left, top, right, bottom, skip: one.matches(".skip-links *") };
        });
}"""

#: The visible titles of regions that do not have the width they need.
CUT = """() => [...document.querySelectorAll("h2")]
    .filter((title) => title.checkVisibility())
    .filter((title) => !getComputedStyle(title).clipPath.startsWith("inset"))
    .filter((title) => title.scrollWidth > title.clientWidth)
    .map((title) => title.textContent)"""


def test_a_block_is_dragged_by_a_finger_and_the_program_run_by_a_tap(sit_down, server):
    screen = {"viewport": TABLET, "has_touch": True, "user_agent": ANDROID}
    pupil = sit_down(server, stage="starter", flat=True, **screen)
    begin(pupil)
    drag_into_main(pupil, "Control", "lb_skill_sleep")
    drag_into_main(pupil, "Move", "lb_skill_move_straight")
    pupil.blocks("lb_skill_sleep").locator(".blocklyNumberField").tap()
    pupil.answer("30")
    tap(pupil, "#run button", "Run")
    pupil.state("Running")
    pupil.picture("running")
    tap(pupil, "#run button", "Stop")
    pupil.state("Ended")
    tap(pupil, ".areas button", "Block-Text")
    pupil.sees("blocktext", "function.move_straight(40)", "function.sleep(30)")
    assert pupil.foreign == []


@pytest.mark.parametrize("screen", [TABLET, UPRIGHT, PHONE], ids=["tablet", "upright", "phone"])
def test_every_control_is_on_the_screen_and_large_enough_for_a_finger(sit_down, server, screen):
    pupil = sit_down(server, stage="starter", viewport=screen, has_touch=True)
    expect(pupil.blocks("lb_main")).to_be_visible()
    for area in pupil.page.locator(".areas button").all():
        area.tap()
        expect(pupil.page.locator(SHOWN[area.inner_text()]).first).to_be_visible()
        pupil.picture(area.inner_text())
        check_all_controls(pupil, screen)


def test_after_a_run_every_control_of_a_phone_is_large_enough_for_a_finger(sit_down, server):
    pupil = sit_down(server, stage="starter", viewport=PHONE, has_touch=True, empty=True)
    tap(pupil, ".areas button", "Block-Text")
    pupil.write("blocktext", 'main:\n    print("hello")\n    function.sleep(0.5)\nend\n')
    pupil.wait_until_saved()
    tap(pupil, "#run button", "Run")
    pupil.state("Ended")
    expect(pupil.page.get_by_role("slider", name="Moment of the run")).to_be_visible()
    expect(pupil.page.locator(".timeline-mark.print")).to_have_count(1)
    pupil.picture("timeline")
    check_all_controls(pupil, PHONE)


@pytest.mark.parametrize("menu", ["Robot", "World"])
def test_on_a_phone_the_choices_of_robot_and_world_are_a_tap_away(sit_down, server, menu):
    pupil = sit_down(server, stage="starter", viewport=PHONE, has_touch=True)
    pupil.menu(menu).tap()
    expect(pupil.page.get_by_role("menuitemradio").first).to_be_visible()
    pupil.picture(menu)
    check_all_controls(pupil, PHONE)


def test_a_divider_can_be_dragged_by_a_finger_next_to_it(sit_down, server):
    pupil = sit_down(server, viewport=TABLET, has_touch=True)
    divider = pupil.page.get_by_role("separator", name="Divider between world and output")
    expect(divider).to_be_visible()
    before = divider.bounding_box()
    x, y = before["x"] + 200, before["y"] - 20
    Finger(pupil.page).drag((x, y), (x, y - 120))
    pupil.page.wait_for_function(
        "([divider, y]) => Math.abs(divider.getBoundingClientRect().y - y) < 3",
        arg=[divider.element_handle(), before["y"] - 120],
    )


def test_on_a_phone_no_title_is_cut_and_no_button_covers_the_console(sit_down, server):
    pupil = sit_down(server, stage="starter", viewport=PHONE, has_touch=True)
    tap(pupil, ".output-button button", "Output")
    for area in ("World", "Output"):
        expect(pupil.page.locator(SHOWN[area]).first).to_be_visible()
    pupil.picture("output")
    assert pupil.page.evaluate(CUT) == []
    lines = pupil.page.locator(".console-lines").bounding_box()
    for name in ("Copy", "Clear"):
        button = pupil.page.get_by_role("button", name=name, exact=True).bounding_box()
        assert button["y"] >= lines["y"] + lines["height"]


class Finger:
    """A finger that touches, moves and lifts."""

    def __init__(self, page):
        self._session = page.context.new_cdp_session(page)

    def drag(self, start, end):
        self._touch("touchStart", start)
        for part in (0.1, 0.3, 0.6, 0.9, 1, 1):
            self._touch("touchMove", [a + part * (b - a) for a, b in zip(start, end, strict=True)])
        self._touch("touchEnd")

    def _touch(self, kind, *points):
        places = [{"x": x, "y": y} for x, y in points]
        self._session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})


def tap(pupil, what, name):
    words = re.compile(f"^{name}$")
    labelled = pupil.page.locator(f'{what}[aria-label="{name}"]')
    labelled.or_(pupil.page.locator(what, has_text=words)).first.tap()


def begin(pupil):
    before = pupil.name_of_project()
    pupil.menu("Project").tap()
    pupil.page.get_by_role("menuitem", name="New…", exact=True).tap()
    pupil.dialog().get_by_role("button", name="Start").tap()
    expect(pupil.page.locator("header .project-name")).not_to_have_text(before)
    expect(pupil.blocks("lb_main")).to_be_visible()


def drag_into_main(pupil, category, kind):
    tap(pupil, ".blocklyToolboxCategory", category)
    offered = pupil.page.locator(f".blocklyFlyout:visible .{kind}").first
    Finger(pupil.page).drag(corner(offered), inside(pupil.blocks("lb_main")))
    expect(pupil.blocks(kind)).to_be_visible()


def corner(block):
    box = block.locator("> .blocklyPath").first.bounding_box()
    return box["x"] + GRIP[0], box["y"] + GRIP[1]


def inside(hat):
    box = hat.locator("> .blocklyPath").first.bounding_box()
    right, down = FIRST_IN_HAT
    return box["x"] + right * SCALE + GRIP[0], box["y"] + down * SCALE + GRIP[1]


def check_all_controls(pupil, screen):
    controls = shown_controls(pupil)
    assert [one for one in controls if not is_within(one, screen)] == []
    assert [one for one in controls if not is_large_enough(one)] == []
    assert pupil.page.evaluate("document.documentElement.scrollWidth") == screen["width"]
    assert pupil.page.evaluate("[scrollX, scrollY]") == [0, 0]


def shown_controls(pupil):
    # The skip links are only for keyboards.
    return [one for one in pupil.page.evaluate(CONTROLS) if not one["skip"]]


def is_within(control, screen):
    return (
        control["left"] >= -1
        and control["top"] >= -1
        and control["right"] <= screen["width"] + 1
        and control["bottom"] <= screen["height"] + 1
    )


def is_large_enough(control):
    width = control["right"] - control["left"]
    height = control["bottom"] - control["top"]
    # Positions in fractions of a pixel do not add up exactly.
    return round(width, 1) >= 44 and round(height, 1) >= 44


def test_at_a_zoom_of_200_percent_on_a_laptop_the_blocks_and_the_world_have_room(sit_down, server):
    pupil = sit_down(
        server, empty=True, stage="starter", viewport={"width": 1366 // 2, "height": 768 // 2}
    )
    palette = pupil.page.locator(".blocklyToolbox").bounding_box()
    blocks = pupil.page.locator("[data-region=blocks]").bounding_box()
    assert palette["y"] - blocks["y"] > 120
    assert pupil.page.locator(SHOWN["World"]).bounding_box()["height"] > 200
    pupil.picture("zoomed")
