"""A drill: type, kill the browser, the server or both at a random moment, and open again.

    uv run python tests/browser/restarts.py --rounds 50 --seed 1

It counts the words that are missing afterwards: of those that the page had shown as saved, and of
those typed at least 0.2 s before the kill. Both must be none.
"""

import argparse
import json
import random
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Error, expect, sync_playwright

if __name__ == "__main__":
    # pytest does this for its tests.
    sys.path[:0] = [str(Path(__file__).parents[1] / "helpers"), str(Path(__file__).parents[1])]

from browser.conftest import SOFTWARE_RENDERING, Server
from browser.conftest import chromium as executable
from browser.pupil import LAYOUT, TIMEOUT

#: Shows the text in which the drill types.
LIKES = json.dumps({"tourDone": True, "language": "en", "layout": LAYOUT})
#: Seconds of typing that a crash may cost.
GRACE = 0.2
KINDS = ("browser", "server", "both")
PROGRAM = "[data-region=blocktext] .cm-content"
SAVED = f"""word => document.querySelector("header .saved").textContent === "Saved"
    && document.querySelector("{PROGRAM}").textContent.includes(word)"""


@dataclass
class Round:
    """What one round lost.

    Args:
        kind: what was killed.
        typed: how many words were typed.
        saved: how many of them were shown as saved.
        lost_saved: those that are missing although they were shown as saved.
        lost: those that are missing although they were typed some time before the kill.
    """

    kind: str
    typed: int
    saved: int
    lost_saved: tuple[str, ...]
    lost: tuple[str, ...]

    def __str__(self):
        lost = " ".join([*self.lost_saved, *self.lost]) or "nothing"
        return f"{self.kind:8} {self.typed:4} typed {self.saved:4} saved  lost: {lost}"


class Desk:
    """A browser that keeps its data, with the page open.

    Args:
        chromium: Playwright's type of browser.
        folder: the folder of its data.
        server: the server of the page.
    """

    def __init__(self, chromium, folder, server):
        self._chromium = chromium
        self._folder = folder
        self._server = server
        self.sit_down()

    def sit_down(self):
        """Start the browser, and open the page."""
        (self._folder / "SingletonLock").unlink(missing_ok=True)
        self._context = self._chromium.launch_persistent_context(
            self._folder, executable_path=executable(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        self._context.add_init_script(f"localStorage['learnblock.preferences'] ??= '{LIKES}'")
        self.page = self._context.pages[0]
        self.page.set_default_timeout(TIMEOUT)
        self.page.goto(self._server.address_of_last_project())
        expect(self.page.locator("header .saved")).to_have_text("Saved")
        expect(self.page.locator(PROGRAM)).not_to_have_text("")

    def kill(self):
        """Kill every process of the browser, as a crash would."""
        subprocess.run(["pkill", "-KILL", "-f", str(self._folder)], check=True)
        try:
            self._context.close()
        except Error:
            # It is gone already.
            return

    def leave(self):
        self._context.close()


def play(chromium, folder, chance, kinds):
    """Play a round for each of these kinds of crash; yield what each has lost."""
    server = Server(folder / "home")
    try:
        desk = Desk(chromium, folder / "browser", server)
        for number, kind in enumerate(kinds):
            yield _round(desk, server, chance, kind, f"n{number}w")
        desk.leave()
    finally:
        server.stop()


def _round(desk, server, chance, kind, prefix):
    typed, saved = _type(desk.page, prefix, chance)
    killed = time.monotonic()
    if kind != "server":
        desk.kill()
    if kind != "browser":
        server.kill()
        server.start()
    if kind != "server":
        desk.sit_down()
    missing = _missing(desk.page, typed)
    early = {word for word, moment in typed.items() if killed - moment > GRACE}
    return Round(
        kind,
        len(typed),
        len(saved),
        tuple(word for word in missing if word in saved),
        tuple(word for word in missing if word in early),
    )


def _type(page, prefix, chance):
    """Type words into a comment for up to three seconds.

    Returns:
        The words with the moment at which each was typed, and those shown as saved.
    """
    page.locator(PROGRAM).focus()
    page.keyboard.press("Control+Home")
    page.keyboard.insert_text("# ")
    typed, saved = {}, set()
    end = time.monotonic() + chance.uniform(0.05, 3)
    while time.monotonic() < end:
        word = f"{prefix}{len(typed)}x"
        page.keyboard.type(word + " ")
        typed[word] = time.monotonic()
        # The longest of these pauses is enough for a save.
        page.wait_for_timeout(chance.choice((0, 20, 300, 1500)))
        if page.evaluate(SAVED, word):
            saved.update(typed)
    page.keyboard.press("Enter")
    return typed, saved


def _missing(page, typed):
    """The words that do not come back; the words just before the kill may be missing."""
    *_, last = typed
    try:
        page.wait_for_function(SAVED, arg=last, timeout=5000)
    except Error:
        expect(page.locator("header .saved")).to_have_text("Saved")
    text = page.locator(PROGRAM).text_content()
    return [word for word in typed if word not in text]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    expect.set_options(timeout=TIMEOUT)
    chance = random.Random(options.seed)  # noqa: S311 - repeatable, not secret
    kinds = [chance.choice(KINDS) for _ in range(options.rounds)]
    rounds = []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        for one in play(playwright.chromium, Path(folder), chance, kinds):
            rounds.append(one)
            print(one, flush=True)  # noqa: T201 - the report
    saved = sum(len(one.lost_saved) for one in rounds)
    lost = sum(len(one.lost) for one in rounds)
    print(f"{len(rounds)} rounds lost {saved} saved words, {lost} older ones")  # noqa: T201
    sys.exit(1 if saved or lost else 0)


if __name__ == "__main__":
    main()
