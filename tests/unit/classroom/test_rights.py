"""Who may what in a class: every kind of message has a decision, for every role."""

import typing

import pytest

from learnblock.classroom import messages as ours
from learnblock.classroom.limits import PACES
from learnblock.classroom.rights import RIGHTS, Role, may
from learnblock.server import messages

pytestmark = [pytest.mark.certain, pytest.mark.realtime]

KINDS = [*typing.get_args(messages.FROM_PAGE), *typing.get_args(ours.FromPupil)]

#: What the teacher's computer, robots and lessons are changed with: nobody's in a class.
NOBODYS = [
    "ReadSettings", "ChangeSettings", "AllowNetwork", "FindRobots", "ConnectRobot",
    "DisconnectRobot", "TryRobot", "CorrectRobot", "NameRobot", "UseRobot", "BeginRobot",
    "MakeRobot", "ImportLesson", "ImportLessonFolder", "CopyLesson", "ReadLessonNotes",
    "DeleteLesson", "MakeLesson", "ChangeLesson", "ExamineLesson",
    "SaveLesson", "TryLesson", "StopTrying", "ExportLesson",
]  # fmt: skip
#: What only reads, and what stops a robot.
EVERYBODYS = [
    "Open", "CloseProject", "OpenTab", "Export", "ListProjects", "ListHistory", "Complete",
    "Describe", "ReadRunsOn", "WatchCamera", "ReadTimeline", "ReadPrediction", "LookBack",
    "ReadPastPicture", "ReadValues", "ReadCalls", "ReadQuestions", "AskWhy", "ListRuns",
    "OpenRun", "CloseRun", "CompareRuns", "ReadCallsBeside", "ReadWorld", "CheckWorld",
    "MakeWorld", "ExportWorld", "ListCustomBlocks", "CheckCustomBlock", "ExportCustomBlock",
    "ListBlockSets", "ReadBlockSet", "ExportBlockSet", "ReadContainment", "ReadNetwork",
    "ReadTags", "ExportTags", "ListLibraries", "ListExportable", "ReadLibraries",
    "DownloadLibrary", "ListLessons", "Introduce", "Stop",
]  # fmt: skip
#: What changes and runs the open program: also the teacher's, if the pupil agrees.
WRITERS = [
    "EditBlocks", "EditText", "RecoverBlocks", "RecoverText", "Undo", "Redo", "Format",
    "Rename",
    "SetBreakpoints", "ChooseRobot", "ChooseWorld", "ChooseBlockSet", "Run", "Pause", "Resume",
    "Step", "SetSpeed", "Answer", "HoldKeys", "HandleRobot", "ResetWorld", "PlaceRobot",
    "Drive",
    "AddTab", "SetRobotCount", "CloseTab", "ReopenTab", "RenameTab", "ShowStep", "CheckStep",
    "StopChecking",
    "ShowVariant",
]  # fmt: skip
#: What the teacher alone says.
TEACHERS = ["AskToWrite"]


def roles_of(kind):
    if kind in NOBODYS:
        return set()
    if kind in EVERYBODYS:
        return {Role.PUPIL, Role.WATCHER, Role.HELPER}
    if kind in WRITERS:
        return {Role.PUPIL, Role.HELPER}
    return {Role.WATCHER, Role.HELPER} if kind in TEACHERS else {Role.PUPIL}


def test_every_kind_of_message_is_in_the_table():
    assert {kind.__name__ for kind in KINDS} == set(RIGHTS)


@pytest.mark.parametrize("role", Role)
def test_each_role_may_send_what_it_should(role):
    assert [kind for kind in RIGHTS if may(role, kind) != (role in roles_of(kind))] == []


def test_an_unknown_kind_is_nobodys():
    for kind in ("", "Nonsense", "open", "Open "):
        assert not any(may(role, kind) for role in Role)


def test_a_teacher_who_looks_changes_nothing_that_is_saved():
    reading = {kind.__name__ for kind in messages.FromReader.__subclasses__()}
    assert {kind for kind in RIGHTS if may(Role.WATCHER, kind)} <= reading | {"AskToWrite"}


def test_what_costs_most_has_a_pace_of_its_own():
    assert {"Run", "CheckStep", "TryCustomBlock"} == set(PACES)
    assert set(PACES) <= set(RIGHTS)
