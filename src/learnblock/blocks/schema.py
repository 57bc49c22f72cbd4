"""What a block configuration may say: JSON values in, block configurations out."""

import json
import keyword
import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any, TypeVar, get_args

from learnblock.blocks.configuration import (
    NUMBERS,
    BlockConfiguration,
    Parameter,
    ParameterType,
)
from learnblock.blocks.defaults import DEFAULTS
from learnblock.blocks.hints import MOST_CHOICES, is_choice, objection
from learnblock.blocks.json_source import Document, Path, Place
from learnblock.errors import Diagnostic, did_you_mean
from learnblock.fields import Range

T = TypeVar("T", bound=str)

TYPES = ("motor", "perceptual", "proprioceptive", "express", "control", "operator", "others")
SHAPES = ("blockVertical", "blockLeft", "blockBoth")
PARAMETER_TYPES: tuple[ParameterType, ...] = get_args(ParameterType)

# Each key with whether it must be there.
_BLOCK_KEYS = {
    "type": True,
    "category": True,
    "name": True,
    "variables": False,
    "shape": True,
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
}
_KEY_ADVICE = {
    "type": "it says what kind of block this is, such as `motor`",
    "category": "it names the tab of the palette, such as `Base`",
    "name": "it names the Python function, or the function's parameter",
    "shape": 'write ["blockVertical"] for a statement, ["blockLeft"] for a value',
}
# Nobody reads more of them at once.
_MOST_PROBLEMS = 100
_LANGUAGE = re.compile(r"[A-Z]{2,3}(-[A-Z0-9]{2,8})*")
_DEVICE = re.compile(r"[A-Za-z]\w*(:\w+)?")


def read(document: Document) -> tuple[tuple[BlockConfiguration, ...], tuple[Diagnostic, ...]]:
    """The configurations in a document that holds one or a list of them, and what is wrong."""
    reader = _Reader(document)
    return tuple(reader.blocks()), tuple(
        sorted(reader.problems, key=lambda problem: (problem.line, problem.column))
    )


