"""Projects, and their files: readable JSON with a version number.

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
"""

import codecs
import dataclasses
import json
import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Struct, field

from learnblock.blocks.block_sets import EVERYTHING, BlockNames, BlockSet
from learnblock.errors import Diagnostic, ProjectError
from learnblock.extensions.libraries import Name, Version
from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.perception.tag_names import LAST_TAG
from learnblock.running import DEFAULT_ROBOT
from learnblock.server.messages import MOST_BREAKPOINTS, MOST_CARRIED, Id
from learnblock.server.projects.carried import NOTHING, Carried, CarriedWorld, Code, TagNames
from learnblock.storage.file_phrases import place as phrase_of_place
from learnblock.storage.file_phrases import unknown_key
from learnblock.storage.files import is_device_name

ENDING = ".learnblock"
VERSION = 1
#: The version of a file that carries something.
CARRYING_VERSION = 2
#: The maximum size in bytes; a thousand statements with their blocks take a tenth of it.
LARGEST = 4 * 1024 * 1024
LONGEST_NAME = 100
#: The maximum number of imports in a program.
MOST_LIBRARIES = 1000

# No separators, no first character that hides a file on Unix, no last one that Windows strips.
_NAME = re.compile(r"[^\W_](?:[\w .-]*[\w-])?")


@dataclass(frozen=True)
class Project:
    """A program with the layout of its blocks, its robot and its world.

    Args:
        name: the name, also of its file.
        blocktext: the program in Block-Text.
        python: the Python that its author wrote by hand; None if it is generated.
        workspace: its blocks; None to lay them out.
        robot: its name.
        world: its name; empty for the usual world of the robot.
        breakpoints: the ids of blocks.
        shown: the name of the block set that the palette shows.
        block_sets: the block sets that are saved in the project.
        libraries: the versions with which the program was made, by name.
        tags: the numbers of tags, by name, that this project uses instead of the user's.
        carried: the author's own things that the program needs.
    """

    name: str
    blocktext: str = ""
    python: str | None = None
    workspace: Workspace | None = None
    robot: str = DEFAULT_ROBOT
    world: str = ""
    breakpoints: tuple[str, ...] = ()
    shown: str = EVERYTHING
    block_sets: tuple[BlockSet, ...] = ()
    libraries: Mapping[str, str] = dataclasses.field(default_factory=dict)
    tags: Mapping[str, int] = dataclasses.field(default_factory=dict)
    carried: Carried = NOTHING


Choice = Annotated[str, Meta(max_length=LONGEST_NAME)]


class _File(Struct, forbid_unknown_fields=True):
    """The values of a project's file, in this order."""

    learnblock: int
    blocktext: list[str]
    robot: Choice = DEFAULT_ROBOT
    world: Choice = ""
    breakpoints: Annotated[list[Id], Meta(max_length=MOST_BREAKPOINTS)] = field(
        default_factory=list
    )
    shown: Choice = EVERYTHING
    block_sets: Annotated[tuple[BlockSet, ...], Meta(max_length=MOST_CARRIED)] = ()
    libraries: Annotated[dict[Name, Version], Meta(max_length=MOST_LIBRARIES)] = {}
    tags: TagNames = {}
    carried: Carried = NOTHING
    python: list[str] | None = None
    workspace: Workspace | None = None


class _Head(Struct):
    """The key that distinguishes a project's file from other JSON."""

    learnblock: Any = None


_read_head = msgspec.json.Decoder(_Head).decode
_read_file = msgspec.json.Decoder(_File).decode


def checked_name(name: str) -> str:
    """Check a name, and return it in the form of file names.

    Raises:
        ProjectError: a project can't have this name.
    """
    name = unicodedata.normalize("NFC", name)
    if not _NAME.fullmatch(name) or len(name.encode("utf-8", "replace")) > LONGEST_NAME:
        _refuse(
            name,
            "wrong-name",
            Phrase("project-name-wrong", name=name[:120], limit=LONGEST_NAME),
        )
    if is_device_name(name):
        _refuse(name, "wrong-name", Phrase("project-name-device", name=name))
    return name


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
    if version not in (VERSION, CARRYING_VERSION) or isinstance(version, bool):
        _refuse(
            filename,
            "unknown-version",
            Phrase("project-version", version=f"{version!r:.40}", known=str(CARRYING_VERSION)),
        )


