"""A project and its file: JSON that a person can read, with a version.

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

Texts are lists of their lines. ``python`` stands there only where its author wrote it by hand,
``workspace`` says where the blocks lie, ``breakpoints`` names blocks, ``shown`` and
``block_sets`` say which blocks the palette shows, and ``libraries`` with which versions of those it
was made.
"""

import dataclasses
import json
import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Struct, field

from learnblock import library
from learnblock.blocks.block_sets import EVERYTHING, BlockNames, BlockSet
from learnblock.errors import Diagnostic, ProjectError, did_you_mean
from learnblock.files import is_device_name
from learnblock.language.workspace import Workspace
from learnblock.running import DEFAULT_ROBOT
from learnblock.server.messages import MOST_BREAKPOINTS, MOST_CARRIED, Id

ENDING = ".learnblock"
VERSION = 1
#: Bytes; a thousand statements with their blocks take a tenth of it.
LARGEST = 4 * 1024 * 1024
LONGEST_NAME = 100
#: That a program imports.
MOST_LIBRARIES = 1000

# No separators, and neither end may be what Windows strips or Unix hides.
_NAME = re.compile(r"[^\W_](?:[\w .-]*[\w-])?")


@dataclass(frozen=True)
class Project:
    """A program, how its blocks are laid out, and what it runs on.

    Args:
        name: also of its file.
        blocktext: the program.
        python: the same, as its author wrote it by hand; None where nobody did.
        workspace: its blocks; None to lay them out anew.
        robot: its name.
        world: its name; empty for the robot's own.
        breakpoints: ids of blocks.
        shown: the name of the set of blocks that the palette shows.
        block_sets: those that are not ours, so that the project takes them along.
        libraries: the version of each that the program was made with.
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


Choice = Annotated[str, Meta(max_length=LONGEST_NAME)]


class _File(Struct, forbid_unknown_fields=True):
    """What a project's file holds, in this order."""

    learnblock: int
    blocktext: list[str]
    robot: Choice = DEFAULT_ROBOT
    world: Choice = ""
    breakpoints: Annotated[list[Id], Meta(max_length=MOST_BREAKPOINTS)] = field(
        default_factory=list
    )
    shown: Choice = EVERYTHING
    block_sets: Annotated[tuple[BlockSet, ...], Meta(max_length=MOST_CARRIED)] = ()
    libraries: Annotated[dict[library.Name, library.Version], Meta(max_length=MOST_LIBRARIES)] = {}
    python: list[str] | None = None
    workspace: Workspace | None = None


class _Head(Struct):
    """What tells a project's file from other JSON."""

    learnblock: Any = None


_read_head = msgspec.json.Decoder(_Head).decode
_read_file = msgspec.json.Decoder(_File).decode


def checked_name(name: str) -> str:
    """The name in the form in which files are called.

    Raises:
        ProjectError: a project cannot be called so.
    """
    name = unicodedata.normalize("NFC", name)
    if not _NAME.fullmatch(name) or len(name.encode("utf-8", "replace")) > LONGEST_NAME:
        _refuse(
            name,
            "wrong-name",
            f"a project cannot be called {name!r:.120}: letters, digits, blanks, `-`, `_` and `.`"
            f" make a name, at most {LONGEST_NAME} of them, and it begins with a letter or digit",
        )
    if is_device_name(name):
        _refuse(name, "wrong-name", f"`{name}` is a device's name on Windows: choose another one")
    return name


def encode(project: Project) -> bytes:
    """The file of a project.

    Raises:
        ProjectError: it is larger than any that `decode` reads, or holds what is no text.
    """
    try:
        data = (_written(_values(project)) + "\n").encode()
    except UnicodeEncodeError as error:
        character = ord(error.object[error.start])
        message = f"the character U+{character:04X} cannot be saved: remove it from the program"
        _refuse(project.name, "bad-character", message)
    if len(data) > LARGEST:
        message = f"the project has {len(data):,} bytes; at most {LARGEST:,} are saved"
        _refuse(project.name, "too-large", message)
    return data


def decode(data: bytes, name: str) -> Project:
    """The project that a file holds.

    Raises:
        ProjectError: it is no project, or a wrong one; the diagnostic says where.
    """
    filename = name + ENDING
    if len(data) > LARGEST:
        message = f"the file has {len(data):,} bytes; a project has at most {LARGEST:,}"
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
        _refuse(filename, "too-deep", "its brackets stand deeper inside each other than any blocks")
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
    )


# Reading.


def _text(data: bytes, filename: str) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        problem = f"the byte {data[error.start]:#x} is not UTF-8: this is no project"
        raise ProjectError(filename, [Diagnostic("not-utf-8", problem, line)]) from None


def _check_version(version: object, filename: str) -> None:
    if version is None:
        _refuse(
            filename,
            "no-project",
            'this is no project of LearnBlock: a project begins with `"learnblock": 1`',
        )
    if version != VERSION or isinstance(version, bool):
        _refuse(
            filename,
            "unknown-version",
            f"`learnblock` is {version!r:.40}, and this LearnBlock reads version {VERSION}:"
            " a newer LearnBlock may open it",
        )


def _check_choices(file: _File, filename: str) -> None:
    """Robots and worlds are chosen by name: a project never leads out of its folder."""
    for key, value in (("robot", file.robot), ("world", file.world)):
        if value and not _NAME.fullmatch(value):
            _refuse(
                filename,
                "no-name",
                f"`{key}` is {value!r}: a project names a {key} there is, such as"
                f" `{_SUCH_AS[key]}`, and no path",
            )


