"""Descriptions of skills, functions and keywords, in the user's language."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from learnblock.blocks import BlockConfiguration, Parameter
from learnblock.language.tree.builtins import BUILTINS, TEMPLATES

_FOLDER = Path(__file__).parent
_FALLBACK = "en"
#: Parameters of Python's functions, if they need a description.
_BUILTIN_PARAMETERS: Mapping[str, str] = {
    "abs": "x",
    "float": "x",
    "input": "prompt",
    "int": "x",
    "len": "values",
    "list": "values",
    "max": "x, ...",
    "min": "x, ...",
    "print": "x, ...",
    "round": "x, digits",
    "sorted": "values",
    "str": "x",
    "sum": "values",
}


@dataclass(frozen=True)
class Words:
    """Sentences in one language, with English for missing ones.

    Args:
        language: the language, such as ``es``.
    """

    language: str = _FALLBACK

    def say(self, key: str, **values: str) -> str:
        """One of the sentences."""
        return str(self._all.get(key, "")).format(**values)

    def about(self, kind: str, name: str) -> str:
        """The description of one of ``keywords``, ``functions``, ``robot_members`` and so on."""
        texts: Mapping[str, str] = self._all.get(kind, {})
        return texts.get(name, "")

    def known(self, kind: str) -> tuple[str, ...]:
        """The names that `about` can describe."""
        return tuple(self._all.get(kind, ()))

    def tooltip(self, skill: BlockConfiguration) -> str:
        return skill.tooltip.get(self.language.upper()) or skill.tooltip.get("EN", "")

    def parameter(self, parameter: Parameter) -> str:
        """The name of a skill's argument on its block."""
        labels = parameter.translations
        return labels.get(self.language.upper()) or labels.get("EN", "")

    @property
    def _all(self) -> Mapping[str, Any]:
        return _read(self.language if self.language in languages() else _FALLBACK)


@cache
def languages() -> tuple[str, ...]:
    """The available languages."""
    return tuple(sorted(path.stem for path in _FOLDER.glob("*.json")))


@cache
def _read(language: str) -> Mapping[str, Any]:
    words: dict[str, Any] = msgspec.json.decode((_FOLDER / f"{language}.json").read_bytes())
    if language == _FALLBACK:
        return words
    english = _read(_FALLBACK)
    return {
        key: {**part, **words.get(key, {})} if isinstance(part, dict) else words.get(key, part)
        for key, part in english.items()
    }


def signature(skill: BlockConfiguration) -> str:
    """The parameters and their defaults in brackets."""
    return f"({', '.join(map(_parameter, skill.parameters))})"


def library_parameters(name: str) -> tuple[str, ...]:
    """The parameters of each form of a function of the language, such as ``values, index``."""
    if name == "elapsedTime":
        return ("seconds",)
    if name in BUILTINS:
        return (_BUILTIN_PARAMETERS[name],)
    return tuple(
        ", ".join(template.parameters)
        for (function, _), template in TEMPLATES.items()
        if function == name
    )


def _parameter(parameter: Parameter) -> str:
    return parameter.name if parameter.required else f"{parameter.name}={parameter.default!r}"
