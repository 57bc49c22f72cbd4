"""A pupil who uses the page: reads the screen, clicks, drags and types."""

import json
import re
from contextlib import contextmanager
from urllib.parse import urlsplit

from playwright.sync_api import expect

#: Ms to wait for a condition, long enough for a busy computer, and for a program to end.
TIMEOUT = 60_000
LONGEST_RUN = 90_000
WORKSPACE = "[data-region=blocks] .blocklySvg > .blocklyWorkspace"
#: Notes the classes of each block that begins to run, however briefly it does.
NOTE_RUNNING = """program => {
    globalThis.ran = [];
    const note = ({ target }) => {
        if (target.classList.contains("lbRunning")) ran.push([...target.classList]);
    };
    const watcher = new MutationObserver((changes) => changes.forEach(note));
    watcher.observe(program, { subtree: true, attributeFilter: ["class"] });
}"""
HAVE_RUN = """kinds => {
    const left = [...kinds];
    for (const classes of ran) if (classes.includes(left[0])) left.shift();
    return left.length === 0;
}"""
#: Makes a browser that cannot draw in 3D.
FLAT = """{
    const all = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
        return kind.startsWith("webgl") ? null : all.call(this, kind, ...options);
    };
}"""
#: The commands of the page's menus, by the name of the menu's button.
MENUS = {
    "View and robot": (
        "Follow the robot",
        "Look around",
        "Manual control",
        "Place robot with keyboard",
        "Robot camera",
        "Shake robot",
        "Show distance sensor beams",
        "Show the whole world",
        "Tilt robot to the left",
        "View from above",
        "Where is the robot?",
    ),
    "World": ("Download world", "Edit world", "Reset world"),
}
#: The command of the project's menu that has the others, in each language.
MORE = re.compile("^(More…|Más…)$")
#: The menu of each of these commands.
MENU_OF = {command: menu for menu, commands in MENUS.items() for command in commands}
#: The positions of the speed's slider.
SPEEDS = ("0.1×", "0.25×", "0.5×", "1×", "2×", "5×", "10×", "20×", "Fastest")
#: What the tests' pupils see at first: all buttons, and two views of the program.
LAYOUT = {"split": True, "views": ["blocks", "blocktext"], "panel": True}
#: The heights of what covers the world's picture at the top and the bottom; the floor is centred
#: between them.
OVERLAYS = (56, 86)
#: The initial scale of the workspace; the measures below are at scale 1.
SCALE = 0.85
#: The first statement inside a hat and a loop, right of and below its corner.
FIRST_IN_HAT = (16, 66)
FIRST_IN_LOOP = (38, 56)


def box_of(part):
    """Return where a part of the page is, once it is drawn.

    A block is taken out and drawn again when the other views follow, and has no box meanwhile.
    """
    while (box := part.bounding_box()) is None:
        expect(part).to_be_visible()
    return box


