"""The files of projects: readable JSON with a version number.

```json
{
  "learnblock": 1,
  "robot": "sim-ebo",
  "world": "line",
  "blocktext": [
    "main:",
    "    function.move_straight()",
    "end"
  ]
}
```

Texts are lists of lines. ``python`` is present only if its author wrote it by hand, ``workspace``
has the positions of the blocks, ``breakpoints`` has ids of blocks, ``shown`` and ``block_sets``
choose blocks in the palette, ``libraries`` has the versions with which the program was made, and
``tags`` the numbers of tags that differ from the user's. ``carried`` (see `carried`) has what the
program needs of its author's own things; a file with it has version 2, so that older versions of
LearnBlock ask for a newer one.

A project with several robots has version 3. The program and the robot above are those of the first,
whose name is ``first``, and ``others`` has the rest:

```json
  "first": "sumo",
  "others": [
    {"name": "bystander", "robot": "sim-thymio", "blocktext": ["main:", ...], ...}
  ]
```

If several robots run one of the programs, its ``count`` says how many, and the file has version 4.
"""

import codecs
import json
import re
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Struct, field

from learnblock.blocks.block_sets import EVERYTHING, BlockNames, BlockSet
from learnblock.errors import Diagnostic, ProjectError
from learnblock.extensions.libraries import Name, Version
from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.perception.tag_names import LAST_TAG
from learnblock.project.files import ENDING
from learnblock.project.files.carried import NOTHING, Carried, CarriedWorld, Code, TagNames
from learnblock.project.files.project import (
    LONGEST_NAME,
    LONGEST_PART_NAME,
    MOST_BLOCK_SETS,
    MOST_BREAKPOINTS,
    BlockId,
    Project,
    ProjectPart,
    is_part_name,
    is_plain,
)
from learnblock.running import DEFAULT_ROBOT, MOST_ROBOTS
from learnblock.storage.file_phrases import place as phrase_of_place
from learnblock.storage.file_phrases import unknown_key

VERSION = 1
#: The version of a file that carries something.
CARRYING_VERSION = 2
#: The version of a file with several robots.
TEAM_VERSION = 3
#: The version of a file in which robots share a program.
SHARED_VERSION = 4
_VERSIONS = (VERSION, CARRYING_VERSION, TEAM_VERSION, SHARED_VERSION)
#: The maximum size in bytes; a thousand statements with their blocks take a tenth of it.
LARGEST = 4 * 1024 * 1024
#: The maximum number of imports in a program.
MOST_LIBRARIES = 1000

Choice = Annotated[str, Meta(max_length=LONGEST_NAME)]
PartName = Annotated[str, Meta(max_length=LONGEST_PART_NAME)]
Count = Annotated[int, Meta(ge=1, le=MOST_ROBOTS)]


class _Part(Struct, forbid_unknown_fields=True, omit_defaults=True):
    """The values of one of the other programs."""

    name: PartName
    blocktext: list[str]
    robot: Choice = DEFAULT_ROBOT
    breakpoints: Annotated[list[BlockId], Meta(max_length=MOST_BREAKPOINTS)] = field(
        default_factory=list
    )
    python: list[str] | None = None
    workspace: Workspace | None = None
    count: Count = 1


class _File(Struct, forbid_unknown_fields=True):
    """The values of a project's file, in this order."""

    learnblock: int
    blocktext: list[str]
    robot: Choice = DEFAULT_ROBOT
    world: Choice = ""
    breakpoints: Annotated[list[BlockId], Meta(max_length=MOST_BREAKPOINTS)] = field(
        default_factory=list
    )
    shown: Choice = EVERYTHING
    block_sets: Annotated[tuple[BlockSet, ...], Meta(max_length=MOST_BLOCK_SETS)] = ()
    libraries: Annotated[dict[Name, Version], Meta(max_length=MOST_LIBRARIES)] = {}
    tags: TagNames = {}
    carried: Carried = NOTHING
    python: list[str] | None = None
    workspace: Workspace | None = None
    count: Count = 1
    first: PartName = ""
    others: Annotated[list[_Part], Meta(max_length=MOST_ROBOTS - 1)] = field(default_factory=list)


