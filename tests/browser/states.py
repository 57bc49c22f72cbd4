"""The states of the page, in walks that go from one to the next, in any language and size.

A walk yields the name of each state while the page shows it.
"""

import re
from functools import cache

from fluent.runtime import FluentBundle, FluentResource
from playwright.sync_api import expect

from places import ROOT

WORDS = ROOT / "src/learnblock/i18n"
WAITS = "main:\n    x = 1\n    function.sleep(600)\nend\n"
GAME = """main:
    function.change_score(3)
    function.drive_distance(400)
    function.win_game()
end
"""
ASKS = 'main:\n    x = input("Ready?")\nend\n'
WRONG = "main:\n    while\nend\n"
FAILS = "main:\n    x = 1 / 0\nend\n"
REACHES = "main:\n    function.drive_distance(800)\nend\n"
#: Blocks whose values have editors of their own.
EDITED = """\
main:
    function.play_note("C4", 1)
    function.RGBled(1, 2, 3, "first")
    function.turn(90)
    function.sleep(1)
end
"""
#: What can be asked for, from the timeline to the question why.
LOOKED_AT = """\
count = 0
def add(n):
    return n + 1
end
main:
    function.expressJoy()
    repeat 2:
        count = add(count)
        print(count)
        function.sleep(1)
    end
end
"""


class Visitor:
    """A pupil who finds everything by the code of its words.

    Args:
        pupil: the pupil.
        language: the language of the page.
    """

    def __init__(self, pupil, language="en"):
        self.pupil = pupil
        self.page = pupil.page
        self.language = language

    def says(self, code, **values):
        """Return the page's words for a code."""
        return words(self.language, code, **values)

    def button(self, code, inside=None, **values):
        """Return the first button with these words."""
        place = inside or self.page
        return place.get_by_role("button", name=self.says(code, **values), exact=True).first

    def press(self, code, inside=None, **values):
        """Press the first button with these words."""
        self.button(code, inside, **values).click()

    def open_menu(self, code):
        """Open a menu whose button may go on with the current choice."""
        name = re.compile(f"^{re.escape(self.says(code))}(:|$)")
        self.page.get_by_role("button", name=name).first.click()
        expect(self.page.get_by_role("menu")).to_be_visible()

    def command(self, menu, code):
        """Choose a command of a menu."""
        self.open_menu(menu)
        if code in RARE:
            more = self.says("page-project-more")
            self.page.get_by_role("menuitem", name=more, exact=True).click()
            self.dialog.get_by_role("button", name=self.says(code), exact=True).click()
            return
        item = self.page.locator("[role^=menuitem]").and_(
            self.page.get_by_label(self.says(code), exact=True)
        )
        item.click()

    @property
    def dialog(self):
        """The open dialog."""
        return self.page.get_by_role("dialog")

    def opens(self, menu, code):
        """Open a dialog by a command of a menu, and wait for it."""
        self.command(menu, code)
        expect(self.dialog).to_be_visible()

    def escape(self):
        """Leave a menu or a dialog by the keyboard."""
        self.page.keyboard.press("Escape")
        expect(self.dialog).to_have_count(0)
        expect(self.page.get_by_role("menu")).to_have_count(0)

    def shows_view(self, view):
        """Show one view of the program."""
        self.press(f"page-shell-{view}", self.page.locator(".areas"))

    def writes(self, text):
        """Show Block-Text with this program."""
        if not self.pupil.editor("blocktext").is_visible():
            self.shows_view("blocktext")
        self.pupil.write("blocktext", text)

    def is_in_state(self, state):
        """Wait until the world shows this state."""
        shown = self.page.locator(".status .state").first
        expect(shown).to_contain_text(self.says(f"page-bar-state-{state}"))

    def runs(self, text):
        """Write a program, and run it."""
        self.writes(text)
        self.press("page-bar-run")

    def stops(self):
        """Stop the program."""
        self.press("page-bar-stop")
        self.is_in_state("ended")


# The start page.


