"""What a browser keeps so that nobody has to say again who they are."""

import pytest

from learnblock.classroom.badges import Badges
from learnblock.classroom.roster import Roster


@pytest.fixture
def roster(tmp_path):
    return Roster(tmp_path, "7b")


@pytest.fixture
def badges(roster):
    return Badges(roster)


def test_a_badge_is_its_pupils(roster, badges):
    ana, _ = roster.add("Ana")
    leo, _ = roster.add("Leo")
    assert badges.pupil(badges.of_pupil(ana)) == ana
    assert badges.pupil(badges.of_pupil(leo)) == leo


def test_the_teachers_badge_is_no_pupils(roster, badges):
    ana, _ = roster.add("Ana")
    assert badges.is_teacher(badges.of_teacher())
    assert not badges.is_teacher(badges.of_pupil(ana))
    assert badges.pupil(badges.of_teacher()) is None


def test_a_changed_badge_is_worth_nothing(roster, badges):
    ana, _ = roster.add("Ana")
    leo, _ = roster.add("Leo")
    badge = badges.of_pupil(ana)
    _, _, signature = badge.rpartition(".")
    for forged in (
        f"{leo.id}.0.{signature}",
        f"{ana.id}.1.{signature}",
        badge[:-1],
        "",
        "é",
        "...",
    ):
        assert badges.pupil(forged) is None
        assert not badges.is_teacher(forged)
    assert not badges.is_teacher(f"teacher.{signature}")


def test_a_new_pin_ends_the_badges_before(roster, badges):
    ana, _ = roster.add("Ana")
    badge = badges.of_pupil(ana)
    roster.renew_pin(ana)
    assert badges.pupil(badge) is None


def test_another_class_has_other_badges(roster, badges, tmp_path):
    other = Roster(tmp_path / "other", "7c")
    ana, _ = roster.add("Ana")
    assert Badges(other).pupil(badges.of_pupil(ana)) is None
    assert not Badges(other).is_teacher(badges.of_teacher())
