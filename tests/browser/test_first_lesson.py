"""The first lesson without a mouse, and as a screen reader tells it, up to the reached goal."""

import re

import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN, WORKSPACE
from browser.states import words
from browser.test_accessibility import LISTEN
from browser.typist import Typist

LANGUAGES = ("en", "es")
IN_PROGRAM = "program => document.activeElement.closest(program) !== null"
#: What a page of 1366x768 has left at a zoom of 200 %.
ZOOMED = {"width": 683, "height": 384}
#: The block of the lesson, as it is read out.
DRIVE = {"en": "^drive forward 500 mm", "es": "^ir hacia delante 500 mm"}
FIELD = {"en": "^Edit .*number", "es": "^Editar .*n.mero"}
#: The name of each control that cannot be scrolled to.
LOST = """() => {
    const all = "button, select, input, a[href], [role=tab], [role=treeitem]";
    // A radio button may be drawn by its label, and skip links come with the focus.
    return [...document.querySelectorAll(all)]
        .map((one) => (one.type === "radio" ? one.labels[0] : one))
        .filter((one) => one.checkVisibility({ visibilityProperty: true }))
        .filter((one) => !one.matches(".skip-links *"))
        .filter((one) => {
            one.scrollIntoView({ block: "nearest", inline: "nearest", behavior: "instant" });
            const { left, top, right, bottom } = one.getBoundingClientRect();
            return left < -1 || top < -1 || right > innerWidth + 1 || bottom > innerHeight + 1;
        })
        .map((one) => one.ariaLabel || one.textContent);
}"""


@pytest.fixture(params=LANGUAGES)
def language(request):
    return request.param


@pytest.fixture
def newcomer(own_server, sit_down, language):
    return sit_down(own_server, start=True, language=language)


def test_the_first_lesson_is_done_with_tab_arrows_and_enter(newcomer, language):
    keys = Typist(newcomer)
    newcomer.page.evaluate(LISTEN)
    keys.walk("Tab", f"^{words(language, 'page-start-all-examples')}")
    keys.press("Enter")
    keys.walk("Tab", f"^{words(language, 'page-catalog-example-first-distance')}")
    keys.press("Enter")
    newcomer.expect_project(re.compile("."))
    expect(newcomer.blocks("lb_skill_drive_distance")).to_be_visible()
    walk_into_the_blocks(newcomer, keys)
    keys.walk("ArrowDown", DRIVE[language])
    change_the_number(newcomer, keys, language)
    walk_to_the_run_button(keys, language)
    keys.press("Enter")
    expect_spoken(newcomer, reached(language))


def test_a_screen_reader_tells_the_first_lesson(newcomer, language):
    page, keys = newcomer.page, Typist(newcomer)
    page.evaluate(LISTEN)
    expect(page.get_by_role("main")).to_match_aria_snapshot(start_page(language))
    keys.walk("Tab", f"^{words(language, 'page-start-all-examples')}")
    keys.press("Enter")
    keys.walk("Tab", f"^{words(language, 'page-catalog-example-first-distance')}")
    keys.press("Enter")
    newcomer.expect_project(re.compile("."))
    expect(newcomer.blocks("lb_skill_drive_distance")).to_be_visible()
    expect(page.locator("body")).to_match_aria_snapshot(working_page(language))
    keys.go_to("blocks")
    keys.walk("ArrowDown", DRIVE[language])
    change_the_number(newcomer, keys, language)
    assert "510" in keys.hears()
    keys.press("Control+Enter")
    expect_spoken(newcomer, words(language, "page-bar-state-running"))
    expect_spoken(newcomer, reached(language))
    expect_spoken(newcomer, words(language, "page-problems-ended-finished"))


def test_f6_goes_once_around_the_regions_of_both_pages(newcomer, language):
    keys = Typist(newcomer)
    assert around(keys) == ["start", "robots", "lessons", "examples", "projects"]
    open_first(newcomer, language)
    assert sorted(around(keys)) == ["bar", "blocks", "program", "world"]


def test_everything_is_reachable_at_a_zoom_of_200_percent(own_server, sit_down, language):
    pupil = sit_down(own_server, start=True, language=language, viewport=ZOOMED)
    pupil.picture(f"start-{language}")
    assert pupil.page.evaluate(LOST) == []
    open_first(pupil, language)
    pupil.picture(f"work-{language}")
    assert pupil.page.evaluate(LOST) == []
    pupil.page.keyboard.press("F1")
    expect(pupil.dialog()).to_be_visible()
    assert pupil.page.evaluate(LOST) == []


def open_first(pupil, language):
    """Open the simplest example."""
    pupil.page.get_by_role("button", name=words(language, "page-start-all-examples")).click()
    pupil.page.get_by_role("button", name=re.compile("500 mm")).first.click()
    pupil.expect_project(re.compile("."))
    expect(pupil.blocks("lb_main")).to_be_visible()


def start_page(language):
    """What a screen reader tells of the start page."""
    return f"""
    - main:
      - region:
        - heading {quoted("page-catalog-example-first-square", language)} [level=1]
        - button {quoted("page-start-try", language)}
      - region {quoted("page-start-robots", language)}:
        - group {quoted("page-start-robots", language)}:
          - radio "EBO"
      - region {quoted("page-lesson-cards-title", language)}
      - region {quoted("page-start-examples-title", language)}:
        - button {quoted("page-start-all-examples", language)}
      - region {quoted("page-start-projects", language)}
    """


def working_page(language):
    """What a screen reader tells of the working page."""
    return f"""
    - banner:
      - heading "LearnBlock" [level=1]
    - main:
      - group {quoted("page-shell-shown", language)}:
        - button {quoted("page-shell-blocks", language)} [pressed]
        - button {quoted("page-shell-blocktext", language)}
        - button {quoted("page-shell-python", language)}
      - region {quoted("page-shell-world", language)}:
        - group {quoted("page-bar-running", language)}:
          - button {quoted("page-bar-run", language)}
          - button {quoted("page-bar-stop", language)} [disabled]
        - slider {quoted("page-bar-speed", language)}
    """


def quoted(code, language):
    return f'"{words(language, code)}"'


def walk_into_the_blocks(pupil, keys):
    """Press Tab until the program has the focus."""
    for _ in range(60):
        if pupil.page.evaluate(IN_PROGRAM, WORKSPACE):
            return
        keys.press("Tab")
    raise AssertionError("Tab does not lead to the program")


def walk_to_the_run_button(keys, language):
    keys.walk("Tab", f"^{words(language, 'page-bar-run')}$")


def change_the_number(pupil, keys, language):
    """Change the distance of the focused block, and leave its field."""
    keys.fill("510", FIELD[language])
    expect(pupil.blocks("lb_skill_drive_distance")).to_contain_text("510")


def reached(language):
    """What is said of the reached goal."""
    goal = words(language, "page-catalog-name-500-mm-ahead")
    return words(language, "page-shell-goal-reached", goal=goal)


def expect_spoken(pupil, text):
    """Wait until a live region has said this."""
    pupil.page.wait_for_function(
        "text => [...announced.status, ...announced.alert].some((one) => one.includes(text))",
        arg=text,
        timeout=LONGEST_RUN,
    )


def around(keys):
    """Press F6 until a region has the focus for the second time; return the regions."""
    keys.press("F6")
    seen = [keys.region()]
    while True:
        keys.press("F6")
        if keys.region() in seen:
            return seen
        seen.append(keys.region())
