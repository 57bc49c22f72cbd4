"""A lesson hour: a class joins, works on a lesson, one child is helped, the work is graded."""

import csv
import os
import re
import subprocess
import sys
import zipfile
from contextlib import ExitStack
from types import SimpleNamespace

import pytest
from playwright.sync_api import expect

import small_lesson
from browser.conftest import ARTEFACTS
from browser.pupil import LONGEST_RUN
from browser.test_accessibility import faults
from classes import hand_in, opened

LESSON = "First drive"
NAMES = ("Ana", "Leo")
DRIVE = "main:\n    function.move_straight(40)\n    function.sleep(1)\nend\n"
PREDICTION = "On the blue line"


@pytest.fixture
def room(tmp_path):
    with opened(tmp_path / "teacher") as one:
        yield one


def picture(page, name):
    if ARTEFACTS:
        folder = ARTEFACTS / "class"
        folder.mkdir(parents=True, exist_ok=True)
        page.screenshot(path=folder / f"{name}.png")


def button(page, name, **options):
    return page.get_by_role("button", name=name, exact=True, **options)


def join(desk, address, word, name, **options):
    """Join as a child does who is new; return the page and the pictures."""
    page = desk(address, **options)
    expect(page.get_by_label("Join word")).to_be_focused()
    page.keyboard.type(word)
    page.get_by_label("Your first name").fill(name)
    button(page, "I am new here").click()
    button(page, "Join").click()
    expect(page.locator(".pin-row li")).to_have_count(4)
    pictures = page.locator(".pin-row li").all_text_contents()
    page.get_by_role("link", name="I'll remember them").click()
    expect(page.locator(".pupil-chip")).to_contain_text(name)
    return page, pictures


def tile(wall, name):
    rows = wall.get_by_role("grid").get_by_role("row")
    return rows.filter(has=wall.get_by_text(name, exact=True))


def state(wall, name):
    return tile(wall, name).locator(".tile-state")


def says(wall, name, words):
    """Expect that screen readers are told this about a pupil."""
    expect(tile(wall, name)).to_have_accessible_name(re.compile(words))


def run(page):
    button(page, "Run").click()
    expect(button(page, "Run")).to_be_enabled(timeout=LONGEST_RUN)


def test_a_lesson_hour(room, desk, tmp_path):
    wall = open_wall(room, desk)
    pages = {name: join(desk, room.address, room.word, name)[0] for name in NAMES}
    expect(wall.locator(".tile")).to_have_count(len(NAMES))
    hand_out(wall, pages)
    work(wall, pages["Ana"])
    ask_and_get_a_hint(wall, pages["Leo"])
    help_in_the_program(wall, pages["Leo"])
    look_up(wall, pages)
    collect(wall)
    grade(room, tmp_path / "out")


def open_wall(room, desk):
    """Open the wall, which says how to join."""
    wall = desk(f"{room.address}/teacher?key={room.key}")
    # The key is gone from the address, so that a glance at the screen does not reveal it.
    expect(wall).to_have_url(f"{room.address}/teacher")
    expect(wall.locator(".join-address")).to_have_text(room.address)
    expect(wall.locator(".join-word")).to_have_text(room.word)
    picture(wall, "1-before-anybody-is-here")
    return wall


def hand_out(wall, pages):
    """Hand out a lesson, which opens on every page."""
    wall.locator(".wall-lesson").click()
    dialog = wall.get_by_role("dialog", name="Hand out a lesson")
    expect(dialog.get_by_label("Find a lesson")).to_be_focused()
    wall.keyboard.type("drive")
    dialog.get_by_text(LESSON, exact=True).click()
    button(dialog, "Hand out").click()
    for name, page in pages.items():
        expect(page.locator("[data-region=lesson]")).to_contain_text("What will it do?")
        says(wall, name, "step 1 of")
    expect(wall.locator(".wall-lesson")).to_contain_text(LESSON)
    picture(wall, "2-lesson-handed-out")


def work(wall, page):
    """Do two steps of the lesson, which the wall shows."""
    page.get_by_role("radio", name=PREDICTION).check()
    button(page, "Check").click()
    expect(page.locator(".lesson-judged")).to_contain_text("Right!")
    button(page, "Next").click()
    run(page)
    says(wall, "Ana", "step 2 of .* [2-9] ★")
    picture(wall, "3-the-wall")
    picture(page, "3-a-quick-pupil")


