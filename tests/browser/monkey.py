"""A monkey before the page: it clicks, drags and types at random, and the page must bear it.

    uv run python tests/browser/monkey.py --seconds 600 --seed 1

It fails on an uncaught error, on an error in the page's console, on an error that the server tells
its terminal, on a request to a foreign host, and when the page no longer answers: after every
hundred acts a program is begun and a text is written, and its blocks and its Python must follow.
A seed chooses the acts; what they meet also depends on how fast the page is.
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
    # pytest does it for its tests.
    sys.path.insert(0, str(Path(__file__).parents[1]))

from browser.acts import ROOMS, Monkey
from browser.conftest import ARTEFACTS, SOFTWARE_RENDERING, Server, chromium
from browser.pupil import PATIENCE, Pupil

#: Acts between two questions whether the page still answers.
ROUND = 100
#: Seconds in which an act, or an answer of the page, must be over.
LONGEST = 120
#: So many acts are told after a failure.
TOLD = 30
#: What the monkey wanted to touch was gone before it came to it, and was perhaps meant to.
GONE = re.compile(r"context was destroyed|Timeout 2000ms")
TROUBLE = re.compile(r"traceback|error|exception|never awaited", re.IGNORECASE)


class HungError(Exception):
    """The page takes no more acts."""


@dataclass
class Diary:
    """What a monkey did, and what came of it."""

    seed: int
    acts: Counter = field(default_factory=Counter)
    last: deque = field(default_factory=lambda: deque(maxlen=TOLD))
    answers: int = 0
    failure: str | None = None

    def note(self, kind, what):
        """Remember an act."""
        self.acts[kind] += 1
        self.last.append(f"{self.acts.total():5} {kind}: {what}")

    def __str__(self):
        counts = ", ".join(f"{kind} {count}" for kind, count in self.acts.most_common())
        told = f"seed {self.seed}: {self.acts.total()} acts, {self.answers} answers\n{counts}"
        return "\n".join((told, *self.last, self.failure)) if self.failure else told


class Watch:
    """Hears what the page and the server complain of.

    Args:
        pupil: whose pages.
        told: the file to which the server writes.
    """

    def __init__(self, pupil, told):
        self._pupil = pupil
        self._told = told
        self._console = []
        pupil.context.on("console", self._hear)

    def check(self):
        """Raises AssertionError if there has been a complaint."""
        server = self._told.read_text("utf-8")
        complaints = [*self._pupil.errors, *self._console, *self._pupil.foreign]
        if TROUBLE.search(server):
            complaints.append(server[-5000:])
        assert not complaints, "\n".join(complaints)

    def _hear(self, message):
        if message.type == "error":
            self._console.append(f"console: {message.text} ({message.location.get('url')})")


def live(browser, home, *, seed, seconds):
    """Let a monkey live for so many seconds before a page of its own; its diary."""
    diary = Diary(seed)
    told = home / "told.txt"
    with told.open("w") as errors, _serving(home, errors) as server:
        pupil = Pupil(browser, server, ARTEFACTS, f"monkey-{seed}")
        monkey = Monkey(pupil, random.Random(seed))  # noqa: S311 - repeatable, not secret
        try:
            _live(monkey, Watch(pupil, told), diary, seconds)
        except HungError as error:
            # Whoever asks such a page for anything waits for ever.
            diary.failure = repr(error)
            return diary
        except (AssertionError, Error) as error:
            diary.failure = f"{type(error).__name__}: {error}\nsee failure.png in {ARTEFACTS}"
            pupil.picture("failure")
        pupil.context.close()
    return diary


def _live(monkey, watch, diary, seconds):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        _live_a_round(monkey, watch, diary, deadline)
        with _in_time("the page does not answer"):
            answers(monkey.pupil, 1000 + diary.acts.total())
        watch.check()
        diary.answers += 1


def _live_a_round(monkey, watch, diary, deadline):
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
        return "in vain"


def answers(pupil, number):
    """Begin a program in the page as a monkey left it, and see that all its views follow."""
    _tidy_up(pupil.page)
    before = pupil.name_of_project()
    pupil.page.locator("header .menu > button").first.click()
    # In any language the first of the menu begins a program.
    pupil.page.get_by_role("menuitem").first.click()
    expect(pupil.page.locator("header .project-name")).not_to_have_text(before)
    _show_all(pupil.page)
    # By its key: the monkey may have left no room to click into.
    pupil.editor("blocktext").focus()
    pupil.page.keyboard.press("Control+a")
    pupil.page.keyboard.insert_text(f"main:\n    function.sleep({number})\nend\n")
    pupil.sees("python", f"sleep({number})")
    expect(pupil.blocks("lb_skill_sleep")).to_contain_text(str(number))


def _tidy_up(page):
    width, height = ROOMS[0]
    page.set_viewport_size({"width": width, "height": height})
    # What is open may lie over something else that is open.
    for _ in range(5):
        page.keyboard.press("Escape")
    expect(page.locator("dialog[open]")).to_have_count(0)


def _show_all(page):
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
    """Raises HungError after a while: Playwright waits for ever for a page that hangs."""

    def hang(_signal, _frame):
        raise HungError(otherwise)

    signal.signal(signal.SIGALRM, hang)
    signal.alarm(LONGEST)
    try:
        yield
    finally:
        signal.alarm(0)


def main():
    """Let a monkey live for as long as asked, and print its diary."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    expect.set_options(timeout=PATIENCE)
    with tempfile.TemporaryDirectory() as home, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        diary = live(browser, Path(home), seed=options.seed, seconds=options.seconds)
        print(diary, flush=True)  # noqa: T201 - its report
        browser.close()
    raise SystemExit(diary.failure is not None)


if __name__ == "__main__":
    main()
