"""The keyboard of a project, which all its programs and pages share."""

import pytest

from learnblock.server.messages import KeysWanted
from learnblock.server.runs.keyboard import SharedKeyboard
from learnblock.server.runs.viewers import Viewers


class Page:
    """A page that keeps what it is sent."""

    def __init__(self):
        self.heard = []

    def send(self, message, data=None):
        assert data is None
        self.heard.append(message)


@pytest.fixture
def page():
    return Page()


@pytest.fixture
def keyboard(page):
    viewers = Viewers()
    viewers.add(page)
    return SharedKeyboard(viewers)


def test_pages_learn_which_keys_all_programs_ask_for(keyboard, page):
    keyboard.want("left", ("up", "space"))
    keyboard.want("right", ("space", "w"))
    keyboard.ignore("left")
    keyboard.ignore("right")
    assert page.heard == [
        KeysWanted(("up", "space"), 1),
        KeysWanted(("up", "space", "w"), 2),
        KeysWanted(("space", "w"), 1),
        KeysWanted((), 0),
    ]


def test_each_program_finds_its_own_keys_from_the_users_of_all_pages(keyboard, page):
    keyboard.want("left", ("up", "space"))
    keyboard.want("right", ("space", "w"))
    keyboard.hold(page, ["up", "w"])
    keyboard.hold(Page(), ["space"])
    assert keyboard.held("left") == ["up", "space"]
    assert keyboard.held("right") == ["space", "w"]
    assert keyboard.held("one that does not listen") == []


def test_a_page_that_leaves_releases_its_keys_and_no_others(keyboard, page):
    other = Page()
    keyboard.want("left", ("up", "w"))
    keyboard.hold(page, ["up"])
    keyboard.hold(other, ["w"])
    keyboard.leave(page)
    assert keyboard.held("left") == ["w"]


def test_a_guest_drives_one_robot_only_and_nobody_else_drives_it(keyboard, page):
    guest = Page()
    keyboard.keep_apart(guest, "rival")
    keyboard.want("own", ("up", "w"))
    keyboard.want("rival", ("up", "w"))
    keyboard.hold(page, ["up"])
    keyboard.hold(guest, ["w"])
    assert keyboard.held("own") == ["up"]
    assert keyboard.held("rival", is_guests=True) == ["w"]
    # The host tries a function of the robot's own program.
    assert keyboard.held("rival") == ["up"]
    keyboard.release(guest)
    assert keyboard.held("rival", is_guests=True) == []
    keyboard.hold(guest, ["w"])
    assert keyboard.held("own") == ["up"]
    assert keyboard.held("rival", is_guests=True) == ["w"]


def test_nobody_drives_the_robot_of_a_guest_who_has_left_until_the_guest_is_back(keyboard, page):
    guest, again = Page(), Page()
    keyboard.want("rival", ("up",))
    keyboard.keep_apart(guest, "rival")
    keyboard.hold(guest, ["up"])
    keyboard.leave(guest)
    keyboard.hold(page, ["up"])
    assert keyboard.held("rival", is_guests=True) == []
    keyboard.keep_apart(again, "rival")
    keyboard.hold(again, ["up"])
    assert keyboard.held("rival", is_guests=True) == ["up"]


def test_keys_held_at_the_end_of_a_run_are_not_held_in_the_next_one(keyboard, page):
    keyboard.want("left", ("up",))
    keyboard.hold(page, ["up"])
    keyboard.ignore("left")
    keyboard.hold(page, ["up"])
    keyboard.want("left", ("up",))
    assert keyboard.held("left") == []


def test_a_page_that_joins_learns_the_keys_only_if_there_are_any(keyboard):
    early, late = Page(), Page()
    keyboard.join(early)
    keyboard.want("left", ("up",))
    keyboard.join(late)
    assert (early.heard, late.heard) == ([], [KeysWanted(("up",))])


def test_a_program_that_never_listened_ends_without_a_word(keyboard, page):
    keyboard.ignore("left")
    assert page.heard == []
