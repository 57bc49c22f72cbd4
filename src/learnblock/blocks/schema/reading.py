"""Block configurations from JSON values, and all the mistakes in them."""

import json
import keyword
import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any, TypeVar, get_args

from learnblock.blocks.schema.configuration import (
    NUMBERS,
    SIGNS,
    BlockConfiguration,
    Parameter,
    ParameterType,
    Returns,
)
from learnblock.blocks.schema.defaults import DEFAULTS
from learnblock.blocks.schema.limits import MOST_CHOICES, is_choice, range_problem
from learnblock.errors import Diagnostic, nearest
from learnblock.fields import Range
from learnblock.i18n import Phrase
from learnblock.storage.json_source import JsonDocument, Path, TextPosition

T = TypeVar("T", bound=str)

TYPES = ("motor", "perceptual", "proprioceptive", "express", "control", "operator", "others")
SHAPES = ("blockVertical", "blockLeft", "blockBoth")
RETURNS: tuple[Returns, ...] = get_args(Returns)
PARAMETER_TYPES: tuple[ParameterType, ...] = get_args(ParameterType)

# Each key, and whether it is required.
_BLOCK_KEYS = {
    "type": True,
    "category": True,
    "name": True,
    "variables": False,
    "shape": True,
    "returns": False,
    "languages": False,
    "tooltip": False,
    "needs": False,
}
_PARAMETER_KEYS = {
    "type": True,
    "name": True,
    "default": False,
    "translate": False,
    "range": False,
    "choices": False,
    "choiceNames": False,
    "directions": False,
    "needs": False,
}
# Reporting more of them at once does not help.
_MOST_PROBLEMS = 100
_LANGUAGE = re.compile(r"[A-Z]{2,3}(-[A-Z0-9]{2,8})*")
_NEED = re.compile(r"[A-Za-z][\w-]*(:(\w+|\{\w+\}))?")


def read(document: JsonDocument) -> tuple[tuple[BlockConfiguration, ...], tuple[Diagnostic, ...]]:
    """The configurations in a document (one, or a list), and its mistakes."""
    reader = _Reader(document)
    return tuple(reader.blocks()), tuple(
        sorted(reader.problems, key=lambda problem: (problem.line, problem.column))
    )


