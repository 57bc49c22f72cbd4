"""The definitions of our blocks, in Blockly's JSON.

A block with a variable shape names its extension or mutator in the page:
``lb_when_mutator``, ``lb_arguments_mutator``, ``lb_compare_mutator``, ``lb_dictionary_mutator``,
``lb_unpacking_mutator``, ``lb_python_mutator``, ``lb_when_names``, ``lb_when_name``,
``lb_code_field``. An extension adds its field to the dummy input ``PLACE``, or in an input of its
own. The page's field ``lb_direction`` shows the sign of a number as a word, and ``lb_more`` is a
button for a part of the sentence that only states a default.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from learnblock.blocks.groups import style_of
from learnblock.blocks.labels import (
    Filling,
    OptionalPart,
    optional_parts,
    parameter_name,
    sentence,
    translated,
    units,
)
from learnblock.blocks.pairs import BlockPair, pairs
from learnblock.blocks.ready_hats import READY_HATS, ready_hat
from learnblock.blocks.schema.configuration import NUMBERS, SIGNS, BlockConfiguration, Parameter
from learnblock.blocks.toolbox import SKILL, is_skill_block, parameter_shadow

Definition = dict[str, Any]

CHANGES = ("-=", "*=", "/=", "//=", "%=", "**=")

_STATEMENT: Definition = {"previousStatement": None, "nextStatement": None}
_DO: Definition = {"message1": "%1", "args1": [{"type": "input_statement", "name": "DO"}]}
_PLACE: Definition = {"type": "input_dummy", "name": "PLACE"}
#: What follows a parameter's name in that of its direction.
_DIRECTION = ".direction"
#: The same for the button of an optional part, and for its ends; the parameter is the part's first.
_OPTIONAL = (".more", ".before", ".after")
_CHECKS = {
    **dict.fromkeys(NUMBERS, "Number"),
    "boolean": "Boolean",
    "list": "Array",
}


def definitions(
    configurations: Iterable[BlockConfiguration], language: str
) -> list[dict[str, Any]]:
    """All our blocks; the words of skills are in `language`, such as ``es``."""
    skill_blocks = list(filter(is_skill_block, configurations))
    paired = pairs(skill_blocks)
    skills = [
        skill_definition(configuration, language, paired.get(configuration.name))
        for configuration in skill_blocks
    ]
    hats = [
        _ready_hat(configuration, language)
        for configuration in skill_blocks
        if ready_hat(configuration.name) in READY_HATS
    ]
    return [*_hats(), *hats, *_statements(), *_values(), *skills]


def _block(kind: str, style: str, args: Iterable[Definition] = (), **rest: Any) -> Definition:
    name = kind.upper()
    return {
        "type": kind,
        "style": style,
        "message0": f"%{{BKY_{name}}}",
        "args0": list(args),
        "tooltip": f"%{{BKY_{name}_TOOLTIP}}",
        **rest,
    }


def _value(name: str, check: str | None = None) -> Definition:
    return {"type": "input_value", "name": name, **({"check": check} if check else {})}


def _text(name: str, text: str = "") -> Definition:
    return {"type": "field_input", "name": name, "text": text}


def _choice(name: str, choices: Iterable[str]) -> Definition:
    return {
        "type": "field_dropdown",
        "name": name,
        "options": [[choice, choice] for choice in choices],
    }


def _hats() -> list[Definition]:
    when = _block(
        "lb_when", "lb_events", [_text("NAME", "start"), _PLACE], mutator="lb_when_mutator"
    )
    return [
        _block("lb_main", "lb_events", **_DO),
        _block("lb_start", "lb_events", **_DO),
        # The mutator adds CONDITION above DO.
        {**when, **_DO},
    ]


def _ready_hat(configuration: BlockConfiguration, language: str) -> Definition:
    """An event whose sentence has the parameters of its condition; the page keeps its name."""
    arguments = _arguments(configuration, language)
    kind = ready_hat(configuration.name)
    return _block(
        kind, "lb_events", arguments, extensions=["lb_when_name"], inputsInline=True, **_DO
    )


def _statements() -> list[Definition]:
    change = [
        {"type": "field_variable", "name": "VAR", "variable": "x"},
        _choice("OP", CHANGES),
        _value("VALUE"),
    ]
    set_local = [change[0], _value("VALUE")]
    change_index = [
        _value("LIST"),
        _value("INDEX"),
        _choice("OP", ("+=", *CHANGES)),
        _value("VALUE"),
    ]
    entry = [_value("DICTIONARY"), _value("KEY")]
    change_entry = [*entry, _choice("OP", ("+=", *CHANGES)), _value("VALUE")]
    set_entry = [*entry, _value("VALUE")]
    names, arguments, words = ["lb_when_names"], "lb_arguments_mutator", "lb_python_mutator"
    statements = [
        _block("lb_activate", "lb_events", [_PLACE], extensions=names),
        _block("lb_deactivate", "lb_events", [_PLACE], extensions=names),
        _block("lb_return", "procedure_blocks", [_value("VALUE")]),
        _block("lb_pass", "lb_control"),
        _block("lb_wait_until", "loop_blocks", [_value("CONDITION", "Boolean")], inputsInline=True),
        _block("lb_import", "lb_control", [_text("MODULE", "dance")]),
        _block("lb_setup", "lb_control", [_PLACE], mutator=arguments, inputsInline=True),
        _block("lb_set_local", "variable_blocks", set_local, inputsInline=True),
        _block("lb_change", "variable_blocks", change, inputsInline=True),
        _block("lb_change_index", "list_blocks", change_index, inputsInline=True),
        _block("lb_dictionary_set", "list_blocks", set_entry, inputsInline=True),
        _block("lb_dictionary_change", "list_blocks", change_entry, inputsInline=True),
        _block("lb_dictionary_remove", "list_blocks", entry, inputsInline=True),
        _block("lb_do", "lb_control", [_value("VALUE")], inputsInline=True),
        _block("lb_call", "procedure_blocks", [_PLACE], mutator=arguments, inputsInline=True),
        _block("lb_python", "lb_control", [_PLACE], extensions=["lb_code_field"]),
        _block("lb_python_text", "lb_control", [_PLACE], extensions=["lb_code_field"]),
        _block("lb_python_line", "lb_control", [_PLACE], mutator=words, inputsInline=True),
        _block("lb_python_block", "lb_control", [_PLACE], mutator=words, inputsInline=True),
        _block("lb_without_robot", "lb_control"),
        _block("lb_comment", "lb_control", [_text("TEXT")]),
    ]
    forever = _block("lb_forever", "loop_blocks", **_DO)
    unpacking = _block(
        "lb_for_unpacking",
        "loop_blocks",
        [_PLACE, _value("LIST", "Array")],
        mutator="lb_unpacking_mutator",
        inputsInline=True,
        **_DO,
    )
    return [{**definition, **_STATEMENT} for definition in (*statements, forever, unpacking)]


def _values() -> list[Definition]:
    names, pair = ["lb_when_names"], {"inputsInline": True}
    numbers = [_value("A", "Number"), _value("B", "Number")]
    words = [["%{BKY_LB_IN_YES}", "in"], ["%{BKY_LB_IN_NO}", "not in"]]
    operator = {"type": "field_dropdown", "name": "OP", "options": words}
    membership = [_value("A"), operator, _value("B")]
    seconds = [_value("SECONDS", "Number")]
    return [
        _block("lb_state", "lb_events", [_PLACE], output="Boolean", extensions=names, **pair),
        _block("lb_time", "lb_events", [_PLACE], output="Number", extensions=names, **pair),
        _block("lb_elapsed_time", "lb_events", seconds, output="Boolean", **pair),
        _block("lb_floor_divide", "math_blocks", numbers, output="Number", **pair),
        _block("lb_positive", "math_blocks", [_value("NUM", "Number")], output="Number", **pair),
        *_dictionaries(),
        _block("lb_in", "logic_blocks", membership, output="Boolean", **pair),
        _block(
            "lb_compare_chain",
            "logic_blocks",
            [_PLACE],
            output="Boolean",
            mutator="lb_compare_mutator",
            **pair,
        ),
        _block(
            "lb_call_value",
            "procedure_blocks",
            [_PLACE],
            output=None,
            mutator="lb_arguments_mutator",
            **pair,
        ),
        _block(
            "lb_python_form",
            "lb_control",
            [_PLACE],
            output=None,
            mutator="lb_python_mutator",
            **pair,
        ),
        _block(
            "lb_python_value", "lb_control", [_PLACE], output=None, extensions=["lb_code_field"]
        ),
    ]


def _dictionaries() -> list[Definition]:
    whole, key = _value("DICTIONARY"), _value("KEY")
    shape = {"output": None, "inputsInline": True}
    mutator = "lb_dictionary_mutator"
    return [
        _block("lb_dictionary", "list_blocks", [_PLACE], mutator=mutator, **shape),
        _block("lb_dictionary_get", "list_blocks", [whole, key], **shape),
        _block("lb_dictionary_keys", "list_blocks", [whole], output="Array", inputsInline=True),
        _block("lb_dictionary_items", "list_blocks", [whole], output="Array", inputsInline=True),
    ]


def skill_definition(
    configuration: BlockConfiguration, language: str, pair: BlockPair | None = None
) -> Definition:
    """The block of a skill, with its words in `language`, such as ``es``.

    The words of its direction have the types of both blocks of a `pair`.
    """
    output = "Boolean" if configuration.returns == "boolean" else None
    shape = {"output": output} if configuration.returns_value else _STATEMENT
    return {
        "type": SKILL + configuration.name,
        "style": style_of(configuration.category),
        "message0": _message(configuration, language),
        "args0": [
            _with_types(argument, pair) if pair else argument
            for argument in _arguments(configuration, language)
        ],
        "inputsInline": True,
        "tooltip": _plain(translated(configuration.tooltip, language, "")),
        **shape,
    }


def _message(configuration: BlockConfiguration, language: str) -> str:
    """The label in Blockly's notation: a percent sign is doubled, and %1 is an argument."""
    names = [argument["name"] for argument in _arguments(configuration, language)]
    places = {name: f"%{index}" for index, name in enumerate(names, 1)}
    escaped = replace(
        configuration,
        languages=_all_plain(configuration.languages),
        parameters=tuple(
            replace(parameter, translations=_all_plain(parameter.translations))
            for parameter in configuration.parameters
        ),
    )

    def optional(parameters: Sequence[Parameter], words: str) -> str:
        first = parameters[0].name
        more, before, after = (places[first + end] for end in _OPTIONAL)
        return f" {more} {before} {words} {after} "

    filling = Filling(
        lambda argument: places[argument.name],
        lambda argument: places[argument.name + _DIRECTION],
        optional,
    )
    return sentence(escaped, language, filling)


