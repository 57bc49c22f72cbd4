"""The toolbox: the blocks of each tab, with their default values."""

import json
from collections.abc import Iterable, Mapping
from itertools import groupby, takewhile
from types import MappingProxyType
from typing import Any, NamedTuple

from learnblock.blocks.groups import GROUPS, Group, group_of
from learnblock.blocks.pairs import BlockPair, pairs
from learnblock.blocks.python_palette import PYTHON_BLOCKS, STAGE
from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter

#: The prefix of the type of a skill's block; the skill's name follows.
SKILL = "lb_skill_"


class Shadow(NamedTuple):
    """The default value of an input, shown until a block is dropped on it.

    Args:
        type: the block's type: math_number, text, or one of the page's blocks for parameters:
            lb_slider, lb_angle, lb_choice, lb_colour, lb_tag and lb_truth.
        field: the name of the field for its value.
        value: a number, a string, or ``TRUE`` or ``FALSE``.
    """

    type: str
    field: str
    value: float | str

    def block(self) -> dict[str, Any]:
        """The shadow in Blockly's JSON."""
        return {"type": self.type, "fields": {self.field: self.value}}


def _number(value: float) -> Shadow:
    return Shadow("math_number", "NUM", value)


def _text(value: str) -> Shadow:
    return Shadow("text", "TEXT", value)


_RED = "#ff0000"
_QUARTER_TURN = 90
_ZERO, _ONE = _number(0), _number(1)

#: The shadows of the language's blocks, by type and input.
SHADOWS: Mapping[str, Mapping[str, Shadow]] = MappingProxyType(
    {
        "controls_repeat_ext": {"TIMES": _number(10)},
        "controls_for": {"FROM": _ONE, "TO": _number(10), "BY": _ONE},
        "math_arithmetic": {"A": _ONE, "B": _ONE},
        "math_modulo": {"DIVIDEND": _number(64), "DIVISOR": _number(10)},
        "math_single": {"NUM": _number(9)},
        "math_trig": {"NUM": _number(45)},
        "math_round": {"NUM": _number(3.1)},
        "math_constrain": {"VALUE": _number(50), "LOW": _ONE, "HIGH": _number(100)},
        "math_random_int": {"FROM": _ONE, "TO": _number(100)},
        "math_atan2": {"X": _ONE, "Y": _ONE},
        "math_change": {"DELTA": _ONE},
        "text_print": {"TEXT": _text("abc")},
        "text_prompt_ext": {"TEXT": _text("abc")},
        "text_changeCase": {"TEXT": _text("abc")},
        "text_trim": {"TEXT": _text("abc")},
        "text_indexOf": {"FIND": _text("abc")},
        "text_replace": {"FROM": _text("a"), "TO": _text("b")},
        "lists_getIndex": {"AT": _ZERO},
        "lists_setIndex": {"AT": _ZERO},
        "lists_split": {"DELIM": _text(",")},
        "lb_elapsed_time": {"SECONDS": _ONE},
        "lb_floor_divide": {"A": _number(64), "B": _number(10)},
        "lb_positive": {"NUM": _ONE},
        "lb_set_local": {"VALUE": _ZERO},
        "lb_change": {"VALUE": _ONE},
        "lb_change_index": {"INDEX": _ZERO, "VALUE": _ONE},
        "lb_dictionary_get": {"KEY": _text("abc")},
        "lb_dictionary_set": {"KEY": _text("abc")},
        "lb_dictionary_change": {"KEY": _text("abc"), "VALUE": _ONE},
        "lb_dictionary_remove": {"KEY": _text("abc")},
    }
)


#: What a new block begins with where the skill has no default, so that it does something.
FIRST_VALUES: Mapping[tuple[str, str], float | str] = MappingProxyType(
    {
        ("drive_distance", "distance"): 200,
        ("drive_arc", "radius"): 200,
        ("go_to", "x"): 200,
        ("play_frequency", "frequency"): 440,
        ("play_frequency", "time"): 500,
        ("led", "intensity"): "TRUE",
        ("RGBled", "red"): 255,
    }
)

#: The same for texts, in the reader's language: the key of their translation.
FIRST_TEXTS: Mapping[tuple[str, str], str] = MappingProxyType(
    {
        **dict.fromkeys(
            (("say_Text", "text"), ("show_text", "text"), ("matrix_text", "text")), "LB_FIRST_TEXT"
        ),
        **{
            (block, "message"): "LB_FIRST_MESSAGE"
            for block in ("send", "received", "message_value")
        },
    }
)