class _Reader:
    def __init__(self, document: JsonDocument) -> None:
        self._document = document
        self.problems: list[Diagnostic] = []

    def blocks(self) -> list[BlockConfiguration]:
        for name, place in self._document.repeated:
            self._note("duplicate-key", Phrase("block-duplicate-key", key=name), place)
        value = self._document.value
        items = value if isinstance(value, list) else [value]
        paths: list[Path] = [(i,) for i in range(len(items))] if isinstance(value, list) else [()]
        blocks = [self._block(item, path) for item, path in zip(items, paths, strict=True)]
        self._refuse_repeated([block.name for block in blocks], paths, None)
        return blocks

    # Blocks and parameters. A mistake is recorded and its value replaced, so that the rest is
    # checked too.

    def _block(self, value: object, path: Path) -> BlockConfiguration:
        who = _block_name(value)
        fields = self._fields(value, path, who, _BLOCK_KEYS)
        return BlockConfiguration(
            type=self._choice(fields, "type", path, who, TYPES),
            category=self._text(fields, "category", path, who),
            name=self._name(fields, path),
            parameters=self._parameters(fields, path, who),
            shapes=self._shapes(fields, path, who),
            languages=self._languages(fields, "languages", path, who),
            tooltip=self._languages(fields, "tooltip", path, who),
            needs=self._needs(fields, path, who),
            returns=self._choice(fields, "returns", path, who, RETURNS),
        )

    def _parameters(
        self, fields: Mapping[str, Any], path: Path, who: Phrase
    ) -> tuple[Parameter, ...]:
        items = self._list(fields, "variables", path, who, '[{"type": "float", ...}]')
        paths: list[Path] = [(*path, "variables", i) for i in range(len(items))]
        parameters = [self._parameter(item, at, who) for item, at in zip(items, paths, strict=True)]
        self._refuse_repeated([parameter.name for parameter in parameters], paths, who)
        self._refuse_late_requirements(parameters, paths, who)
        return tuple(parameters)

    def _parameter(self, value: object, path: Path, block: Phrase) -> Parameter:
        who = _parameter_name(value, block)
        fields = self._fields(value, path, who, _PARAMETER_KEYS)
        kind = self._choice(fields, "type", path, who, PARAMETER_TYPES)
        choices = self._choices(fields, kind, path, who)
        return Parameter(
            name=self._name(fields, path),
            type=kind,
            default=self._default(fields, kind, path, who),
            required="default" not in fields,
            translations=self._languages(fields, "translate", path, who),
            range=self._range(fields, kind, path, who),
            choices=choices,
            choice_names=self._choice_names(fields, choices, path, who),
            directions=self._directions(fields, kind, path, who),
            needs=self._need(fields.get("needs", ""), (*path, "needs"), who),
        )

    # Their parts.

    def _fields(
        self, value: object, path: Path, who: Phrase, schema: Mapping[str, bool]
    ) -> dict[str, Any]:
        if not isinstance(value, dict):
            message = Phrase("block-not-object", where=who, value=_shown(value))
            self._wrong("wrong-type", path, message)
            return {}
        for key in value.keys() - schema:
            place = self._document.keys.get((*path, key), TextPosition())
            self._note("unknown-key", _unknown_key(key, who, schema), place)
        for key in (key for key, required in schema.items() if required and key not in value):
            self._wrong("missing-key", path, Phrase("block-missing-key", where=who, key=key))
        return {key: value[key] for key in schema if key in value}

    def _choice(
        self, fields: Mapping[str, Any], key: str, path: Path, who: Phrase, choices: Sequence[T]
    ) -> T:
        if key not in fields:
            return choices[0]
        return self._one_of(choices, fields[key], (*path, key), who, key)

    def _one_of(self, choices: Sequence[T], value: object, path: Path, who: Phrase, key: str) -> T:
        for choice in choices:
            if value == choice:
                return choice
        self._wrong("unknown-value", path, _unknown_value(value, choices, who, key))
        return choices[0]

    def _text(self, fields: Mapping[str, Any], key: str, path: Path, who: Phrase) -> str:
        if key not in fields:
            return ""
        return self._words(fields[key], (*path, key), who, key)

    def _words(self, value: object, path: Path, who: Phrase, key: str) -> str:
        """A string on one line; line breaks become spaces."""
        if isinstance(value, str) and value.strip():
            return " ".join(value.split())
        message = Phrase("block-not-text", where=who, key=key, value=_shown(value))
        self._wrong("wrong-type", path, message)
        return ""

    def _name(self, fields: Mapping[str, Any], path: Path) -> str:
        name = fields.get("name", "")
        if "name" in fields and not _is_python_name(name):
            message = Phrase("block-bad-name", value=_shown(name).strip('"'))
            self._wrong("bad-name", (*path, "name"), message)
        return name if isinstance(name, str) else ""

    def _shapes(self, fields: Mapping[str, Any], path: Path, who: Phrase) -> tuple[str, ...]:
        items = self._list(fields, "shape", path, who, '["blockVertical"]')
        at: Path = (*path, "shape")
        shapes = tuple(
            self._one_of(SHAPES, item, (*at, i), who, "shape") for i, item in enumerate(items)
        )
        if fields.get("shape") == []:
            self._wrong("bad-shape", at, Phrase("block-empty-shape", where=who))
        elif "blockVertical" in shapes and len(set(shapes)) > 1:
            self._wrong("bad-shape", at, Phrase("block-two-shapes", where=who))
        return shapes

    def _languages(
        self, fields: Mapping[str, Any], key: str, path: Path, who: Phrase
    ) -> dict[str, str]:
        value, at = fields.get(key, {}), (*path, key)
        if not isinstance(value, dict):
            message = Phrase("block-not-translations", where=who, key=key, value=_shown(value))
            self._wrong("wrong-type", at, message)
            return {}
        texts: dict[str, str] = {}
        for code, text in value.items():
            self._check_language(code, texts, (*at, code), who)
            texts[code.upper()] = self._words(text, (*at, code), who, f"{key}.{code}")
        return texts

    def _check_language(self, code: str, codes: Collection[str], path: Path, who: Phrase) -> None:
        place, key = self._document.keys.get(path, TextPosition()), str(path[-2])
        if not _LANGUAGE.fullmatch(code.upper()):
            message = Phrase("block-bad-language", where=who, key=key, value=_shown(code))
            self._note("bad-language", message, place)
        elif code.upper() in codes:
            message = Phrase("block-duplicate-language", where=who, key=key, language=code.upper())
            self._note("duplicate-key", message, place)

    def _needs(self, fields: Mapping[str, Any], path: Path, who: Phrase) -> tuple[str, ...]:
        items = self._list(fields, "needs", path, who, '["Base"]')
        needs = (self._need(item, (*path, "needs", i), who) for i, item in enumerate(items))
        return tuple(filter(None, needs))

    def _need(self, value: object, path: Path, who: Phrase) -> str:
        if isinstance(value, str) and (not value or _NEED.fullmatch(value)):
            return value
        self._wrong("unknown-value", path, Phrase("block-bad-need", where=who, value=_shown(value)))
        return ""

    def _list(
        self, fields: Mapping[str, Any], key: str, path: Path, who: Phrase, example: str
    ) -> list[Any]:
        value = fields.get(key, [])
        if isinstance(value, list):
            return value
        message = Phrase("block-not-list", where=who, key=key, value=_shown(value), example=example)
        self._wrong("wrong-type", (*path, key), message)
        return []

    def _default(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: Phrase
    ) -> object:
        value = fields.get("default")
        if value is None or value == "None":
            return None
        try:
            return DEFAULTS[kind](value)
        except (ValueError, TypeError, LookupError, OverflowError, RecursionError):
            message = Phrase("block-bad-default", where=who, value=_shown(value), type=kind)
            self._wrong("bad-default", (*path, "default"), message)
            return None

    def _range(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: Phrase
    ) -> Range | None:
        value = fields.get("range")
        if value is None:
            return None
        bounds = _to_range(value)
        wrong = Phrase("block-range-form") if bounds is None else range_problem(bounds)
        if kind not in NUMBERS:
            wrong = Phrase("block-range-not-number")
        if wrong is not None:
            message = Phrase("block-bad-range", where=who, value=_shown(value), problem=wrong)
            self._wrong("bad-range", (*path, "range"), message)
            return None
        return bounds

    def _choices(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: Phrase
    ) -> tuple[str, ...]:
        items = self._list(fields, "choices", path, who, '["slow", "fast"]')
        choices = tuple(dict.fromkeys(item for item in items if is_choice(item)))
        if kind != "choice" and not items:
            return ()
        if kind not in ("choice", "string"):
            message = Phrase("block-choices-type", where=who)
        elif len(choices) == len(items) and 0 < len(choices) <= MOST_CHOICES:
            return choices
        else:
            items_text = _shown(items)
            message = Phrase("block-bad-choices", where=who, value=items_text, most=MOST_CHOICES)
        at: Path = (*path, "choices") if "choices" in fields else path
        self._wrong("bad-choices", at, message)
        return ()

    def _choice_names(
        self, fields: Mapping[str, Any], choices: tuple[str, ...], path: Path, who: Phrase
    ) -> dict[str, dict[str, str]]:
        value, at = fields.get("choiceNames", {}), (*path, "choiceNames")
        if not isinstance(value, dict):
            message = Phrase("block-not-choice-names", where=who, value=_shown(value))
            self._wrong("wrong-type", at, message)
            return {}
        for name in value.keys() - set(choices):
            place = self._document.keys.get((*at, name), TextPosition())
            self._note("unknown-key", _unknown_choice(name, choices, who), place)
        return {name: self._languages(value, name, at, who) for name in choices if name in value}

    def _directions(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: Phrase
    ) -> dict[str, dict[str, str]]:
        value, at = fields.get("directions", {}), (*path, "directions")
        if value == {}:
            return {}
        if not isinstance(value, dict) or set(value) != set(SIGNS):
            message = Phrase("block-not-directions", where=who, value=_shown(value))
        elif kind not in NUMBERS:
            message = Phrase("block-directions-not-number", where=who)
        else:
            return {sign: self._languages(value, sign, at, who) for sign in SIGNS}
        self._wrong("bad-directions", at, message)
        return {}

    # Names that must differ, and parameters without a default after those with one.

    def _refuse_repeated(
        self, names: Sequence[str], paths: Sequence[Path], who: Phrase | None
    ) -> None:
        """Refuse duplicate names of blocks, or of the parameters of one block."""
        earlier: set[str] = set()
        for name, path in zip(names, paths, strict=True):
            if name and name in earlier:
                message = (
                    Phrase("block-duplicate-block", name=name)
                    if who is None
                    else Phrase("block-duplicate-parameter", name=name, where=who)
                )
                self._wrong("duplicate-name", (*path, "name"), message)
            earlier.add(name)

    def _refuse_late_requirements(
        self, parameters: Sequence[Parameter], paths: Sequence[Path], who: Phrase
    ) -> None:
        optional = ""
        for parameter, path in zip(parameters, paths, strict=True):
            if not parameter.required:
                optional = optional or parameter.name
            elif optional:
                message = Phrase(
                    "block-missing-default", where=who, name=parameter.name, optional=optional
                )
                self._wrong("missing-default", path, message)

    def _wrong(self, code: str, path: Path, message: Phrase) -> None:
        self._note(code, message, self._document.values.get(path, TextPosition()))

    def _note(self, code: str, message: Phrase, place: TextPosition) -> None:
        if len(self.problems) == _MOST_PROBLEMS:
            return
        self.problems.append(Diagnostic(code, message, place.line, place.column, place.end_column))


