"""Where block configurations come from: our own files, the user's, and skills without any."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from learnblock.blocks.configuration import BlockConfiguration, Configurations, Parameter
from learnblock.errors import BlockConfigurationError, Diagnostic

#: Our own, one file per tab, in the order of the palette.
TABS = (
    "base",
    "motor",
    "distances",
    "ground",
    "camera",
    "light",
    "infrared",
    "controller",
    "emotion",
    "speaker",
    "led",
    "matrix",
    "mp3",
    "cozmo",
    "others",
)


def load_configurations(source: Path | str) -> tuple[BlockConfiguration, ...]:
    """The block configurations in a file, or in a text: one, or a list of them.

        >>> load_configurations('''{"type": "motor", "category": "Dance", "name": "waltz",
        ...                         "shape": ["blockVertical"], "languages": {"EN": "waltz"}}''')
        (BlockConfiguration(type='motor', category='Dance', name='waltz', ...),)

    Args:
        source: a path is read as UTF-8; a string is the JSON itself.

    Raises:
        BlockConfigurationError: with everything that is wrong.
        OSError: there is no such file.
    """
    if isinstance(source, Path):
        return _parse(_read(source), str(source))
    return _parse(source, "<text>")


@cache
def builtin() -> Mapping[str, BlockConfiguration]:
    """Our own blocks by name, in the order of the palette."""
    # They are known to be right, since the tests load them with every check.
    blocks = [_trusted(raw) for tab in TABS for raw in _our_own(tab)]
    return MappingProxyType({block.name: block for block in blocks})


def all_configurations() -> Configurations:
    """Every block by name: ours, the user's, those of plugins, and of installed libraries.

    A skill without a configuration has one derived from its signature and docstring. A file in the
    ``blocks`` folder of `home` describes such a skill better, or adds translations to any block.
    What is wrong with a file is told by `Configurations.problems`; all others are there.
    """
    from learnblock.blocks.known import known  # noqa: PLC0415 - not needed to start

    return known()


def _read(path: Path) -> str:
    data = path.read_bytes()
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        diagnostic = Diagnostic("not-utf-8", "this is no UTF-8 text; save the file as UTF-8", line)
        raise BlockConfigurationError(str(path), [diagnostic]) from None


def _parse(text: str, filename: str) -> tuple[BlockConfiguration, ...]:
    from learnblock.blocks.json_source import parse  # noqa: PLC0415 - not needed to start
    from learnblock.blocks.schema import read  # noqa: PLC0415 - as above

    blocks, problems = read(parse(text, filename))
    if problems:
        raise BlockConfigurationError(filename, problems, text)
    return blocks


def _our_own(tab: str) -> Iterator[dict[str, Any]]:
    path = Path(__file__).parent / "configurations" / f"{tab}.json"
    yield from json.loads(path.read_bytes())


def _trusted(raw: dict[str, Any]) -> BlockConfiguration:
    return BlockConfiguration(
        type=raw["type"],
        category=raw["category"],
        name=raw["name"],
        parameters=tuple(map(_trusted_parameter, raw.get("variables", ()))),
        shapes=tuple(raw["shape"]),
        languages=raw["languages"],
        tooltip=raw["tooltip"],
        needs=tuple(raw.get("needs", ())),
    )


def _trusted_parameter(raw: dict[str, Any]) -> Parameter:
    return Parameter(
        name=raw["name"],
        type=raw["type"],
        default=raw.get("default"),
        required="default" not in raw,
        translations=raw["translate"],
        choices=tuple(raw.get("choices", ())),
        choice_names=raw.get("choiceNames", {}),
    )


def completed(block: BlockConfiguration, known: BlockConfiguration) -> BlockConfiguration:
    """`block` with what only the configuration `known` before says."""
    same = {parameter.name: parameter for parameter in known.parameters}
    parameters = tuple(
        replace(one, translations={**same[one.name].translations, **one.translations})
        if one.name in same
        else one
        for one in block.parameters
    )
    return replace(
        block,
        parameters=parameters or known.parameters,
        languages={**known.languages, **block.languages},
        tooltip={**known.tooltip, **block.tooltip},
        needs=block.needs or known.needs,
        library=known.library,
        titles=known.titles,
    )
