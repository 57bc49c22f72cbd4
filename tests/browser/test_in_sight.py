"""What matters in a lesson is whole on the screen, in each size and language."""

import re

import pytest
from playwright.sync_api import expect

from browser.pupil import FLAT, WORKSPACE
from classes import opened
from learnblock.lessons.reading import find_lesson

SIZES = {"laptop": (1366, 768), "small": (1024, 768), "tablet": (820, 1180), "phone": (390, 844)}
LANGUAGES = ("en", "es")
#: The selected elements that are not whole: beyond the page, cut by a part that scrolls, or under
#: the groups of a phone.
CUT = """(wanted) => [...document.querySelectorAll(wanted)].filter((one) => {
    const { left, top, right, bottom, width } = one.getBoundingClientRect();
    if (width === 0) return false;
    let [x0, y0, x1, y1] = [0, 0, innerWidth, innerHeight];
    const isFixed = (part) => getComputedStyle(part).position === "fixed";
    for (let part = one; part && !isFixed(part); part = part.parentElement) {
        if (part === one) continue;
        const strip = part.querySelector(':scope > .blocklyToolbox[layout="h"]');
        if (strip) y1 = Math.min(y1, strip.getBoundingClientRect().top);
        if (getComputedStyle(part).overflow === "visible") continue;
        const box = part.getBoundingClientRect();
        [x0, y0] = [Math.max(x0, box.left), Math.max(y0, box.top)];
        [x1, y1] = [Math.min(x1, box.right), Math.min(y1, box.bottom)];
    }
    return left < x0 - 1 || top < y0 - 1 || right > x1 + 1 || bottom > y1 + 1;
}).map((one) => one.textContent || one.getAttribute("class"))"""
#: How far the page is larger than the screen.
BEYOND = """() => [
    document.documentElement.scrollWidth - innerWidth,
    document.documentElement.scrollHeight - innerHeight,
]"""
DRAWN = "() => { const world = learnblock.views.world.value; world.resize(); return world.drawn; }"
BLOCKS = f"{WORKSPACE} > .blocklyBlockCanvas .blocklyDraggable > .blocklyPath"
TASK = ".lesson-choice, .lesson-quiz legend, .lesson-goal"
RUN = "#run .go"
PROGRAM = f"{BLOCKS}, .program-head button"
#: The names of the project and its world that are cut; letters reach a little below their line.
CUT_NAMES = """() => [...document.querySelectorAll(".project-name, .world-name")].filter((name) =>
    name.scrollWidth > name.clientWidth || name.scrollHeight > name.clientHeight + 8
).map((name) => name.textContent)"""
CASES = [(size, language) for size in SIZES for language in LANGUAGES]


def words(text, language):
    return text if isinstance(text, str) else text[language]


class Reader:
    """A pupil who has opened a lesson, and does nothing but look."""

    def __init__(self, sit_down, server, size, language, *, flat=False, **options):
        width, height = SIZES[size]
        options |= {"language": language, "viewport": {"width": width, "height": height}}
        self.pupil = sit_down(server, start=True, flat=flat, **options)
        self.page, self.size, self.language = self.pupil.page, size, language
        self._flat = flat

    def open(self, name):
        opened = find_lesson(name)
        self.page.goto(self.page.url + "?test")
        self.page.get_by_role("button", name=re.compile(f"^{opened.lesson.level} · ")).click()
        title = words(opened.lesson.title, self.language)
        self.page.locator(".lesson-card").get_by_role("button", name=title).first.click()
        expect(self.page.locator(BLOCKS).first).to_be_visible()
        expect(self.page.locator(TASK).first).to_be_visible()
        if not self._flat:
            self.page.wait_for_function("() => learnblock.views.world.value?.framesDrawn > 0")

    def go_to(self, number):
        self.page.evaluate("step => learnblock.lessons.showStep(step)", number)
        expect(self.page.locator(".lesson-goal").first).to_be_visible()

    def expect_all_in_sight(self):
        """Wait until the task, the program and Run are whole, and look for robot and goals."""
        wanted = f"{TASK}, {RUN}, {PROGRAM}"
        self.page.wait_for_function(f"(wanted) => ({CUT})(wanted).length === 0", arg=wanted)
        assert self.page.evaluate(BEYOND) == [0, 0]
        assert self.page.evaluate(CUT_NAMES) == []
        drawn = self.page.evaluate(DRAWN)
        places = [drawn["robot"], *([drawn["goal"]] if drawn["goal"] else []), *drawn["others"]]
        assert max(abs(along) for place in places for along in place) < 1

    def toggle_output(self):
        self.page.locator(".output-button button").click()


