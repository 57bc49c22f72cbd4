"""Messages that our page never sends to the server."""

import json
import random
from typing import get_args

from learnblock.server.messages import FROM_PAGE
from learnblock.server.pages.page import MessageError, decode

PROGRAM = "main:\n    function.sleep(1)\nend\n"
WORLD = {"title": "Mine", "floor": {"size": [1000, 1000]}, "robot": [{"x": 0, "y": 0}]}
SOURCE = "def waltz(robot, times: int = 3):\n    return times\n"
BLOCK = json.dumps({"learnblock_block": 1, "name": "dance", "source": [SOURCE]})
SET = {"name": "lesson"}
EDITED = {
    "content": {"title": {"en": "Mine"}, "step": [{"title": {}, "check": [{"kind": "ends"}]}]},
    "steps": [{"before": 0, "program": {"text": PROGRAM}, "solution": {"text": PROGRAM}}],
    "programs": {"puzzle.bt": PROGRAM},
    "notes": {"en": "A note"},
}
LIBRARY = {"filename": "songs.lblib", "content": "UEsDBA=="}
PLACE = {"request": 1, "notation": "blocktext", "line": 2, "column": 14}
#: Every message of a page, with valid values.
EMPTY = {"stacks": [], "variables": []}
MESSAGES = {
    "Open": {"name": "program"},
    "New": {"name": "another"},
    "Import": {"filename": "a.bt", "text": PROGRAM},
    "ImportOriginal": {
        "filename": "a.blockProject",
        "content": "gAJOLg==",
        "libraries": {"dance": "ZGVm"},
    },
    "SaveAs": {"name": "a copy"},
    "RenameProject": {"name": "renamed"},
    "OpenExample": {"name": "Square", "example": "square", "robot": "sim-ebo"},
    "CopyProject": {"project": "program", "name": "a copy"},
    "KeepPicture": {"project": "square", "content": "/9j/wAALCAAQABABAQEA"},
    "CloseProject": {},
    "Delete": {"name": "another"},
    "Export": {"format": "py"},
    "ListProjects": {},
    "ListHistory": {},
    "Restore": {"version": "1"},
    "EditBlocks": {"edit": 1, "workspace": EMPTY},
    "EditText": {"edit": 1, "notation": "blocktext", "text": PROGRAM},
    "RecoverBlocks": {"edit": 1, "workspace": EMPTY, "base": EMPTY},
    "RecoverText": {"edit": 1, "notation": "python", "text": PROGRAM, "base": "x = 1"},
    "Undo": {},
    "Redo": {},
    "Format": {},
    "Rename": {"sort": "variable", "name": "x", "new": "y"},
    "Complete": PLACE,
    "Describe": PLACE,
    "SetBreakpoints": {"blocks": ["one", "two"]},
    "ChooseRobot": {"name": "sim-cozmo"},
    "ChooseWorld": {"name": "line"},
    "Run": {"paused": True},
    "Stop": {},
    "Pause": {},
    "Resume": {},
    "Step": {"over": True},
    "SetSpeed": {"factor": 20},
    "Answer": {"text": "hello"},
    "HandleRobot": {"how": "shake"},
    "HoldKeys": {"keys": ["up", "space"]},
    "ResetWorld": {},
    "PlaceRobot": {"x": 100, "y": 100, "heading": 90},
    "Drive": {"advance": 1, "rotation": -1},
    "WatchCamera": {"on": True},
    "ReadTimeline": {},
    "ReadPrediction": {},
    "LookBack": {"time": 1.5, "event": 7, "step": -1, "to": "change", "subject": "x"},
    "ReadPastPicture": {"time": 1.5},
    "ReadValues": {},
    "ReadCalls": {"first": 0.5, "last": 2.5},
    "ReadQuestions": {"block": "b1"},
    "AskWhy": {"question": {"ask": "line", "subject": "2", "time": 1.5}},
    "ListRuns": {},
    "OpenRun": {"run": "1700000000000-1"},
    "CloseRun": {},
    "NameRun": {"run": "1700000000000-1", "name": "my best"},
    "CompareRuns": {"first": "1700000000000-1", "second": "1700000000000-2"},
    "ReadCallsBeside": {"first": "1700000000000-1", "second": "1700000000000-2"},
    "DeleteRun": {"run": "1700000000000-1"},
    "Introduce": {"browser": "0123456789abcdef0123456789abcdef"},
    "ListLessons": {},
    "StartLesson": {"lesson": "small", "name": "Small", "robot": "sim-ebo", "again": True},
    "ShowStep": {"step": 2},
    "RestartStep": {},
    "CheckStep": {},
    "StopChecking": {},
    "ShowVariant": {"robot": "sim-cozmo", "variant": 1},
    "TakeHint": {},
    "AnswerQuiz": {"choices": [0, 1]},
    "AnswerPuzzle": {"order": [2, 0, 1]},
    "ImportLesson": {"filename": "small.lblesson", "content": "UEsDBA=="},
    "ImportLessonFolder": {"name": "small", "files": {"lesson.toml": "bGVzc29uID0gMQ=="}},
    "DeleteLesson": {"lesson": "small"},
    "MakeLesson": {},
    "ChangeLesson": {"lesson": "small"},
    "ExamineLesson": {"edited": EDITED},
    "SaveLesson": {"edited": EDITED},
    "TryLesson": {"edited": EDITED},
    "StopTrying": {},
    "ExportLesson": {"lesson": "small", "for_pupils": False},
    "ReadLessonNotes": {"lesson": "small"},
    "CopyLesson": {"lesson": "small"},
    "ReadContainment": {},
    "ReadNetwork": {},
    "AllowNetwork": {"allowed": True, "key": "key"},
    "ReadWorld": {"name": "line"},
    "CheckWorld": {"world": WORLD},
    "MakeWorld": {"template": "maze", "size": 4, "seed": 7},
    "SaveWorld": {"name": "mine", "world": WORLD},
    "ImportWorld": {"filename": "mine.toml", "content": "W2Zsb29yXQ=="},
    "ExportWorld": {"name": "mine"},
    "RenameWorld": {"name": "mine", "title": "Ours"},
    "DeleteWorld": {"name": "mine"},
    "RestoreWorld": {"name": "mine"},
    "AddTab": {"robot": "sim-thymio"},
    "SetRobotCount": {"name": "", "count": 2},
    "OpenTab": {"name": "sim-thymio"},
    "CloseTab": {"name": "sim-thymio"},
    "ReopenTab": {},
    "RenameTab": {"name": "sim-thymio", "new": "keeper"},
    "InstallOffered": {},
    "ListCustomBlocks": {},
    "CheckCustomBlock": {"request": 1, "name": "dance", "source": SOURCE, "configuration": "[]"},
    "SaveCustomBlock": {"name": "dance", "source": SOURCE, "configuration": "", "replaces": ""},
    "TryCustomBlock": {"name": "dance", "source": SOURCE, "arguments": [1, "a", [2.5], True, None]},
    "DuplicateCustomBlock": {"name": "dance", "new": "another"},
    "DeleteCustomBlock": {"name": "dance"},
    "RestoreCustomBlock": {"name": "dance"},
    "ExportCustomBlock": {"name": "dance"},
    "ImportCustomBlock": {"content": BLOCK, "replace": True},
    "ListBlockSets": {},
    "ChooseBlockSet": {"set": SET},
    "ReadBlockSet": {"filename": "lesson.toml", "text": "show = ['lb_main']"},
    "SaveBlockSet": {"set": SET, "replace": True},
    "DeleteBlockSet": {"name": "lesson"},
    "ExportBlockSet": {"set": SET},
    "ReadRunsOn": {},
    "ReadSettings": {"robot": "ev3"},
    "ChangeSettings": {"robot": "ev3", "values": {"wheel_radius": 28}},
    "SaveTags": {"names": {"ball": 3}},
    "ReadTags": {"filename": "tags.csv", "text": "ball,3"},
    "ExportTags": {"format": "html"},
    "ListLibraries": {},
    "ListExportable": {},
    "ReadLibraries": {"files": [LIBRARY]},
    "ImportLibraries": {"files": [LIBRARY]},
    "RemoveLibrary": {"name": "songs"},
    "DownloadLibrary": {"name": "songs"},
    "MakeLibrary": {"name": "songs", "version": "1.0", "functions": ["f"], "own": ["dance"]},
    "ConvertLibrary": {"filename": "a.lb", "content": "ZGVm", "configuration": "W10="},
    "UseLibrary": {"name": "songs"},
    "BeginRobot": {},
    "FindRobots": {"on": True},
    "ConnectRobot": {"id": "ev3"},
    "DisconnectRobot": {},
    "TryRobot": {"action": "wheels"},
    "CorrectRobot": {"distance": 480, "angle": 350, "save": True},
    "NameRobot": {"robot": "ev3", "name": "Ada"},
    "UseRobot": {},
    "MakeRobot": {"name": "rover", "description": "[body]\nlength = -1"},
}
assert set(MESSAGES) == {kind.__name__ for kind in get_args(FROM_PAGE)}
WRONG = (
    None, True, -1, 10**30, 10**400, 1.5e308, float("inf"), float("nan"), "", "\0", "x" * 2000,
    "../../etc/passwd", [], [[[]]], {}, {"": {}}, ["a", 1, None], {"kind": "Open"}, "🤖", "\ud800",
)  # fmt: skip