def parameter_shadow(parameter: Parameter) -> Shadow | None:
    """The shadow of a skill's parameter: its default, in a block for its type."""
    default = parameter.default
    match parameter.type:
        case "float" | "int" | "angle":
            return Shadow(_number_field(parameter), "NUM", _shown_number(parameter))
        case "choice" | "string" if parameter.type == "choice" or parameter.choices:
            first = next(iter(parameter.choices), "")
            return Shadow("lb_choice", "TEXT", first if default is None else str(default))
        case "string" | "apriltext":
            kind = "text" if parameter.type == "string" else "lb_tag"
            return Shadow(kind, "TEXT", "" if default is None else str(default))
        case "colour":
            return Shadow("lb_colour", "TEXT", _RED if default is None else str(default))
        case "boolean":
            return Shadow("lb_truth", "BOOL", "TRUE" if default else "FALSE")
        case "list":
            return None


def _number_field(parameter: Parameter) -> str:
    if parameter.type == "angle":
        return "lb_angle"
    return "lb_slider" if parameter.range else "math_number"


def _shown_number(parameter: Parameter) -> float:
    if isinstance(parameter.default, int | float):
        return parameter.default
    usual = _QUARTER_TURN if parameter.type == "angle" else 0
    if parameter.range:
        return min(max(usual, parameter.range.least), parameter.range.most)
    return usual


