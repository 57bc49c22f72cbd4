"""The random actions of a monkey test."""

from browser.pupil import WORKSPACE
from fuzz import NASTY, mutated, texts
from places import ROOT

PROGRAMS = texts(ROOT / "examples", "*.bt")
#: Sizes of the page in pixels; the usual one is the most frequent.
ROOMS = ((1366, 768), (1366, 768), (1920, 1080), (1000, 700), (420, 800))
WORDS = (
    "function.move_straight(100)\n", "function.turn_right()\n", "    x = 1\n", "if x > 3:\n",
    "end\n", "while True:\n", "when start:\n", "else:\n", "print(x)\n", "main:\n",
    "for i in range(3):\n", "def f():\n", "function.", "robot.", "input()", "función", "🤖",
    "(", "x", "1", ".", " ", "\n", '"', "#",
)  # fmt: skip
VALUES = ("", "0", "-1", "1e9", "12.5", "nan", "A name", "ñandú", "../x", "a" * 300, "<b>", "🤖")
KEYS = (
    "Escape", "Escape", "Enter", "Tab", "Tab", "Shift+Tab", "Space", "Delete", "Backspace",
    "Home", "End", "PageDown", "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight", "F1", "F2",
    "F4", "F6", "Shift+F6", "F7", "F8", "F9", "F10", "F12", "Control+Enter",
    "Control+Shift+Enter", "Control+z", "Control+y", "Control+Shift+z", "Control+a",
    "Control+c", "Control+x", "Control+v", "Control+f", "Control+i", "Control+o", "Control+s",
    "Control+Space", "Alt+Enter", "Shift+Alt+f", "t", "w", "m", "i", "d", "x", "c", "n", "b",
    "h", "+", "-", ",", ".", "p",
)  # fmt: skip
RUN_KEYS = ("Control+Enter", "Control+Enter", "Control+Shift+Enter", "F4", "F4", "F7", "F10")
FILES = (
    ("wave.bt", "main:\n    function.expressJoy()\nend\n"),
    ("wave.py", "from learnblock.client import *\n"),
    ("wave.learnblock", '{"learnblock": 1, "blocktext": ["main:", "    pass", "end"]}'),
    ("broken.learnblock", '{"learnblock": 1, "blocktext": [{}]'),
    ("holiday.jpg", "no program"),
)

#: The position and name of everything that can be clicked, in the order of the page.
CONTROLS = """() => {
    const wanted = "button, a[href], summary, input, textarea, [role=tab], [role=option],"
        + " [role=menuitem], [role=treeitem], [role=separator], [role=slider], [tabindex='0'],"
        + " .blocklyMenuItem, .blocklyFlyoutButton, .blocklyToolboxCategory, .blocklyIconGroup";
    const found = [];
    for (const one of document.querySelectorAll(wanted)) {
        const box = one.getBoundingClientRect();
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        const hit = box.width && document.elementFromPoint(x, y);
        if (!hit || !(one.contains(hit) || hit.contains(one))) continue;
        const name = one.ariaLabel || one.title || one.textContent || one.tagName;
        found.push({ x, y, name: name.trim().slice(0, 40) });
    }
    return found;
}"""
#: A point at the edge of each element that can be dragged.
GRIPS = """(wanted) => [...document.querySelectorAll(wanted)].map((one) => {
    const box = one.getBoundingClientRect();
    const [x, y] = [box.x + 5, box.y + Math.min(14, box.height / 2)];
    return { x, y, name: one.getAttribute("class") };
}).filter(({ x, y }) => x > 0 && y > 0 && x < innerWidth && y < innerHeight)"""
BLOCKS = f"{WORKSPACE} > .blocklyBlockCanvas .blocklyDraggable > .blocklyPath"
OFFERED = ".blocklyFlyout .blocklyDraggable > .blocklyPath"


