"""Labels of blocks: sentences that name their parameters in braces.

    drive forward at {advSpeed} mm/s

A parameter that the label does not name follows it, with the parameter's own translation.
"""

import re
from collections.abc import Callable, Mapping

from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter

_PLACE = re.compile(r"\{(\w+)\}")


def translated(texts: Mapping[str, str], language: str, otherwise: str) -> str:
    """A text of a configuration in a language, else in English, else `otherwise`."""
    code = language.upper()
    return texts.get(code) or texts.get(code.partition("-")[0]) or texts.get("EN") or otherwise


def label(block: BlockConfiguration, language: str) -> str:
    """The label with its parameters in brackets: ``drive forward at (speed) mm/s``."""
    return sentence(block, language, lambda one: f"({parameter_name(one, language)})")


def sentence(block: BlockConfiguration, language: str, field: Callable[[Parameter], str]) -> str:
    """The label with a replacement for each parameter.

    Args:
        block: the skill.
        language: such as ``es``.
        field: returns the replacement for a parameter.
    """
    parameters = {one.name: one for one in block.parameters}
    text = translated(block.languages, language, block.name)
    named = {name for name in _PLACE.findall(text) if name in parameters}
    following = [
        f"{parameter_name(one, language)} {field(one)}"
        for name, one in parameters.items()
        if name not in named
    ]

    def filled(place: re.Match[str]) -> str:
        name = place[1]
        # A field can be shown only once, and braces that name no parameter are plain text.
        return field(parameters.pop(name)) if name in parameters else place[0]

    return " ".join([_PLACE.sub(filled, text), *following])


def parameter_name(parameter: Parameter, language: str) -> str:
    """The name of a parameter for a reader."""
    return translated(parameter.translations, language, parameter.name)
