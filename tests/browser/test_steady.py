"""Nothing that was in sight moves by itself, neither during a drag nor by what the page shows."""

import json

import pytest
from playwright.sync_api import expect

from browser.pupil import WORKSPACE, box_of
from browser.test_in_sight import SIZES, Reader

#: The places, by name, of the world, its state and goals, the lesson, the hat, the palette's
#: blocks and the visible buttons.
PLACES = f"""() => {{
    const placeOf = (part) => {{
        const {{ x, y, width, height }} = part.getBoundingClientRect();
        return [x, y, width, height].map(Math.round).join(" ");
    }};
    const inSight = (part) => part.checkVisibility({{ visibilityProperty: true }});
    // The same step in another view has a button of the view's name.
    const group = (part) => part.closest("[role=group], section")?.ariaLabel ?? "";
    const label = (part) => part.ariaLabel || part.textContent;
    const named = (parts, name) => [...parts].filter(inSight).map((part) => [name(part), part]);
    const hat = document.querySelectorAll("{WORKSPACE} .lb_main > .blocklyPath");
    const offered = document.querySelectorAll(".blocklyFlyout .blocklyBlock > .blocklyPath");
    const buttons = document.querySelectorAll("header button, main button, main [role=slider]");
    const fixed = document.querySelectorAll(
        ".world-place, .world-bottom p.goals, .main > .lesson-pane"
    );
    const parts = [
        ...named(fixed, (part) => part.className),
        ...named(hat, () => "hat"),
        ...named(offered, (part) => `offered ${{part.parentNode.dataset.id}}`),
        ...named(buttons, (part) => `button ${{group(part)}} ${{label(part)}}`),
    ];
    // The words of the state change, its place does not.
    const state = document.querySelector(".world-bottom .state").getBoundingClientRect();
    const places = parts.map(([name, part]) => [name, placeOf(part)]);
    return {{ ...Object.fromEntries(places), state: `${{state.left}} ${{state.top}}` }};
}}"""

#: Whether the lesson keeps room for what a run will say.
ROOM_IS_KEPT = """() =>
    document.querySelector(".main > .lesson-pane").style.getPropertyValue("--lesson-least") !== ""
"""
WAITS = """main:
    function.sleep(0.5)
end
"""
TALKS = """main:
    print("I am a robot")
    name = input("Your name?")
    print("Hello, " + name)
end
"""


class Places:
    """Remembers where everything is, and says what has moved."""

    def __init__(self, page):
        self._page = page
        self._before = page.evaluate(PLACES)
        assert "hat" in self._before

    def moved(self):
        """Return what is still in sight, but not where it was."""
        now = self._page.evaluate(PLACES)
        return {
            name: (place, now[name])
            for name, place in self._before.items()
            if name in now and now[name] != place
        }


@pytest.fixture
def pupil(sit_down, server):
    """A pupil with an empty program beside an open palette."""
    pupil = sit_down(server, stage="starter", empty=True, flat=True)
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_turn").first).to_be_visible()
    return pupil


def test_nothing_moves_while_the_first_block_is_taken_and_dropped(pupil):
    page = pupil.page
    places = Places(page)
    offered = page.locator(".blocklyFlyout .lb_skill_drive_distance").first
    hat = pupil.blocks("lb_main").first.get_attribute("data-id")
    path = box_of(offered.locator("> .blocklyPath").first)
    page.mouse.move(path["x"] + 5, path["y"] + 15)
    page.mouse.down()
    assert places.moved() == {}
    # The hat grows around the block that it will hold, but stays where it is.
    hats = page.locator(f"{WORKSPACE} .lb_main > .blocklyPath")
    corner = box_of(hats)
    x, y = pupil.inside(hat)
    for part in (0.1, 0.5, 1):
        page.mouse.move(path["x"] + 5 + part * (x - path["x"]), path["y"] + part * (y - path["y"]))
    expect(page.locator(f"{WORKSPACE} .blocklyInsertionMarker")).to_be_visible()
    page.mouse.up()
    expect(pupil.blocks("lb_main").locator(".lb_skill_drive_distance")).to_be_visible()
    after = box_of(hats)
    assert (after["x"], after["y"]) == (corner["x"], corner["y"])
    assert set(places.moved()) <= {"hat"}


def test_a_block_snaps_in_from_as_far_as_in_scratch(pupil):
    hat = pupil.blocks("lb_main").first.get_attribute("data-id")
    pupil.take("Move", "lb_skill_drive_distance", to=lambda: near(pupil.inside(hat), 27))
    expect(pupil.blocks("lb_main").locator(".lb_skill_drive_distance")).to_be_visible()