def start_page(visitor):
    """The start page of a newcomer, and its dialogs."""
    yield "start"
    visitor.open_menu("page-bar-language")
    yield "menu of languages"
    visitor.escape()
    visitor.press("page-lesson-cards-level-2")
    yield "lessons of another level"
    visitor.press("page-start-all-examples")
    yield "all examples"
    visitor.press("page-start-teachers")
    expect(visitor.button("page-start-teachers-grade-more")).to_be_visible()
    yield "for teachers"
    visitor.press("page-start-teachers-grade-more")
    expect(visitor.dialog).to_contain_text("results.csv")
    yield "grade a class"
    visitor.escape()
    visitor.press("page-start-home")
    visitor.press("page-start-new")
    expect(visitor.dialog).to_be_visible()
    yield "new project"
    visitor.escape()
    visitor.press("page-start-connect")
    expect(visitor.dialog).to_be_visible()
    yield "connect"
    visitor.escape()


def start_page_with_projects(visitor):
    """The start page with projects, and what can be done to one."""
    projects = visitor.page.get_by_role("region", name=visitor.says("page-start-projects"))
    expect(projects.get_by_role("listitem")).not_to_have_count(0)
    yield "start with projects"
    more = projects.locator("[aria-haspopup=menu]").first
    commands = {"page-project-rename": "rename", "page-start-copy": "copy"}
    for code, name in {**commands, "page-project-delete": "delete"}.items():
        more.click()
        expect(visitor.page.get_by_role("menu")).to_be_visible()
        if name == "rename":
            yield "menu of a project"
        visitor.page.get_by_role("menuitem", name=visitor.says(code), exact=True).click()
        expect(visitor.dialog).to_be_visible()
        yield f"{name} a project"
        visitor.escape()


# The working page.


def views(visitor):
    """Each view alone, and two or three side by side."""
    yield "blocks"
    visitor.page.locator(".blocklyToolboxCategory").nth(1).click()
    expect(visitor.page.locator(".blocklyFlyout:visible .blocklyPath").first).to_be_visible()
    yield "palette"
    for view in ("blocktext", "python"):
        visitor.shows_view(view)
        expect(visitor.pupil.editor(view)).to_be_visible()
        yield view
    split = visitor.button("page-shell-split")
    if split.count():
        split.click()
        yield "split"
        visitor.shows_view(
            "blocktext" if visitor.pupil.editor("blocktext").is_hidden() else "blocks"
        )
        yield "three views"
        split.click()


def menus(visitor):
    """Each menu of the working page."""
    for code, name in MENUS.items():
        visitor.open_menu(code)
        yield f"menu, {name}"
        visitor.escape()
    block = visitor.pupil.blocks("lb_main").locator("> .blocklyPath").first
    block.click(button="right", position={"x": 20, "y": 12})
    expect(visitor.page.locator(".blocklyContextMenu")).to_be_visible()
    yield "menu, block"
    visitor.page.keyboard.press("Escape")
    visitor.page.keyboard.press("Control+i")
    expect(visitor.page.locator(".lbHelp")).to_be_visible()
    yield "help of a block"
    visitor.page.keyboard.press("Escape")
    expect(visitor.page.locator(".lbHelp")).to_have_count(0)


def project_dialogs(visitor):
    """The dialogs of the project's menu."""
    for code, name in PROJECT_DIALOGS.items():
        visitor.opens("page-project-menu", code)
        yield f"dialog, {name}"
        visitor.escape()
    visitor.page.get_by_role("button", name=visitor.says("page-share-menu"), exact=True).click()
    expect(visitor.dialog.get_by_role("img", name=visitor.says("page-share-code"))).to_be_visible()
    yield "dialog, share"
    visitor.escape()


def page_dialogs(visitor):
    """The dialogs of the menu of the page."""
    visitor.command("page-bar-more", "page-bar-stage-coder")
    for code, name in PAGE_DIALOGS.items():
        visitor.opens("page-bar-more", code)
        yield f"dialog, {name}"
        visitor.escape()
    visitor.opens("page-bar-robot", "page-robots-robots-menu")
    expect(visitor.dialog.get_by_role("textbox").first).to_be_visible()
    yield "dialog, robot settings"
    visitor.escape()


