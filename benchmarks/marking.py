"""Measure a teacher's way from thirty hand-ins to thirty that are handed back, in a browser.

    python benchmarks/marking.py [pupils]

Scripted pupils hand in a step of a lesson, a third each with a program that is right, too short and
never stops. A teacher in a browser checks them, gives each a mark and each third a note of her own,
and hands each back: with the keyboard, then in another class with the mouse. What is counted are
clicks, keys and the seconds that the page takes. What hands take besides is calculated for an
average typist (Card, Moran and Newell 1980); reading and thinking are not in it. The table of
results is compared with that of `learnblock grade`, byte for byte.
"""

import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from _browser import SIZE, TIMEOUT, chromium
from playwright.sync_api import Locator, Page, expect

from classes import Class, graded, hand_in, opened

LESSON, STEP = "1-01-first-drive", 2
PLACE = f"lesson={LESSON}&step={STEP}"
DRIVE = "main:\n    function.move_straight(40)\n    function.sleep({})\n{}end\n"
STOP = "    function.stop_bot()\n"
PROGRAMS = (DRIVE.format(5, STOP), DRIVE.format(1, STOP), DRIVE.format(5, ""))
NOTE, MARK = "Nearly! Look at the number again.", "8"
#: Seconds for a key, for pointing and clicking, and for a hand that goes to the mouse or back.
KEY, CLICK, MOVE = 0.28, 1.3, 0.4
#: Until all hand-ins are checked, in ms.
LONGEST_CHECK = 900_000


@dataclass
class Hands:
    """A teacher's hands.

    Args:
        page: what they use.
    """

    page: Page
    clicks: int = 0
    keys: int = 0
    moves: int = 0
    _at_mouse: bool = True

    def click(self, part: Locator) -> None:
        """Point at a part and click."""
        self._go(mouse=True)
        self.clicks += 1
        part.click()

    def type(self, text: str) -> None:
        """Type a text, letter by letter."""
        self._go(mouse=False)
        self.keys += len(text)
        self.page.keyboard.type(text)

    def press(self, *keys: str) -> None:
        """Press keys, together."""
        self._go(mouse=False)
        self.keys += len(keys)
        self.page.keyboard.press("+".join(keys))

    def _go(self, *, mouse: bool) -> None:
        self.moves += mouse != self._at_mouse
        self._at_mouse = mouse

    @property
    def seconds(self) -> float:
        """How long hands take for this."""
        return self.clicks * CLICK + self.keys * KEY + self.moves * MOVE


def join_and_hand_in(room: Class, number: int) -> None:
    """Join as a pupil, and hand in a program."""
    with room.pupil(f"Pupil {number}").page() as page:
        hand_in(page, LESSON, STEP, PROGRAMS[number % len(PROGRAMS)])


def check(hands: Hands, pupils: int) -> None:
    """Have the lesson's checks run on all hand-ins."""
    page = hands.page
    hands.click(page.get_by_role("link", name="Hand-ins"))
    expect(page.get_by_role("heading", name=f"To check · {pupils}")).to_be_visible(timeout=TIMEOUT)
    hands.click(page.get_by_role("button", name=f"Check {pupils}", exact=True))
    done = page.get_by_role("heading", name=f"To mark · {pupils}")
    expect(done).to_be_visible(timeout=LONGEST_CHECK)


def mark(hands: Hands, pupils: int, *, by_mouse: bool) -> None:
    """Give each a mark, and some a note, and hand each back."""
    page = hands.page
    answer = page.locator(".hand-in-answer")
    note, field = answer.locator("textarea"), answer.get_by_label("Your mark")
    hands.click(page.locator("button.hand-ins-line").first)
    for number in range(1, pupils + 1):
        expect(note).to_be_focused(timeout=TIMEOUT)
        shown = answer.locator("bdi").inner_text()
        if number % len(PROGRAMS) == 0:
            hands.type(NOTE)
        if by_mouse:
            hands.click(field)
            hands.type(MARK)
            hands.click(answer.get_by_role("button", name="Hand back"))
        else:
            hands.press("Tab")
            hands.type(MARK)
            hands.press("Control", "Enter")
        back = page.get_by_role("heading", name=f"Handed back · {number}", exact=True)
        expect(back).to_be_visible(timeout=TIMEOUT)
        if number < pupils:
            expect(answer.locator("bdi")).not_to_have_text(shown, timeout=TIMEOUT)


def measure(room: Class, page: Page, pupils: int, *, by_mouse: bool) -> None:
    """Print what one way takes, and whether both tables are the same."""
    begun = perf_counter()
    for number in range(1, pupils + 1):
        join_and_hand_in(room, number)
    handed_in = perf_counter()
    hands = Hands(page)
    page.goto(f"{room.address}/teacher?key={room.key}")
    check(hands, pupils)
    checked = perf_counter()
    mark(hands, pupils, by_mouse=by_mouse)
    marked = perf_counter()
    table = room.ask(f"/results.csv?{PLACE}&language=en", cookie=room.teacher()).body
    print(f"\nwith the {'mouse' if by_mouse else 'keyboard'}")
    print(
        f"  {pupils} pupils joined and handed in, one after the other  {handed_in - begun:6.1f} s"
    )
    print(f"  the page opened and all were checked  {checked - handed_in:6.1f} s")
    print(f"  all were marked and handed back: the page took  {marked - checked:6.1f} s")
    print(
        f"  the teacher's hands: {hands.clicks} clicks, {hands.keys} keys,"
        f" {hands.seconds / 60:.1f} min"
    )
    with tempfile.TemporaryDirectory() as out:
        is_same = table == graded(room, LESSON, STEP, out)
    print(
        f"  results.csv, {len(table)} bytes, is {'' if is_same else 'NOT '}that of learnblock grade"
    )


def main() -> None:
    pupils = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    with chromium() as browser:
        for by_mouse in (False, True):
            with tempfile.TemporaryDirectory() as home, opened(Path(home, "teacher")) as room:
                page = browser.new_page(viewport=SIZE, locale="en")
                page.set_default_timeout(TIMEOUT)
                measure(room, page, pupils, by_mouse=by_mouse)
                page.close()


if __name__ == "__main__":
    main()