@pytest.mark.parametrize(
    ("stage", "size"), [("starter", "laptop"), ("explorer", "small"), ("explorer", "phone")]
)
def test_a_run_moves_nothing(sit_down, server, stage, size):
    width, height = SIZES[size]
    viewport = {"width": width, "height": height}
    pupil = sit_down(server, stage=stage, empty=True, flat=True, viewport=viewport)
    expect(pupil.page.locator(".lbGroupIcon").first).to_be_visible()
    page = pupil.page
    pupil.show("Block-Text")
    pupil.write("blocktext", WAITS)
    pupil.wait_until_saved()
    pupil.show("Blocks")
    expect(pupil.blocks("lb_skill_sleep")).to_be_visible()
    places = Places(page)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator(".status .state").first).to_contain_text("Ended")
    # The timeline of the run is new.
    expect(page.get_by_role("slider", name="Moment of the run")).to_be_visible()
    assert places.moved() == {}


@pytest.mark.parametrize("size", ["laptop", "small"])
def test_a_run_that_misses_a_goal_moves_nothing_of_the_lesson(own_server, sit_down, size):
    reader = Reader(sit_down, own_server, size, "en", flat=True)
    page = reader.page
    reader.open("1-03-square")
    reader.go_to(4)
    expect(page.locator(".lesson-text")).to_be_visible()
    page.wait_for_function(ROOM_IS_KEPT)
    reader.pupil.choose("Speed", "Fastest")
    places = Places(page)
    page.get_by_role("button", name="Run", exact=True).click()
    expect(page.locator(".lesson-goal.failed .lesson-reason")).to_be_visible()
    expect(page.get_by_role("slider", name="Moment of the run")).to_be_visible()
    assert places.moved() == {}


def test_a_run_that_prints_and_asks_moves_nothing(sit_down, server):
    pupil = sit_down(server, stage="explorer", empty=True, flat=True)
    page = pupil.page
    pupil.write("blocktext", TALKS)
    expect(pupil.blocks("lb_main").locator(".text_print")).to_have_count(2)
    page.locator(".output-button button").click()
    expect(page.locator("#panel")).to_be_hidden()
    places = Places(page)
    page.get_by_role("button", name="Run", exact=True).click()
    question = page.locator(".world-asked .question input")
    expect(question).to_be_focused()
    assert places.moved() == {}
    pupil.picture("asked")
    page.keyboard.type("Ada")
    page.keyboard.press("Enter")
    said = page.locator(".world-said button")
    expect(said).to_have_text("Hello, Ada")
    pupil.state("Ended")
    assert places.moved() == {}
    pupil.picture("said")
    said.click()
    expect(page.locator(".console-lines")).to_contain_text("Your name? Ada")


def test_the_offer_of_the_tour_moves_nothing(sit_down, server):
    pupil = sit_down(server, stage="starter", empty=True, flat=True, tour=True)
    page = pupil.page
    decline = page.get_by_role("button", name="No, thanks")
    expect(decline).to_be_visible()
    expect(page.locator(".blocklyFlyout .lb_skill_turn").first).to_be_visible()
    places = Places(page)
    decline.click()
    expect(decline).to_have_count(0)
    assert places.moved() == {}


def test_a_lost_connection_moves_nothing(sit_down, own_server):
    pupil = sit_down(own_server, stage="starter", empty=True, flat=True)
    expect(pupil.page.locator(".blocklyFlyout .lb_skill_turn").first).to_be_visible()
    places = Places(pupil.page)
    own_server.kill()
    expect(pupil.page.get_by_role("alert").filter(has_text="Connection")).to_be_visible()
    assert places.moved() == {}


def test_a_higher_level_moves_nothing_of_the_program(pupil):
    page = pupil.page
    places = Places(page)
    likes = json.loads(page.evaluate("localStorage['learnblock.preferences']"))
    assert likes["stage"] == "starter"
    pupil.command("Settings and help", "Explorer")
    expect(page.get_by_role("button", name="Step", exact=True)).to_be_visible()
    moved = places.moved()
    # New buttons take some of the world's room.
    program = {name for name in moved if name == "hat" or name.startswith("offered")}
    assert program == set()


def near(place, distance):
    """Return a place to the left of another."""
    return place[0] - distance, place[1]