def filled_dialogs(visitor):
    """Dialogs in which something was opened or added."""
    visitor.opens("page-project-menu", "page-sets-menu")
    visitor.dialog.locator("[aria-expanded=false]").first.click()
    yield "block set, blocks of a tab"
    visitor.press("page-sets-save-as", visitor.dialog)
    yield "block set, save as"
    visitor.escape()
    visitor.opens("page-project-menu", "page-tags-menu")
    visitor.press("page-tags-add", visitor.dialog)
    yield "tag names, added"
    visitor.escape()
    visitor.opens("page-project-menu", "page-libraries-menu")
    visitor.press("page-libraries-make", visitor.dialog)
    yield "libraries, create"
    visitor.escape()
    visitor.opens("page-project-menu", "page-custom-menu")
    visitor.press("page-custom-new", visitor.dialog)
    expect(visitor.dialog.locator(".cm-content").first).to_be_visible()
    yield "my blocks, new"
    for tab in ("try", "json"):
        visitor.dialog.get_by_role("tab", name=visitor.says(f"page-custom-tab-{tab}")).click()
        yield f"my blocks, {tab}"
    visitor.escape()


def gallery(visitor):
    """The worlds: all, those of a group, those with a word, and none."""
    visitor.opens("page-bar-world", "page-gallery-open")
    expect(visitor.dialog.locator("[data-world]").first).to_be_visible()
    yield "gallery"
    visitor.dialog.locator("[aria-pressed=false]").nth(3).click()
    yield "gallery, a group"
    visitor.dialog.locator("[aria-pressed=false]").first.click()
    visitor.dialog.get_by_role("searchbox").fill("2")
    yield "gallery, search"
    visitor.dialog.get_by_role("searchbox").fill("xyz")
    yield "gallery, nothing found"
    # The first Escape empties the search.
    visitor.page.keyboard.press("Escape")
    visitor.escape()


SORTS = ("wall", "tag", "line", "reach")


def world_editor(visitor):
    """The world editor, empty-handed and with things."""
    visitor.opens("page-bar-world", "page-bar-edit-world")
    expect(visitor.button("page-editor-sort-wall", visitor.dialog)).to_be_visible()
    yield "world editor"
    for code in (*(f"page-editor-sort-{sort}" for sort in SORTS), "page-world-kind-tree"):
        visitor.press(code, visitor.dialog)
        yield f"world editor, about to put {code}"
        visitor.page.keyboard.press("Enter")
        yield f"world editor, {code}"
    visitor.press("page-editor-sort-follow", visitor.dialog)
    yield "world editor, follow"
    visitor.press("page-editor-action-new", visitor.dialog)
    visitor.press("page-editor-template-maze", visitor.dialog)
    yield "world editor, template"
    visitor.page.keyboard.press("Escape")
    # The first Escape leaves the thing.
    visitor.page.keyboard.press("Escape")
    visitor.escape()
    visitor.opens("page-bar-world", "page-worlds-variant-choose")
    yield "dialog, variant"
    visitor.escape()


def connecting(visitor):
    """The dialog that finds robots, without any."""
    visitor.opens("page-bar-robot", "page-connect-menu")
    expect(visitor.dialog.get_by_role("listitem").first).to_be_visible()
    yield "connect, nothing found"
    visitor.press("page-connect-help-named", visitor.dialog, robot="Cozmo")
    yield "connect, help"
    visitor.press("page-connect-address", visitor.dialog)
    expect(visitor.dialog.get_by_role("combobox").first).to_be_visible()
    yield "connect, address"
    visitor.dialog.get_by_role("radio", name=visitor.says("page-connect-simulated")).check()
    yield "connect, simulated"
    visitor.escape()


def runs(visitor):
    """A program that runs, is paused, asks, fails and reaches its goal."""
    visitor.runs(WAITS)
    visitor.is_in_state("running")
    yield "running"
    show_output(visitor)
    for tab in ("variables", "sensors", "problems", "result"):
        open_tab(visitor, tab)
        yield f"running, {tab}"
    if visitor.button("page-bar-pause").count():
        visitor.press("page-bar-pause")
        visitor.is_in_state("paused")
        open_tab(visitor, "variables")
        yield "paused"
    visitor.stops()
    visitor.runs(ASKS)
    visitor.is_in_state("input")
    yield "asked"
    visitor.stops()
    show_output(visitor)
    open_tab(visitor, "result")
    yield "ended"


