"""The example in the help of each block: a program that uses it, and where it runs."""

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import msgspec

from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.blocks.schema.loading import builtin
from learnblock.storage.learned_types import learned

_FOLDER = Path(__file__).parent
#: Before the name of a skill in the names of blocks.
SKILL = "function."
#: A face that every question about another one answers with no.
_OTHER_FACE = {"expressNeutral": "expressJoy"}


class HelpExample(msgspec.Struct, frozen=True, kw_only=True):
    """A program that shows what a block does.

    Args:
        program: its Block-Text.
        world: the name of its world in the folder beside this module.
        keys: (seconds, the key held from then on, or "" for none).
        seconds: when it is stopped, if it has not ended.
    """

    program: str
    world: str = "floor"
    keys: tuple[tuple[float, str], ...] = ()
    seconds: float = 8.0

    @property
    def world_file(self) -> Path:
        """The file of its world."""
        return _FOLDER / "worlds" / f"{self.world}.toml"


class _Usual(msgspec.Struct, frozen=True):
    action: str
    question: str
    measurement: str


class _Skills(HelpExample, frozen=True, kw_only=True):
    """What the examples of some skills have in common; no program stands for the usual one."""

    names: tuple[str, ...]
    program: str = ""


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    usual: _Usual
    arguments: dict[str, str]
    skills: tuple[_Skills, ...]
    faces: dict[str, str]
    language: dict[str, str]
    like: dict[str, str]


def examples() -> Mapping[str, HelpExample]:
    """The examples of all built-in blocks, by the blocks' names in block sets."""
    file = _file()
    language = {
        name: HelpExample(program=text.strip("\n") + "\n") for name, text in file.language.items()
    }
    skills = {SKILL + name: _of_skill(block, file) for name, block in builtin().items()}
    return {**language, **skills}


def example_name(block: str) -> str:
    """The name of the block whose example explains a block, such as that of any call."""
    like = _file().like
    name = like.get(block, block)
    general = name.partition(":")[0]
    return name if name in _file().language or name.startswith(SKILL) else general


@cache
def _file() -> _File:
    return msgspec.convert(
        tomllib.loads((_FOLDER / "examples.toml").read_text("utf-8")), learned(_File)
    )


def _of_skill(block: BlockConfiguration, file: _File) -> HelpExample:
    own = next((entry for entry in file.skills if block.name in entry.names), None)
    entry = own or _Skills(names=(block.name,))
    face = file.faces.get(block.name, "")
    program = (
        (entry.program or _usual(block, file.usual))
        .strip("\n")
        .format(
            call=_call(block, file.arguments),
            face=face,
            other=_OTHER_FACE.get(face, "expressNeutral"),
        )
    )
    return HelpExample(
        program=f"{program}\n", world=entry.world, keys=entry.keys, seconds=entry.seconds
    )


def _usual(block: BlockConfiguration, usual: _Usual) -> str:
    if not block.returns_value:
        return usual.action
    return usual.question if block.returns == "boolean" else usual.measurement


def _call(block: BlockConfiguration, arguments: Mapping[str, str]) -> str:
    if block.name == "elapsedTime":
        return f"elapsedTime({arguments[block.name]})"
    argument_text = arguments.get(block.name)
    if argument_text is None:
        argument_text = ", ".join(_literal(parameter.default) for parameter in block.parameters)
    return f"{SKILL}{block.name}({argument_text})"


def _literal(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)
