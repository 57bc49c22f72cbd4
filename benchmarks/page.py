"""Measure the page: opening it, showing an edit in all three views, drawing the world.

    python benchmarks/page.py [opening] [sync] [drawing]

It needs a built page, Playwright and a Chromium (``CHROMIUM=/path/to/it``).
"""

import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from learnblock.blocks import builtin
from learnblock.language import Workspace, parse, to_workspace

GIVEN = Path(__file__).with_suffix(".js")
SIZES = (100, 1000, 5000)
ROUNDS = 20
OPENINGS = 5
STARTS = 5
#: The time in which frames are counted, in ms.
WATCHED = 8000
#: The time in which the largest program appears on a slow machine, in ms.
TIMEOUT = 120_000
#: The edit changes the number on the second line.
HEAD = "main:\n    function.sleep(1)\n"
BODY = """\
    x = x + 2 * (y - 1)
    if x > 3 and not function.is_front_obstacle(100):
        y += 1
        function.move_straight(advSpeed=x)
    end
    function.turn(90)
"""
CANVAS = "[data-region=blocks] .blocklySvg > .blocklyWorkspace > .blocklyBlockCanvas"
NUMBER = f"{CANVAS} .lb_skill_sleep > .blocklyShadow"
COLUMNS = ("all", "worst", "sending", "server", "showing", "painting")
PARTS = ("opening", "sync", "drawing")
#: There is no graphics card.
SOFTWARE = "--enable-unsafe-swiftshader"


# Opening the page.


def opening(browser: Browser) -> None:
    starts = [started() for _ in range(STARTS)]
    print(f"server      {statistics.median(starts):.2f} s until the first answer")
    with serving() as address:
        opened(browser, address)  # The first visit creates the project that later visits open.
        measured = [opened(browser, address) for _ in range(OPENINGS)]
    first, again = (sorted(one[index] for one in measured) for index in (0, 1))
    print(f"page ready  {median_of(first, 'ready')} ms; again, from the cache,", end=" ")
    print(f"{median_of(again, 'ready')} ms (first paint {median_of(first, 'painted')} ms)")
    print(f"transferred {measured[0][0]['bytes'] / 1000:.0f} kB in", end=" ")
    print(f"{measured[0][0]['requests']} requests; again {measured[0][1]['bytes'] / 1000:.0f} kB")


def started() -> float:
    """Return the seconds from the command to the first answer."""
    began = perf_counter()
    with serving() as address, urllib.request.urlopen(address) as answer:  # noqa: S310
        answer.read()
        return perf_counter() - began


def opened(browser: Browser, address: str) -> "tuple[Figures, Figures]":
    """Open the page with an empty cache, and again."""
    with visitor(browser) as page:
        return ready(page, address), ready(page, address)


def ready(page: Page, address: str) -> "Figures":
    page.goto(f"{address}&test")
    return Figures(page.evaluate("measures.ready()"))


class Figures(dict[str, float]):
    """The measurements of one opening."""

    def __lt__(self, other: "Figures") -> bool:
        return self["ready"] < other["ready"]


def median_of(measured: "list[Figures]", name: str) -> str:
    return f"{statistics.median(one[name] for one in measured):.0f}"


# One program in three views.


def sync(browser: Browser) -> None:
    print(f"ms, medians of {ROUNDS}      ", *(f"{column:>9}" for column in COLUMNS))
    with serving() as address, visitor(browser) as page:
        page.goto(f"{address}&test")
        page.evaluate("measures.ready()")
        show_all_views(page)
        for size in SIZES:
            text, blocks = program(size)
            put_in(page, text)
            print_row(f"{blocks} blocks, a letter", [typed(page, turn) for turn in range(ROUNDS)])
            print_row(f"{blocks} blocks, a field", [filled(page, turn) for turn in range(ROUNDS)])