def ask_and_get_a_hint(wall, page):
    """Raise the hand, and read the teacher's hint."""
    button(page, "I need help").click()
    expect(state(wall, "Leo")).to_have_text("Needs help")
    expect(page.get_by_label("What do you need help with?")).to_be_focused()
    page.keyboard.type("It is too small")
    page.keyboard.press("Enter")
    expect(tile(wall, "Leo").locator(".tile-finding")).to_have_text("“It is too small”")
    expect(wall.locator(".tile").first).to_contain_text("Leo")
    expect(wall.get_by_label("Waiting for you")).to_contain_text("It is too small")
    picture(wall, "4-a-raised-hand")
    tile(wall, "Leo").hover()
    button(tile(wall, "Leo"), "Hint").click()
    wall.keyboard.type("Which number is in the block?")
    wall.keyboard.press("Control+Enter")
    expect(page.locator(".class-notes")).to_contain_text("Which number is in the block?")
    expect(state(wall, "Leo")).to_have_text("Editing")
    picture(page, "5-a-hint")


def help_in_the_program(wall, page):
    """Look at the pupil's program, and write in it while the pupil agrees."""
    tile(wall, "Leo").hover()
    with wall.context.expect_page() as shown:
        tile(wall, "Leo").get_by_role("link", name="Look").click()
    looking = shown.value
    notes = looking.locator(".class-notes")
    expect(notes).to_contain_text("You are looking at the program of Leo")
    button(looking, "Ask to write").click()
    button(page, "Let them write").click()
    expect(notes).to_contain_text("You can write in the program of Leo")
    picture(looking, "6-the-teacher-helps")
    button(page, "That's enough").click()
    expect(notes).to_contain_text("You are looking")
    looking.close()


def look_up(wall, pages):
    """Have all pages rest, and go on."""
    button(wall, "Eyes up").click()
    for page in pages.values():
        expect(page.get_by_role("heading", name="Eyes up!")).to_be_visible()
    page = pages["Ana"]
    picture(page, "7-eyes-up")
    page.keyboard.press("Escape")
    expect(page.get_by_role("heading", name="Eyes up!")).to_be_visible()
    button(wall, "Eyes up").click()
    expect(page.get_by_role("heading", name="Eyes up!")).to_have_count(0)


def collect(wall):
    """Download the work of all."""
    button(wall, "More").click()
    with wall.expect_download() as download:
        wall.get_by_role("menuitem", name="Download all work").click()
    with zipfile.ZipFile(download.value.path()) as archive:
        handed_in = [name for name in archive.namelist() if name.endswith(f"/{LESSON}.learnblock")]
    assert len(handed_in) == len(NAMES)


