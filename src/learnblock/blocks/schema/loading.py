"""Block configurations from JSON: the built-in ones, and files of users and libraries."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.errors import BlockConfigurationError, Diagnostic
from learnblock.fields import Range
from learnblock.i18n import Phrase

_CONFIGURATIONS = Path(__file__).parents[1] / "configurations"
#: The first built-in configurations, in the order of the palette; all others follow by name. There
#: is one file per tab; their words are in `words/`, one file per language.
_FIRST_TABS = (
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
    "screen",
    "led",
    "matrix",
    "mp3",
    "pen",
    "cozmo",
    "messages",
    "others",
)
#: Words by upper-case language code.
_Words = Mapping[str, Any]


def load_configurations(source: Path | str) -> tuple[BlockConfiguration, ...]:
    """The block configurations in a file or a string: one, or a list of them.

        >>> load_configurations('''{"type": "motor", "category": "Dance", "name": "waltz",
        ...                         "shape": ["blockVertical"], "languages": {"EN": "waltz"}}''')
        (BlockConfiguration(type='motor', category='Dance', name='waltz', ...),)

    Args:
        source: a path is read as UTF-8; a string is the JSON itself.

    Raises:
        BlockConfigurationError: there are mistakes; the error lists all of them.
        OSError: the file cannot be read.
    """
    if isinstance(source, Path):
        return _parse(_read(source), str(source))
    return _parse(source, "<text>")


@cache
def builtin() -> Mapping[str, BlockConfiguration]:
    """The built-in blocks by name, in the order of the palette."""
    # The tests check them, so they can be loaded here without checks.
    words = {path.stem.upper(): _json(path) for path in _CONFIGURATIONS.glob("words/*.json")}
    blocks = [
        _trusted(raw, _of(words, raw["name"]))
        for tab in tabs()
        for raw in _json(_CONFIGURATIONS / f"{tab}.json")
    ]
    return MappingProxyType({block.name: block for block in blocks})


def tabs() -> Iterator[str]:
    """The names of the files of built-in configurations, in the order of the palette."""
    there = sorted(path.stem for path in _CONFIGURATIONS.glob("*.json"))
    yield from _FIRST_TABS
    yield from (tab for tab in there if tab not in _FIRST_TABS)


def _read(path: Path) -> str:
    data = path.read_bytes()
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        diagnostic = Diagnostic("not-utf-8", Phrase("block-not-utf-8"), line)
        raise BlockConfigurationError(str(path), [diagnostic]) from None


def _parse(text: str, filename: str) -> tuple[BlockConfiguration, ...]:
    from learnblock.blocks.schema.reading import read  # noqa: PLC0415 - not needed to start
    from learnblock.storage.json_source import parse  # noqa: PLC0415 - not needed to start

    blocks, problems = read(parse(text, filename))
    if problems:
        raise BlockConfigurationError(filename, problems, text)
    return blocks


def _json(path: Path) -> Any:
    return json.loads(path.read_bytes())


def _trusted(raw: dict[str, Any], words: _Words) -> BlockConfiguration:
    parameters = _of(words, "parameters")
    return BlockConfiguration(
        type=raw["type"],
        category=raw["category"],
        name=raw["name"],
        parameters=tuple(
            _trusted_parameter(variable, _of(parameters, variable["name"]))
            for variable in raw.get("variables", ())
        ),
        shapes=tuple(raw["shape"]),
        languages=_of(words, "label"),
        tooltip=_of(words, "tooltip"),
        needs=tuple(raw.get("needs", ())),
        returns=raw.get("returns", "any"),
    )


def _trusted_parameter(raw: dict[str, Any], words: _Words) -> Parameter:
    return Parameter(
        name=raw["name"],
        type=raw["type"],
        default=raw.get("default"),
        required="default" not in raw,
        translations=_of(words, "name"),
        range=Range(*raw["range"]) if "range" in raw else None,
        choices=tuple(raw.get("choices", ())),
        choice_names=_by_key(_of(words, "choices")),
        directions=_by_key(_of(words, "directions")),
        needs=raw.get("needs", ""),
    )


def _of(words: _Words, key: str) -> _Words:
    """By language what is under a key, in the languages that have it."""
    return {language: own[key] for language, own in words.items() if key in own}


def _by_key(words: _Words) -> dict[str, _Words]:
    """The same words by key, and then by language."""
    keys = dict.fromkeys(key for own in words.values() for key in own)
    return {key: _of(words, key) for key in keys}


def completed(block: BlockConfiguration, earlier: BlockConfiguration) -> BlockConfiguration:
    """`block`, completed from its earlier configuration."""
    same = {parameter.name: parameter for parameter in earlier.parameters}
    parameters = tuple(
        replace(
            parameter, translations={**same[parameter.name].translations, **parameter.translations}
        )
        if parameter.name in same
        else parameter
        for parameter in block.parameters
    )
    return replace(
        block,
        parameters=parameters or earlier.parameters,
        languages={**earlier.languages, **block.languages},
        tooltip={**earlier.tooltip, **block.tooltip},
        returns=earlier.returns if block.returns == "any" else block.returns,
        needs=block.needs or earlier.needs,
        library=earlier.library,
        titles=earlier.titles,
    )
