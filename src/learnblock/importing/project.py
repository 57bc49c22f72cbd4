"""A project of the original LearnBlock: the blocks on its canvas and how they are connected."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from math import isfinite
from typing import Any

from learnblock.errors import ProjectError
from learnblock.i18n import Phrase
from learnblock.importing.pickle_reader import Object, Point, read_pickle, refusal

#: Of a project: more than any person has made.
MOST_BLOCKS = 10_000
#: Values in the fields of a block.
MOST_VARIABLES = 50
#: Names of variables, events, functions and libraries.
MOST_NAMES = 1000
#: Characters of a name or a value.
LONGEST_TEXT = 10_000
#: Pixels from the middle of the canvas.
FARTHEST = 1_000_000.0


class BlockKind(IntEnum):
    """What a block is."""

    OPERATOR = 0
    CONTROL = 1
    SKILL = 2
    VARIABLE = 3
    FUNCTION = 4
    WHEN = 5
    LIBRARY = 6


@dataclass(frozen=True)
class Value:
    """A value in a field of a block.

    Args:
        type: ``float``, ``int``, ``string``, ``boolean``, ``list`` or ``apriltext``.
        text: the value as typed, or the name of a variable.
    """

    type: str
    text: str


@dataclass(frozen=True)
class OldBlock:
    """A block on the canvas.

    Args:
        id: names the block in the project.
        name: of the skill, function or variable; or the text of the block.
        kind: what it is.
        values: those in its fields.
        event: the name of a ``when``.
        right: the id of the block on its right.
        inside: the id of the first block inside it.
        below: the id of the block below.
        holds_blocks: whether blocks can be put inside it.
        is_value: whether it fits on the right of another block.
        x: its position in pixels, to the right.
        y: its position in pixels, downwards.
    """

    id: str
    name: str
    kind: BlockKind
    values: tuple[Value, ...] = ()
    event: str = ""
    right: str | None = None
    inside: str | None = None
    below: str | None = None
    holds_blocks: bool = False
    is_value: bool = False
    x: float = 0
    y: float = 0


@dataclass(frozen=True)
class OriginalProject:
    """What a ``.blockProject`` contains.

    Args:
        blocks: by id, in the order of the file.
        variables: the names of its variables.
        functions: the names of its functions.
        libraries: the imported libraries: names or paths.
        in_radians: whether rotations are radians per second, as in version 1.
    """

    blocks: Mapping[str, OldBlock]
    variables: tuple[str, ...] = ()
    functions: tuple[str, ...] = ()
    libraries: tuple[str, ...] = ()
    in_radians: bool = False


def read_project(data: bytes, filename: str) -> OriginalProject:
    """Read a project of the original LearnBlock, of versions 1 to 3.

    Raises:
        ProjectError: the file is damaged, or is not such a project.
    """
    return _Reader(filename).project(read_pickle(data, filename))


#: The ends of connections, by their numbers in the file.
_ENDS = {0: "above", 1: "below", -1: "inside", 5: "inside", 3: "right", 4: "left"}


class _Reader:
    """Checks the values of a pickle, which may be anything."""

    def __init__(self, filename: str) -> None:
        self.filename = filename

    def wrong(self, what: str) -> ProjectError:
        message = Phrase("import-wrong-project", place=what)
        return refusal(self.filename, "wrong-project", message)

    def project(self, value: object) -> OriginalProject:
        if not isinstance(value, tuple) or len(value) not in {5, 6}:
            raise self.wrong("project")
        blocks, _, _, variables, functions, *libraries = value
        if not isinstance(blocks, dict) or len(blocks) > MOST_BLOCKS:
            raise self.wrong("blocks")
        read = {str(key): self.block(str(key), block) for key, block in blocks.items()}
        first = any(
            isinstance(block, Object) and block.kind == "first block" for block in blocks.values()
        )
        return OriginalProject(
            read,
            self.names(variables, "variables"),
            self.names(functions, "functions"),
            self.names(libraries[0], "libraries") if libraries else (),
            in_radians=first,
        )

    def names(self, values: object, place: str) -> tuple[str, ...]:
        if not isinstance(values, list) or len(values) > MOST_NAMES:
            raise self.wrong(place)
        return tuple(self.text(text, place) for text in values)

    def text(self, value: object, place: str) -> str:
        if not isinstance(value, str) or len(value) > LONGEST_TEXT:
            raise self.wrong(place)
        return value

    def block(self, key: str, value: object) -> OldBlock:
        if not isinstance(value, Object) or value.kind not in {"block", "first block"}:
            raise self.wrong(key[:LONGEST_TEXT])
        state = value.state
        name = self.text(state.get("name"), f"{key[:100]}.name")
        position = state.get("pos")
        return OldBlock(
            id=key,
            name=name.strip(),
            kind=self.kind(state.get("type"), name),
            values=self.values(state.get("vars"), name),
            event=self.text(state.get("nameControl") or "", name).strip(),
            **self.ends(state.get("connections"), name),
            **_place(position) if isinstance(position, Point) else {},
        )

    def kind(self, value: object, name: str) -> BlockKind:
        if isinstance(value, int) and value in set(BlockKind):
            return BlockKind(value)
        raise self.wrong(f"{name[:100]}.type")

    def values(self, values: object, name: str) -> tuple[Value, ...]:
        if not isinstance(values, list | None) or len(values or ()) > MOST_VARIABLES:
            raise self.wrong(f"{name[:100]}.vars")
        return tuple(self.value(value, name) for value in values or ())

    def value(self, value: object, name: str) -> Value:
        place = f"{name[:100]}.vars"
        if not isinstance(value, Object) or value.kind != "variable":
            raise self.wrong(place)
        text = value.state.get("defaul")
        default = text if isinstance(text, str) else "" if text is None else self.plain(text, place)
        return Value(self.text(value.state.get("type"), place), self.text(default, place).strip())

    def plain(self, value: object, place: str) -> str:
        if isinstance(value, int | float):
            return str(value)
        raise self.wrong(place)

    def ends(self, values: object, name: str) -> dict[str, Any]:
        """The blocks at the ends of a block's connections."""
        place = f"{name[:100]}.connections"
        if not isinstance(values, list) or len(values) > MOST_VARIABLES:
            raise self.wrong(place)
        ends: dict[str, Any] = {}
        for value in values:
            if not isinstance(value, Object) or value.kind != "connection":
                raise self.wrong(place)
            end = value.state.get("_Connection__type")
            if not isinstance(end, int) or end not in _ENDS:
                raise self.wrong(place)
            self.add_end(ends, _ENDS[end], value.state.get("_Connection__idItem"), place)
        return ends

    def add_end(self, ends: dict[str, Any], end: str, other: object, place: str) -> None:
        if end == "inside":
            ends["holds_blocks"] = True
        if end == "left":
            ends["is_value"] = True
        if other is None or end in {"above", "left"}:
            return
        if not isinstance(other, str | int):
            raise self.wrong(place)
        ends[end] = str(other)


def _place(point: Point) -> dict[str, Any]:
    """A position that a page can show."""
    x, y = (
        max(-FARTHEST, min(FARTHEST, float(coordinate))) if isfinite(coordinate) else 0.0
        for coordinate in (point.x, point.y)
    )
    return {"x": x, "y": y}