@pytest.mark.parametrize(("size", "language"), CASES)
def test_a_question_and_goals_are_in_sight_beside_program_robot_and_run(
    own_server, sit_down, size, language
):
    reader = Reader(sit_down, own_server, size, language)
    reader.open("1-03-square")
    expect(reader.page.locator(".block-drawing")).to_have_count(0)
    reader.expect_all_in_sight()
    reader.pupil.picture(f"question-{size}-{language}")
    if size != "phone":
        reader.toggle_output()
        reader.expect_all_in_sight()
        reader.toggle_output()
    reader.go_to(4)
    reader.expect_all_in_sight()
    reader.pupil.picture(f"goals-{size}-{language}")


#: Programs of ten blocks.
FLAT_TEN = "main:\n" + "    function.drive_distance(100)\n" * 9 + "end\n"
NESTED_TEN = (
    "main:\n    forever:\n        if function.is_left_ground_line():\n"
    + "            function.drive_distance(100)\n" * 7
    + "        end\n    end\nend\n"
)
#: The size of the words on the blocks of the program, px.
WORDS = f"""() => Math.min(...[...document.querySelectorAll("{BLOCKS} ~ g .blocklyText")].map(
    (word) => parseFloat(getComputedStyle(word).fontSize) * word.getScreenCTM().a))"""


