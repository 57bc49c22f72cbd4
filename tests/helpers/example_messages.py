"""An example of every message of a page, made from the types of its fields and their defaults.

Where the type allows what would be refused at once, or would reach little of the server, a field
has a value here: by its name, or by its message.
"""

import json
from collections.abc import Callable, Mapping
from typing import Any, get_args

from msgspec import NODEFAULT, inspect

from learnblock.server.messages import FROM_PAGE

PROGRAM = "main:\n    function.sleep(1)\nend\n"
SOURCE = "def waltz(robot, times: int = 3):\n    return times\n"
BLOCK = json.dumps({"learnblock_block": 1, "name": "dance", "source": [SOURCE]})
RUN = "1700000000000-1"
EMPTY = {"stacks": [], "variables": []}
_EDITED = {
    "content": {"title": {"en": "Mine"}, "step": [{"title": {}, "check": [{"kind": "ends"}]}]},
    "steps": [{"before": 0, "program": {"text": PROGRAM}, "solution": {"text": PROGRAM}}],
    "programs": {"puzzle.bt": PROGRAM},
    "notes": {"en": "A note"},
}
#: By the name of a field.
_FIELDS = {
    "arguments": [1, "a", [2.5], True, None],
    "base": EMPTY,
    "browser": "0123456789abcdef0123456789abcdef",
    "configuration": "[]",
    "content": "UEsDBA==",
    "edit": 1,
    "edited": _EDITED,
    "files": [{"filename": "songs.lblib", "content": "UEsDBA=="}],
    "first": RUN,
    "lesson": "small",
    "name": "program",
    "robot": "sim-ebo",
    "run": RUN,
    "second": RUN,
    "set": {"name": "lesson"},
    "source": SOURCE,
    "template": "maze",
    "text": PROGRAM,
    "workspace": EMPTY,
    "world": {"title": "Mine", "floor": {"size": [1000, 1000]}, "robot": [{"x": 0, "y": 0}]},
}
#: By message, and by the name of a field.
_MESSAGES = {
    "AddTab": {"robot": "sim-thymio"},
    "AskWhy": {"question": {"ask": "line", "subject": "2", "time": 1.5}},
    "ChangeSettings": {"robot": "ev3", "values": {"wheel_radius": 28}},
    "ChooseRobot": {"name": "sim-cozmo"},
    "ChooseWorld": {"name": "line"},
    "CloseTab": {"name": "sim-thymio"},
    "ConnectRobot": {"id": "ev3"},
    "ConvertLibrary": {"filename": "a.lb", "content": "ZGVm", "configuration": "W10="},
    "Delete": {"name": "another"},
    "ExportWorld": {"name": "line"},
    "Import": {"filename": "a.bt"},
    "ImportCustomBlock": {"content": BLOCK, "replace": True},
    "ImportLesson": {"filename": "small.lblesson"},
    "ImportLessonFolder": {"files": {"lesson.toml": "bGVzc29uID0gMQ=="}},
    "ImportOriginal": {"filename": "a.blockProject", "content": "gAJOLg=="},
    "ImportWorld": {"filename": "mine.toml", "content": "W2Zsb29yXQ=="},
    # One that needs nothing: a test must not change what is installed.
    "InstallAddOn": {"robot": "sim-ebo"},
    "KeepPicture": {"content": "/9j/wAALCAAQABABAQEA"},
    "LookBack": {"time": 1.5, "event": 7, "step": -1, "to": "change", "subject": "x"},
    "MakeRobot": {"description": "[body]\nlength = -1"},
    "NameRobot": {"robot": "ev3", "name": "Ada"},
    "New": {"name": "another", "world": "line"},
    "OpenExample": {"example": "square"},
    "OpenTab": {"name": "sim-thymio"},
    "ReadBlockSet": {"filename": "lesson.toml", "text": "show = ['lb_main']"},
    "ReadCalls": {"first": 0.5, "last": 2.5},
    "ReadSettings": {"robot": "ev3"},
    "ReadTags": {"filename": "tags.csv", "text": "ball,3"},
    "ReadWorld": {"name": "line"},
    "RecoverText": {"base": "x = 1"},
    "RenameTab": {"name": "sim-thymio"},
    "Restore": {"version": "1"},
    "SetRobotCount": {"name": "", "count": 2},
    "SetSpeed": {"factor": 20},
}


def examples() -> dict[str, dict[str, Any]]:
    """The fields of an example of each kind of message."""
    return {kind.__name__: _fields(kind) for kind in get_args(FROM_PAGE)}


def _fields(kind: type) -> dict[str, Any]:
    fields = {field.name: field for field in inspect.type_info(kind).fields}
    del fields["request"]
    values = _FIELDS | _MESSAGES.get(kind.__name__, {})
    return {name: values[name] if name in values else _default(fields[name]) for name in fields}


def _default(field: inspect.Field) -> Any:
    if field.required:
        return _value(field.type)
    return field.default_factory() if field.default is NODEFAULT else field.default


def _value(kind: Any) -> Any:
    return _VALUES[type(kind)](kind)


def _number(kind: Any) -> float:
    return max(kind.ge or 0, 1)


#: Makes a value, by the type of its type.
_VALUES: Mapping[type, Callable[[Any], Any]] = {
    inspect.Metadata: lambda kind: _value(kind.type),
    inspect.AnyType: lambda _: 1,
    inspect.BoolType: lambda _: True,
    inspect.IntType: _number,
    inspect.FloatType: _number,
    inspect.StrType: lambda kind: "a" * (kind.min_length or 1),
    inspect.BytesType: lambda _: "ZGVm",
    inspect.LiteralType: lambda kind: kind.values[0],
    inspect.NoneType: lambda _: None,
    inspect.UnionType: lambda kind: _value(kind.types[0]),
    inspect.ListType: lambda kind: [_value(kind.item_type)],
    inspect.VarTupleType: lambda kind: [_value(kind.item_type)],
    inspect.DictType: lambda kind: {_value(kind.key_type): _value(kind.value_type)},
    inspect.StructType: lambda kind: {
        field.encode_name: _value(field.type) for field in kind.fields if field.required
    },
}