def _all_plain(texts: Mapping[str, str]) -> dict[str, str]:
    return {code: _plain(text) for code, text in texts.items()}


def _arguments(configuration: BlockConfiguration, language: str) -> list[Definition]:
    parameters = configuration.parameters
    directions = [
        _direction(parameter, language) for parameter in parameters if parameter.directions
    ]
    parts = [
        argument for part in optional_parts(configuration, language) for argument in _optional(part)
    ]
    unit = units(configuration, language)
    inputs = [
        _parameter(parameter, language, unit.get(parameter.name, "")) for parameter in parameters
    ]
    return [*inputs, *directions, *parts]


def _optional(part: OptionalPart) -> list[Definition]:
    """A button that shows the part, and the ends of what it shows: the page hides it."""
    more, before, after = (part.parameters[0].name + end for end in _OPTIONAL)
    usual = {
        parameter.name: shadow.value
        for parameter in part.parameters
        if (shadow := parameter_shadow(parameter)) is not None
    }
    return [
        {"type": "lb_more", "name": more, "usual": usual, "end": after},
        {"type": "input_dummy", "name": before},
        {"type": "input_dummy", "name": after},
    ]


def _direction(parameter: Parameter, language: str) -> Definition:
    options = [
        [translated(parameter.directions.get(sign, {}), language, sign), sign] for sign in SIGNS
    ]
    return {"type": "lb_direction", "name": parameter.name + _DIRECTION, "options": options}


