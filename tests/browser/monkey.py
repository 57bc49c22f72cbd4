"""A monkey test: random clicks, drags and keys, which the page must survive.

    uv run python tests/browser/monkey.py --seconds 600 --seed 1

It fails on an uncaught error, on an error in the page's console or the server's terminal, on a
request to a foreign host, and when the page stops answering: after every hundred actions a new
program is written, and its blocks and its Python must appear.
A seed chooses the actions; their effects also depend on the speed of the page.
"""

import argparse
import random
import re
import signal
import sys
import tempfile
import time
from collections import Counter, deque
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from playwright.sync_api import Error, expect, sync_playwright

if __name__ == "__main__":
    # pytest does this for its tests.
    TESTS = Path(__file__).parents[1]
    sys.path[:0] = [str(TESTS), str(TESTS / "helpers")]

from browser.acts import ROOMS, Monkey
from browser.conftest import FAILURES, SOFTWARE_RENDERING, Server, chromium
from browser.pupil import TIMEOUT, Pupil

#: Actions between two checks that the page still answers.
ROUND = 100
#: The longest time in seconds for an action or an answer of the page.
LONGEST = 120
#: The number of actions reported after a failure.
REPORTED = 30
#: The target disappeared before the action reached it, which is no failure.
GONE = re.compile(r"context was destroyed|Timeout 2000ms")
TROUBLE = re.compile(r"traceback|error|exception|never awaited", re.IGNORECASE)


class HungError(Exception):
    """The page no longer reacts."""


@dataclass
class Diary:
    """The actions of a monkey, and their result."""

    seed: int
    acts: Counter = field(default_factory=Counter)
    last: deque = field(default_factory=lambda: deque(maxlen=REPORTED))
    answers: int = 0
    failure: str | None = None

    def note(self, kind, what):
        """Record an action."""
        self.acts[kind] += 1
        self.last.append(f"{self.acts.total():5} {kind}: {what}")

    def __str__(self):
        counts = ", ".join(f"{kind} {count}" for kind, count in self.acts.most_common())
        report = f"seed {self.seed}: {self.acts.total()} acts, {self.answers} answers\n{counts}"
        return "\n".join((report, *self.last, self.failure)) if self.failure else report


class Watch:
    """Collects the errors of the page and the server.

    Args:
        pupil: the owner of the pages.
        log: the file to which the server writes.
    """

    def __init__(self, pupil, log):
        self._pupil = pupil
        self._log = log
        self._console = []
        pupil.context.on("console", self._hear)

    def check(self):
        """Raise AssertionError if there was an error."""
        server = self._log.read_text("utf-8")
        complaints = [*self._pupil.errors, *self._console, *self._pupil.foreign]
        if TROUBLE.search(server):
            complaints.append(server[-5000:])
        assert not complaints, "\n".join(complaints)

    def _hear(self, message):
        if message.type == "error":
            self._console.append(f"console: {message.text} ({message.location.get('url')})")


def run_monkey(browser, home, *, seed, seconds):
    """Let a monkey use a new page for some seconds; return its diary."""
    diary = Diary(seed)
    log = home / "log.txt"
    with log.open("w") as errors, _serving(home, errors) as server:
        pupil = Pupil(browser, server, FAILURES, f"monkey-{seed}")
        monkey = Monkey(pupil, random.Random(seed))  # noqa: S311 - repeatable, not secret
        try:
            _run_monkey(monkey, Watch(pupil, log), diary, seconds)
        except HungError as error:
            # Any request to a page that hangs would wait forever.
            diary.failure = repr(error)
            return diary
        except (AssertionError, Error) as error:
            diary.failure = f"{type(error).__name__}: {error}\nsee failure.png in {FAILURES}"
            pupil.picture("failure")
        pupil.context.close()
    return diary


def _run_monkey(monkey, watch, diary, seconds):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        _run_round(monkey, watch, diary, deadline)
        with _in_time("the page does not answer"):
            answers(monkey.pupil, 1000 + diary.acts.total())
        watch.check()
        diary.answers += 1


def _run_round(monkey, watch, diary, deadline):
    for _ in range(ROUND):
        if time.monotonic() > deadline:
            return
        act = monkey.next_act()
        with _in_time(f"{act.__name__} does not end"):
            diary.note(act.__name__, _outcome(act, monkey))
        watch.check()


def _outcome(act, monkey):
    try:
        return act(monkey)
    except Error as error:
        if not GONE.search(error.message):
            raise
        return "target gone"


def answers(pupil, number):
    """Write a new program in the page that a monkey left, and check that all views follow."""
    _tidy_up(pupil.page)
    before = pupil.name_of_project()
    pupil.page.locator("header .menu > button").first.click()
    # The first item of the menu begins a program, in any language.
    pupil.page.get_by_role("menuitem").first.click()
    # The name is preset, and the button that begins has the focus.
    expect(pupil.dialog().locator("button:focus")).to_be_visible()
    pupil.page.keyboard.press("Enter")
    expect(pupil.page.locator("header .project-name")).not_to_have_text(before)
    _show_all(pupil.page)
    # By keyboard: the monkey may have left no space to click.
    pupil.editor("blocktext").focus()
    pupil.page.keyboard.press("Control+a")
    pupil.page.keyboard.insert_text(f"main:\n    function.sleep({number})\nend\n")
    pupil.sees("python", f"sleep({number})")
    expect(pupil.blocks("lb_skill_sleep")).to_contain_text(str(number))


def _tidy_up(page):
    width, height = ROOMS[0]
    page.set_viewport_size({"width": width, "height": height})
    # Several menus and dialogs can be open on top of each other.
    for _ in range(5):
        page.keyboard.press("Escape")
    expect(page.locator("dialog[open]")).to_have_count(0)
    _come_back(page)


def _come_back(page):
    """Leave the start page, to which the monkey may have gone."""
    bar = page.locator("header.bar, header.start-bar")
    expect(bar).to_have_count(1)
    if page.locator("header.start-bar").count():
        page.locator(".start-hero button").first.click()
    # It has a name once the project is open.
    expect(page.locator("header .project-name")).not_to_have_text("…")


def _show_all(page):
    split = page.locator(".program-head > button[aria-pressed]")
    if split.get_attribute("aria-pressed") == "false":
        split.click()
    for button in page.locator(".areas button").all():
        if button.get_attribute("aria-pressed") == "false":
            button.click()


@contextmanager
def _serving(home, errors):
    server = Server(home, errors=errors)
    try:
        yield server
    finally:
        server.stop()


@contextmanager
def _in_time(otherwise):
    """Raise HungError after a while: Playwright waits forever for a page that hangs."""

    def hang(_signal, _frame):
        raise HungError(otherwise)

    signal.signal(signal.SIGALRM, hang)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)


def main():
    """Run a monkey test, and print its diary."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    expect.set_options(timeout=TIMEOUT)
    with tempfile.TemporaryDirectory() as home, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        diary = run_monkey(browser, Path(home), seed=options.seed, seconds=options.seconds)
        print(diary, flush=True)  # noqa: T201 - the report
        browser.close()
    raise SystemExit(diary.failure is not None)


if __name__ == "__main__":
    main()
