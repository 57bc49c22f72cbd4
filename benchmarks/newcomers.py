"""Play the first ten minutes of three people, and count their clicks, keys, seconds and stumbles.

    python benchmarks/newcomers.py [child] [scratcher] [teacher]

A child who has never programmed begins at the start page and in the first lesson. A child who knows
Scratch builds a program with a block of its own from an empty project. A teacher starts a class
with a lesson, helps, checks and hands back. The seconds are those of the page, without any thought.

A stumble is what a person would notice as wrong: something covered, words that are cut, a page
wider than the screen, a dialog without the focus. A step waits for what the person expects, and
ends the trial if it never comes. The pictures of all steps are in build/newcomers; look at them.

It needs a built page, Playwright and a Chromium (``CHROMIUM=/path/to/it``).
"""

import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from time import perf_counter

from _browser import SIZE, TIMEOUT, chromium, serving, visitor
from playwright.sync_api import BrowserContext, FloatRect, Locator, Page, expect

GIVEN = Path(__file__).with_suffix(".js")
PICTURES = Path(__file__).parents[1] / "build" / "newcomers"
BLOCKS = "[data-region=blocks] .blocklySvg > .blocklyWorkspace > .blocklyBlockCanvas"
Play = Iterator[tuple[str, Page]]


def seen(part: str, page: Page, *, text: str | None = None) -> None:
    """Wait until a part of the page is in sight."""
    expect(page.locator(part, has_text=text).first).to_be_in_viewport()


def button(page: Page, name: str | re.Pattern[str], *, exact: bool = True) -> None:
    """Click a button by its name."""
    page.get_by_role("button", name=name, exact=exact).first.click()


def keys(page: Page, *pressed: str) -> None:
    for key in pressed:
        page.keyboard.press(key)


def run(page: Page) -> None:
    """Run the program to its end."""
    button(page, "Run")
    seen(".status .state", page, text="Running")
    ended(page)


def ended(page: Page) -> None:
    seen(".status .state", page, text="Ended")


def child(page: Page) -> Play:
    """A child of nine who has never programmed."""
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    yield "start page", page
    button(page, "Try it")
    page.wait_for_function("() => learnblock.context.running.telemetry.value?.time > 0.2")
    yield "a program drives", page
    button(page, "No, thanks")
    ended(page)
    yield "the goals are reached", page
    page.locator(f"{BLOCKS} .lb_skill_turn > .blocklyShadow").first.click()
    keys(page, "Control+a", "6", "0", "Enter")
    run(page)
    yield "another number misses a goal", page
    page.get_by_role("button", name=re.compile("Why")).first.click()
    yield "why", page
    keys(page, "Escape")
    button(page, re.compile("^Home|^LearnBlock"), exact=False)
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    yield "home", page
    page.locator(".lesson-card").first.get_by_role("button").first.click()
    seen(".lesson-choice", page)
    yield "the first lesson asks", page
    page.locator(".lesson-choice").first.click()
    button(page, "Check")
    seen(".lesson-judged", page)
    yield "an answer", page
    button(page, "Next")
    seen(".lesson-goal", page)
    yield "step 2", page
    run(page)
    yield "step 2 run", page