def malformed(chance):
    """Return something that is not a message."""
    while True:
        message = chance.choice(WAYS)(chance)
        try:
            decode(message)
        except MessageError:
            return message


def disordered(chance):
    """Return a message sent at the wrong time or about something missing."""
    kind = chance.choice(tuple(MESSAGES))
    values = dict(MESSAGES[kind])
    if values and chance.random() < 0.3:
        values[chance.choice(tuple(values))] = chance.choice(WRONG)
    return json.dumps({"kind": kind, **values})


def _noise(chance):
    return chance.randbytes(chance.randint(0, 200))


def _letters(chance):
    return "".join(chr(chance.randint(0, 0xD7FF)) for _ in range(chance.randint(0, 100)))


def _other_json(chance):
    return json.dumps(chance.choice(WRONG))


def _of_no_kind(chance):
    return json.dumps({"kind": chance.choice(WRONG), "name": chance.choice(WRONG)})


def _with_wrong_values(chance):
    kind = chance.choice(tuple(MESSAGES))
    wrong = {name: chance.choice(WRONG) for name in MESSAGES[kind]}
    return json.dumps({"kind": kind, **MESSAGES[kind], **wrong})


def _with_too_few_values(chance):
    kind = chance.choice(tuple(MESSAGES))
    kept = chance.sample(tuple(MESSAGES[kind]), k=len(MESSAGES[kind]) // 2)
    return json.dumps({"kind": kind, **{name: MESSAGES[kind][name] for name in kept}})


def _cut_off(chance):
    message = json.dumps({"kind": (kind := chance.choice(tuple(MESSAGES))), **MESSAGES[kind]})
    return message[: chance.randrange(len(message))]


def _deep(chance):
    opening, closing = chance.choice((("[", "]"), ('{"a":', "}")))
    depth = chance.choice((10, 1000, 5000))
    inner = opening * depth + "1" + closing * chance.choice((0, depth))
    return chance.choice((inner, f'{{"kind": "SaveWorld", "name": "w", "world": {inner}}}'))


WAYS = (
    _noise,
    _letters,
    _other_json,
    _of_no_kind,
    _with_wrong_values,
    _with_too_few_values,
    _cut_off,
    _deep,
)


def stream(say, count, seed):
    """Return `count` messages made by `say`."""
    chance = random.Random(seed)  # noqa: S311 - repeatable, not secret
    return [say(chance) for _ in range(count)]
