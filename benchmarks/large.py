"""Measure the page with a large program: opening it, editing it, running it.

    python benchmarks/large.py [lines]

It needs a built page, Playwright and a Chromium (``CHROMIUM=/path/to/it``).
"""

import os
import platform
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from _browser import STARTED, chromium, serving, visitor
from playwright.sync_api import Page

GIVEN = Path(__file__).with_suffix(".js")
LINES = 5000
#: The time for which the program runs, in ms.
RUNNING = 10_000
#: The edits change the number on the second line, in the first statement of the first stack.
CANVAS = "[data-region=blocks] .blocklySvg > .blocklyWorkspace > .blocklyBlockCanvas"
NUMBER = f"{CANVAS} > g > .lb_skill_sleep > .blocklyShadow"
STATEMENT = "    function.sleep(1)\n"
FIRST = f"def first():\n{STATEMENT}end\n"
PART = """
def step_{number}(x):
    y = x + 2 * (x - 1)
    for i from 1 to 5:
        y = y + i
        if y > 3 and not function.is_front_obstacle(100):
            y += 1
            function.move_straight(advSpeed=x)
        elif y < -3:
            function.stop_bot()
        else:
            y = y - 1
        end
    end
    function.turn(90)
    function.sleep(0.1)
    if y > 100:
        y = 0
    end
    return y
end
"""
MAIN = """
main:
    first()
    repeat 1000:
        step_0(1)
    end
end
"""

Figures = dict[str, Any]


def program(lines: int) -> str:
    """Return a program with this number of lines or a few more."""
    ends = (FIRST + MAIN).count("\n")
    parts = -(-(lines - ends) // PART.count("\n"))
    return FIRST + "".join(PART.format(number=number) for number in range(parts)) + MAIN


def one_stack(lines: int) -> str:
    """Return a program of the same statements, all of them in one stack."""
    body = "".join(PART.splitlines(keepends=True)[2:-2])
    body = body.replace("(advSpeed=x)", "(advSpeed=9)").replace("x", "2")
    times = lines // body.count("\n")
    return f"main:\n{STATEMENT}{body * times}end\n"


def created(page: Page, name: str, text: str) -> None:
    """Create a project with this program, and wait until it is saved."""
    before = page.evaluate("() => learnblock.context.program.state.value.blocktext")
    page.evaluate("name => learnblock.project.create(name, 'avoid')", name)
    page.wait_for_function(
        "before => learnblock.context.program.state.value.blocktext !== before", arg=before
    )
    page.evaluate("text => learnblock.context.program.editedText('blocktext', () => text)", text)
    page.wait_for_function("() => learnblock.context.program.settled")
    page.wait_for_function("() => learnblock.context.program.saved.value")


def opened(page: Page, address: str, name: str) -> Figures:
    page.goto(f"{address}&test#project={name}")
    page.evaluate("number => void (large.number = number)", NUMBER)
    return Figures(page.evaluate("() => large.opening()"))


def typed(page: Page) -> Figures:
    """Change the number on the second line of Block-Text."""
    page.locator("[data-region=blocktext] .cm-content").focus()
    for key in ("Control+Home", "ArrowDown", "End", "ArrowLeft", "Shift+ArrowLeft"):
        page.keyboard.press(key)
    return edited(page, "sleep(2)", lambda: page.keyboard.press("2"))


def filled(page: Page) -> Figures:
    """Change the same number in its block."""
    page.evaluate("() => learnblock.views.show('blocks')")
    page.evaluate(
        "number => learnblock.context.reveal(document.querySelector(number).dataset.id)", NUMBER
    )
    page.locator(NUMBER).first.click()
    page.locator(".blocklyHtmlInput").wait_for()
    found = edited(page, "sleep(3)", lambda: page.keyboard.press("3"))
    page.keyboard.press("Enter")
    page.wait_for_function("() => learnblock.context.program.settled")
    return found


def edited(page: Page, words: str, act: Callable[[], None]) -> Figures:
    page.evaluate("words => large.edited(words)", words)
    act()
    return Figures(page.wait_for_function("() => large.seen").json_value())


def ran(page: Page) -> Figures:
    """Run the program at 10 times for a while."""
    page.get_by_role("slider", name="Speed").fill("6")
    began = page.evaluate("() => large.now()")
    page.get_by_role("button", name="Run", exact=True).click()
    page.wait_for_function("() => learnblock.context.running.active.value")
    page.wait_for_timeout(RUNNING)
    page.get_by_role("button", name="Stop", exact=True).click()
    page.wait_for_function("() => !learnblock.context.running.active.value")
    return {"took": {}, "tasks": page.evaluate("began => large.rest(began)", began)}


def print_row(what: str, figures: Figures) -> None:
    took, tasks = figures["took"], figures["tasks"]
    columns = [f"{took[name] / 1000:9.1f}" if name in took else " " * 9 for name in SEEN]
    frozen = sum(1 for task in tasks if task > LONGEST)
    longest = ", ".join(f"{task / 1000:.2f}" for task in tasks[:3])
    print(f"{what:22}", *columns, f"{frozen:9}", f"  {longest}", flush=True)


SEEN = ("blocktext", "blocks")
#: ms for which the page may be frozen.
LONGEST = 200


def measure(page: Page, address: str, name: str, text: str) -> None:
    print(f"{name}: {text.count(chr(10))} lines")
    created(page, name, text)
    print_row("opened", opened(page, address, name))
    print_row("opened again", opened(page, address, name))
    print_row("a letter in the text", typed(page))
    print_row("a letter in a block", filled(page))
    print_row("a run at 10 times", ran(page))
    print_row("opened after the run", opened(page, address, name))


def main() -> None:
    lines = int(sys.argv[1]) if len(sys.argv) > 1 else LINES
    with chromium() as browser, serving() as address, visitor(browser, GIVEN) as page:
        print(f"Python {platform.python_version()}, Chromium {browser.version},", end=" ")
        print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}; seconds")
        print(f"{'':22}", *(f"{name:>9}" for name in SEEN), f"{'> 0.2 s':>9}", "  longest tasks")
        page.goto(f"{address}&test#project={STARTED}")
        page.wait_for_function("() => globalThis.learnblock?.context.program.state.value.blocktext")
        measure(page, address, "functions", program(lines))
        measure(page, address, "stack", one_stack(lines))


if __name__ == "__main__":
    main()