def _check_choices(file: _File, filename: str) -> None:
    """Refuse paths: a project names robots and worlds, and never points outside its folder."""
    for key, value in (("robot", file.robot), ("world", file.world)):
        if value and not _NAME.fullmatch(value):
            _refuse(
                filename,
                "no-name",
                Phrase("project-path", kind=key, value=repr(value), example=_SUCH_AS[key]),
            )


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
    "block_sets": Phrase("project-expects-block-sets", limit=MOST_CARRIED),
    "libraries": Phrase("project-expects-libraries", example='{"dance": "1.2.0"}'),
    "tags": Phrase("project-expects-tags", example='{"door": 12}', last=LAST_TAG),
    "carried": Phrase("project-expects-carried"),
    "workspace": Phrase("project-expects-workspace"),
}
#: The positions of a file with keys of their own.
_PARTS: tuple[tuple[str, type[Struct]], ...] = (
    (r"block_sets.*\.(?:show|hide)", BlockNames),
    (r"block_sets.*", BlockSet),
    (r"carried\.world", CarriedWorld),
    (r"carried\.(?:code|offered)", Code),
    (r"carried", Carried),
)


def _explained(refusal: str, text: str) -> Diagnostic:
    """Explain an error of msgspec to a person who knows only the file."""
    found = _PLACE.search(refusal)
    place = found[1] if found else ""
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
    found = (kind for pattern, kind in _PARTS if re.fullmatch(pattern, place))
    return next(found, _File).__struct_fields__


def _shown(place: str, text: str) -> str | None:
    """The value at a position as in the file, shortened if long; None if it can't be shown."""
    try:
        value = json.loads(text)
        for index, key in re.findall(r"\[(\d+)\]|([^.\[\]]+)", place):
            value = value[int(index)] if index else value[key]
        written = json.dumps(value, ensure_ascii=False)
    except (KeyError, TypeError, ValueError, RecursionError):
        # Msgspec calls each value of an object `...`, and some values can't be shown at all.
        return None
    return written if len(written) <= 60 else written[:57] + "..."


def _at(key: str, text: str, code: str, message: Phrase) -> Diagnostic:
    found = re.search(rf'^\s*("{re.escape(key)}")\s*:', text, re.MULTILINE) if key else None
    if found is None:
        return Diagnostic(code, message)
    start = text.rfind("\n", 0, found.start(1)) + 1
    line, column = text.count("\n", 0, start) + 1, found.start(1) - start + 1
    return Diagnostic(code, message, line, column, column + len(found[1]))


def _malformed(refusal: str, data: bytes) -> Diagnostic:
    """Report a file that is not JSON, with the position."""
    found = _BYTE.search(refusal)
    at = int(found[1]) if found else len(data)
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
    version = CARRYING_VERSION if project.carried or project.tags else VERSION
    values: dict[str, Any] = {"learnblock": version, "robot": project.robot}
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
    return values


def _written(value: Any, depth: int = _SPREAD, indent: str = "") -> str:
    """Encode JSON with one line per line of text and per stack of blocks."""
    if not depth or not value or not isinstance(value, dict | list):
        return msgspec.json.encode(value).decode()
    inner = indent + "  "
    if isinstance(value, dict):
        opening, closing = "{}"
        items = value.items()
        parts = [f"{_key(key)}: {_written(one, depth - 1, inner)}" for key, one in items]
    else:
        opening, closing = "[]"
        parts = [_written(one, depth - 1, inner) for one in value]
    return f"{opening}\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}{closing}"


def _key(key: str) -> str:
    return msgspec.json.encode(key).decode()