@pytest.mark.parametrize("program", [FLAT_TEN, NESTED_TEN], ids=["flat", "nested"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_phone_shows_the_first_ten_blocks_beside_task_world_and_run(
    own_server, sit_down, language, program
):
    reader = Reader(sit_down, own_server, "phone", language, flat=True, has_touch=True)
    reader.open("1-03-square")
    blocks, text = reader.page.locator(".areas button").all()[:2]
    text.tap()
    reader.pupil.write("blocktext", program)
    expect(reader.page.locator(".saved")).to_have_text({"en": "Saved", "es": "Guardado"}[language])
    blocks.tap()
    reader.page.reload()
    drives = f"{WORKSPACE} .lb_skill_drive_distance > .blocklyPath"
    expect(reader.page.locator(drives)).to_have_count(program.count("drive_distance"))
    wanted = f"{TASK}, {RUN}, {drives}"
    reader.page.wait_for_function(f"(wanted) => ({CUT})(wanted).length === 0", arg=wanted)
    assert 12 <= reader.page.evaluate(WORDS) < 16
    reader.pupil.picture(f"ten-{language}")


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_phone_on_its_side_shows_a_question_with_all_answers(own_server, sit_down, language):
    reader = Reader(sit_down, own_server, "phone", language, flat=True, has_touch=True)
    reader.page.set_viewport_size({"width": 844, "height": 390})
    reader.open("1-03-square")
    wanted = f"{TASK}, {RUN}"
    reader.page.wait_for_function(f"(wanted) => ({CUT})(wanted).length === 0", arg=wanted)


#: Whether the button of the block set shows its whole title, or only its icon.
WHOLE_TITLE = """() => {
    const title = document.querySelector(".shown-blocks span");
    const isShown = getComputedStyle(title).position !== "absolute";
    return isShown ? title.scrollWidth <= title.clientWidth : "icon";
}"""


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_title_of_a_lessons_blocks_is_whole_or_an_icon(own_server, sit_down, language):
    reader = Reader(sit_down, own_server, "laptop", language, flat=True)
    reader.open("1-01-first-drive")
    assert reader.page.evaluate(WHOLE_TITLE) is True
    width, height = SIZES["small"]
    reader.page.set_viewport_size({"width": width, "height": height})
    reader.page.wait_for_function(f"() => ({WHOLE_TITLE})() === 'icon'")
    expect(reader.page.locator(".shown-blocks svg")).to_be_in_viewport(ratio=1)


#: The boxes of what the offer of the tour must not cover, and its own, in pixels.
BESIDE_THE_OFFER = """() => {
    const box = (one) => one.getBoundingClientRect();
    const parts = [".world-pane", "#run", ".blocklyToolbox", ".blocklyBlockCanvas .blocklyPath"];
    const offer = box(document.querySelector(".tour-offer"));
    const covered = [...document.querySelectorAll(parts.join())].map(box).filter((part) =>
        part.width > 0 && part.left < offer.right && part.right > offer.left
        && part.top < offer.bottom && part.bottom > offer.top);
    return { height: offer.height, bottom: innerHeight - offer.bottom, covered };
}"""


@pytest.mark.parametrize(("size", "language"), CASES)
def test_the_offer_of_the_tour_covers_neither_world_nor_blocks_nor_run(
    sit_down, server, size, language
):
    width, height = SIZES[size]
    viewport = {"width": width, "height": height}
    pupil = sit_down(server, tour=True, empty=True, flat=True, language=language, viewport=viewport)
    expect(pupil.page.locator(".tour-offer")).to_be_visible()
    offer = pupil.page.evaluate(BESIDE_THE_OFFER)
    assert offer["height"] > 50
    assert offer["bottom"] >= 0
    assert offer["covered"] == []


def test_the_output_is_closed_when_a_lesson_opens(own_server, sit_down):
    reader = Reader(sit_down, own_server, "laptop", "en")
    reader.page.evaluate(
        "() => localStorage['learnblock.preferences'] = JSON.stringify("
        "{ ...JSON.parse(localStorage['learnblock.preferences']), layout: { panel: true } })"
    )
    reader.page.reload()
    reader.open("1-01-first-drive")
    expect(reader.page.locator("#panel")).to_be_hidden()


def test_a_missed_goal_says_by_how_much_and_is_shown(own_server, sit_down):
    reader = Reader(sit_down, own_server, "laptop", "en")
    reader.open("1-03-square")
    reader.go_to(4)
    expect(reader.page.locator(".lesson-goal.failed")).to_have_count(0)
    reader.pupil.choose("Speed", "Fastest")
    reader.pupil.run_to_the_end()
    missed = reader.page.locator(".lesson-goal.failed").first
    expect(missed).to_contain_text(re.compile(r"The first corner: \d+ mm short\."))
    missed.get_by_role("button", name=re.compile("^Show")).click()
    reader.pupil.picture("missed")


#: Whether the page is no wider than the screen, and the notes of the class cover nothing.
IN_CLASS = """() => {
    const box = (one) => one.getBoundingClientRect();
    const notes = [...document.querySelectorAll(".class-notes > *")].map(box);
    const parts = [...document.querySelectorAll("#run .go, .blocklyToolbox, .bar button")];
    const isCovered = (part) => notes.some((note) =>
        box(part).left < note.right && box(part).right > note.left
        && box(part).top < note.bottom && box(part).bottom > note.top);
    const isWhole = document.documentElement.scrollWidth <= innerWidth;
    return isWhole && notes.length > 0 && !parts.some(isCovered);
}"""


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_hint_of_the_teacher_covers_neither_run_nor_the_groups(tmp_path, browser, language):
    with opened(tmp_path / "teacher") as room, room.wall() as wall:
        pupil = room.pupil("Maximiliano")
        context = browser.new_context(locale=language)
        context.add_init_script(FLAT)
        name, _, value = pupil.cookie.partition("=")
        context.add_cookies([{"name": name, "value": value, "url": room.address}])
        page = context.new_page()
        page.goto(f"{room.address}/{pupil.address}")
        wall.say("HandOut", lesson="1-01-first-drive", project="First drive", step=2)
        expect(page.locator(BLOCKS).first).to_be_visible(timeout=60_000)
        page.locator(".pupil-chip button").click()
        wall.say("SendHint", pupil=pupil.id, text="Look at the number in the block.")
        expect(page.locator(".note.hint")).to_be_visible()
        for width, height in SIZES.values():
            page.set_viewport_size({"width": width, "height": height})
            # The page follows the new size in its next frames.
            page.wait_for_function(IN_CLASS)
        context.close()
