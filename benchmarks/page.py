"""Measure the page: opening it, showing an edit in all three views, drawing the world, typing.

    python benchmarks/page.py [opening] [sync] [drawing] [typing]

It needs a built page, Playwright and a Chromium (``CHROMIUM=/path/to/it``).
"""

import os
import platform
import re
import statistics
import sys
import urllib.request
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Any

from _browser import SIZE, SPLIT, STARTED, Processors, chromium, serving, visitor
from large import created
from large import program as functions
from playwright.sync_api import Browser, Page

from learnblock.blocks import builtin
from learnblock.language import Workspace, parse, to_workspace

GIVEN = Path(__file__).with_suffix(".js")
SIZES = (100, 1000, 5000)
ROUNDS = 20
OPENINGS = 5
STARTS = 5
#: The time in which frames are counted, in ms.
WATCHED = 8000
#: Runs in which pictures are counted.
RUNS = 3
#: Lines of the program in which is typed, letters, and ms from letter to letter.
LINES, LETTERS, PAUSE = 1000, 100, 120
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
PARTS = ("opening", "sync", "drawing", "typing")
#: What the page is measured with, besides the newcomer's page: everything that moves.
ALL_VIEWS = {**SPLIT, "views": ["blocks", "blocktext", "python"]}
BUSY = {"split": False, "views": ["blocks"], "view": "blocks", "panel": True, "camera": True}


# Opening the page.


def opening(browser: Browser) -> None:
    starts = [started() for _ in range(STARTS)]
    print(f"server      {statistics.median(starts):.2f} s until the first answer")
    for name, place in (("start page", ""), ("project", f"#project={STARTED}")):
        with serving() as address:
            measured = [opened(browser, f"{address}&test{place}") for _ in range(OPENINGS)]
        first, again = ([one[index] for one in measured] for index in (0, 1))
        print(f"{name:11} ready in {median_of(first, 'ready')} ms", end=" ")
        print(f"(first paint {median_of(first, 'painted')} ms),", end=" ")
        print(f"again, from the cache, in {median_of(again, 'ready')} ms;", end=" ")
        came, kept = median_of(first, "bytes", 1000), median_of(again, "bytes", 1000)
        print(f"transferred {came} kB in {median_of(first, 'requests')} requests, again {kept} kB")


def started() -> float:
    """Return the seconds from the command to the first answer."""
    began = perf_counter()
    with serving() as address, urllib.request.urlopen(address) as answer:  # noqa: S310
        answer.read()
        return perf_counter() - began


def opened(browser: Browser, address: str) -> "tuple[Figures, Figures]":
    """Open the page with an empty cache, and again in a new tab."""
    with visitor(browser, GIVEN, SIZE, layout=None) as page:
        first = ready(page, address)
        page.goto("about:blank")
        return first, ready(page, address)


def ready(page: Page, address: str) -> "Figures":
    page.goto(address)
    figures = Figures(page.evaluate("measures.ready()"))
    page.wait_for_load_state("networkidle")
    return figures | page.evaluate("measures.transferred()")


Figures = dict[str, float]


def median_of(measured: list[Figures], name: str, unit: float = 1) -> str:
    return f"{statistics.median(one[name] for one in measured) / unit:.0f}"


# One program in three views.


def sync(browser: Browser) -> None:
    print(f"ms, medians of {ROUNDS}      ", *(f"{column:>9}" for column in COLUMNS))
    with serving() as address, visitor(browser, GIVEN, layout=ALL_VIEWS) as page:
        page.goto(f"{address}&test#project={STARTED}")
        page.evaluate("measures.ready()")
        page.locator("[data-region=python] .cm-content").wait_for()
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


def put_in(page: Page, text: str) -> None:
    page.locator("[data-region=blocktext] .cm-content").click()
    page.keyboard.press("Control+a")
    page.evaluate("text => measures.paste(text)", text)
    turns = text.count("turn(90)")
    page.wait_for_function("turns => measures.hasTurns(turns)", arg=turns)
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
    layouts = {"alone": None, "with camera and sensors": BUSY}
    for name, layout in layouts.items():
        with serving() as address, visitor(browser, GIVEN, SIZE, layout) as page:
            page.goto(f"{address}&test#project={STARTED}")
            page.evaluate("measures.ready()")
            page.evaluate("learnblock.project.create('frames', 'avoid')")
            page.wait_for_url(re.compile("project=frames"))
            choose_robot(page, "EBO")
            if layout:
                page.evaluate("learnblock.views.showPanel('sensors')")
            runs = [watched(page) for _ in range(RUNS)]
        print_drawing(name, runs)


def choose_robot(page: Page, name: str) -> None:
    page.get_by_role("button", name=re.compile("^Robot:")).click()
    page.get_by_role("menuitemradio", name=name, exact=True).click()


def watched(page: Page) -> Figures:
    """Run the program, and count pictures and processor time while it runs."""
    page.get_by_role("button", name="Run", exact=True).click()
    page.wait_for_function("() => learnblock.context.running.telemetry.value?.time > 1")
    processors = Processors()
    figures = Figures(page.evaluate("duration => measures.frames(duration)", WATCHED))
    figures |= {"browser": processors.cores("chrom"), "server": processors.cores("learnblock")}
    page.get_by_role("button", name="Stop", exact=True).click()
    page.wait_for_function("() => !learnblock.context.running.active.value")
    return figures


def print_drawing(name: str, runs: list[Figures]) -> None:
    found = {key: statistics.median(run[key] for run in runs) for key in runs[0]}
    print(f"world       {name}: {found['drawn']:.1f} pictures a second", end=" ")
    print(f"of {found['display']:.1f} of the display, longest gap {found['gap']:.0f} ms;", end=" ")
    print(f"browser {found['browser']:.2f} cores, server {found['server']:.2f}", end=" ")
    print(f"(load {os.getloadavg()[0]:.1f})", flush=True)


# Typing while a program runs.


def typing(browser: Browser) -> None:
    with serving() as address, visitor(browser, GIVEN, SIZE) as page:
        page.goto(f"{address}&test#project={STARTED}")
        page.evaluate("measures.ready()")
        created(page, "long", functions(LINES))
        page.get_by_role("button", name="Run", exact=True).click()
        page.wait_for_function("() => learnblock.context.running.active.value")
        page.locator("[data-region=blocktext] .cm-content").focus()
        for key in ("Control+Home", "ArrowDown", "End", "Enter"):
            page.keyboard.press(key)
        page.evaluate("() => measures.watchKeys()")
        page.keyboard.type(("x = x + 12345\n" * LETTERS)[:LETTERS], delay=PAUSE)
        page.wait_for_function("count => measures.keys.length >= count", arg=LETTERS)
        keys = sorted(page.evaluate("() => measures.keys"))
        longest = page.evaluate("() => measures.longestTask()")
    print(f"typing      in {LINES} lines while a program runs:", end=" ")
    print(
        f"p95 {keys[int(0.95 * len(keys))]:.0f} ms, median {statistics.median(keys):.0f} ms",
        end=" ",
    )
    print(f"until painted; longest task {longest:.0f} ms (load {os.getloadavg()[0]:.1f})")


def main() -> None:
    wanted = sys.argv[1:] or list(PARTS)
    measures: dict[str, Callable[[Browser], Any]]
    measures = {"opening": opening, "sync": sync, "drawing": drawing, "typing": typing}
    with chromium() as browser:
        print(f"Python {platform.python_version()}, Chromium {browser.version},", end=" ")
        print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
        for part in wanted:
            measures[part](browser)


if __name__ == "__main__":
    main()