def editors(visitor):
    """What the fields of blocks open, the searches, and the suggestions of the texts."""
    visitor.writes(EDITED)
    visitor.shows_view("blocks")
    block = visitor.pupil.blocks
    fields = {
        "note": block("lb_skill_play_note").locator("> .lb_choice"),
        "colour": block("lb_skill_RGBled").locator("> .blocklyImageField").last,
        "menu": block("lb_skill_turn").locator("> .blocklyDropdownField"),
        "number": block("lb_skill_sleep").locator(".blocklyNumberField"),
    }
    for name, field in fields.items():
        expect(field.first).to_be_visible()
        visitor.pupil.click_on(field.first)
        editor = visitor.page.locator(
            ":is(.blocklyDropDownDiv, .blocklyWidgetDiv, .lbPanel):visible"
        )
        expect(editor.first).to_be_visible()
        yield f"editor, {name}"
        visitor.page.keyboard.press("Escape")
        expect(editor).to_have_count(0)
    visitor.page.locator(".lbSearch").click()
    visitor.page.locator(".lbSearchHead input").fill("a")
    yield "palette, search"
    visitor.page.keyboard.press("Escape")
    for view in ("blocktext", "python"):
        visitor.shows_view(view)
        visitor.pupil.editor(view).press("Control+f")
        expect(visitor.page.locator(".cm-search:visible")).to_have_count(1)
        yield f"{view}, search"
        visitor.page.keyboard.press("Escape")
        visitor.page.keyboard.press("Control+Space")
        expect(visitor.page.locator(".cm-tooltip-autocomplete")).to_be_visible()
        yield f"{view}, suggestions"
        visitor.page.keyboard.press("Escape")


def looking_back(visitor):
    """A run that has ended: its moments, calls and questions, and two runs compared."""
    for _ in range(2):
        visitor.runs(LOOKED_AT)
        visitor.is_in_state("ended")
    expect(
        visitor.page.get_by_role("slider", name=visitor.says("page-timeline-time"))
    ).to_be_visible()
    yield "timeline"
    show_output(visitor)
    for tab in ("console", "variables", "calls", "runs", "sensors", "result"):
        open_tab(visitor, tab)
        yield f"ended, {tab}"
    open_tab(visitor, "runs")
    for tick in visitor.page.locator(".run-row input[type=checkbox]").all():
        tick.check()
    visitor.press("page-runs-compare")
    expect(
        visitor.page.get_by_role("button", name=visitor.says("page-runs-compare-end"))
    ).to_be_visible()
    yield "two runs compared"
    open_tab(visitor, "why")
    yield "why, questions"
    visitor.page.get_by_role("tabpanel").locator("li button").first.click()
    expect(visitor.button("page-why-back")).to_be_visible()
    yield "why, answer"


def game(visitor):
    """The end of a game, and the replay of its last seconds."""
    visitor.runs(GAME)
    again = visitor.page.get_by_role("region", name=visitor.says("page-world-game-won"))
    expect(again).to_be_visible()
    yield "end of a game"
    visitor.press("page-world-game-watch", again)
    expect(visitor.button("page-world-replay-stop")).to_be_focused()
    yield "replay of a game"
    visitor.press("page-world-replay-stop")
    expect(again).to_be_visible()


def robots(visitor):
    """Several robots: adding, naming and counting them."""
    visitor.command("page-bar-robot", "page-tabs-add-menu")
    expect(visitor.dialog).to_be_visible()
    yield "add robots"
    visitor.press("page-tabs-add-action", visitor.dialog)
    tabs = visitor.page.get_by_role("tablist", name=visitor.says("page-tabs-label")).get_by_role(
        "tab"
    )
    expect(tabs).to_have_count(2)
    yield "two robots"
    visitor.page.locator(".robot-tabs > button").first.click()
    expect(visitor.dialog).to_be_visible()
    yield "rename a robot"
    visitor.escape()


def lesson(visitor):
    """A lesson from its card to its stars, and its teacher's editor."""
    visitor.press("page-lesson-cards-level-1")
    card = visitor.page.locator(".lesson-card", has_text="10 min")
    expect(card).to_be_visible()
    yield "lessons"
    card.locator("[aria-haspopup=menu]").click()
    expect(visitor.page.get_by_role("menu")).to_be_visible()
    yield "menu of a lesson"
    visitor.escape()
    card.get_by_role("button").first.click()
    pane = visitor.page.locator("[data-region=lesson]")
    expect(pane).to_be_visible()
    if "lesson-line" in pane.get_attribute("class"):
        yield "lesson, one line"
        pane.get_by_role("button").first.click()
        pane = visitor.dialog
    expect(pane.get_by_role("radio").first).to_be_visible()
    yield "lesson, question"
    pane.get_by_role("radio").first.check()
    visitor.press("page-lesson-answer", pane)
    expect(pane.locator(".lesson-stars").first).to_have_attribute("aria-label", re.compile("^1"))
    yield "lesson, right"


