"""Block configurations from the source of skills, which is not run."""

import importlib.util
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.blocks.schema.configuration import NUMBERS, BlockConfiguration, Parameter
from learnblock.blocks.source.hints import FieldType
from learnblock.blocks.source.signature import Argument, Signature, signatures
from learnblock.errors import LearnBlockError
from learnblock.storage import skill_files

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

VALUE = ("blockLeft", "blockBoth")
STATEMENT = ("blockVertical",)


def derive(source: str, filename: str) -> tuple[BlockConfiguration, ...]:
    """The blocks of the skills in a Python file: its public functions that take the robot first.

    Types come from the hints (or else from the defaults), the label from the function's name, the
    tooltip from the first paragraph of its docstring, the tab from the file's name. A function that
    returns something is a value, any other a statement.

        >>> source = 'def waltz(robot, times: int = 3) -> None: "Dance a waltz."'
        >>> (block,) = derive(source, "ball_room.py")
        >>> block.category, block.name, block.tooltip
        ('Ball room', 'waltz', {'EN': 'Dance a waltz.'})

    Raises:
        ProgramError: the source is not valid Python.
    """
    return tuple(derived(signature, filename) for signature in signatures(source, filename))


def derived(signature: Signature, filename: str) -> BlockConfiguration:
    """The block of a function, from its signature and docstring."""
    label = _words(signature.name)
    return BlockConfiguration(
        type="others",
        category=category_of(filename),
        name=signature.name,
        parameters=tuple(map(_parameter, signature.arguments)),
        shapes=VALUE if signature.answers else STATEMENT,
        returns=signature.returns,
        languages={"EN": label},
        tooltip={"EN": signature.summary or label},
    )


def category_of(filename: str) -> str:
    """The default tab for the blocks in a file."""
    return Path(filename).stem.replace("_", " ").strip().capitalize() or "Others"


def fitted(
    chosen: BlockConfiguration, signature: Signature, known: BlockConfiguration
) -> BlockConfiguration:
    """A configuration, adapted to the current function.

    The function determines its parameters, their defaults and hinted types. Everything else
    is as `chosen`, or else as `known`.
    """
    by_name = {parameter.name: parameter for parameter in chosen.parameters}
    same_kind = chosen.returns_value == signature.answers
    return replace(
        chosen,
        parameters=tuple(
            _fitted_parameter(by_name.get(argument.name), argument, parameter)
            for argument, parameter in zip(signature.arguments, known.parameters, strict=True)
        ),
        returns=signature.returns if signature.is_said else chosen.returns,
        shapes=chosen.shapes if same_kind or not signature.is_said else known.shapes,
        languages={**known.languages, **chosen.languages},
        tooltip={**known.tooltip, **chosen.tooltip},
        needs=chosen.needs or known.needs,
    )


def _fitted_parameter(chosen: Parameter | None, argument: Argument, known: Parameter) -> Parameter:
    if chosen is None:
        return known
    field = FieldType(chosen.type, chosen.range, chosen.choices)
    if not may_be(argument, field):
        field = argument.field
    return Parameter(
        name=argument.name,
        type=field.type,
        default=argument.default if argument.is_constant else chosen.default,
        required=argument.required,
        translations={**known.translations, **chosen.translations},
        range=field.range,
        choices=field.choices,
        choice_names={
            choice: names
            for choice, names in {**known.choice_names, **chosen.choice_names}.items()
            if choice in field.choices
        },
        directions=(chosen.directions or known.directions) if field.type in NUMBERS else {},
    )


#: The types that may replace the type of a hint, because they are the same in Python.
_FINER: Mapping[str, frozenset[str]] = {
    "float": frozenset(("float", "int", "angle")),
    "int": frozenset(("int", "float", "angle", "apriltext")),
    "string": frozenset(("string", "choice", "colour", "apriltext")),
}


def may_be(argument: Argument, field: FieldType) -> bool:
    """Whether the field chosen for a parameter is compatible with its hint or default."""
    if not argument.is_said or field == argument.field:
        return True
    is_plain = argument.field.range is None
    return is_plain and field.type in _FINER.get(argument.field.type, ())


def derive_plugin(point: "EntryPoint") -> Iterator[tuple[Signature, BlockConfiguration]]:
    """The skills of a plugin, which is not imported.

    Raises:
        LearnBlockError: its module cannot be found.
        ProgramError: it is not valid Python.
        OSError: it cannot be read.
    """
    path = plugin_source(point)
    for signature in signatures(skill_files.read(path), str(path)):
        yield signature, derived(signature, str(path))


def plugin_source(point: "EntryPoint") -> Path:
    """The file of a plugin's module, found without importing the packages around it."""
    package, *rest = point.module.split(".")
    spec = importlib.util.find_spec(package)
    candidates = [] if spec is None else list(_candidates(spec, rest))
    for path in candidates:
        if path.suffix == ".py" and path.is_file():
            return path
    raise LearnBlockError("block-plugin-missing", plugin=point.name, module=point.module)


def _candidates(package: ModuleSpec, inside: list[str]) -> Iterator[Path]:
    """The files that a module inside a package may have; "" is the package itself."""
    if not inside:
        yield Path(package.origin or "")
        return
    for location in package.submodule_search_locations or ():
        path = Path(location, *inside)
        yield path.with_suffix(".py")
        yield path / "__init__.py"


def _parameter(argument: Argument) -> Parameter:
    return Parameter(
        name=argument.name,
        type=argument.field.type,
        default=argument.default,
        required=argument.required,
        translations={"EN": _words(argument.name)},
        range=argument.field.range,
        choices=argument.field.choices,
    )


def _words(name: str) -> str:
    """``followTheLight`` and ``follow_the_light`` as words for a block."""
    separate = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name)
    words = [word if word.isupper() else word.lower() for word in separate.split("_") if word]
    return " ".join(words)