def _with_types(argument: Definition, pair: BlockPair) -> Definition:
    """A direction with the type of the block that each of its words belongs to."""
    if argument["name"] != pair.parameter + _DIRECTION:
        return argument
    return {**argument, "types": {sign: SKILL + name for sign, name in pair.names.items()}}


def _parameter(parameter: Parameter, language: str, unit: str) -> Definition:
    field = _field(parameter, language)
    value = _value(parameter.name, _CHECKS.get(parameter.type))
    definition = {**value, "label": parameter_name(parameter, language), "kind": parameter.type}
    definition |= {"unit": unit} if unit else {}
    return {**definition, "field": field} if field else definition


def _field(parameter: Parameter, language: str) -> Definition:
    """The choices of the field, under a key that only our page knows."""
    if parameter.choices:
        names = parameter.choice_names
        options = [
            [translated(names.get(choice, {}), language, choice), choice]
            for choice in parameter.choices
        ]
        return {"options": options, **({"open": True} if parameter.type == "string" else {})}
    if parameter.range is None:
        return {}
    ends = {"min": parameter.range.least, "max": parameter.range.most}
    return ends if parameter.range.step is None else {**ends, "step": parameter.range.step}


def _plain(text: str) -> str:
    """A string in which Blockly finds no inputs."""
    return text.replace("%", "%%")