def mistakes(visitor):
    """A program with mistakes, and one that an error stops."""
    visitor.writes(WRONG)
    expect(visitor.page.locator(".stale-note")).to_be_visible()
    yield "mistake"
    show_output(visitor)
    open_tab(visitor, "problems")
    yield "mistake, problems"
    visitor.shows_view("blocks")
    yield "mistake, blocks"
    visitor.runs(FAILS)
    visitor.is_in_state("ended")
    yield "error"
    show_output(visitor)
    open_tab(visitor, "problems")
    yield "error, problems"


def extras(visitor):
    """What the menu of the view shows over the world, and the tour."""
    for code in ("page-shell-camera", "page-shell-drive"):
        visitor.command("page-world-eye", code)
    expect(visitor.page.locator(".drive-place .drive").first).to_be_visible()
    yield "camera and joystick"
    for code in ("page-shell-camera", "page-shell-drive"):
        visitor.command("page-world-eye", code)
    visitor.command("page-bar-more", "page-tour-title")
    expect(visitor.page.locator(".tour-card")).to_be_visible()
    yield "tour"
    visitor.page.keyboard.press("Escape")
    expect(visitor.page.locator(".tour-card")).to_have_count(0)


def show_output(visitor):
    """Show the output below the world."""
    button = visitor.button("page-shell-panel")
    if button.get_attribute("aria-pressed") == "false":
        button.click()


def open_tab(visitor, tab):
    """Open a tab of the output."""
    visitor.page.get_by_role("tab", name=visitor.says(f"page-shell-{tab}")).click()


MENUS = {
    "page-project-menu": "project",
    "page-bar-robot": "robot",
    "page-bar-more": "page",
    "page-bar-world": "world",
    "page-world-eye": "view",
}
PROJECT_DIALOGS = {
    "page-project-new": "new",
    "page-project-open": "open",
    "page-project-examples": "examples",
    "page-project-rename": "rename",
    "page-project-save-as": "save as",
    "page-project-history": "history",
    "page-sets-menu": "block sets",
    "page-custom-menu": "my blocks",
    "page-libraries-menu": "libraries",
    "page-tags-menu": "tag names",
    "page-maker-menu": "make a lesson",
    "page-project-more": "more of the project",
    "page-share-open": "open a link",
    "page-project-delete": "delete",
}
#: The commands of the project's menu that are under *More*.
RARE = {
    "page-sets-menu",
    "page-custom-menu",
    "page-libraries-menu",
    "page-tags-menu",
    "page-maker-menu",
    "page-share-open",
    "page-project-upload-folder",
}
PAGE_DIALOGS = {
    "page-help-title": "help",
    "page-settings-shortcuts": "shortcuts",
    "page-device-title": "other device",
    "page-settings-title": "settings",
    "page-robots-perception-menu": "camera recognition",
    "page-containment-menu": "what programs may do",
    "page-newrobot-menu": "new robot",
}
#: The walks of what Starter does not show.
EXPLORED = (looking_back,)
#: The walks for which the page draws the world; the others are about what lies over it.
BESIDE_THE_WORLD = (views, menus, runs, looking_back, game, extras)
#: The walks of the working page.
WALKS = (
    views,
    menus,
    project_dialogs,
    page_dialogs,
    filled_dialogs,
    gallery,
    world_editor,
    connecting,
    editors,
    runs,
    mistakes,
    looking_back,
    game,
    robots,
    extras,
)


@cache
def bundle(language):
    """Return the words of the page in a language."""
    found = FluentBundle([language], use_isolating=False)
    for file in sorted((WORDS / language / "page").glob("*.ftl")):
        found.add_resource(FluentResource(file.read_text("utf-8")))
    return found


def words(language, code, **values):
    """Return the page's words for a code."""
    found = bundle(language)
    text, errors = found.format_pattern(found.get_message(code).value, values)
    assert not errors, (code, errors)
    return str(text)