_SUCH_AS = {"robot": DEFAULT_ROBOT, "world": "line"}
_PLACE = re.compile(r" - at (?:`key` in )?`\$\.?(.*?)`$")
_UNKNOWN = re.compile(r"Object contains unknown field `(.+)`")
_MISSING = re.compile(r"Object missing required field `(.+)`")
_BYTE = re.compile(r" \(byte (\d+)\)")
_ADVICE = {
    "blocktext": "it is the list of the program's lines",
    "python": "it is the list of the lines of Python",
    "robot": "it is the name of a robot, such as `sim-ebo`",
    "world": "it is the name of a world, such as `line`",
    "breakpoints": f"it is a list of the ids of at most {MOST_BREAKPOINTS} blocks",
    "shown": "it is the name of a set of blocks, such as `first-steps`",
    "block_sets": f"it is a list of at most {MOST_CARRIED} sets of blocks",
    "libraries": 'it gives the version of each library, such as `{"dance": "1.2.0"}`',
    "workspace": "leave it out to have the blocks laid out anew",
}


def _explained(refusal: str, text: str) -> Diagnostic:
    """What msgspec refuses, in the words of the file."""
    found = _PLACE.search(refusal)
    place = found[1] if found else ""
    key = re.split(r"[.\[]", place, maxsplit=1)[0]
    refusal = _PLACE.sub("", refusal)
    if missing := _MISSING.match(refusal):
        advice = _ADVICE.get(missing[1], "it belongs there")
        return _at("", text, "missing-key", f"{_owner(place)} lacks `{missing[1]}`: {advice}")
    if unknown := _UNKNOWN.match(refusal):
        known = _known(place)
        hint = did_you_mean(unknown[1], known) or "known are: " + ", ".join(known)
        message = f"{_owner(place)} has a key `{unknown[1]}`, which is not known; {hint}"
        return _at(unknown[1], text, "unknown-key", message)
    value = _shown(place, text)
    wrong = refusal[0].lower() + refusal[1:]
    advice = _ADVICE.get(key, 'the file begins with `{"learnblock": 1`')
    message = f"{_owner(place)} is {value}: {wrong}; {advice}"
    return _at(key, text, "wrong-value", message)


def _known(place: str) -> tuple[str, ...]:
    """The keys that there may be at a place."""
    if not place.startswith("block_sets"):
        return _File.__struct_fields__
    kind = BlockNames if place.endswith((".show", ".hide")) else BlockSet
    return kind.__struct_fields__


def _owner(place: str) -> str:
    return f"`{place}`" if place else "the file"


def _shown(place: str, text: str) -> str:
    """The value at a place, as the file has it, cut where it is long."""
    try:
        value = json.loads(text)
        for index, key in re.findall(r"\[(\d+)\]|([^.\[\]]+)", place):
            value = value[int(index)] if index else value[key]
        written = json.dumps(value, ensure_ascii=False)
    except (KeyError, TypeError, ValueError, RecursionError):
        # Msgspec calls each value of an object `...`; and some values cannot be shown at all.
        return "wrong"
    return written if len(written) <= 60 else written[:57] + "..."


def _at(key: str, text: str, code: str, message: str) -> Diagnostic:
    found = re.search(rf'^\s*("{re.escape(key)}")\s*:', text, re.MULTILINE) if key else None
    if found is None:
        return Diagnostic(code, message)
    start = text.rfind("\n", 0, found.start(1)) + 1
    line, column = text.count("\n", 0, start) + 1, found.start(1) - start + 1
    return Diagnostic(code, message, line, column, column + len(found[1]))


def _malformed(refusal: str, data: bytes) -> Diagnostic:
    """What is no JSON, and where."""
    found = _BYTE.search(refusal)
    at = int(found[1]) if found else len(data)
    start = data.rfind(b"\n", 0, at) + 1
    column = len(data[start:at].decode("utf-8", "replace")) + 1
    what = _BYTE.sub("", refusal).removeprefix("JSON is malformed: ")
    message = f"this is no JSON ({what}), so no project: take an older copy of the file"
    return Diagnostic("not-json", message, data.count(b"\n", 0, start) + 1, column)


def _refuse(filename: str, code: str, message: str) -> NoReturn:
    raise ProjectError(filename, [Diagnostic(code, message)])


# Writing.

#: Brackets that begin a line of their own: those of the file, of a text, of the list of stacks.
_SPREAD = 3


def _values(project: Project) -> dict[str, Any]:
    """The file's values; blocks stay what they are, since `msgspec` alone writes deep ones."""
    values: dict[str, Any] = {"learnblock": VERSION, "robot": project.robot}
    values["world"] = project.world
    values["breakpoints"] = list(project.breakpoints)
    if project.shown != EVERYTHING:
        values["shown"] = project.shown
    if project.block_sets:
        values["block_sets"] = msgspec.to_builtins(project.block_sets)
    if project.libraries:
        values["libraries"] = dict(project.libraries)
    values["blocktext"] = project.blocktext.split("\n")
    if project.python is not None:
        values["python"] = project.python.split("\n")
    if project.workspace is not None:
        values["workspace"] = msgspec.structs.asdict(project.workspace)
    return values


def _written(value: Any, depth: int = _SPREAD, indent: str = "") -> str:
    """JSON with a line for each line of a text and for each stack of blocks."""
    if not depth or not value or not isinstance(value, dict | list):
        return msgspec.json.encode(value).decode()
    inner = indent + "  "
    if isinstance(value, dict):
        opening, closing = "{}"
        parts = [f'"{key}": {_written(one, depth - 1, inner)}' for key, one in value.items()]
    else:
        opening, closing = "[]"
        parts = [_written(one, depth - 1, inner) for one in value]
    return f"{opening}\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}{closing}"
