"""A teacher's wall at a real JupyterHub, in a browser."""

import sys

import pytest
from playwright.sync_api import expect

import hubs
import small_lesson
from browser.test_class import button, tile
from learnblock.lessons.archive import SUFFIX
from learnblock.lessons.own import MOST_OWN

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc"),
]

CLASS = "/services/class-7b/"
#: Until the hub has started a server, in ms.
STARTING = 1000 * hubs.STARTING


@pytest.fixture
def hub(tmp_path):
    small_lesson.put_in(tmp_path / "homes" / "class")
    with hubs.running(tmp_path, hubs.proxy_command()) as running:
        yield running


def open_wall(hub, desk):
    """Log in as a teacher does who has opened the address of the class."""
    wall = desk(f"{hub.address}/hub/login?next={CLASS}")
    wall.fill("[name=username]", "teacher")
    wall.click("[type=submit]")
    expect(wall).to_have_url(f"{hub.address}{CLASS}teacher", timeout=STARTING)
    return wall


def hand_out_own(wall):
    """Hand out the only lesson of the teacher's own."""
    wall.locator(".wall-lesson").click()
    dialog = wall.get_by_role("dialog", name="Hand out a lesson")
    button(dialog, "My lessons 1").click()
    dialog.get_by_text("First drive", exact=True).click()
    button(dialog, "Hand out").click()


def fill(lessons):
    """Put as many lessons as there can be into a pupil's folder, instead of those in it."""
    for file in lessons.iterdir():
        file.unlink()
    for number in range(MOST_OWN):
        (lessons / f"old-{number}{SUFFIX}").touch()


@pytest.mark.timeout(240)
def test_the_wall_says_whom_a_lesson_of_the_teachers_own_has_not_reached(hub, desk):
    alice = hub.visitor("alice")
    alice.login(CLASS)
    address = alice.client.get(CLASS).url.path
    wall = open_wall(hub, desk)
    with alice.socket(f"{address}ws") as page:
        expect(tile(wall, "alice")).to_be_visible(timeout=STARTING)
        hand_out_own(wall)
        page.hear("LessonShown", name=small_lesson.NAME)
        lessons = next(hub.home("alice").rglob(f"{small_lesson.NAME}{SUFFIX}")).parent
        fill(lessons)
        hand_out_own(wall)
        alert = wall.get_by_role("alert").filter(has_text="The lesson did not reach alice.")
        expect(alert).to_be_visible()
        next(lessons.iterdir()).unlink()
        hand_out_own(wall)
        expect(alert).to_have_count(0)
        page.hear("LessonShown", name=small_lesson.NAME)
