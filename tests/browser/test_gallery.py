"""The gallery of worlds, and the worlds that a new project offers."""

import re

import pytest
from playwright.sync_api import expect

OWN = 'title = "Yard"\n[[box]]\nx = 400\ny = 0\ncolour = "red"\n'
#: Whether the picture of the first card is drawn.
IS_DRAWN = "() => document.querySelector('[data-world] img')?.naturalWidth > 0"


@pytest.fixture
def pupil(sit_down, server):
    return sit_down(server, reduced_motion="reduce", empty=True, flat=True)


def focused(pupil):
    """The name of the world whose card has the focus."""
    return pupil.page.evaluate("() => document.activeElement.dataset.world ?? null")


def test_a_world_is_found_and_chosen_by_keys_alone_and_its_card_says_all(pupil):
    press = pupil.page.keyboard.press
    pupil.command("World", "All worlds…")
    expect(pupil.dialog().get_by_role("searchbox")).to_be_focused()
    pupil.page.keyboard.type("bumper")
    card = pupil.dialog().get_by_role("button", name="Bumper")
    expect(card).to_have_accessible_name(
        re.compile("Bumper.*Obstacles.*Drive to the wall, back off and stop.*Medium.*all robots")
    )
    press("ArrowDown")
    assert focused(pupil) == "bumper"
    press("Enter")
    expect(pupil.dialog()).to_have_count(0)
    pupil.expect_chosen("World", "Bumper")


def test_arrows_go_from_card_to_card_across_the_groups(pupil):
    press = pupil.page.keyboard.press
    pupil.command("World", "All worlds…")
    expect(pupil.dialog().get_by_role("heading", name="Games")).to_be_visible()
    cards = pupil.dialog().locator(".world-card:visible")
    names = cards.evaluate_all("all => all.map(({ dataset }) => dataset.world)")
    cards.first.focus()
    for _ in range(3):
        press("ArrowRight")
    # The second group is beside the first.
    assert focused(pupil) == names[3]
    press("ArrowDown")
    assert focused(pupil) not in names[:6]
    press("ArrowUp")
    assert focused(pupil) == names[3]


def test_ones_own_worlds_come_first_with_a_picture(sit_down, own_server):
    folder = own_server.home / "worlds"
    folder.mkdir(exist_ok=True)
    (folder / "yard.toml").write_text(OWN, encoding="utf-8")
    pupil = sit_down(own_server, reduced_motion="reduce", empty=True, flat=False)
    pupil.command("World", "All worlds…")
    first = pupil.dialog().locator("[data-world]").first
    expect(first).to_contain_text("Yard")
    pupil.page.wait_for_function(IS_DRAWN)
    pupil.picture("gallery")


def test_a_new_project_begins_with_enter_in_the_world_of_last_time(sit_down, own_server):
    pupil = sit_down(own_server, reduced_motion="reduce", empty=True, flat=True)
    pupil.project("New…")
    expect(pupil.dialog()).not_to_contain_text("As last time")
    pupil.dialog().get_by_role("button", name=re.compile("All .* worlds")).click()
    pupil.dialog().get_by_role("searchbox").fill("labyrinth")
    pupil.dialog().get_by_role("button", name="Labyrinth").click()
    pupil.picture("new")
    pupil.dialog().get_by_role("button", name="Start").click()
    expect(pupil.page.locator("header .project-name")).to_have_text("Labyrinth")
    pupil.expect_chosen("World", "Labyrinth")
    pupil.project("New…")
    expect(pupil.dialog()).to_contain_text("As last time")
    expect(pupil.dialog().get_by_role("button", name="Start")).to_be_focused()
    pupil.page.keyboard.press("Enter")
    expect(pupil.page.locator("header .project-name")).to_have_text("Labyrinth 2")
    pupil.expect_chosen("World", "Labyrinth")