def grade(room, out):
    """Grade the class while it is open."""
    command = [sys.executable, "-m", "learnblock", "grade", "--class", "7b"]
    command += ["--lesson", "1-01-first-drive", "--step", "2", "--robots", "sim-thymio"]
    graded = subprocess.run(
        [*command, "--variants", "0", "--out", out],
        env={**os.environ, "LEARNBLOCK_HOME": str(room.home)},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert graded.returncode == 0, graded.stderr
    with (out / "results.csv").open(newline="", encoding="utf-8-sig") as results:
        rows = list(csv.DictReader(results))
    assert [row["pupil"].partition(" ")[0] for row in rows] == list(NAMES)


def test_the_wall_and_the_entrance_have_no_faults_for_axe(room, desk, axe):
    def found(page):
        return faults(SimpleNamespace(page=page), axe)

    entrance = desk(room.address)
    expect(entrance.get_by_label("Join word")).to_be_visible()
    assert found(entrance) == []
    page, pictures = join(desk, room.address, room.word, "Ana")
    again = desk(room.address, width=390, height=844)
    expect(again.get_by_label("Join word")).to_be_focused()
    again.keyboard.type(room.word)
    again.keyboard.press("Enter")
    expect(again.get_by_label("Your first name")).to_be_focused()
    again.keyboard.type("Ana")
    button(again, "I have been here before").click()
    assert found(again) == []
    picture(again, "pictures-390")
    for name in pictures:
        button(again, name.strip()).click()
    expect(button(again, "Join")).to_be_focused()
    again.keyboard.press("Enter")
    expect(again.locator(".pupil-chip")).to_contain_text("Ana")
    picture(again, "joined-390")
    wall = desk(f"{room.address}/teacher?key={room.key}")
    expect(wall.locator(".tile")).to_have_count(1)
    assert found(wall) == []
    projector = wall.context.new_page()
    projector.goto(f"{room.address}/projector")
    expect(projector.locator(".join-word")).to_have_text(room.word)
    assert found(projector) == []
    picture(projector, "projector")
    page.close()


def test_the_wall_is_used_by_keyboard_and_keeps_what_is_typed_into_a_hint(room, desk):
    with ExitStack() as stack:
        for name in ("Ana", "Leo", "Mia"):
            page = stack.enter_context(room.pupil(name).page())
            page.open("mine", DRIVE)
        page.say("AskForHelp", on=True, question="One side is missing")
        wall = desk(f"{room.address}/teacher?key={room.key}", flat=False)
        walk_by_keyboard(wall)
        keep_a_hint(wall, page)


def walk_by_keyboard(wall):
    """Go from tile to tile, and on to the parts beside them."""
    expect(wall.locator(".tile-name")).to_have_text(["Mia", "Ana", "Leo"])
    expect(wall.locator("canvas[data-shown]")).to_have_count(3)
    assert wall.evaluate("document.documentElement.scrollWidth") <= 1366
    tile(wall, "Mia").focus()
    wall.keyboard.press("ArrowRight")
    expect(tile(wall, "Ana")).to_be_focused()
    wall.keyboard.press("l")
    expect(tile(wall, "Leo")).to_be_focused()
    wall.keyboard.press("Shift+F10")
    expect(wall.get_by_role("menuitem").first).to_be_focused()
    wall.keyboard.press("Escape")
    wall.keyboard.press("Escape")
    expect(tile(wall, "Leo")).to_be_focused()
    wall.keyboard.press("F6")
    expect(wall.locator(".wall-side a").first).to_be_focused()
    wall.keyboard.press("Shift+F6")
    expect(tile(wall, "Leo")).to_be_focused()


def keep_a_hint(wall, page):
    """Close a hint by mistake, open it again, and send it."""
    wall.keyboard.press("m")
    wall.keyboard.press("h")
    wall.keyboard.type("Count the corners")
    wall.keyboard.press("Escape")
    expect(tile(wall, "Mia")).to_be_focused()
    wall.keyboard.press("h")
    hint = wall.get_by_label("What should the pupil look at?")
    expect(hint).to_have_value("Count the corners")
    wall.keyboard.press("Control+Enter")
    assert page.hear("InClass", hand=False)["hint"] == "Count the corners"
    expect(state(wall, "Mia")).not_to_have_text("Needs help")
    wall.keyboard.press("h")
    expect(hint).to_have_value("")


def test_the_next_lesson_opens_for_those_who_are_ready_whose_work_stays_on_the_wall(room, desk):
    with room.pupil("Ana").page() as ana, room.pupil("Leo").page() as leo:
        hand_in(ana, "1-01-first-drive", 5)
        leo.say("StartLesson", lesson="1-01-first-drive", name=LESSON)
        wall = desk(f"{room.address}/teacher?key={room.key}")
        button(wall, "Turn a corner, for 1 who is ready").click()
        ana.hear("LessonShown", name="1-02-turn-a-corner")
        says(wall, "Ana", "Turn a corner · step 1")
        says(wall, "Leo", f"{LESSON} · step 1")
    row = wall.get_by_label("Hand-ins").get_by_role("row").filter(has_text="Ana")
    expect(row).to_contain_text(f"{LESSON}, step 5")
    expect(row).to_contain_text("to mark")


def test_a_lesson_of_the_teachers_own_is_added_at_the_wall_chosen_and_deleted(room, desk, tmp_path):
    wall = desk(f"{room.address}/teacher?key={room.key}")
    wall.locator(".wall-lesson").click()
    dialog = wall.get_by_role("dialog", name="Hand out a lesson")
    for name, content in (("notes", b"no lesson"), ("patrol", small_lesson.packed())):
        file = tmp_path / f"{name}.lblesson"
        file.write_bytes(content)
        with wall.expect_file_chooser() as choosing:
            button(dialog, "Add my lesson…").click()
        choosing.value.set_files(file)
        if name == "notes":
            expect(dialog.get_by_role("alert")).to_have_text(
                "This file is damaged or not a lesson."
            )
    expect(dialog.get_by_role("status")).to_have_text("“First drive” is in your lessons now.")
    expect(dialog.get_by_role("alert")).to_have_text("")
    expect(button(dialog, "My lessons 1")).to_have_attribute("aria-pressed", "true")
    expect(dialog.get_by_role("radio", checked=True)).to_have_count(1)
    button(dialog, "Delete…").click()
    button(wall, "Delete lesson").click()
    expect(button(dialog, "My lessons 1")).to_have_count(0)
    expect(dialog.get_by_role("radio", checked=True)).to_have_count(1)


def test_the_wall_is_not_shown_to_pupils(room, desk):
    page, _ = join(desk, room.address, room.word, "Ana")
    page.goto(f"{room.address}/teacher")
    expect(page.locator("body")).not_to_contain_text(room.word)
    page.goto(f"{room.address}/projector")
    expect(page.locator("body")).to_contain_text("This page is the teacher's")


def test_wrong_pictures_are_said_in_spanish(room, desk):
    join(desk, room.address, room.word, "Ana")
    page = desk(f"{room.address}/?word={room.word}")
    page.get_by_role("combobox").select_option("es")
    page.get_by_label("Tu nombre").fill("Ana")
    button(page, "Ya he estado aquí").click()
    for name in ("Paraguas", "Manzana", "Pelota", "Campana"):
        button(page, name).click()
    expect(page.locator(".pin-keys button").first).to_have_text("Manzana2")
    button(page, "Entrar").click()
    expect(page.get_by_role("alert")).to_contain_text("no van juntos")
    picture(page, "wrong-pictures-es")