class _Reader:
    def __init__(self, document: Document) -> None:
        self._document = document
        self.problems: list[Diagnostic] = []

    def blocks(self) -> list[BlockConfiguration]:
        for name, place in self._document.repeated:
            self._note("duplicate-key", f"the key `{name}` stands here twice; keep one", place)
        value = self._document.value
        items = value if isinstance(value, list) else [value]
        paths: list[Path] = [(i,) for i in range(len(items))] if isinstance(value, list) else [()]
        blocks = [self._block(item, path) for item, path in zip(items, paths, strict=True)]
        self._refuse_repeated([block.name for block in blocks], paths, "a block")
        return blocks

    # Blocks and parameters. What is wrong is noted and replaced, so that all of it is found.

    def _block(self, value: object, path: Path) -> BlockConfiguration:
        who = _called(value, "the block")
        fields = self._fields(value, path, who, _BLOCK_KEYS)
        return BlockConfiguration(
            type=self._choice(fields, "type", path, who, TYPES),
            category=self._text(fields, "category", path, who),
            name=self._name(fields, path, who),
            parameters=self._parameters(fields, path, who),
            shapes=self._shapes(fields, path, who),
            languages=self._languages(fields, "languages", path, who),
            tooltip=self._languages(fields, "tooltip", path, who),
            needs=self._needs(fields, path, who),
        )

    def _parameters(self, fields: Mapping[str, Any], path: Path, who: str) -> tuple[Parameter, ...]:
        items = self._list(fields, "variables", path, who, '[{"type": "float", ...}]')
        paths: list[Path] = [(*path, "variables", i) for i in range(len(items))]
        parameters = [self._parameter(item, at, who) for item, at in zip(items, paths, strict=True)]
        self._refuse_repeated([one.name for one in parameters], paths, f"{who}: a parameter")
        self._refuse_late_requirements(parameters, paths, who)
        return tuple(parameters)

    def _parameter(self, value: object, path: Path, block: str) -> Parameter:
        who = f"{block}, {_called(value, 'the parameter')}"
        fields = self._fields(value, path, who, _PARAMETER_KEYS)
        kind = self._choice(fields, "type", path, who, PARAMETER_TYPES)
        choices = self._choices(fields, kind, path, who)
        return Parameter(
            name=self._name(fields, path, who),
            type=kind,
            default=self._default(fields, kind, path, who),
            required="default" not in fields,
            translations=self._languages(fields, "translate", path, who),
            range=self._range(fields, kind, path, who),
            choices=choices,
            choice_names=self._choice_names(fields, choices, path, who),
        )

    # Their parts.

    def _fields(
        self, value: object, path: Path, who: str, known: Mapping[str, bool]
    ) -> dict[str, Any]:
        if not isinstance(value, dict):
            self._wrong(
                "wrong-type", path, f"{who} is {_shown(value)}; it must be an object {{...}}"
            )
            return {}
        for key in value.keys() - known:
            advice = did_you_mean(key, known) or f"known are: {', '.join(known)}"
            place = self._document.keys.get((*path, key), Place())
            self._note("unknown-key", f"{who}: there is no key `{key}`; {advice}", place)
        for key in (key for key, required in known.items() if required and key not in value):
            self._wrong("missing-key", path, f"{who}: `{key}` is missing; {_KEY_ADVICE[key]}")
        return {key: value[key] for key in known if key in value}

    def _choice(
        self, fields: Mapping[str, Any], key: str, path: Path, who: str, known: Sequence[T]
    ) -> T:
        if key not in fields:
            return known[0]
        return self._one_of(known, fields[key], (*path, key), f"{who}: `{key}`")

    def _one_of(self, known: Sequence[T], value: object, path: Path, what: str) -> T:
        for choice in known:
            if value == choice:
                return choice
        advice = did_you_mean(str(value), known) or f"it must be one of {', '.join(known)}"
        self._wrong("unknown-value", path, f"{what} is {_shown(value)}; {advice}")
        return known[0]

    def _text(self, fields: Mapping[str, Any], key: str, path: Path, who: str) -> str:
        if key not in fields:
            return ""
        return self._words(fields[key], (*path, key), f"{who}: `{key}`")

    def _words(self, value: object, path: Path, what: str) -> str:
        """A text of one line, whatever line breaks it was written with."""
        if isinstance(value, str) and value.strip():
            return " ".join(value.split())
        self._wrong(
            "wrong-type",
            path,
            f"{what} is {_shown(value)}; it must be a text in double quotes, not empty",
        )
        return ""

    def _name(self, fields: Mapping[str, Any], path: Path, who: str) -> str:
        name = fields.get("name", "")
        if "name" in fields and not _is_python_name(name):
            self._wrong(
                "bad-name",
                (*path, "name"),
                f"{who}: `name` is {_shown(name)}, which no function or parameter of Python can be"
                " called; write letters, digits and _, such as `turn_left`",
            )
        return name if isinstance(name, str) else ""

    def _shapes(self, fields: Mapping[str, Any], path: Path, who: str) -> tuple[str, ...]:
        items = self._list(fields, "shape", path, who, '["blockVertical"]')
        at: Path = (*path, "shape")
        what = f"{who}: `shape`"
        shapes = tuple(self._one_of(SHAPES, item, (*at, i), what) for i, item in enumerate(items))
        if fields.get("shape") == []:
            self._wrong("bad-shape", at, f"{what} is empty; {_KEY_ADVICE['shape']}")
        elif "blockVertical" in shapes and len(set(shapes)) > 1:
            self._wrong(
                "bad-shape", at, f"{what} makes it a statement and a value; {_KEY_ADVICE['shape']}"
            )
        return shapes

    def _languages(
        self, fields: Mapping[str, Any], key: str, path: Path, who: str
    ) -> dict[str, str]:
        value, at, what = fields.get(key, {}), (*path, key), f"{who}: `{key}`"
        if not isinstance(value, dict):
            self._wrong(
                "wrong-type", at, f'{what} is {_shown(value)}; write {{"EN": "...", "ES": "..."}}'
            )
            return {}
        texts: dict[str, str] = {}
        for code, text in value.items():
            self._check_language(code, texts, (*at, code), what)
            texts[code.upper()] = self._words(text, (*at, code), f"{what} in {code}")
        return texts

    def _check_language(self, code: str, known: Collection[str], path: Path, what: str) -> None:
        place = self._document.keys.get(path, Place())
        if not _LANGUAGE.fullmatch(code.upper()):
            self._note(
                "bad-language",
                f"{what}: {_shown(code)} is no language; write its code, such as EN, ES or PT-BR",
                place,
            )
        elif code.upper() in known:
            self._note(
                "duplicate-key",
                f"{what}: the language {code.upper()} stands here twice; keep one",
                place,
            )

    def _needs(self, fields: Mapping[str, Any], path: Path, who: str) -> tuple[str, ...]:
        items = self._list(fields, "needs", path, who, '["Base"]')
        for i, item in enumerate(items):
            if not (isinstance(item, str) and _DEVICE.fullmatch(item)):
                self._wrong(
                    "unknown-value",
                    (*path, "needs", i),
                    f"{who}: `needs` holds {_shown(item)}; name a device, such as `Base`, or one"
                    " with its key, such as `JointMotor:CAMERA`",
                )
        return tuple(item for item in items if isinstance(item, str))

    def _list(
        self, fields: Mapping[str, Any], key: str, path: Path, who: str, example: str
    ) -> list[Any]:
        value = fields.get(key, [])
        if isinstance(value, list):
            return value
        self._wrong(
            "wrong-type",
            (*path, key),
            f"{who}: `{key}` is {_shown(value)}; it must be a list, such as {example}",
        )
        return []

    def _default(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: str
    ) -> object:
        value = fields.get("default")
        if value is None or value == "None":
            return None
        convert, expected = DEFAULTS[kind]
        try:
            return convert(value)
        except (ValueError, TypeError, LookupError, OverflowError, RecursionError):
            self._wrong(
                "bad-default",
                (*path, "default"),
                f"{who}: the default {_shown(value)} is no {kind}; write {expected}",
            )
            return None

    def _range(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: str
    ) -> Range | None:
        value = fields.get("range")
        if value is None:
            return None
        found = _to_range(value)
        wrong = "write [0, 100], or [0, 10, 1] with a step" if found is None else objection(found)
        if kind not in NUMBERS:
            wrong = "only a number has a range"
        if wrong:
            what = f"{who}: `range` is {_shown(value)}; {wrong}"
            self._wrong("bad-range", (*path, "range"), what)
            return None
        return found

    def _choices(
        self, fields: Mapping[str, Any], kind: ParameterType, path: Path, who: str
    ) -> tuple[str, ...]:
        items = self._list(fields, "choices", path, who, '["slow", "fast"]')
        found = tuple(dict.fromkeys(item for item in items if is_choice(item)))
        if kind != "choice" and not items:
            return ()
        if kind != "choice":
            wrong = "they go with the type `choice`"
        elif len(found) == len(items) and 0 < len(found) <= MOST_CHOICES:
            return found
        else:
            wrong = f'write different texts of one line, at most {MOST_CHOICES}: ["slow", "fast"]'
        at: Path = (*path, "choices") if "choices" in fields else path
        self._wrong("bad-choices", at, f"{who}: `choices` is {_shown(items)}; {wrong}")
        return ()

    def _choice_names(
        self, fields: Mapping[str, Any], choices: tuple[str, ...], path: Path, who: str
    ) -> dict[str, dict[str, str]]:
        value, at = fields.get("choiceNames", {}), (*path, "choiceNames")
        what = f"{who}: `choiceNames`"
        if not isinstance(value, dict):
            advice = 'write {"slow": {"ES": "lento"}}'
            self._wrong("wrong-type", at, f"{what} is {_shown(value)}; {advice}")
            return {}
        for name in value.keys() - set(choices):
            hint = did_you_mean(name, choices) or "it names what is among the `choices`"
            place = self._document.keys.get((*at, name), Place())
            self._note("unknown-key", f"{what}: there is no choice {_shown(name)}; {hint}", place)
        return {name: self._languages(value, name, at, what) for name in choices if name in value}

    # Names that must differ, and parameters without a default behind those that have one.

    def _refuse_repeated(self, names: Sequence[str], paths: Sequence[Path], what: str) -> None:
        seen: set[str] = set()
        for name, path in zip(names, paths, strict=True):
            if name and name in seen:
                self._wrong(
                    "duplicate-name",
                    (*path, "name"),
                    f"{what} called `{name}` stands above already; each needs a name of its own",
                )
            seen.add(name)

    def _refuse_late_requirements(
        self, parameters: Sequence[Parameter], paths: Sequence[Path], who: str
    ) -> None:
        optional = ""
        for parameter, path in zip(parameters, paths, strict=True):
            if not parameter.required:
                optional = optional or parameter.name
            elif optional:
                self._wrong(
                    "missing-default",
                    path,
                    f"{who}: the parameter `{parameter.name}` needs a `default`, since `{optional}`"
                    " before it has one",
                )

    def _wrong(self, code: str, path: Path, message: str) -> None:
        self._note(code, message, self._document.values.get(path, Place()))

    def _note(self, code: str, message: str, place: Place) -> None:
        if len(self.problems) == _MOST_PROBLEMS:
            return
        self.problems.append(Diagnostic(code, message, place.line, place.column, place.end_column))


def _called(value: object, what: str) -> str:
    """The block or parameter by its name, where it has one to be called by."""
    name = value.get("name") if isinstance(value, dict) else None
    return f"{what} `{name}`" if isinstance(name, str) and name else what


def _shown(value: object) -> str:
    """A value as JSON writes it, cut short where it is long."""
    return _shorten(json.dumps(value, ensure_ascii=False))


def _shorten(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:37]}..."


def _is_python_name(name: object) -> bool:
    return isinstance(name, str) and name.isidentifier() and not keyword.iskeyword(name)


def _to_range(value: object) -> Range | None:
    """A range written as a list of two or three numbers."""
    if not isinstance(value, list) or not 2 <= len(value) <= 3:
        return None
    if any(isinstance(one, bool) or not isinstance(one, int | float) for one in value):
        return None
    return Range(*value)