class _Head(Struct):
    """The key that distinguishes a project's file from other JSON."""

    learnblock: Any = None


_read_head = msgspec.json.Decoder(_Head).decode
_read_file = msgspec.json.Decoder(_File).decode


def encode(project: Project) -> bytes:
    """Encode a project as a file.

    Raises:
        ProjectError: it is larger than `decode` reads, or contains half a character.
    """
    try:
        data = (_written(_values(project)) + "\n").encode()
    except UnicodeEncodeError as error:
        character = ord(error.object[error.start])
        message = Phrase("project-character", code=f"{character:04X}")
        _refuse(project.name, "bad-character", message)
    if len(data) > LARGEST:
        message = Phrase("project-too-large", size=len(data), limit=LARGEST)
        _refuse(project.name, "too-large", message)
    return data


def decode(data: bytes, name: str) -> Project:
    """Decode the project in a file.

    Raises:
        ProjectError: the file is not a valid project; the error gives the position.
    """
    filename = name + ENDING
    data = data.removeprefix(codecs.BOM_UTF8)
    if len(data) > LARGEST:
        message = Phrase("project-too-large", size=len(data), limit=LARGEST)
        _refuse(filename, "too-large", message)
    text = _text(data, filename)
    try:
        _check_version(_read_head(data).learnblock, filename)
        file = _read_file(data)
    except msgspec.ValidationError as error:
        raise ProjectError(filename, [_explained(str(error), text)], text) from None
    except msgspec.DecodeError as error:
        raise ProjectError(filename, [_malformed(str(error), data)], text) from None
    except RecursionError:
        _refuse(filename, "too-deep", Phrase("project-too-deep"))
    _check_choices(file, filename)
    return _project(file, name)


def _project(file: _File, name: str) -> Project:
    return Project(
        name=name,
        blocktext="\n".join(file.blocktext),
        python=None if file.python is None else "\n".join(file.python),
        workspace=file.workspace,
        robot=file.robot,
        world=file.world,
        breakpoints=tuple(file.breakpoints),
        shown=file.shown,
        block_sets=file.block_sets,
        libraries=file.libraries,
        tags=file.tags,
        carried=file.carried,
        count=file.count,
        first=file.first,
        others=tuple(map(_part, file.others)),
    )


def _part(part: _Part) -> ProjectPart:
    return ProjectPart(
        name=part.name,
        blocktext="\n".join(part.blocktext),
        python=None if part.python is None else "\n".join(part.python),
        workspace=part.workspace,
        robot=part.robot,
        breakpoints=tuple(part.breakpoints),
        count=part.count,
    )


# Reading.


def _text(data: bytes, filename: str) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        problem = Phrase("project-not-utf-8", byte=f"{data[error.start]:#x}")
        raise ProjectError(filename, [Diagnostic("not-utf-8", problem, line)]) from None


def _check_version(version: object, filename: str) -> None:
    if version is None:
        _refuse(filename, "no-project", Phrase("project-none", start=_START))
    if version not in _VERSIONS or isinstance(version, bool):
        _refuse(
            filename,
            "unknown-version",
            Phrase("project-version", version=f"{version!r:.40}", known=str(SHARED_VERSION)),
        )


def _check_choices(file: _File, filename: str) -> None:
    """Refuse paths: a project names robots and worlds, and never points outside its folder."""
    kinds = [("robot", robot) for robot in (file.robot, *(other.robot for other in file.others))]
    for key, value in (*kinds, ("world", file.world)):
        if value and not is_plain(value):
            _refuse(
                filename,
                "no-name",
                Phrase("project-path", kind=key, value=repr(value), example=_SUCH_AS[key]),
            )

    _check_names(file, filename)


def _check_names(file: _File, filename: str) -> None:
    """Refuse robots that could not be distinguished, and too many."""
    robots = file.count + sum(other.count for other in file.others)
    if robots > MOST_ROBOTS:
        _refuse(filename, "too-many", Phrase("tabs-too-many", limit=MOST_ROBOTS))
    names = [file.first, *(other.name for other in file.others)] if robots > 1 else []
    for name in names:
        if not is_part_name(name) or names.count(name) > 1:
            _refuse(filename, "robot-name", Phrase("project-robot-name", name=name))


