"""The palette: everything that the page needs to know about the blocks, in one language."""

from collections.abc import Mapping
from typing import Any

from learnblock.blocks.definitions import definitions, skill_definition
from learnblock.blocks.labels import translated
from learnblock.blocks.python_sentences import python_forms
from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.blocks.styles import CALLS
from learnblock.blocks.toolbox import category_word, skill_block, toolbox
from learnblock.blocks.translation import translation, units


def palette(configurations: Mapping[str, BlockConfiguration], language: str) -> dict[str, Any]:
    """Definitions, toolbox and words of the blocks.

    Input types only guide the user who drags a block. Programs mix types, so the page's
    connection checker must accept any value in any input when a workspace is loaded.

    Args:
        configurations: of the skills, by name.
        language: such as ``es``; words without a translation are English.
    """
    words = translation(language)
    return {
        "definitions": definitions(configurations.values(), language),
        "toolbox": toolbox(configurations, {**_titles(configurations, language), **words}),
        "messages": dict(words),
        "calls": dict(CALLS),
        "forms": python_forms(),
        "units": dict(units()),
        "language": language,
    }


def _titles(configurations: Mapping[str, BlockConfiguration], language: str) -> dict[str, str]:
    """The names of the tabs that libraries bring."""
    return {
        category_word(configuration.category): translated(
            configuration.titles, language, configuration.category
        )
        for configuration in configurations.values()
        if configuration.titles
    }


def preview(
    configuration: BlockConfiguration, language: str
) -> tuple[dict[str, Any], dict[str, Any]]:
    """A skill's block: its definition, and its entry in the palette."""
    return skill_definition(configuration, language), skill_block(configuration)
