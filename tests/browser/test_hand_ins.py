"""A pupil hands in; the teacher checks, marks and hands back, and the pupil sees it."""

from types import SimpleNamespace

import pytest
from playwright.sync_api import expect

from browser.conftest import ARTEFACTS
from browser.test_accessibility import faults
from browser.test_class import button, join
from classes import opened

LESSON, STEP = "1-01-first-drive", 2
#: Runs of a check on a computer that is busy.
LONGEST_CHECK = 300_000
NOTE = "Well driven! Now stop on the blue line."
SHORT = """\
main:
    function.move_straight(40)
    function.sleep(1)
    function.stop_bot()
end
"""
#: Until a server has started, and a run has ended; in ms.
LONGEST_RUN = 60_000


@pytest.fixture
def room(tmp_path):
    with opened(tmp_path / "teacher") as one:
        yield one


def picture(page, name):
    if ARTEFACTS:
        folder = ARTEFACTS / "hand-ins"
        folder.mkdir(parents=True, exist_ok=True)
        for width, height in ((1366, 768), (390, 844)):
            page.set_viewport_size({"width": width, "height": height})
            page.screenshot(path=folder / f"{name}-{width}.png", full_page=width < 700)
        page.set_viewport_size({"width": 1366, "height": 768})


def step_of(page):
    """Take a pupil who talks over the wire to the step."""
    page.say("StartLesson", lesson=LESSON, name="First drive", step=STEP)
    while page.hear("LessonShown").get("step") != STEP:
        pass


@pytest.mark.certain
@pytest.mark.timeout(450)
def test_a_pupil_hands_in_and_gets_it_back_with_a_note_and_a_mark(room, desk, axe):
    page, _ = join(desk, room.address, room.word, "Ana", width=1366, height=768)
    with room.wall() as wall, room.pupil("Leo").page() as leo, room.pupil("Kim").page() as kim:
        wall.say("HandOut", lesson=LESSON, project="First drive", step=STEP)
        step_of(leo)
        leo.type(SHORT)
        leo.say("HandIn")
        step_of(kim)
        room.pupil("Eva")
        button(page, "Hand in").click()
        expect(page.locator(".handed-in")).to_contain_text("Your teacher looks at it")
        steps = page.locator(".lesson-moves button")
        assert len({step.bounding_box()["y"] for step in steps.all()}) == 1
        picture(page, "pupil-handed-in-en")

        teacher = desk(f"{room.address}/teacher?key={room.key}", width=1366, height=768)
        teacher.get_by_role("link", name="Hand-ins").click()
        check(teacher)
        mark(teacher, axe)
        assert faults(SimpleNamespace(page=teacher), axe) == []
        expect(page.locator(".handed-back")).to_contain_text(NOTE)
        expect(page.locator(".handed-back")).to_contain_text("9 of 10")
        expect(page.locator(".handed-back-line")).to_be_visible()
        expect(page.locator("#blocks .lbNoted")).to_have_count(1)
        assert faults(SimpleNamespace(page=page), axe) == []
        picture(page, "pupil-handed-back-en")
        see_own_run(page, axe)
        button(page, "Improve and hand in again").click()
        expect(teacher.get_by_role("heading", name="Improving · 1")).to_be_visible()
        button(page, "Hand in again").click()
        expect(page.locator(".handed-in")).to_contain_text("Your teacher looks at it")
        teacher.locator(".class-language select").select_option("es")
        expect(teacher.get_by_role("heading", name="Entregas", level=1)).to_be_visible()
        picture(teacher, "teacher-es")


def check(teacher):
    """Check what is handed in; who has not begun is apart, and under no mistake."""
    expect(teacher.get_by_role("heading", name="To check · 2")).to_be_visible()
    expect(teacher.locator(".hand-ins-without").first).to_contain_text("Eva not begun")
    expect(teacher.locator(".hand-ins-without").last).to_contain_text("Kim not handed in yet")
    button(teacher, "Check 2").click()
    expect(teacher.get_by_role("heading", name="To mark · 2")).to_be_visible(timeout=LONGEST_CHECK)
    expect(teacher.get_by_role("button", name="Ana")).to_contain_text("nothing")
    expect(teacher.get_by_role("button", name="Leo")).not_to_contain_text("nothing")


def see_own_run(page, axe):
    """Look at the run that was handed in, which changes nothing of the pupil's page."""
    button(page, "Your run").click()
    run = page.frame_locator("iframe")
    expect(run.locator(".timeline")).to_be_visible(timeout=LONGEST_RUN)
    expect(run.locator(".lesson-goal.met").first).to_be_visible()
    assert faults(SimpleNamespace(page=page.frames[-1]), axe) == []
    picture(page, "pupil-own-run-en")
    page.keyboard.press("Escape")
    expect(page.locator("iframe")).to_have_count(0)


def mark(teacher, axe):
    """Look at a hand-in, write a note, give a mark and hand back."""
    teacher.get_by_role("button", name="Leo").click()
    expect(teacher.get_by_role("heading", name="Why?")).to_be_visible()
    expect(teacher.locator(".block-drawing svg").first).to_be_visible()
    button(teacher, "Show the run").click()
    run = teacher.frame_locator("iframe")
    expect(run.locator(".timeline")).to_be_visible(timeout=LONGEST_RUN)
    run.locator(".lesson-goal.failed").get_by_role("button", name="Why?").first.click()
    run.get_by_role("button", name="Show the block").first.click()
    expect(teacher.locator(".block-drawing .lbRunning")).to_have_count(1)
    picture(teacher, "teacher-missed-en")
    assert faults(SimpleNamespace(page=teacher.frames[-1]), axe) == []
    button(teacher, "From above").click()
    teacher.get_by_role("button", name="Ana").click()
    note = teacher.get_by_label("Note to Ana")
    expect(note).to_be_focused()
    note.fill(NOTE)
    teacher.locator(".block-drawing .blocklyPath").last.click(force=True)
    expect(teacher.get_by_label("About")).not_to_have_value("0")
    teacher.get_by_label("Your mark").fill("9 of 10")
    picture(teacher, "teacher-en")
    # As a teacher does who stays on the keyboard; leaving the field sends the mark again.
    teacher.keyboard.press("Control+Enter")
    expect(teacher.get_by_role("heading", name="Handed back · 1")).to_be_visible()