#: How a project's file starts.
_START = '{"learnblock": 1'
_SUCH_AS = {"robot": DEFAULT_ROBOT, "world": "line"}
_PLACE = re.compile(r" - at (?:`key` in )?`\$\.?(.*?)`$")
_UNKNOWN = re.compile(r"Object contains unknown field `(.+)`")
_MISSING = re.compile(r"Object missing required field `(.+)`")
_BYTE = re.compile(r" \(byte (\d+)\)")
_EXPECTED = {
    "blocktext": Phrase("project-expects-blocktext"),
    "python": Phrase("project-expects-python"),
    "robot": Phrase("project-expects-robot"),
    "world": Phrase("project-expects-world"),
    "breakpoints": Phrase("project-expects-breakpoints", limit=MOST_BREAKPOINTS),
    "shown": Phrase("project-expects-shown"),
    "block_sets": Phrase("project-expects-block-sets", limit=MOST_BLOCK_SETS),
    "libraries": Phrase("project-expects-libraries", example='{"dance": "1.2.0"}'),
    "tags": Phrase("project-expects-tags", example='{"door": 12}', last=LAST_TAG),
    "carried": Phrase("project-expects-carried"),
    "workspace": Phrase("project-expects-workspace"),
    "first": Phrase("project-expects-first"),
    "count": Phrase("project-expects-count", limit=MOST_ROBOTS),
    "others": Phrase("project-expects-others", limit=MOST_ROBOTS - 1),
}
#: The positions of a file with keys of their own.
_PARTS: tuple[tuple[str, type[Struct]], ...] = (
    (r"block_sets.*\.(?:show|hide)", BlockNames),
    (r"block_sets.*", BlockSet),
    (r"others.*", _Part),
    (r"carried\.world", CarriedWorld),
    (r"carried\.(?:code|offered)", Code),
    (r"carried", Carried),
)


def _explained(refusal: str, text: str) -> Diagnostic:
    """Explain an error of msgspec to a person who knows only the file."""
    match = _PLACE.search(refusal)
    place = match[1] if match else ""
    refusal = _PLACE.sub("", refusal)
    if missing := _MISSING.match(refusal):
        message = Phrase("file-missing-key", key=missing[1], place=phrase_of_place(place))
        return _at("", text, "missing-key", message)
    if unknown := _UNKNOWN.match(refusal):
        message = unknown_key(unknown[1], place, _known(place))
        return _at(unknown[1], text, "unknown-key", message)
    key = re.split(r"[.\[]", place, maxsplit=1)[0]
    return _at(key, text, "wrong-value", _wrong_value(place, key, text))


def _wrong_value(place: str, key: str, text: str) -> Phrase:
    expected = _EXPECTED.get(key)
    if expected is None:
        return Phrase("project-none", start=_START)
    value = _shown(place, text)
    if value is None:
        return Phrase("project-value-wrong", place=phrase_of_place(place), expected=expected)
    return Phrase("project-value", place=phrase_of_place(place), value=value, expected=expected)


def _known(place: str) -> tuple[str, ...]:
    """The keys that are allowed at a position."""
    kinds = (kind for pattern, kind in _PARTS if re.fullmatch(pattern, place))
    return next(kinds, _File).__struct_fields__


def _shown(place: str, text: str) -> str | None:
    """The value at a position as in the file, shortened if long; None if it can't be shown."""
    try:
        value = json.loads(text)
        for index, key in re.findall(r"\[(\d+)\]|([^.\[\]]+)", place):
            value = value[int(index)] if index else value[key]
        json_text = json.dumps(value, ensure_ascii=False)
    except (KeyError, TypeError, ValueError, RecursionError):
        # Msgspec calls each value of an object `...`, and some values can't be shown at all.
        return None
    return json_text if len(json_text) <= 60 else json_text[:57] + "..."


