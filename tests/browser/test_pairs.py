"""Two pupils of a class play in one world, or show each other programs, each on their own page."""

import re
from types import SimpleNamespace

import pytest
from playwright.sync_api import expect

from browser.pupil import LONGEST_RUN
from browser.test_accessibility import faults
from browser.test_class import button, join, open_wall, picture
from classes import Joined, opened

WAIT = "main:\n    forever:\n        function.sleep(0.1)\n    end\nend\n"
GUESTS = """main:
    while not function.is_key_pressed("up"):
        function.sleep(0.05)
    end
    function.drive_distance(200)
    function.win_game()
end
"""


@pytest.fixture
def room(tmp_path):
    with opened(tmp_path / "teacher") as room:
        yield room


def make_project(room, page, name, program, second=None):
    """Let a pupil have a project in a game's world, with a second robot if it has a program."""
    path = re.search(r"p/\w+/", page.url)[0]
    [badge] = [one for one in page.context.cookies() if not one["name"].endswith("teacher")]
    with Joined(room, "", path, f"{badge['name']}={badge['value']}").page() as maker:
        maker.open(name, program, robot="sim-cozmo", world="stars")
        if second:
            maker.say("AddTab", robot="sim-cozmo")
            maker.hear("TabOpened")
            maker.hear("Document")
            maker.type(second)
        maker.pulse()
    page.goto(f"{room.address}/{path}#project={name}")
    expect(button(page, "Run")).to_be_visible()


@pytest.mark.timeout(240)
def test_a_classmates_program_plays_in_a_pupils_world_and_both_see_it(room, desk, axe):
    wall = open_wall(room, desk)
    button(wall, "More").click()
    wall.get_by_role("menuitemcheckbox", name="Let pupils play in pairs").click()
    ana, _ = join(desk, room.address, room.word, "Ana")
    ben, _ = join(desk, room.address, room.word, "Ben", flat=False, reduced_motion="reduce")
    make_project(room, ana, "duel", WAIT, second=WAIT)
    make_project(room, ben, "mine", GUESTS)
    invite(ana)
    notes = ben.get_by_role("log", name="From your class")
    expect(notes).to_contain_text("Ana invites you to drive the robot")
    picture(ben, "10-invited")
    button(notes, "Play").click()
    world = ben.frame_locator(".host-world iframe")
    expect(world.get_by_text("Goal: all stars")).to_be_visible()
    button(ana, "Run").click()
    expect(world.locator(".hud")).to_contain_text("duel")
    # What only the host can do is not offered.
    expect(world.get_by_role("button", name=re.compile("Why|Run|Play again"))).to_have_count(0)
    world.locator("canvas").first.click()
    picture(ben, "11-guest")
    picture(ana, "11-host")
    ben.keyboard.down("ArrowUp")
    for end in (world, ana):
        expect(end.locator(".game-end")).to_be_visible(timeout=LONGEST_RUN)
    ben.keyboard.up("ArrowUp")
    expect(world.locator(".game-end").get_by_role("button")).to_have_text(["Close"])
    picture(ben, "12-guest-end")
    picture(ana, "12-host-end")
    assert faults(SimpleNamespace(page=ben), axe) == []
    button(ben, "Stop playing together").click()
    expect(ben.locator(".host-world")).to_have_count(0)
    expect(ben.locator("#world")).to_be_visible()
    expect(ana.get_by_text("Ben no longer plays with you.")).to_be_visible()


def invite(page):
    """Invite the only classmate from the menu of the project."""
    page.get_by_role("button", name=re.compile("^Project")).click()
    page.get_by_role("menuitem", name="Play with a classmate…").click()
    dialog = page.get_by_role("dialog", name="Play with a classmate")
    picture(page, "9-invite")
    button(dialog, "Ben").click()
    expect(page.locator(".class-notes")).to_contain_text("You have invited Ben")


def share(page, way):
    """Choose a way to share the open project."""
    button(page.get_by_role("banner"), "Share").click()
    dialog = page.get_by_role("dialog")
    expect(dialog.get_by_label("Link", exact=True)).to_be_visible()
    picture(page, f"13-share-{way.split()[-1]}")
    dialog.get_by_role("button", name=re.compile(f"^{way}")).click()


@pytest.mark.timeout(240)
def test_a_pupil_shows_a_project_on_the_wall_and_to_a_classmate_who_opens_a_copy(room, desk, axe):
    wall = open_wall(room, desk)
    button(wall, "More").click()
    wall.get_by_role("menuitemcheckbox", name="Let pupils show each other programs").click()
    ana, _ = join(desk, room.address, room.word, "Ana")
    ben, _ = join(desk, room.address, room.word, "Ben", reduced_motion="reduce")
    make_project(room, ana, "Square", WAIT)
    make_project(room, ben, "mine", GUESTS)
    share(ana, "To my teacher")
    waiting = wall.get_by_role("region", name="Waiting for you")
    expect(waiting).to_contain_text("shows “Square”")
    share(ana, "To a classmate")
    button(ana.get_by_role("dialog"), "Ben").click()
    expect(wall.get_by_role("region", name="Shown to classmates")).to_contain_text("Ana to Ben")
    picture(wall, "14-wall-shown")
    notes = ben.get_by_role("log", name="From your class")
    expect(notes).to_contain_text("Ana shows you “Square”.")
    picture(ben, "14-offered")
    assert faults(SimpleNamespace(page=ben), axe) == []
    button(notes, "Open").click()
    expect(ben).to_have_url(re.compile("#project=Square"))
    expect(button(ben, "Run")).to_be_visible()
    expect(ana.get_by_text("Ben has opened a copy of “Square”.")).to_be_visible()
    with wall.expect_popup() as looking:
        waiting.get_by_role("link", name="Look").click()
    expect(looking.value).to_have_url(re.compile("#project=Square"))
    expect(ana.get_by_text("Your teacher is looking at “Square”.")).to_be_visible()
    expect(waiting).not_to_contain_text("shows")
