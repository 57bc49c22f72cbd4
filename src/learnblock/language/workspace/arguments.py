"""Convert the arguments of skills: a block has an input for every parameter, a call may omit some.

A parameter whose input shows the default is omitted in the program, and those after it are keyword
arguments. Where a program does this differently, its block has a note.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from learnblock.blocks import BlockConfiguration, Parameter
from learnblock.blocks.toolbox import Shadow, parameter_shadow
from learnblock.language.blocktext.expression_parser import NUMBER
from learnblock.language.tree.nodes import Call, Expression, Number, SkillCall, String
from learnblock.language.tree.strings import quote
from learnblock.language.workspace.blocks import Block
from learnblock.language.workspace.literals import Literal, literal
from learnblock.language.workspace.notes import NO_NOTES, Notes

#: The fields of parameters, with the blocks that show such values elsewhere.
_PLAIN = {
    "lb_slider": "math_number",
    "lb_angle": "math_number",
    "lb_choice": "text",
    "lb_colour": "text",
    "lb_tag": "text",
    "lb_truth": "logic_boolean",
}


class Given(NamedTuple):
    """The names of the parameters passed by position and by keyword."""

    arguments: tuple[str, ...]
    keywords: tuple[str, ...]


def given(names: Sequence[str], present: Mapping[str, bool], notes: Notes) -> Given:
    """Decide which arguments a call has, and which of them are keyword arguments.

    Args:
        names: the names of all parameters.
        present: whether each differs from its default.
        notes: the notes of the block.
    """
    by_name = [name for name in notes.keywords if name in present]
    stated = {*names[: max(notes.given, 0)], *by_name}
    filled = [name for name in names if present[name] or name in stated]
    places = 0
    while places < len(filled) and filled[places] == names[places] and names[places] not in by_name:
        places += 1
    rest = [name for name in filled[places:] if name not in by_name]
    return Given(tuple(filled[:places]), tuple(dict.fromkeys([*by_name, *rest])))


def given_by(call: Call | SkillCall, configuration: BlockConfiguration) -> Given | None:
    """The arguments of a call; None if the skill's block has no input for one of them."""
    names = [parameter.name for parameter in configuration.parameters]
    count = len(call.arguments)
    keywords = [keyword.name for keyword in call.keywords]
    held = {*names[:count], *keywords}
    if count > len(names) or len(held) < count + len(keywords) or not held <= set(names):
        return None
    if any(
        parameter.required and parameter.name not in held for parameter in configuration.parameters
    ):
        return None
    return Given(tuple(names[:count]), tuple(keywords))


def noted(
    call: Call | SkillCall, configuration: BlockConfiguration, values: Mapping[str, Expression]
) -> Notes:
    """The notes that a block needs to reproduce the arguments of the call."""
    stated = Given(
        tuple(parameter.name for parameter in configuration.parameters[: len(call.arguments)]),
        tuple(keyword.name for keyword in call.keywords),
    )
    names = [parameter.name for parameter in configuration.parameters]
    present = {
        parameter.name: parameter.required
        or (parameter.name in values and not _is_default(values[parameter.name], parameter))
        for parameter in configuration.parameters
    }
    if given(names, present, NO_NOTES) == stated:
        return NO_NOTES
    return Notes(given=len(stated.arguments), keywords=stated.keywords)


def differs(shadow: Block, parameter: Parameter) -> bool:
    """Whether a shadow's value differs from the parameter's default."""
    default = parameter_shadow(parameter)
    return (
        default is None
        or _PLAIN.get(shadow.type, shadow.type) != _PLAIN.get(default.type, default.type)
        or shadow.fields.get(default.field) != default.value
    )


def shadow_literal(node: Expression, shadow: Shadow, parameter: Parameter | None) -> Literal | None:
    """The literal that shows an argument in a shadow; None if the argument needs a block."""
    value = _tag(node) if parameter is not None and parameter.type == "apriltext" else literal(node)
    if value is None or _PLAIN.get(shadow.type, shadow.type) != value.type:
        return None
    return value._replace(type=shadow.type)


def tag(node: Expression, shadow: Block) -> Expression:
    """The tag in a shadow's text: a number if the text is a number."""
    if isinstance(node, String) and shadow.data is None and _is_number(node.value):
        return Number(node.value)
    return node


def _tag(node: Expression) -> Literal | None:
    if isinstance(node, Number):
        return Literal("text", "TEXT", node.text) if _is_number(node.text) else None
    value = literal(node)
    if isinstance(node, String) and _is_number(node.value):
        return Literal("text", "TEXT", node.value, Notes(quoted=(node.value, quote(node.value))))
    return value


def _is_number(text: str) -> bool:
    return text.isascii() and text.isdecimal() and bool(NUMBER.fullmatch(text))


def _is_default(node: Expression, parameter: Parameter) -> bool:
    shadow = parameter_shadow(parameter)
    if shadow is None:
        return False
    value = shadow_literal(node, shadow, parameter)
    return value is not None and value.value == shadow.value
