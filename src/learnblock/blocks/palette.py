"""The palette: all that the page needs to know of the blocks, in one language."""

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from learnblock.blocks.configuration import BlockConfiguration
from learnblock.blocks.definitions import definitions, skill_definition, translated
from learnblock.blocks.toolbox import category_word, skill_block, toolbox

_TRANSLATIONS = Path(__file__).parent / "translations"


def palette(configurations: Mapping[str, BlockConfiguration], language: str) -> dict[str, Any]:
    """Definitions, toolbox and words of the blocks.

    The types of the inputs are there to help who drags a block: programs mix them, so the page's
    connection checker must let any value stand in any input when a workspace is loaded.

    Args:
        configurations: of the skills, by name.
        language: such as ``es``; what is not translated stays English.
    """
    words = translation(language)
    return {
        "definitions": definitions(configurations.values(), language),
        "toolbox": toolbox(configurations, {**_titles(configurations, language), **words}),
        "messages": dict(words),
        "language": language,
    }


def _titles(configurations: Mapping[str, BlockConfiguration], language: str) -> dict[str, str]:
    """The words of the tabs that bring their own."""
    return {
        category_word(one.category): translated(one.titles, language, one.category)
        for one in configurations.values()
        if one.titles
    }


def preview(
    configuration: BlockConfiguration, language: str
) -> tuple[dict[str, Any], dict[str, Any]]:
    """One skill's block: its definition, and how it lies in the palette."""
    return skill_definition(configuration, language), skill_block(configuration)


def languages() -> tuple[str, ...]:
    """The languages that there is a translation for, such as ``en`` and ``es``."""
    return tuple(sorted(path.stem for path in _TRANSLATIONS.glob("*.json")))


@cache
def translation(language: str) -> Mapping[str, str]:
    """The words of the blocks that are no skills, by the name of their message."""
    known = languages()
    chosen = next((one for one in (language, language.partition("-")[0]) if one in known), "en")
    return MappingProxyType({**_words("en"), **_words(chosen)})


def _words(language: str) -> dict[str, str]:
    found = json.loads((_TRANSLATIONS / f"{language}.json").read_text("utf-8"))
    return {str(name): str(text) for name, text in found.items()}
