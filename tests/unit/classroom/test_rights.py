"""Who may what in a class: every kind of message has a decision, for every role."""

from collections import Counter
from typing import get_args

import pytest

from learnblock.classroom.limits import PACES
from learnblock.classroom.rights import FROM_GUEST, RIGHTS, TO_GUEST, may
from learnblock.server import messages
from learnblock.server.messages.base import Role

pytestmark = [pytest.mark.certain, pytest.mark.realtime]


def test_as_many_messages_have_each_role_as_was_decided():
    """A new message, or another base, shows here: decide who may send it, then count it."""
    roles = Counter(", ".join(sorted(roles)) for roles in RIGHTS.values())
    assert roles == {
        "helper, pupil, watcher": 46,
        "helper, pupil": 32,
        "pupil": 51,
        "helper, watcher": 1,
        "": 36,
    }


@pytest.mark.parametrize(
    ("kind", "roles"),
    [
        ("Stop", set(Role)),
        ("AskWhy", set(Role)),
        ("Run", {Role.PUPIL, Role.HELPER}),
        ("EditText", {Role.PUPIL, Role.HELPER}),
        ("SaveTags", {Role.PUPIL}),
        ("LetTeacherWrite", {Role.PUPIL}),
        ("HandIn", {Role.PUPIL}),
        ("ImproveHandIn", {Role.PUPIL}),
        ("MarkHandIn", set()),
        ("HandBack", set()),
        ("ReadHandIn", set()),
        ("WorkGiven", set()),
        ("AskToWrite", {Role.WATCHER, Role.HELPER}),
        ("AskClassmates", {Role.PUPIL}),
        ("Invite", {Role.PUPIL}),
        ("AnswerInvitation", {Role.PUPIL}),
        ("LeaveWorld", {Role.PUPIL}),
        ("LetShareWorlds", set()),
        ("ShowTeacher", {Role.PUPIL}),
        ("AskViewers", {Role.PUPIL}),
        ("ShowClassmate", {Role.PUPIL}),
        ("AnswerOffer", {Role.PUPIL}),
        ("LetShowPrograms", set()),
        ("FindGuestRobot", set()),
        ("GiveProgram", set()),
        ("KeepKeysApart", set()),
        ("TakeGuest", set()),
        ("GuestTaken", set()),
        ("GiveLesson", set()),
        ("ReadLessonWork", set()),
        ("LessonWorkRead", set()),
        ("MakeRobot", set()),
        ("AllowNetwork", set()),
    ],
)
def test_each_role_may_send_what_it_should(kind, roles):
    assert {role for role in Role if may(role, kind)} == roles


def test_a_guest_sends_keys_and_sees_the_world_but_no_program():
    assert FROM_GUEST == {"HoldKeys"}
    to_page = {kind.__name__ for kind in get_args(messages.TO_PAGE)}
    assert to_page >= TO_GUEST
    assert not TO_GUEST & {
        "Document", "Printed", "PrintedByRobots", "Variables", "RunningLine", "Projects",
        "History", "KeptRuns", "File", "LessonShown", "Failed", "WhyAnswer", "CameraFrame",
    }  # fmt: skip


def test_an_unknown_kind_is_nobodys():
    for kind in ("", "Nonsense", "open", "Open "):
        assert not any(may(role, kind) for role in Role)


def test_a_teacher_who_looks_changes_nothing_that_is_saved():
    kinds = get_args(messages.FROM_PAGE)
    reading = {kind.__name__ for kind in kinds if issubclass(kind, messages.FromReader)}
    assert {kind for kind in RIGHTS if may(Role.WATCHER, kind)} <= reading | {"AskToWrite"}


def test_what_costs_most_has_a_pace_of_its_own():
    assert {"Run", "CheckStep", "TryCustomBlock", "HandIn", "ExportRun"} == set(PACES)
    assert set(PACES) <= set(RIGHTS)