# The categories of the language: the key of their name, and the types of their blocks, with fields
# if their defaults differ from the block's, and an extra state if it is needed. If several blocks
# have the same type, all but the first have a `variant`, by which block sets refer to them; a call
# is identified by the name of the called function.
_TABS: tuple[tuple[str, tuple[tuple[str, dict[str, Any]], ...]], ...] = (
    (
        "LB_CATEGORY_EVENTS",
        (("lb_main", {}), ("lb_start", {}), ("lb_elapsed_time", {})),
    ),
    (
        "LB_CATEGORY_CONTROL",
        (
            ("controls_if", {}),
            ("controls_if", {"extraState": {"hasElse": True}, "variant": "else"}),
            ("controls_whileUntil", {"fields": {"MODE": "WHILE"}}),
            ("controls_repeat_ext", {}),
            ("lb_forever", {}),
            ("controls_for", {"fields": {"VAR": {"name": "i"}}}),
            ("controls_forEach", {"fields": {"VAR": {"name": "x"}}}),
            (
                "lb_for_unpacking",
                {
                    "extraState": {"variables": 2},
                    "fields": {"VAR": {"name": "x"}, "VAR1": {"name": "y"}},
                },
            ),
            ("lb_wait_until", {}),
            ("controls_flow_statements", {"fields": {"FLOW": "BREAK"}}),
            ("lb_pass", {}),
            ("lb_comment", {}),
            ("lb_do", {}),
            ("lb_import", {}),
            ("lb_setup", {"extraState": {"arguments": 0, "keywords": ["world"]}}),
            ("lb_python", {}),
            ("lb_python_value", {}),
        ),
    ),
    (
        "LB_CATEGORY_LOGIC",
        (
            ("logic_compare", {"fields": {"OP": "EQ"}}),
            ("logic_operation", {"fields": {"OP": "AND"}}),
            ("logic_negate", {}),
            ("logic_boolean", {"fields": {"BOOL": "TRUE"}}),
            ("logic_null", {}),
            ("logic_ternary", {}),
            ("lb_in", {}),
            ("lb_compare_chain", {"extraState": {"operators": ["<", "<"]}}),
        ),
    ),
    (
        "LB_CATEGORY_MATHS",
        (
            ("math_number", {"fields": {"NUM": 123}}),
            ("math_arithmetic", {"fields": {"OP": "ADD"}}),
            ("lb_floor_divide", {}),
            ("math_modulo", {}),
            ("math_single", {"fields": {"OP": "ROOT"}}),
            ("math_trig", {"fields": {"OP": "SIN"}}),
            ("math_atan2", {}),
            ("math_constant", {"fields": {"CONSTANT": "PI"}}),
            ("math_round", {"fields": {"OP": "ROUND"}}),
            ("math_constrain", {}),
            ("math_random_int", {}),
            ("math_random_float", {}),
        ),
    ),
    (
        "LB_CATEGORY_TEXT",
        (
            ("text", {"fields": {"TEXT": ""}}),
            ("text_join", {"extraState": {"itemCount": 2}}),
            ("text_print", {}),
            ("lb_call", {"extraState": {"name": "print", "arguments": 2, "keywords": []}}),
            ("text_prompt_ext", {"fields": {"TYPE": "TEXT"}}),
            ("text_changeCase", {"fields": {"CASE": "UPPERCASE"}}),
            ("text_trim", {"fields": {"MODE": "BOTH"}}),
            ("text_indexOf", {"fields": {"END": "FIRST"}}),
            ("text_replace", {}),
            ("lb_call_value", {"extraState": {"name": "str", "arguments": 1, "keywords": []}}),
            ("lb_call_value", {"extraState": {"name": "int", "arguments": 1, "keywords": []}}),
            ("lb_call_value", {"extraState": {"name": "float", "arguments": 1, "keywords": []}}),
        ),
    ),
    (
        "LB_CATEGORY_LISTS",
        (
            ("lists_create_with", {"extraState": {"itemCount": 0}, "variant": "empty"}),
            ("lists_create_with", {"extraState": {"itemCount": 3}}),
            ("lists_length", {}),
            ("lists_getIndex", {"fields": {"MODE": "GET", "WHERE": "FROM_START"}}),
            ("lists_setIndex", {"fields": {"MODE": "SET", "WHERE": "FROM_START"}}),
            (
                "lists_setIndex",
                {"fields": {"MODE": "INSERT", "WHERE": "LAST"}, "variant": "insert"},
            ),
            ("lb_change_index", {}),
            ("math_on_list", {"fields": {"OP": "SUM"}}),
            ("lists_split", {"fields": {"MODE": "SPLIT"}, "extraState": {"mode": "SPLIT"}}),
            ("lb_call_value", {"extraState": {"name": "sorted", "arguments": 1, "keywords": []}}),
            (
                "lb_call_value",
                {"extraState": {"name": "enumerate", "arguments": 1, "keywords": []}},
            ),
            ("lb_call_value", {"extraState": {"name": "index", "arguments": 2, "keywords": []}}),
            ("lb_call_value", {"extraState": {"name": "sublist", "arguments": 3, "keywords": []}}),
            ("lb_call", {"extraState": {"name": "remove", "arguments": 2, "keywords": []}}),
        ),
    ),
    (
        "LB_CATEGORY_DICTIONARIES",
        (
            ("lb_dictionary", {"extraState": {"items": 0}, "variant": "empty"}),
            ("lb_dictionary", {"extraState": {"items": 2}}),
            ("lb_dictionary_get", {}),
            ("lb_dictionary_set", {}),
            ("lb_dictionary_change", {"fields": {"OP": "+="}}),
            ("lb_dictionary_remove", {}),
            ("lb_dictionary_keys", {}),
            ("lb_dictionary_items", {}),
        ),
    ),
    ("LB_CATEGORY_PYTHON", PYTHON_BLOCKS),
)
#: The stage of the page from which the palette shows a category; the search finds all of them.
_STAGES = MappingProxyType({"LB_CATEGORY_PYTHON": STAGE})
# Categories that Blockly or the page fills.
_CUSTOM = (
    ("LB_CATEGORY_WHENS", "WHEN"),
    ("LB_CATEGORY_VARIABLES", "VARIABLE"),
    ("LB_CATEGORY_FUNCTIONS", "PROCEDURE"),
)


def toolbox(
    configurations: Mapping[str, BlockConfiguration], words: Mapping[str, str]
) -> dict[str, Any]:
    """The palette's groups, and every category with its group and its blocks.

    Args:
        configurations: of the skills, by name.
        words: the names of the groups and categories.
    """
    tabs = [
        {
            **_category(name, words),
            "contents": [{**_item(block), **_stage(name)} for block in blocks],
        }
        for name, blocks in _TABS
    ]
    custom = [{**_category(name, words), "custom": kind} for name, kind in _CUSTOM]
    events, *others = tabs
    skills = _skill_tabs(configurations.values(), words)
    return {
        "kind": "categoryToolbox",
        "groups": [_group(group, words) for group in GROUPS],
        "contents": [*skills, events, custom[0], *others, *custom[1:]],
    }


