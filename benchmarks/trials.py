"""What a newcomer tries first, played by a script: the steps of a hand, and seconds.

    python benchmarks/trials.py [first-run] [number] [robot] [breakpoint] [spanish]

A step is a click or a key. The seconds are the page's and the robot's, without any thought: from
the address for the first run, which begins at the start page of a server without projects, and
from a page that is ready for all others. Each trial is played several times in a new browser
profile; the table shows the medians.

It needs a built page, Playwright and a Chromium (``CHROMIUM=/path/to/it``).
"""

import os
import platform
import re
import statistics
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

from _browser import SIZE, STARTED, chromium, serving, visitor
from playwright.sync_api import Browser, Page

GIVEN = Path(__file__).with_suffix(".js")
ROUNDS = 5
#: The robot has begun to move.
DRIVES = "() => learnblock.context.running.telemetry.value?.time > 0.2"
#: The robot has begun the first corner of the square, which it reaches only later with the number
#: that was there before, 5; a page may draw nothing for seconds while its first picture is made.
TURNS_EARLY = """() => {
    const now = learnblock.context.running.telemetry.value;
    return now && now.time < 5 && Math.abs(now.robots[0].heading) > 10;
}"""
BLOCKS = "[data-region=blocks] .blocklySvg > .blocklyWorkspace > .blocklyBlockCanvas"


@dataclass(frozen=True)
class Trial:
    """What is tried.

    Attributes:
        goal: what the newcomer wants, and has at the end.
        play: does it, and waits until it can be seen.
        project: whether the page begins with a project instead of the start page.
    """

    goal: str
    play: Callable[[Page], None]
    project: bool = True


@dataclass(frozen=True)
class Played:
    """What a trial took: clicks, keys, and seconds."""

    clicks: int
    keys: int
    seconds: float


def first_run(page: Page) -> None:
    page.get_by_role("button", name="Try it").click()
    page.wait_for_function(DRIVES)


def number(page: Page) -> None:
    page.locator(f"{BLOCKS} .lb_skill_sleep > .blocklyShadow").first.click()
    for key in ("Control+a", "1", "Enter"):
        page.keyboard.press(key)
    page.get_by_role("button", name="Run", exact=True).click()
    page.wait_for_function(TURNS_EARLY)


def robot(page: Page) -> None:
    page.get_by_role("button", name=re.compile("^Robot:")).click()
    page.get_by_role("menuitemradio", name="Thymio II", exact=True).click()
    page.get_by_role("img", name=re.compile("Thymio II at")).wait_for()


def breakpoint_(page: Page) -> None:
    page.get_by_role("button", name="Block-Text", exact=True).click()
    numbers = page.locator("[data-region=blocktext] .cm-lineNumbers .cm-gutterElement")
    numbers.get_by_text("9", exact=True).click()
    page.get_by_role("button", name="Run", exact=True).click()
    page.locator(".status", has_text="Paused at breakpoint").wait_for()


def spanish(page: Page) -> None:
    page.get_by_role("button", name="Settings and help").click()
    page.get_by_role("menuitemradio", name="Español").click()
    page.locator(BLOCKS, has_text="al pulsar Ejecutar").wait_for()


TRIALS = {
    "first-run": Trial("a program drives the robot", first_run, project=False),
    "number": Trial("a changed number shows in the run", number),
    "robot": Trial("another robot stands in the world", robot),
    "breakpoint": Trial("the program waits at a breakpoint", breakpoint_),
    "spanish": Trial("page and blocks are in Spanish", spanish),
}


def played(browser: Browser, trial: Trial) -> Played:
    """Play a trial once, on a server and in a profile of its own."""
    with (
        serving(started=trial.project) as address,
        visitor(browser, GIVEN, SIZE, layout=None) as page,
    ):
        place = f"#project={STARTED}" if trial.project else ""
        began = perf_counter()
        page.goto(f"{address}&test{place}")
        if trial.project:
            page.locator(f"{BLOCKS} .blocklyDraggable").first.wait_for()
            page.wait_for_function("() => learnblock.context.running.scene.value")
            began = perf_counter()
        trial.play(page)
        seconds = perf_counter() - began
        steps = page.evaluate("steps")
        return Played(steps["clicks"], steps["keys"], seconds)


def print_row(trial: Trial, rounds: list[Played]) -> None:
    clicks, keys = (statistics.median(column) for column in zip(*counts(rounds), strict=True))
    seconds = [one.seconds for one in rounds]
    print(f"{trial.goal:36}{clicks:7.0f}{keys:6.0f}", end="")
    print(f"{statistics.median(seconds):10.1f}{max(seconds):8.1f}", flush=True)


def counts(rounds: list[Played]) -> list[tuple[int, int]]:
    return [(one.clicks, one.keys) for one in rounds]


def main() -> None:
    wanted = sys.argv[1:] or list(TRIALS)
    with chromium() as browser:
        print(f"Python {platform.python_version()}, Chromium {browser.version},", end=" ")
        print(f"{os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
        print(f"{f'medians of {ROUNDS}':36}{'clicks':>7}{'keys':>6}{'seconds':>10}{'worst':>8}")
        for name in wanted:
            print_row(TRIALS[name], [played(browser, TRIALS[name]) for _ in range(ROUNDS)])


if __name__ == "__main__":
    main()