def scratcher(page: Page) -> Play:
    """A child of eleven who knows Scratch."""
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    button(page, "New")
    expect(page.get_by_role("dialog")).to_be_visible()
    yield "new project", page
    keys(page, "Enter")
    seen(".lbGroupIcon", page)
    seen(f"{BLOCKS} .lb_main", page)
    yield "an empty program", page
    page.locator(".lbSearch").click()
    page.keyboard.type("costume")
    seen(".blocklyFlyout .lb_skill_expressJoy", page)
    yield "the search knows Scratch's words", page
    open_group(page, "Control")
    take(page, "controls_repeat_ext", f"{BLOCKS} .lb_main", (18, 60))
    yield "repeat is dropped into the hat", page
    open_group(page, "Move")
    take(page, "lb_skill_drive_distance", f"{BLOCKS} .controls_repeat_ext", (34, 50))
    yield "drive is dropped into the loop", page
    open_group(page, "Events")
    yield "events", page
    open_group(page, "My blocks")
    page.locator(".blocklyFlyout:visible .lbMake").click()
    page.keyboard.type("dance")
    button(page, "Number")
    page.keyboard.type("times")
    yield "make a block", page
    keys(page, "Enter")
    seen(f"{BLOCKS} .procedures_defnoreturn", page)
    yield "the block is there", page
    page.locator(f"{BLOCKS} .lb_skill_drive_distance > .blocklyPath").first.click(
        button="right", position={"x": 8, "y": 14}
    )
    seen(".blocklyContextMenu", page)
    yield "the menu of a block", page
    keys(page, "Escape")
    run(page)
    yield "the run", page
    button(page, re.compile("^World"), exact=False)
    page.get_by_role("menuitem", name="All worlds…").click()
    yield "all worlds", page
    keys(page, "Escape", "Escape")
    button(page, "Share")
    yield "share", page
    keys(page, "Escape")
    button(page, re.compile("^Home|^LearnBlock"), exact=False)
    button(page, "All examples", exact=False)
    yield "all examples", page


def open_group(page: Page, name: str) -> None:
    """Open a group of the palette."""
    row = page.locator(".blocklyToolboxCategory", has_text=re.compile(f"^{name}$"))
    if "blocklyToolboxSelected" not in (row.get_attribute("class") or ""):
        row.click()


def take(page: Page, kind: str, onto: str, corner: tuple[int, int]) -> None:
    """Drag a block from the palette onto one of the program, to a corner of it."""
    offered = page.locator(f".blocklyFlyout:visible .{kind} > .blocklyPath").first
    expect(offered).to_be_in_viewport()
    start, end = box_of(offered), box_of(page.locator(f"{onto} > .blocklyPath").first)
    page.mouse.move(start["x"] + 5, start["y"] + 15)
    page.mouse.down()
    # From below, so that no other place is offered on the way, which would move what is there.
    page.mouse.move(end["x"] + corner[0] + 5, end["y"] + corner[1] + 115, steps=3)
    page.mouse.move(end["x"] + corner[0] + 5, end["y"] + corner[1] + 15, steps=3)
    page.mouse.up()
    dropped = page.locator(f"{onto} .{kind}:not(.blocklyInsertionMarker)").first
    expect(dropped).to_be_visible()


def box_of(part: Locator) -> FloatRect:
    box = part.bounding_box()
    assert box  # noqa: S101
    return box


def teacher(page: Page) -> Play:
    """A teacher with a lesson and a class of two."""
    # At once, before the page is connected.
    button(page, "For teachers")
    expect(page.get_by_label("Name, such as 7b")).to_be_focused()
    yield "for teachers", page
    page.keyboard.type("7b")
    page.get_by_label("First lesson").select_option("First drive")
    yield "the form is filled", page
    with page.context.expect_page() as opened:
        keys(page, "Enter")
    wall = opened.value
    wall.set_viewport_size(SIZE)  # type: ignore[arg-type] # a width and a height
    expect(wall.locator(".join-word")).to_be_visible()
    yield "the wall is open", wall
    address, word = wall.url.removesuffix("/teacher"), wall.locator(".join-word").inner_text()
    pupils = [join(page, address, word, name) for name in ("Ana", "Leo")]
    expect(wall.locator(".tile")).to_have_count(len(pupils))
    yield "a pupil in the class", pupils[0]
    yield "two pupils are here", wall
    button(pupils[1], "I need help")
    pupils[1].keyboard.type("Which line?")
    keys(pupils[1], "Enter")
    expect(wall.get_by_label("Waiting for you")).to_contain_text("Which line?")
    yield "a pupil asks", wall
    tile = wall.get_by_role("row").filter(has=wall.get_by_text("Leo", exact=True))
    tile.hover()
    tile.get_by_role("button", name="Hint", exact=True).click()
    wall.keyboard.type("Read the number in the block.")
    yield "a hint is typed", wall
    keys(wall, "Control+Enter")
    expect(pupils[1].locator(".class-notes")).to_contain_text("Read the number")
    yield "the pupil reads it", pupils[1]
    yield from mark(wall, pupils[0])


