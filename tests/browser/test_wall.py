"""The teacher's wall of a class of thirty."""

import json
import re

import pytest
from playwright.sync_api import expect

from browser.test_class import button, picture
from classes import opened
from thirty_pupils import LESSON, NAMES, thirty_at_work


@pytest.fixture(scope="module")
def full_room(tmp_path_factory):
    """A class of thirty, all of whom share these tests."""
    with opened(tmp_path_factory.mktemp("teacher")) as room, thirty_at_work(room) as pupils:
        yield room, pupils


def open_wall(desk, room, theme="light", language="en", **options):
    wall = desk(f"{room.address}/teacher?key={room.key}", **options)
    expect(wall.locator(".tile")).to_have_count(len(NAMES))
    prefer = {"tourDone": True, "sound": False, "theme": theme, "language": language}
    wall.evaluate("p => localStorage['learnblock.preferences'] = p", json.dumps(prefer))
    wall.reload()
    expect(wall.locator(".tile")).to_have_count(len(NAMES))
    return wall


@pytest.mark.parametrize(("theme", "language"), [("light", "en"), ("dark", "es")])
def test_all_thirty_tiles_are_whole_and_their_words_can_be_read(full_room, desk, theme, language):
    wall = open_wall(desk, full_room[0], theme, language, flat=False)
    # The grey pictures of those who have not begun are those of the lesson.
    expect(wall.locator("canvas[data-shown]")).to_have_count(len(NAMES), timeout=60_000)
    picture(wall, f"thirty-{theme}-{language}")
    tiles = wall.locator(".tile")
    places = tiles.evaluate_all("all => all.map(one => one.getBoundingClientRect().toJSON())")
    assert [place for place in places if place["bottom"] > 768 or place["right"] > 1366] == []
    words = wall.locator(".tile-name, .tile-state span")
    sizes = words.evaluate_all("all => all.map(one => parseFloat(getComputedStyle(one).fontSize))")
    assert min(sizes) >= 12
    cut = words.evaluate_all(
        "all => all.filter(one => one.scrollWidth > one.clientWidth).map(one => one.textContent)"
    )
    assert cut == []


def test_the_actions_of_a_narrow_tile_are_all_in_it(full_room, desk):
    wall = open_wall(desk, full_room[0], language="es")
    tile = wall.locator(".tile").first
    tile.hover()
    outer = tile.bounding_box()
    for action in tile.locator(".tile-tools .button").all():
        inner = action.bounding_box()
        assert outer["x"] <= inner["x"]
        assert inner["x"] + inner["width"] <= outer["x"] + outer["width"]


def test_a_row_of_the_hand_ins_opens_the_hand_in_of_its_pupil(full_room, desk):
    room, pupils = full_room
    wall = open_wall(desk, room)
    rows = wall.get_by_label("Hand-ins").get_by_role("row")
    # Wherever one clicks: here not at the name.
    rows.filter(has_text="Jonas").click(position={"x": 200, "y": 8})
    expect(wall).to_have_url(re.compile(f"hand-ins#pupil={pupils['Jonas'].id}&lesson={LESSON}"))
    expect(wall.get_by_role("heading", name="Jonas")).to_be_visible()
    expect(button(wall, "Hand back")).to_be_visible()
