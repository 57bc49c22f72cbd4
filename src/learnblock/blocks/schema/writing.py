"""Block configurations as the JSON that `load_configurations` reads."""

import json
from collections.abc import Iterable, Mapping
from typing import Any

from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.fields import Range


def written(configurations: Iterable[BlockConfiguration]) -> str:
    """Configurations as the text of a file."""
    return json.dumps(list(map(_block, configurations)), indent=2, ensure_ascii=False) + "\n"


def _block(block: BlockConfiguration) -> dict[str, Any]:
    return {
        "type": block.type,
        "category": block.category,
        "name": block.name,
        "variables": list(map(_parameter, block.parameters)),
        "shape": list(block.shapes),
        **({} if block.returns == "any" else {"returns": block.returns}),
        "languages": dict(block.languages),
        "tooltip": dict(block.tooltip),
        **({"needs": list(block.needs)} if block.needs else {}),
    }


def _parameter(parameter: Parameter) -> dict[str, Any]:
    return {
        "type": parameter.type,
        "name": parameter.name,
        **({} if parameter.required else {"default": parameter.default}),
        **({"range": _range(parameter.range)} if parameter.range else {}),
        **({"choices": list(parameter.choices)} if parameter.choices else {}),
        **_words("choiceNames", parameter.choice_names),
        **_words("directions", parameter.directions),
        **({"needs": parameter.needs} if parameter.needs else {}),
        "translate": dict(parameter.translations),
    }


def _words(key: str, words: Mapping[str, Mapping[str, str]]) -> dict[str, Any]:
    entries = {word: dict(translations) for word, translations in words.items()}
    return {key: entries} if entries else {}


def _range(bounds: Range) -> list[float]:
    step = () if bounds.step is None else (bounds.step,)
    return [bounds.least, bounds.most, *step]
