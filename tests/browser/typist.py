"""A pupil without a mouse, who uses the keyboard and a screen reader."""

import re

from playwright.sync_api import expect

from browser.pupil import WORKSPACE

#: More steps than any part of the page has.
FAR = 60
#: The accessible name of the focused element, or of the active item of a list.
SPOKEN = """() => {
    const focused = document.activeElement;
    const item = document.getElementById(focused.getAttribute("aria-activedescendant"));
    const one = focused.getAttribute("role") === "listbox" && item ? item : focused;
    const words = (one.getAttribute("aria-labelledby") ?? "").split(" ").filter(Boolean);
    const labels = [...words.map((id) => document.getElementById(id)), one.labels?.[0]];
    const label = labels.map((label) => label?.querySelector("span") ?? label).find(Boolean);
    return (one.ariaLabel || (label ?? one).textContent).trim();
}"""
REGION = "document.activeElement.closest('[data-region]')?.dataset.region"
IN_TABS = "document.activeElement.closest('.blocklyToolbox') !== null"
BLOCKS = f"{WORKSPACE} > .blocklyBlockCanvas [data-id]"
PALETTE = ".blocklyFlyout:visible"


class Typist:
    """The keyboard of a pupil.

    Args:
        pupil: the pupil who types.
    """

    def __init__(self, pupil):
        self._pupil = pupil
        self._page = pupil.page

    def press(self, *keys):
        """Press keys one after another."""
        for key in keys:
            self._page.keyboard.press(key)

    def write(self, text):
        """Replace the text of the focused field, and press Enter."""
        self.press("Control+a")
        self._page.keyboard.type(text)
        self.press("Enter")

    def hears(self):
        """Return the accessible name of the focused element."""
        return self._page.evaluate(SPOKEN)

    def region(self):
        """Return the region of the page that has the focus."""
        return self._page.evaluate(REGION)

    def go_to(self, region):
        """Press F6 until a region has the focus."""
        for _ in range(FAR):
            if self.region() == region:
                return
            self.press("F6")
        raise AssertionError(f"F6 does not lead to {region}")

    def walk(self, key, name):
        """Press a key until the name of the focused element matches this."""
        heard = []
        for _ in range(FAR):
            heard.append(self.hears())
            if re.search(name, heard[-1]):
                return
            self.press(key)
        raise AssertionError(f"{key} does not lead to {name}, but to {heard}")

    # Projects and the bar.

    def begin(self):
        """Begin an empty program."""
        before = self._pupil.name_of_project()
        self.go_to("bar")
        self.walk("Tab", "^Project: ")
        self.press("Enter")
        expect(self._page.get_by_role("menuitem", name="New…", exact=True)).to_be_focused()
        self.press("Enter")
        expect(self._page.get_by_role("button", name="Start", exact=True)).to_be_focused()
        self.press("Enter")
        expect(self._page.locator("header .project-name")).not_to_have_text(before)
        expect(self._page.locator(BLOCKS)).to_have_count(1)

    def choose(self, what, letters):
        """Choose from a menu of the bar by the first letters of a name."""
        self.go_to("bar")
        self.walk("Tab", f"^{what}: ")
        self.press("Enter")
        self.walk("ArrowDown", f"^{letters}")
        self.press("Enter")

    def command(self, menu, name):
        """Choose a command of a menu of the world."""
        self.go_to("bar")
        self.go_to("world")
        self.walk("Tab", f"^{menu}$")
        self.press("Enter")
        self.walk("ArrowDown", f"^{name}")
        self.press("Enter")

    def speed(self, steps):
        """Move the slider of the speed by steps."""
        self.go_to("world")
        self.walk("Tab", "^Speed$")
        for _ in range(steps):
            self.press("ArrowRight")

    def switch(self, view):
        """Switch a view of the program on or off."""
        self.go_to("program")
        self.walk("Tab", f"^{view}$")
        self.press("Enter")

    # Blocks.

    def take(self, category, block):
        """Insert a block from the palette at the position that Blockly offers."""
        self.go_to_tabs()
        self.walk("ArrowDown", f"^{category}$")
        self.press("ArrowRight")
        self._insert(block)

    def find(self, words, block):
        """Insert a block found by the palette's search."""
        self.press("Control+b", "Control+a")
        self._page.keyboard.type(words)
        self.press("ArrowRight")
        self._insert(block)

    def go_to_tabs(self):
        """Move the focus to the tabs of the palette."""
        self.press("t")
        self._page.wait_for_function(IN_TABS)

    def _insert(self, block):
        self.walk("ArrowDown", block)
        self.press("Enter", "Enter")

    def make_variable(self, name):
        """Create a variable with the palette's button."""
        self.go_to_tabs()
        self.walk("ArrowDown", "^Variables$")
        self.press("ArrowRight")
        self.walk("ArrowDown", "^Create variable")
        self.press("Enter")
        expect(self._page.locator("dialog[open] input")).to_be_focused()
        self.write(name)
        expect(self._page.locator(PALETTE).get_by_text(name).first).to_be_visible()
        # Blockly moves the focus to the variable's first block as soon as the palette shows it.
        expect(self._page.locator(f"{PALETTE} .blocklyPath:focus")).to_have_count(1)
        self.press("Escape")
        expect(self._page.locator(PALETTE)).to_have_count(0)

    def choose_in(self, field, choice):
        """Choose from a list of the focused block or of a block inside it."""
        self.walk("ArrowRight", field)
        self.press("Enter")
        self.walk("ArrowDown", choice)
        self.press("Enter")

    def fill(self, number, field="^Edit .*number"):
        """Fill in the first number of the focused block."""
        self.walk("ArrowRight", field)
        self.press("Enter")
        self.write(number)