def mark(wall: Page, pupil: Page) -> Play:
    """Have all eyes up, and give one pupil's hand-in back."""
    wall.locator(".wall-lesson").click()
    expect(wall.get_by_role("dialog")).to_be_visible()
    yield "another lesson", wall
    keys(wall, "Escape")
    button(wall, "Eyes up")
    expect(pupil.get_by_role("heading", name="Eyes up!")).to_be_visible()
    yield "eyes up", pupil
    button(wall, "Eyes up")
    button(pupil, "Next")
    button(pupil, "Hand in")
    expect(pupil.locator(".handed-in")).to_be_visible()
    yield "handed in", pupil
    wall.get_by_role("link", name="Hand-ins").click()
    expect(wall.get_by_role("heading", name=re.compile("^To check"))).to_be_visible()
    yield "hand-ins", wall
    button(wall, re.compile("^Check "), exact=False)
    expect(wall.get_by_role("heading", name=re.compile("^To mark · 1"))).to_be_visible()
    wall.locator("button.hand-ins-line").first.click()
    expect(wall.locator(".hand-in-answer textarea")).to_be_focused()
    wall.keyboard.type("Well driven!")
    yield "marked", wall
    keys(wall, "Control+Enter")
    expect(pupil.locator(".handed-back")).to_contain_text("Well driven!")
    yield "handed back", pupil


def join(page: Page, address: str, word: str, name: str) -> Page:
    """Join a class as a child does, in a browser of its own."""
    browser = page.context.browser
    assert browser  # noqa: S101
    pupil = browser.new_context(viewport=SIZE, locale="en").new_page()  # type: ignore[arg-type]
    pupil.add_init_script(path=GIVEN)
    pupil.goto(address)
    expect(pupil.get_by_label("Join word")).to_be_focused()
    pupil.keyboard.type(word)
    pupil.get_by_label("Your first name").fill(name)
    button(pupil, "I am new here")
    button(pupil, "Join")
    pupil.get_by_role("link", name="I'll remember them").click()
    expect(pupil.locator(".pupil-chip")).to_contain_text(name)
    expect(pupil.locator("[data-region=lesson]")).to_be_visible()
    return pupil


PLAYS: dict[str, Callable[[Page], Play]] = {
    "child": child,
    "scratcher": scratcher,
    "teacher": teacher,
}


def main() -> None:
    expect.set_options(timeout=TIMEOUT)
    PICTURES.mkdir(parents=True, exist_ok=True)
    for old in PICTURES.glob("*.png") if len(sys.argv) == 1 else ():
        old.unlink()
    with chromium() as browser:
        for name in sys.argv[1:] or PLAYS:
            with (
                serving(started=False) as address,
                visitor(browser, GIVEN, SIZE, layout=None, tour=True) as page,
            ):
                page.goto(f"{address}&test")
                print_play(name, page)


def print_play(name: str, page: Page) -> None:
    """Play as one person, and print a row for each step."""
    print(f"{name:36}{'clicks':>7}{'keys':>6}{'seconds':>10}  stumbles")
    began, total, hand = perf_counter(), 0.0, (0, 0)
    for number, (step, at) in enumerate(PLAYS[name](page), 1):
        seconds = perf_counter() - began
        now = hands(page.context)
        stumbles = at.evaluate("stumbles()")
        row = f"  {step:34}{now[0] - hand[0]:7}{now[1] - hand[1]:6}{seconds:10.1f}"
        print(row, "", "; ".join(stumbles) or "-", flush=True)
        at.screenshot(path=PICTURES / f"{name}-{number:02}.png")
        total, hand, began = total + seconds, now, perf_counter()
    print(f"  {'all':34}{hand[0]:7}{hand[1]:6}{total:10.1f}")


def hands(context: BrowserContext) -> tuple[int, int]:
    """Return the clicks and keys on all pages of a person, but not those of pupils in a class."""
    counts = [page.evaluate("steps") for page in context.pages]
    return sum(one["clicks"] for one in counts), sum(one["keys"] for one in counts)


if __name__ == "__main__":
    main()