def _group(group: Group, words: Mapping[str, str]) -> dict[str, Any]:
    """A group with its headings and first blocks."""
    first = [
        {"heading": words[section.heading] if section.heading else "", "blocks": section.blocks}
        for section in group.first
    ]
    return {"group": group.name, "name": words[group.word], "first": first}


def is_skill_block(configuration: BlockConfiguration) -> bool:
    """Whether a configuration has its own block; `elapsedTime` is a block of the language."""
    return configuration.name != "elapsedTime"


def category_word(category: str) -> str:
    """The key of a skill category's name in the translations."""
    return "LB_SKILLS_" + "_".join(category.upper().split())


def _category(name: str, words: Mapping[str, str]) -> dict[str, Any]:
    """A category of the language; block sets call it `category`."""
    category = "lb_" + name.removeprefix("LB_CATEGORY_").lower()
    return {
        "kind": "category",
        "name": words[name],
        "category": category,
        "group": group_of(category),
    }


def _stage(category: str) -> dict[str, str]:
    """The stage from which the palette shows a block of a category."""
    return {"stage": _STAGES[category]} if category in _STAGES else {}


def _item(entry: tuple[str, dict[str, Any]]) -> dict[str, Any]:
    """A block of the language; block sets call it `block`."""
    kind, state = entry
    variant = state.get("variant") or state.get("extraState", {}).get("name")
    name = f"{kind}:{variant}" if variant else kind
    attributes = {key: value for key, value in state.items() if key != "variant"}
    return {"kind": "block", "type": kind, "block": name, **attributes, **_inputs(kind, state)}


def _inputs(kind: str, state: Mapping[str, Any]) -> dict[str, Any]:
    """The shadows of a block; only the last input of a list may have none."""
    last = state.get("fields", {}).get("WHERE") == "LAST"
    shadows = {
        name: {"shadow": shadow.block()}
        for name, shadow in SHADOWS.get(kind, {}).items()
        if not (last and name == "AT")
    }
    return {"inputs": shadows} if shadows else {}


def _skill_tabs(
    configurations: Iterable[BlockConfiguration], words: Mapping[str, str]
) -> list[dict[str, Any]]:
    skills = sorted(
        filter(is_skill_block, configurations), key=lambda configuration: configuration.category
    )
    by_category = {
        name: list(blocks)
        for name, blocks in groupby(skills, lambda configuration: configuration.category)
    }
    paired = pairs(skills)
    order = dict.fromkeys(
        configuration.category for configuration in configurations if is_skill_block(configuration)
    )
    return [
        {
            "kind": "category",
            "name": words.get(category_word(category), category),
            "category": category,
            "group": group_of(category),
            "contents": [
                skill_block(configuration, paired.get(configuration.name), words)
                for configuration in by_category[category]
            ],
        }
        for category in order
    ]


def skill_block(
    configuration: BlockConfiguration,
    pair: BlockPair | None = None,
    words: Mapping[str, str] = MappingProxyType({}),
) -> dict[str, Any]:
    """A skill's block in the palette, with the shadows of its parameters.

    The second block of a `pair` names the first, which also does what it does.
    """
    shadows = {
        parameter.name: _first_shadow(configuration, parameter, words)
        for parameter in configuration.parameters
    }
    inputs = {
        name: {"shadow": shadow.block()} for name, shadow in shadows.items() if shadow is not None
    }
    count = len(list(takewhile(_is_shown, configuration.parameters)))
    return {
        "kind": "block",
        "type": SKILL + configuration.name,
        "block": f"function.{configuration.name}",
        **({"like": f"function.{pair.first}"} if pair and pair.first != configuration.name else {}),
        **({"inputs": inputs} if inputs else {}),
        **({"needs": list(configuration.needed())} if configuration.needs else {}),
        # A new block shows its defaults in the code: `sleep(5)`, and not `sleep()`.
        **({"data": json.dumps({"given": count})} if count else {}),
    }


def _first_shadow(
    configuration: BlockConfiguration, parameter: Parameter, words: Mapping[str, str]
) -> Shadow | None:
    shadow, place = parameter_shadow(parameter), (configuration.name, parameter.name)
    value = FIRST_VALUES.get(place, words.get(FIRST_TEXTS.get(place, "")))
    return shadow if shadow is None or value is None else shadow._replace(value=value)


def _is_shown(parameter: Parameter) -> bool:
    """Whether an unchanged block shows what its call does."""
    has_default = parameter.required or parameter.default is not None
    return has_default and parameter_shadow(parameter) is not None