def _block_name(value: object) -> Phrase:
    name = _name_of(value)
    if name:
        return Phrase("block-where-block", name=name)
    return Phrase("block-where-nameless-block")


def _parameter_name(value: object, block: Phrase) -> Phrase:
    name = _name_of(value)
    if name:
        return Phrase("block-where-parameter", name=name, block=block)
    return Phrase("block-where-nameless-parameter", block=block)


def _name_of(value: object) -> str:
    """The name of a block or parameter; empty if it has none."""
    name = value.get("name") if isinstance(value, dict) else None
    return name if isinstance(name, str) else ""


def _unknown_key(key: str, who: Phrase, schema: Mapping[str, bool]) -> Phrase:
    near = nearest(key, schema)
    if near is None:
        return Phrase("block-unknown-key", where=who, key=key, known=tuple(schema))
    return Phrase("block-unknown-key-like", where=who, key=key, suggestion=near)


def _unknown_value(value: object, choices: Sequence[str], who: Phrase, key: str) -> Phrase:
    value_text, near = _shown(value), nearest(str(value), choices)
    if near is None:
        return Phrase(
            "block-unknown-value", where=who, key=key, value=value_text, known=tuple(choices)
        )
    return Phrase("block-unknown-value-like", where=who, key=key, value=value_text, suggestion=near)


def _unknown_choice(name: str, choices: Sequence[str], who: Phrase) -> Phrase:
    near = nearest(name, choices)
    if near is None:
        return Phrase("block-unknown-choice", where=who, value=_shown(name))
    return Phrase("block-unknown-choice-like", where=who, value=_shown(name), suggestion=near)


def _shown(value: object) -> str:
    """A value as JSON, shortened if it is long."""
    return _shorten(json.dumps(value, ensure_ascii=False))


def _shorten(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:37]}..."


def _is_python_name(name: object) -> bool:
    return isinstance(name, str) and name.isidentifier() and not keyword.iskeyword(name)


def _to_range(value: object) -> Range | None:
    """A range written as a list of two or three numbers."""
    if not isinstance(value, list) or not 2 <= len(value) <= 3:
        return None
    if any(isinstance(item, bool) or not isinstance(item, int | float) for item in value):
        return None
    return Range(*value)