class Monkey:
    """Performs random actions on a page.

    Args:
        pupil: the owner of the page.
        chance: the random numbers that choose the actions.
    """

    def __init__(self, pupil, chance):
        self.pupil = pupil
        self._chance = chance
        self._welcome(pupil.page)
        pupil.context.on("page", self._welcome)

    @property
    def _page(self):
        return self.pupil.page

    def next_act(self):
        """Choose the next action: a method of this class that describes what it did."""
        return self._chance.choices(tuple(WEIGHTS), tuple(WEIGHTS.values()))[0]

    # Clicks and keys.

    def click(self):
        controls = self._page.evaluate(CONTROLS)
        if not controls:
            return "nothing to click"
        at = self._chance.choice(controls)
        self._page.mouse.click(at["x"], at["y"])
        return at["name"]

    def click_anywhere(self):
        x, y = self._somewhere()
        button = self._chance.choice(("left", "left", "right"))
        self._page.mouse.click(x, y, button=button, click_count=self._chance.choice((1, 1, 2)))
        return f"{button} at {x:.0f}, {y:.0f}"

    def press(self):
        keys = self._chance.choices(KEYS, k=self._chance.randint(1, 4))
        return self._press_all(keys)

    def escape(self):
        return self._press_all(["Escape"] * self._chance.randint(1, 3))

    def _press_all(self, keys):
        for key in keys:
            self._page.keyboard.press(key)
        return " ".join(keys)

    def wheel(self):
        self._page.mouse.move(*self._somewhere())
        self._page.mouse.wheel(0, self._chance.choice((-400, 400, 1200)))
        return "turned"

    # Texts.

    def write(self):
        return self._replace_text(self._chance.choice(PROGRAMS))

    def write_rubbish(self):
        rubbish = mutated(self._chance.choice(PROGRAMS), PROGRAMS, self._chance)
        return self._replace_text(self._chance.choice((rubbish, self._chance.choice(NASTY))))

    def type(self):
        if not self._into_text():
            return "no text"
        words = self._chance.choices(WORDS, k=self._chance.randint(1, 3))
        for word in words:
            self._page.keyboard.insert_text(word)
        self._page.keyboard.type(self._chance.choice("xy=(1 "))
        return repr("".join(words))

    def _replace_text(self, text):
        if not self._into_text():
            return "no text"
        self._page.keyboard.press("Control+a")
        # A keyboard cannot type half a surrogate pair.
        self._page.keyboard.insert_text(text.encode("utf-8", "ignore").decode())
        return repr(text[:200])

    def _into_text(self):
        places = self._page.evaluate(GRIPS, ".cm-content .cm-line")
        if places:
            at = self._chance.choice(places)
            self._page.mouse.click(at["x"] + self._chance.randint(0, 200), at["y"])
        return bool(places)

    def fill(self):
        fields = self._page.evaluate(GRIPS, "input:not([type=file]), textarea")
        if not fields:
            return "no field"
        at = self._chance.choice(fields)
        value = self._chance.choice(VALUES)
        self._page.mouse.click(at["x"], at["y"])
        self._page.keyboard.press("Control+a")
        self._page.keyboard.insert_text(value)
        self._page.keyboard.press(self._chance.choice(("Enter", "Tab", "Escape")))
        return value[:20]

    # Dragging.

    def drag_block(self):
        return self._drag_one_of(BLOCKS)

    def take_block(self):
        rows = self._page.evaluate(GRIPS, ".blocklyToolboxCategory")
        if rows:
            row = self._chance.choice(rows)
            self._page.mouse.click(row["x"], row["y"])
        return self._drag_one_of(OFFERED)

    def _drag_one_of(self, wanted):
        grips = self._page.evaluate(GRIPS, wanted)
        if not grips:
            return "no block"
        at = self._chance.choice(grips)
        others = self._page.evaluate(GRIPS, BLOCKS)
        # Mostly to a position where it can connect.
        goal = self._chance.choice(others) if others and self._chance.random() < 0.6 else None
        to = (goal["x"], goal["y"] + 20) if goal else self._somewhere()
        self._drag((at["x"], at["y"]), to)
        return f"{at['name']} to {to[0]:.0f}, {to[1]:.0f}"

    def drag_anything(self):
        start, end = self._somewhere(), self._somewhere()
        self._drag(start, end)
        return f"{start[0]:.0f}, {start[1]:.0f} to {end[0]:.0f}, {end[1]:.0f}"

    def _drag(self, start, end):
        self._page.mouse.move(*start)
        self._page.mouse.down()
        self._page.mouse.move(*end, steps=self._chance.randint(2, 5))
        if self._chance.random() < 0.1:
            self._page.keyboard.press(self._chance.choice(KEYS))
        self._page.mouse.up()

    # The bar.

    def undo_or_redo(self):
        return self._press_all([self._chance.choice(("Control+z", "Control+z", "Control+y"))])

    def run_or_stop(self):
        if self._chance.random() < 0.3:
            return self._press_all([self._chance.choice(RUN_KEYS)])
        return self._click_one_of("#run button")

    def choose(self):
        if self._chance.random() < 0.5:
            speed = self._page.locator(".speed input:visible")
            if speed.count():
                position = self._chance.randrange(9)
                speed.fill(str(position))
                return f"speed {position}"
        lists = self._page.locator("select:visible:enabled")
        if not lists.count():
            return "no list"
        chosen = lists.nth(self._chance.randrange(lists.count()))
        options = chosen.locator("option")
        value = self._chance.randrange(max(1, options.count()))
        chosen.select_option(index=value, timeout=2000)
        return f"option {value}"

    def menu(self):
        menu = self._click_one_of(".menu > button")
        return f"{menu}: {self._click_one_of('[role^=menuitem]')}"

    def edit_world(self):
        self._click_one_of(".world-menu button")
        editor = self._click_one_of("[role=menuitem]")
        thing = self._click_one_of("dialog button")
        self._press_all(self._chance.choices(KEYS, k=3))
        return f"{editor}: {thing}"

    def _click_one_of(self, wanted):
        found = self._page.evaluate(GRIPS, wanted)
        if not found:
            return "nothing"
        at = self._chance.randrange(len(found))
        self._page.mouse.click(found[at]["x"] + 4, found[at]["y"])
        return f"{wanted} {at}"

    # Pages.

    def other_tab(self):
        tabs = self.pupil.context.pages
        if len(tabs) == 1:
            self._open_tab()
            return "opened"
        if self._chance.random() < 0.5:
            self._page.close()
        left = [tab for tab in self.pupil.context.pages if tab != self._page]
        self.pupil.page = left[0]
        self._page.bring_to_front()
        return f"the other of {len(tabs)}"

    def _open_tab(self):
        at_start = self._page.locator("header.start-bar").count()
        address = self._chance.choice((None, self._page.url))
        if at_start and address:
            self.pupil.page = self.pupil.open_start()
        else:
            self.pupil.page = self.pupil.open(address)

    def load_again(self):
        self._page.reload()
        return "the page"

    def go_back_or_forward(self):
        way = self._chance.choice(("Back", "Forward"))
        # Going beyond the history of our page would show another one.
        self._page.evaluate(f"navigation.canGo{way} && history.{way.lower()}()")
        return way

    def change_room(self):
        width, height = self._chance.choice(ROOMS)
        self._page.set_viewport_size({"width": width, "height": height})
        return f"{width} x {height}"

    def _welcome(self, page):
        page.on("filechooser", self._choose_file)
        page.on("dialog", lambda dialog: dialog.accept())

    def _choose_file(self, chooser):
        if chooser.element.get_attribute("webkitdirectory") is not None:
            chooser.set_files(ROOT / "examples")
            return
        name, text = self._chance.choice(FILES)
        chooser.set_files({"name": name, "mimeType": "text/plain", "buffer": text.encode()})

    def _somewhere(self):
        size = self._page.viewport_size
        return (
            self._chance.uniform(0, size["width"] - 1),
            self._chance.uniform(0, size["height"] - 1),
        )


#: The relative frequency of each action.
WEIGHTS = {
    Monkey.click: 30,
    Monkey.click_anywhere: 5,
    Monkey.press: 10,
    Monkey.escape: 8,
    Monkey.wheel: 2,
    Monkey.write: 5,
    Monkey.write_rubbish: 5,
    Monkey.type: 6,
    Monkey.fill: 4,
    Monkey.drag_block: 10,
    Monkey.take_block: 8,
    Monkey.drag_anything: 4,
    Monkey.undo_or_redo: 6,
    Monkey.run_or_stop: 10,
    Monkey.choose: 5,
    Monkey.menu: 6,
    Monkey.edit_world: 2,
    Monkey.other_tab: 1,
    Monkey.load_again: 0.5,
    Monkey.go_back_or_forward: 0.5,
    Monkey.change_room: 1,
}