def program(size: int) -> tuple[str, int]:
    """Return a program of at least this many blocks, and their number."""
    smallest = count(HEAD + BODY + "end\n")
    each = count(HEAD + 2 * BODY + "end\n") - smallest
    times = 1 + max(0, -(-(size - smallest) // each))
    text = HEAD + times * BODY + "end\n"
    return text, count(text)


def count(text: str) -> int:
    """Count the blocks of a program, without the shadow blocks that show defaults."""
    return len(blocks(to_workspace(parse(text), builtin()).workspace))


def blocks(workspace: Workspace) -> list[str]:
    ahead = [block for stack in workspace.stacks for block in stack]
    for block in ahead:
        for plug in block.inputs.values():
            ahead += [*([plug.block] if plug.block else []), *plug.stack]
    return [block.id for block in ahead]


def show_all_views(page: Page) -> None:
    for name in ("Blocks", "Block-Text", "Python"):
        button = page.locator(".areas").get_by_role("button", name=name, exact=True)
        if button.get_attribute("aria-pressed") == "false":
            button.click()
    page.locator("[data-region=python] .cm-content").wait_for()


def put_in(page: Page, text: str) -> None:
    page.locator("[data-region=blocktext] .cm-content").click()
    page.keyboard.press("Control+a")
    page.evaluate("text => measures.paste(text)", text)
    turns = text.count("turn(90)")
    page.wait_for_function(
        "turns => document.querySelectorAll('.blocklyBlockCanvas .lb_skill_turn').length === turns",
        arg=turns,
    )
    page.wait_for_function("() => learnblock.context.program.settled")


def typed(page: Page, turn: int) -> "Sync":
    """Change a digit in Block-Text, and wait until blocks and Python show it."""
    put_cursor_behind_number(page)
    page.keyboard.press("Shift+ArrowLeft")
    digit = digit_of(turn)
    seen = [[NUMBER, digit], ["[data-region=python] .cm-content", f"sleep({digit})"]]
    return measured(page, seen, lambda: page.keyboard.press(digit))


def put_cursor_behind_number(page: Page) -> None:
    page.locator("[data-region=blocktext] .cm-content").focus()
    page.keyboard.press("Control+Home")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("End")
    page.keyboard.press("ArrowLeft")


def filled(page: Page, turn: int) -> "Sync":
    """Change a digit in a block, and wait until both texts show it."""
    page.locator(NUMBER).first.click()
    page.locator(".blocklyHtmlInput").wait_for()
    digit = digit_of(turn)
    seen = [
        [f"[data-region={view}] .cm-content", f"sleep({digit})"] for view in ("blocktext", "python")
    ]
    took = measured(page, seen, lambda: page.keyboard.press(digit))
    page.keyboard.press("Enter")
    page.wait_for_function("() => learnblock.context.program.settled")
    return took


def digit_of(turn: int) -> str:
    """Each repetition types a different digit."""
    return str(2 + turn % 8)


class Sync:
    """Return the ms from a key until the edit is visible, and how they were spent."""

    def __init__(self, figures: dict[str, float]) -> None:
        self.whole = figures["painted"] - figures["pressed"]
        self.sending = figures["sent"] - figures["pressed"]
        self.server = figures["answered"] - figures["sent"]
        self.showing = figures["shown"] - figures["answered"]
        self.painting = figures["painted"] - figures["shown"]


def measured(page: Page, seen: list[list[str]], act: Callable[[], None]) -> Sync:
    page.evaluate("seen => void measures.watch(seen)", seen)
    act()
    return Sync(page.wait_for_function("() => measures.seen").json_value())


def print_row(what: str, edits: list[Sync]) -> None:
    columns = [
        statistics.median(one.whole for one in edits),
        max(one.whole for one in edits),
        statistics.median(one.sending for one in edits),
        statistics.median(one.server for one in edits),
        statistics.median(one.showing for one in edits),
        statistics.median(one.painting for one in edits),
    ]
    print(f"{what:22}" + "".join(f"{time:10.0f}" for time in columns), flush=True)


# Drawing the world.


def drawing(browser: Browser) -> None:
    with serving() as address, visitor(browser) as page:
        page.goto(f"{address}&test")
        page.evaluate("measures.ready()")
        page.evaluate("learnblock.project.create('frames', 'avoid')")
        page.wait_for_url(re.compile("project=frames"))
        page.get_by_role("combobox", name="Robot").select_option(label="EBO")
        page.get_by_role("tab", name="Sensors").click()
        page.get_by_role("button", name="Robot camera").click()
        page.get_by_role("button", name="Run", exact=True).click()
        page.locator(".camera-place canvas, .camera-place img").first.wait_for()
        page.wait_for_function("() => learnblock.context.running.active.value")
        figures = page.evaluate("duration => measures.frames(duration)", WATCHED)
    print(f"3D view     {figures['drawn']:.1f} pictures a second with plots and camera,", end=" ")
    print(f"of {figures['display']:.1f} of the display; longest gap {figures['gap']:.0f} ms")


# The setup.


@contextmanager
def serving() -> Iterator[str]:
    """Return the address of a server with an empty home folder."""
    with tempfile.TemporaryDirectory() as home:
        command = [sys.executable, "-m", "learnblock", "--no-browser", "--port", "0"]
        environment = {**os.environ, "LEARNBLOCK_HOME": home}
        server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        try:
            assert server.stdout  # noqa: S101
            found = re.search(r"http://\S+", server.stdout.readline())
            assert found  # noqa: S101
            yield found[0]
        finally:
            server.terminate()
            server.wait()


@contextmanager
def visitor(browser: Browser) -> Iterator[Page]:
    """Open a page that has already shown the tour."""
    likes = json.dumps({"tourDone": True, "language": "en", "sound": False})
    context = browser.new_context(viewport={"width": 1800, "height": 900}, locale="en")
    context.set_default_timeout(TIMEOUT)
    context.add_init_script(f"localStorage['learnblock.preferences'] ??= {json.dumps(likes)}")
    context.add_init_script(path=GIVEN)
    try:
        yield context.new_page()
    finally:
        context.close()


@contextmanager
def chromium() -> Iterator[Browser]:
    found = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, args=["--no-sandbox", SOFTWARE])
        yield browser
        browser.close()


def main() -> None:
    wanted = sys.argv[1:] or list(PARTS)
    measures: dict[str, Callable[[Browser], Any]]
    measures = {"opening": opening, "sync": sync, "drawing": drawing}
    with chromium() as browser:
        print(f"Python {platform.python_version()}, Chromium {browser.version},", end=" ")
        print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
        for part in wanted:
            measures[part](browser)


if __name__ == "__main__":
    main()
