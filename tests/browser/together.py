"""A drill: three pages and an editor on disk change one program, over connections that fail.

    uv run python tests/browser/together.py --edits 3000 --seed 1

Each page types its own words, letter by letter and anywhere in the program, with up to half a
second of delay each way and cuts of the connection, and rests after a word until it is saved; the
editor inserts lines in the project's file. At the end, pages and file must hold the same program,
with each word in it or in the history.
"""

import argparse
import json
import random
import re
import sys
import tempfile
import time
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import expect, sync_playwright

if __name__ == "__main__":
    # pytest does this for its tests.
    sys.path[:0] = [str(Path(__file__).parents[1] / "helpers"), str(Path(__file__).parents[1])]

from browser.conftest import FAILURES, SOFTWARE_RENDERING, Server, chromium
from browser.jitter import Jitter
from browser.pupil import TIMEOUT, Pupil

PAGES = "abc"
#: Of so many words, the connection is cut once, and the editor on disk writes once.
CUT = 12
WRITTEN = 8
#: How often a word is typed in a line of its own; two in one line may be a conflict.
IN_NEW_LINE = 0.9
START = "main:\n    pass\nend\n"


@dataclass
class Outcome:
    """How a drill ended.

    Args:
        words: every word that was typed or written to the file.
        edits: the number of edits.
        texts: what each page and the file hold at the end.
        history: the programs of all versions.
    """

    words: tuple[str, ...]
    edits: int
    texts: tuple[str, ...]
    history: tuple[str, ...]

    @property
    def lost(self):
        """The words that are nowhere."""
        everything = "\n".join([*self.texts, *self.history])
        return [word for word in self.words if word not in everything]

    @property
    def is_equal(self):
        """Whether everybody has the same program."""
        return len(set(self.texts)) == 1

    def __str__(self):
        merged = sum(word in self.texts[0] for word in self.words)
        kept = len(self.words) - merged - len(self.lost)
        return (
            f"{self.edits} edits of {len(self.words)} words: {merged} in the program, {kept} in the"
            f" history of {len(self.history)} versions, {len(self.lost)} lost; "
            + ("all equal" if self.is_equal else "not equal")
        )


class Writer:
    """A page behind its own unreliable connection.

    Args:
        pupil: who types in the page.
        line: the connection.
        name: the first letter of its words.
    """

    def __init__(self, pupil, line, name):
        self.pupil = pupil
        self.line = line
        self.name = name
        self.words = []
        #: The keys of the current word that are not typed yet, the next one last.
        self._left = []

    def type(self, chance):
        """Type the next letter; after a word, begin another one elsewhere."""
        if not self._left:
            self._begin(chance)
        elif self.words[-1] and self.words[-1] not in self.text():
            # Another edit of this line has won, so the next letters would form a different word.
            self._left.clear()
            return
        key = self._left.pop()
        self.pupil.page.keyboard.press(key)
        if re.match(r"\w$", key):
            self.words[-1] += key

    def rests(self):
        """Whether it has typed a word that is not saved."""
        saved = self.pupil.page.locator("header .saved")
        return bool(self.words) and not self._left and saved.text_content() != "Saved"

    def finish(self, chance):
        """Type the rest of the word."""
        while self._left:
            self.type(chance)

    def text(self):
        """The whole text of the page, also what is scrolled out of sight."""
        return self.pupil.editor("blocktext").evaluate(
            "content => content.cmTile.view.state.doc.toString()"
        )

    def _begin(self, chance):
        """Go to the end of any line, and mostly begin a new one."""
        self.pupil.editor("blocktext").focus()
        keyboard = self.pupil.page.keyboard
        keyboard.press("Control+Home")
        for _ in range(chance.randrange(12)):
            keyboard.press("ArrowDown")
        keyboard.press("End")
        if chance.random() < IN_NEW_LINE:
            keyboard.press("Enter")
        word = f"{self.name}{len(self.words):03}word"
        self._left = ["#", " ", *word][::-1]
        self.words.append("")


class Editor:
    """A program on this machine that changes the file of a project.

    Args:
        file: the file.
    """

    def __init__(self, file):
        self._file = file
        self.words = []

    def write(self, chance):
        """Insert a line."""
        project = json.loads(self._file.read_text("utf-8"))
        word = f"d{len(self.words):03}word"
        at = chance.randrange(len(project["blocktext"]))
        project["blocktext"].insert(at, f"# {word}")
        new = self._file.with_suffix(".new")
        new.write_text(json.dumps(project), "utf-8")
        new.replace(self._file)
        self.words.append(word)

    def text(self):
        return "\n".join(json.loads(self._file.read_text("utf-8"))["blocktext"])


def drill(browser, folder, chance, edits):
    """Let everybody write; return how it ended."""
    server = Server(folder)
    with ExitStack() as stack:
        stack.callback(server.stop)
        writers = list(_writers(browser, server, chance, stack))
        editor = Editor(folder / "projects" / "program.learnblock")
        made = 0
        while made < edits:
            writer = chance.choice(writers)
            if writer.rests():
                writer.pupil.page.wait_for_timeout(10)
                continue
            writer.type(chance)
            made += 1
            if chance.randrange(CUT * 6) == 0:
                chance.choice(writers).line.cut()
            if chance.randrange(WRITTEN * 6) == 0:
                editor.write(chance)
        for writer in writers:
            writer.finish(chance)
        texts = _settled(writers, editor)
        words = [word for one in (*writers, editor) for word in one.words]
        return Outcome(tuple(words), made, texts, tuple(_history(folder)))


def _writers(browser, server, chance, stack):
    first = None
    for name in PAGES:
        line = stack.enter_context(Jitter(server.port, chance, 0))
        pupil = Pupil(browser, Behind(server, line), FAILURES, "together")
        stack.callback(pupil.context.close)
        if first is None:
            pupil.begin()
            pupil.write("blocktext", START)
            pupil.wait_until_saved()
            first = pupil.page.url
        else:
            pupil.page.goto(first.replace(_port(first), str(line.port)))
        pupil.show("Block-Text")
        pupil.sees("blocktext", "pass")
        line.longest = 0.5
        yield Writer(pupil, line, name)


class Behind:
    """A server as seen through a connection."""

    def __init__(self, server, line):
        self._server = server
        self._line = line

    def address_of_last_project(self):
        """Return the address of the project that was changed last, over the connection."""
        address = self._server.address_of_last_project()
        return address.replace(str(self._server.port), str(self._line.port))


def _port(address):
    return re.search(r":(\d+)/", address)[1]


def _settled(writers, editor):
    """Wait until everybody has the same program; return what each has."""
    for writer in writers:
        writer.line.longest = 0
    end = time.monotonic() + 60
    while True:
        for writer in writers:
            writer.pupil.wait_until_saved()
        texts = (*(writer.text() for writer in writers), editor.text())
        if len(set(texts)) == 1 or time.monotonic() > end:
            return texts
        writers[0].pupil.page.wait_for_timeout(200)


def _history(folder):
    for file in folder.glob("projects/.history/program/*.learnblock"):
        yield "\n".join(json.loads(file.read_text("utf-8"))["blocktext"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--edits", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    expect.set_options(timeout=TIMEOUT)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        chance = random.Random(options.seed)  # noqa: S311 - repeatable, not secret
        ended = drill(browser, Path(folder), chance, options.edits)
        browser.close()
    print(ended)  # noqa: T201 - the report
    sys.exit(1 if ended.lost or not ended.is_equal else 0)


if __name__ == "__main__":
    main()