class Pupil:
    """A user with their own browser, in which the page is open.

    Args:
        browser: the browser.
        server: the server of the page.
        artefacts: the folder for screenshots; None for none.
        test: the name of the test, used for its screenshots.
        tour: whether the first-run tour is shown.
        empty: whether the page opens a new, empty project instead of the last one.
        start: whether the page opens without a project, as newcomers see it.
        flat: whether the browser cannot draw in 3D, so that the page shows no picture of the world;
            without a graphics card that takes half of the time in which a page opens.
        options: options of the browser context, such as ``viewport`` or ``has_touch``.
    """

    def __init__(
        self,
        browser,
        server,
        artefacts,
        test,
        *,
        tour=False,
        empty=False,
        start=False,
        flat=False,
        stage="explorer",
        language="en",
        theme="light",
        **options,
    ):
        self.errors = []
        self.foreign = []
        self._pictures = artefacts and artefacts / re.sub(r"[^\w-]+", "-", test)
        options = {"viewport": {"width": 1366, "height": 768}, "locale": language, **options}
        self.context = browser.new_context(**options)
        self.context.set_default_timeout(TIMEOUT)
        if flat:
            self.context.add_init_script(FLAT)
        if not tour:
            layout = {"layout": LAYOUT} if stage == "explorer" and not start else {}
            likes = json.dumps(
                {
                    "tourDone": True,
                    "language": language,
                    "theme": theme,
                    "sound": False,
                    "stage": "starter" if start else stage,
                    **layout,
                }
            )
            self.context.add_init_script(
                f"localStorage['learnblock.preferences'] ??= {json.dumps(likes)}"
            )
        self._server = server
        if start:
            self.page = self.open_start()
            return
        self.page = self.open(server.address_of_new_project() if empty else None)
        if empty:
            expect(self.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas [data-id]")).to_have_count(
                1
            )

    def open(self, address=None):
        """Open a project in a new tab: the last one, or that of an address."""
        page = self._new_tab()
        page.goto(address or self._server.address_of_last_project())
        expect(page.locator("header .project-name")).not_to_have_text("…")
        return page

    def open_start(self):
        """Open the start page in a new tab."""
        page = self._new_tab()
        page.goto(self._server.address)
        expect(page.get_by_role("heading", level=1)).to_be_visible()
        return page

    def _new_tab(self):
        page = self.context.new_page()
        page.on("pageerror", lambda error: self.errors.append(error.stack or str(error)))
        page.on("request", self._note_foreign)
        return page

    def picture(self, name):
        """Save a screenshot, if there is a folder for it."""
        if self._pictures:
            self._pictures.mkdir(parents=True, exist_ok=True)
            self.page.screenshot(path=self._pictures / f"{name}.png")

    # Projects.

    def choose(self, what, name):
        """Choose a robot, a world or a speed."""
        if what == "Speed":
            self.page.get_by_role("slider", name=what).fill(str(SPEEDS.index(name)))
            return
        if what == "World":
            self.choose_world(name)
            return
        self.menu(what).click()
        self.page.get_by_role("menuitemradio", name=name, exact=True).click()

    def choose_world(self, name):
        """Choose a world in the gallery."""
        self.command("World", "All worlds…")
        self.dialog().get_by_role("searchbox").fill(name)
        title = self.page.locator("strong", has_text=re.compile(f"^{re.escape(name)}$"))
        self.dialog().locator("[data-world]").filter(has=title).click()

    def menu(self, name):
        """Return the button of a menu by its name, which may go on with the current choice."""
        return self.page.get_by_role("button", name=re.compile(f"^{name}(:|$)")).first

    def command(self, menu, name):
        """Choose a command of a menu."""
        self.menu(menu).click()
        self.page.locator("[role^=menuitem]").and_(self.page.get_by_label(name, exact=True)).click()

    def expect_chosen(self, what, name):
        """Wait until this robot or world is chosen."""
        expect(self.menu(what)).to_have_accessible_name(re.compile(rf"^{what}: {name}"))

    def begin(self, name="program"):
        """Begin an empty program."""
        with self._another_project():
            self.project("New…")
            self.answer(name)

    def project(self, command):
        """Choose a command of the project's menu."""
        self.page.locator("header .project-name").click()
        item = self.page.get_by_role("menuitem", name=command, exact=True)
        if item.count():
            item.click()
            return
        # What is rarely asked for.
        self.page.get_by_role("menuitem", name=MORE).click()
        self.page.get_by_role("dialog").get_by_role("button", name=command, exact=True).click()

    def share(self, way):
        """Share the project in one of the ways of the dialog."""
        self.page.get_by_role("banner").get_by_role("button", name="Share").click()
        self.dialog().get_by_role("button", name=re.compile(f"^{re.escape(way)}")).click()

    def open_example(self, title):
        """Open an example as a new project."""
        with self._another_project():
            self.project("Examples…")
            self.dialog().get_by_role("button", name=title).first.click()
        expect(self.dialog()).to_have_count(0)

    def add_robot(self, kind):
        """Add a robot, and wait until its empty program is shown."""
        self.command("Robot", "Add robots…")
        self.dialog().get_by_role("combobox", name="Robot").select_option(kind)
        self.dialog().get_by_role("button", name="Add").click()
        # The program shown before may be empty too.
        tabs = self.page.get_by_role("tablist", name="Robots").get_by_role("tab")
        expect(tabs.last).to_have_attribute("aria-selected", "true")
        self.sees("blocktext", "pass")

    def upload(self, file):
        """Upload a file, or several."""
        with self.page.expect_file_chooser() as chooser:
            self.project("Upload files…")
        chooser.value.set_files(file)

    @contextmanager
    def _another_project(self):
        before = self.name_of_project()
        yield
        expect(self.page.locator("header .project-name")).not_to_have_text(before)

    def name_of_project(self):
        """Return the name of the project in the bar."""
        return self.page.locator("header .project-name").text_content()

    def expect_project(self, name):
        """Wait until a project is open."""
        expect(self.page.locator("header .project-name")).to_have_text(name)

    def wait_until_saved(self):
        """Wait until the bar shows that the project is saved."""
        expect(self.page.locator("header .saved")).to_have_text("Saved")

    def expect_note(self, sentence):
        """Wait until a notification has this text; return it."""
        note = self.page.locator(".toast", has_text=sentence)
        expect(note).to_be_visible()
        return note

    def dialog(self):
        """Return the open dialog."""
        return self.page.get_by_role("dialog")

    # Texts.

    def put_in_world(self, thing, right=0, up=0):
        """Choose a thing in the world editor, and click on its plan, pixels from the middle."""
        editor = self.page.get_by_role("dialog")
        editor.get_by_role("button", name=thing, exact=True).click()
        box = box_of(editor.locator("svg.plan"))
        x, y = box["x"] + box["width"] / 2 + right, box["y"] + box["height"] / 2 - up
        self.page.mouse.click(x, y)

    def editor(self, view):
        """Return the element with the text of a text view."""
        return self.page.locator(f"[data-region={view}] .cm-content")

    def show(self, *views):
        """Show exactly these views of the program."""
        for name in ("Blocks", "Block-Text", "Python"):
            self._switch(name, wanted=name in views)

    def _switch(self, view, *, wanted):
        button = self.page.locator(".areas").get_by_role("button", name=view, exact=True)
        if (button.get_attribute("aria-pressed") == "true") != wanted:
            button.click()

    def write(self, view, text):
        """Replace the whole text of a view, as by pasting."""
        self.editor(view).click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(text)

    def sees(self, view, *lines):
        """Wait until a text view contains these lines or parts of lines."""
        for line in lines:
            expect(self.editor(view)).to_contain_text(line)

    def lacks(self, view, words):
        """Wait until a text view no longer contains these words."""
        expect(self.editor(view)).not_to_contain_text(words)

    def lines(self, view):
        """Return the elements of the lines of a text view."""
        return self.page.locator(f"[data-region={view}] .cm-line")

    def reads(self, view):
        """Return the lines that a text view shows now."""
        return self.lines(view).all_text_contents()

    def click_beside(self, view, line):
        """Click in the margin next to a line, where breakpoints are."""
        margin = self.page.locator(f"[data-region={view}] .cm-breakpoints .cm-gutterElement")
        # The first one keeps the margin open.
        margin.nth(line).click()

    def click_line_number(self, view, line):
        """Click the number of a line."""
        numbers = self.page.locator(f"[data-region={view}] .cm-lineNumbers .cm-gutterElement")
        numbers.get_by_text(str(line), exact=True).last.click()

    def put_cursor(self, view, word, occurrence=0):
        """Put the cursor before a word of a text."""
        before = self.text(view).split(word, occurrence + 1)
        before = word.join(before[: occurrence + 1]).split("\n")
        self.editor(view).focus()
        self.page.keyboard.press("Control+Home")
        self.press_keys("ArrowDown", len(before) - 1)
        self.press_keys("ArrowRight", len(before[-1]))

    def press_keys(self, key, times):
        """Press a key several times."""
        for _ in range(times):
            self.page.keyboard.press(key)

    def text(self, view):
        """Return the text that a text view shows now."""
        return "\n".join(self.reads(view))

    def expect_cursor(self, view, line, before):
        """Wait until the text cursor is on this line, after these words."""
        expect(self.editor(view)).to_be_focused()
        self.page.wait_for_function(
            """([line, before]) => {
                const at = getSelection();
                const lines = [...document.activeElement.querySelectorAll(".cm-line")];
                const found = lines.findIndex((one) => one.contains(at.focusNode));
                if (found + 1 !== line) return false;
                const range = document.createRange();
                range.setStart(lines[found], 0);
                range.setEnd(at.focusNode, at.focusOffset);
                return range.toString() === before;
            }""",
            arg=[line, before],
        )

    def expect_cursor_in(self, view, line):
        """Wait until the text cursor is on this line."""
        expect(self.editor(view)).to_be_focused()
        shown = self.editor(view).locator(f":nth-match(.cm-line, {line})")
        expect(shown).to_have_class(re.compile("cm-activeLine"))

    def line_of(self, view, words):
        """Return the number of the first line with these words."""
        return 1 + next(at for at, line in enumerate(self.reads(view)) if words in line)

    def scrolled(self, view):
        """Return the scroll position of a text in pixels."""
        return self.editor(view).evaluate("content => content.closest('.cm-scroller').scrollTop")

    # Blocks.

    def blocks(self, kind):
        """Return the blocks of a type in the program."""
        return self.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas .{kind}")

    def all_blocks(self):
        """Return all blocks of the program."""
        return self.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas .blocklyBlock")

    def open_category(self, category):
        """Open a group of the palette; a second click would close it."""
        row = self.page.locator(".blocklyToolboxCategory", has_text=re.compile(f"^{category}$"))
        if "blocklyToolboxSelected" not in row.get_attribute("class"):
            row.click()

    def groups(self):
        """Return the names of the palette's groups."""
        expect(self.page.locator(".lbGroupIcon").first).to_be_visible()
        return self.page.locator(".blocklyToolboxCategoryLabel:visible").all_text_contents()

    def search_blocks(self, words):
        """Search in the palette."""
        self.page.locator(".lbSearch").click()
        self.page.locator(".lbSearchHead input").fill(words)

    def show_more_blocks(self):
        """Show all blocks of the open group, if there are more."""
        more = self.page.locator(".blocklyFlyout:visible .lbMore")
        if more.count():
            self.scroll_to_offered(more)
            more.click()

    def take(self, category, kind, words="", to=None):
        """Drag the first block with these words out of the palette.

        Args:
            category: the group of the palette.
            kind: the type of the block.
            words: on the block.
            to: returns where to, once the palette is open; None for an empty spot.

        Returns:
            Its id.
        """
        self.open_category(category)
        offered = self.page.locator(f".blocklyFlyout .{kind}", has_text=words).first
        if not offered.count():
            self.show_more_blocks()
        self.scroll_to_offered(offered)
        known = self.block_ids()
        self._drag(offered, to() if to else self.empty_spot())
        expect(self.page.locator(f"{WORKSPACE} .blocklyDragging")).to_have_count(0)
        return next(one for one in self.block_ids() if one not in known)

    def make_variable(self, name):
        """Create a variable with the palette's button."""
        self.open_category("Variables")
        self.page.locator(".blocklyFlyoutButton").first.click()
        self.answer(name)

    def set_variable(self, name, value, to=None):
        """Take a block that sets a variable to a number; return its id."""
        block = self.take("Variables", "variables_set", to=to)
        self.choose_in(block, name)
        self.put_number(block, value)
        return block

    def put_number(self, block, value):
        """Plug a number into the first empty input of a block."""
        number = self.take("Maths", "math_number", to=lambda: self.on(self.hole(block)))
        self.fill(self.block(number), value)

    def choose_in(self, block, choice):
        """Choose a variable or an operator from a block's list."""
        self.block(block).locator("> .blocklyDropdownField").first.click()
        self.page.locator(".blocklyMenuItem", has_text=re.compile(rf"^\W*{choice}$")).click()

    def hole(self, block):
        """Return the first value input of a block, or the shadow block in it."""
        return self.block(block).locator("> .blocklyOutlinePath, > .blocklyShadow").first

    def scroll_to_offered(self, offered):
        """Scroll the palette until one of its blocks is visible."""
        offered.wait_for()
        palette = box_of(self.page.locator(".blocklyFlyout:visible"))
        self.page.mouse.move(palette["x"] + 20, palette["y"] + 20)
        beyond = box_of(offered)["y"] - palette["y"] - 0.5 * palette["height"]
        self.page.mouse.wheel(0, max(0, beyond))
        self.page.wait_for_function(
            "([block, low]) => block.getBoundingClientRect().bottom < low",
            arg=[offered.element_handle(), palette["y"] + palette["height"]],
        )

    def block(self, block):
        """Return a block by its id."""
        return self.page.locator(f'{WORKSPACE} > .blocklyBlockCanvas [data-id="{block}"]')

    def select_block(self, block):
        """Click a block near its left edge, where it has no field."""
        block.locator("> .blocklyPath").first.click(position={"x": 5, "y": 15})

    def put_into(self, block, hat):
        """Put a statement into a hat, as the first one."""
        self._drag(self.block(block), self.inside(hat))

    def put_into_loop(self, block, loop):
        """Put a statement into a loop, as the first one."""
        self._drag(self.block(block), self.inside_loop(loop))

    def put_below(self, block, above):
        """Put a statement below another."""
        self._drag(self.block(block), self.below(above))

    def put_on(self, block, value):
        """Plug in a value in place of another value or into an empty input."""
        self._drag(self.block(block), self.on(value))

    def empty_spot(self):
        """Return where no blocks are."""
        ground = box_of(self.page.locator(f"{WORKSPACE} .blocklyMainBackground"))
        return ground["x"] + 0.62 * ground["width"], ground["y"] + 60

    def inside(self, hat):
        """Return where the corner of the first statement in a hat is."""
        return self._corner(self.block(hat), *FIRST_IN_HAT)

    def inside_loop(self, loop):
        """Return where the corner of the first statement in a loop is."""
        return self._corner(self.block(loop), *FIRST_IN_LOOP)

    def below(self, above):
        """Return where the corner of the statement after another is."""
        path = box_of(self.block(above).locator("> .blocklyPath").first)
        return path["x"], path["y"] + path["height"] - 8 * SCALE

    def on(self, value):
        """Return where the corner of a value is that takes the place of another."""
        box = box_of(value)
        return box["x"] + 4, box["y"] + 4

    def fill(self, field, text):
        """Type into a field of a block."""
        self.click_on(field)
        self.page.keyboard.press("Control+a")
        self.page.keyboard.type(text)
        self.page.keyboard.press("Enter")

    def click_on(self, part):
        """Click on a part of a block, after scrolling to it."""
        self._scroll_program_to(part)
        part.click()

    def open_menu(self, block):
        """Open the menu of a block, after scrolling to it."""
        self._scroll_program_to(block)
        block.click(button="right", position={"x": 20, "y": 12})

    def _scroll_program_to(self, element):
        """Scroll the program to the right and down until one of its elements is visible."""
        ground = box_of(self.page.locator(f"{WORKSPACE} .blocklyMainBackground"))
        right, bottom = (ground["x"] + ground["width"] - 40, ground["y"] + ground["height"] - 40)
        box = box_of(element)
        across, down = box["x"] + box["width"] - right, box["y"] + box["height"] - bottom
        if across > 0 or down > 0:
            self.page.mouse.move(right, ground["y"] + 20)
            # A bit more: the wheel is measured in other pixels.
            self.page.mouse.wheel(*(beyond + 20 if beyond > 0 else 0 for beyond in (across, down)))
            self.page.wait_for_function(
                """([element, right, bottom]) => {
                    const box = element.getBoundingClientRect();
                    return box.right <= right && box.bottom <= bottom;
                }""",
                arg=[element.element_handle(), right, bottom],
            )

    def answer(self, text):
        """Type an answer into the open dialog."""
        field = self.page.locator("dialog[open] input:not([type=radio])")
        field.fill(text)
        field.press("Enter")

    def block_ids(self):
        """Return the ids of all blocks that are shown, from top to bottom and left to right."""
        found = self.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas [data-id]:visible")
        return found.evaluate_all(
            """all => all
                .map((one) => ({ id: one.dataset.id, at: one.getBoundingClientRect() }))
                .sort((one, other) => one.at.y - other.at.y || one.at.x - other.at.x)
                .map((one) => one.id)"""
        )

    def places_of_blocks(self):
        """Return the position of each block relative to its parent, by id."""
        found = self.page.locator(f"{WORKSPACE} > .blocklyBlockCanvas [data-id]")
        return found.evaluate_all(
            "all => Object.fromEntries(all.map("
            "  (one) => [one.dataset.id, one.getAttribute('transform')]))"
        )

    def _corner(self, block, right, down):
        box = box_of(block.locator("> .blocklyPath").first)
        return box["x"] + right * SCALE, box["y"] + down * SCALE

    def _drag(self, block, to):
        """Drag a block at its left edge, which has no field, until its corner is at `to`."""
        with self.dragging(block, to):
            pass

    @contextmanager
    def dragging(self, block, to):
        """Hold a block with its corner at `to` during the with statement."""
        box = box_of(block.locator("> .blocklyPath").first)
        grip = (6 * SCALE, min(20 * SCALE, box["height"] / 2))
        mouse = self.page.mouse
        mouse.move(box["x"] + grip[0], box["y"] + grip[1])
        mouse.down()
        for part in (0.2, 0.6, 1):
            mouse.move(
                box["x"] + grip[0] + part * (to[0] - box["x"]),
                box["y"] + grip[1] + part * (to[1] - box["y"]),
            )
        yield
        mouse.up()

    # The world.

    def where_is_the_robot(self):
        """Ask where the robot is; return the answer."""
        self.press("Where is the robot?")
        said = self.page.locator(".world-said").text_content()
        return re.search(r"\w+ at .*?, facing [a-z-]+", said)[0]

    def expect_robot(self, words):
        """Wait until the description of the world's picture matches these words."""
        picture = self.page.locator(".world-view canvas")
        expect(picture).to_have_attribute("aria-label", re.compile(words))

    def expect_view(self, name):
        """Wait until the world is seen in this way."""
        self.menu("View and robot").click()
        expect(self.page.get_by_role("menuitemradio", name=name)).to_be_checked()
        self.page.keyboard.press("Escape")

    def expect_switched(self, name, *, on):
        """Wait until a command of the menu for view and robot is on or off."""
        self.menu("View and robot").click()
        expect(self.page.get_by_role("menuitemcheckbox", name=name)).to_be_checked(checked=on)
        self.page.keyboard.press("Escape")

    def carry_robot(self, right, down):
        """Drag the robot from the middle of the floor, seen from above, by pixels."""
        picture = box_of(self.page.locator(".world-view canvas"))
        x = picture["x"] + picture["width"] / 2
        top, bottom = OVERLAYS
        y = picture["y"] + (top + picture["height"] - bottom) / 2
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move(x + right, y + down, steps=5)
        self.page.mouse.up()

    # Running.

    def note_running_blocks(self):
        """Note from now on which blocks run."""
        self.page.locator(WORKSPACE).evaluate(NOTE_RUNNING)

    def have_run(self, *kinds):
        """Wait until blocks of these types have run one after another."""
        self.page.wait_for_function(HAVE_RUN, arg=kinds)

    def wait_for_the_end(self):
        """Wait until the program has ended."""
        expect(self.page.get_by_role("button", name="Stop", exact=True)).to_be_disabled(
            timeout=LONGEST_RUN
        )

    def place_of_robot(self):
        """Ask where the robot is; return mm east and mm north."""
        self.press("Where is the robot?")
        return self.described_place()

    def described_place(self):
        """Return the last answer about the robot's position: mm east and mm north."""
        said = self.page.locator(".world-said").text_content()
        east, north = re.search(r"(\d+) mm (?:east|west), (\d+) mm (?:north|south)", said).groups()
        return (
            float(east) * (1 if "east," in said else -1),
            float(north) * (1 if "north," in said else -1),
        )

    def tab(self, name):
        """Open a tab of the output; return its panel."""
        self.page.get_by_role("tab", name=name).click()
        return self.page.get_by_role("tabpanel", name=name)

    def state(self, word):
        """Wait until the world shows this state, such as ``Running``."""
        expect(self._head()).to_contain_text(re.compile(word))

    def seconds(self):
        """Return the time of the world in seconds."""
        return float(re.search(r"([\d.]+) s", self._head().inner_text())[1])

    def seconds_at_rest(self):
        """Return the time of the world after it has not changed for a second."""
        self.page.wait_for_function(
            """head => {
              const now = performance.now();
              if (head.textContent !== window.restedAt?.text)
                window.restedAt = { text: head.textContent, since: now };
              return now - window.restedAt.since > 1000;
            }""",
            arg=self._head().element_handle(),
        )
        return self.seconds()

    def wait_until_later_than(self, seconds):
        """Wait until the time of the world is later than this."""
        self.page.wait_for_function(
            "([head, seconds]) => parseFloat(head.textContent.match(/([\\d.]+) s/)[1]) > seconds",
            arg=[self._head().element_handle(), seconds],
        )

    def run_to_the_end(self):
        """Run the program to its end."""
        begun = self.page.locator(".console-lines .run")
        before = begun.count()
        self.press("Run")
        # The last run has ended too, and this one may be over before anyone looks.
        expect(begun).to_have_count(before + 1)
        self.state("Ended")

    def trace_of_a_run(self):
        """Run the program to its end; return the hash of its trace."""
        self.run_to_the_end()
        return self.tab("Result").locator(".hash").text_content()

    def _head(self):
        return self.page.locator(".status .state").first

    def press(self, name):
        """Press a button, or choose a command of the world's menus, by its name."""
        if menu := MENU_OF.get(name):
            self.command(menu, name)
        else:
            self.page.get_by_role("button", name=name, exact=True).first.click()

    def _note_foreign(self, request):
        host = urlsplit(request.url).hostname
        if host not in (None, "127.0.0.1", "localhost"):
            self.foreign.append(request.url)