def _at(key: str, text: str, code: str, message: Phrase) -> Diagnostic:
    match = re.search(rf'^\s*("{re.escape(key)}")\s*:', text, re.MULTILINE) if key else None
    if match is None:
        return Diagnostic(code, message)
    start = text.rfind("\n", 0, match.start(1)) + 1
    line, column = text.count("\n", 0, start) + 1, match.start(1) - start + 1
    return Diagnostic(code, message, line, column, column + len(match[1]))


def _malformed(refusal: str, data: bytes) -> Diagnostic:
    """Report a file that is not JSON, with the position."""
    match = _BYTE.search(refusal)
    at = int(match[1]) if match else len(data)
    start = data.rfind(b"\n", 0, at) + 1
    column = len(data[start:at].decode("utf-8", "replace")) + 1
    what = _BYTE.sub("", refusal).removeprefix("JSON is malformed: ")
    message = Phrase("project-damaged", reason=what)
    return Diagnostic("not-json", message, data.count(b"\n", 0, start) + 1, column)


def _refuse(filename: str, code: str, message: Phrase) -> NoReturn:
    raise ProjectError(filename, [Diagnostic(code, message)])


# Writing.

#: The levels of brackets that are split into lines: the file, a text, the list of stacks.
_SPREAD = 3


def _values(project: Project) -> dict[str, Any]:
    """The file's values; blocks stay Structs, because only `msgspec` can encode deep ones."""
    values: dict[str, Any] = {"learnblock": _version(project), "robot": project.robot}
    values["world"] = project.world
    values["breakpoints"] = list(project.breakpoints)
    if project.shown != EVERYTHING:
        values["shown"] = project.shown
    if project.block_sets:
        values["block_sets"] = msgspec.to_builtins(project.block_sets)
    if project.libraries:
        values["libraries"] = dict(project.libraries)
    if project.tags:
        values["tags"] = dict(project.tags)
    if project.carried:
        values["carried"] = msgspec.to_builtins(project.carried)
    values["blocktext"] = project.blocktext.split("\n")
    if project.python is not None:
        values["python"] = project.python.split("\n")
    if project.workspace is not None:
        values["workspace"] = msgspec.structs.asdict(project.workspace)
    return values | _team_values(project)


def _team_values(project: Project) -> dict[str, Any]:
    """The values that only a file with several robots has."""
    values: dict[str, Any] = {"first": project.parts[0].name} if project.has_several else {}
    if project.count > 1:
        values["count"] = project.count
    if project.others:
        values["others"] = [_part_values(part) for part in project.others]
    return values


def _version(project: Project) -> int:
    if any(part.count > 1 for part in project.parts):
        return SHARED_VERSION
    if project.others:
        return TEAM_VERSION
    return CARRYING_VERSION if project.carried or project.tags else VERSION


def _part_values(part: ProjectPart) -> dict[str, Any]:
    values: dict[str, Any] = {"name": part.name, "robot": part.robot}
    if part.count > 1:
        values["count"] = part.count
    if part.breakpoints:
        values["breakpoints"] = list(part.breakpoints)
    values["blocktext"] = part.blocktext.split("\n")
    if part.python is not None:
        values["python"] = part.python.split("\n")
    if part.workspace is not None:
        values["workspace"] = msgspec.structs.asdict(part.workspace)
    return values


def _written(value: Any, depth: int = _SPREAD, indent: str = "") -> str:
    """Encode JSON with one line per line of text and per stack of blocks."""
    if not depth or not value or not isinstance(value, dict | list):
        return msgspec.json.encode(value).decode()
    inner = indent + "  "
    if isinstance(value, dict):
        opening, closing = "{}"
        # Each of the other robots has texts and blocks as the file itself has.
        items = ((key, item, depth + (1 if key == "others" else -1)) for key, item in value.items())
        parts = [f"{_key(key)}: {_written(item, levels, inner)}" for key, item, levels in items]
    else:
        opening, closing = "[]"
        parts = [_written(item, depth - 1, inner) for item in value]
    return f"{opening}\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}{closing}"


def _key(key: str) -> str:
    return msgspec.json.encode(key).decode()
