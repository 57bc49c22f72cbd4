"""Value blocks into expressions. What is missing or cannot be read is noted, and replaced."""

from collections.abc import Callable, Mapping
from typing import TypeVar

from learnblock.blocks.configuration import BlockConfiguration, Parameter
from learnblock.blocks.toolbox import SKILL
from learnblock.errors import Diagnostic
from learnblock.language import workspace_literals as literals
from learnblock.language.expression_parser import MAX_HEIGHT
from learnblock.language.nodes import (
    Binary,
    Call,
    Compare,
    Constant,
    Expression,
    Index,
    Keyword,
    List,
    Name,
    Node,
    Number,
    RawExpression,
    SkillCall,
    String,
    Unary,
    within,
)
from learnblock.language.workspace import Block, FieldValue, Workspace
from learnblock.language.workspace_arguments import differs, given, tag
from learnblock.language.workspace_notes import NO_NOTES, Notes, notes_of, writable
from learnblock.language.workspace_types import (
    ARITHMETIC,
    COMPARISONS,
    CONSTANTS,
    FUNCTIONS_OF,
    LOGIC,
    MANUALLY_DISABLED,
    MEMBERSHIPS,
    SKILL_PREFIX,
    Library,
    as_name,
    is_name,
    is_word,
)

# Nobody reads more of them at once, and nobody plugs more values into one block.
MAX_PROBLEMS = 100
MAX_INPUTS = 1000

Found = TypeVar("Found")
Made = TypeVar("Made", bound=Expression)
Handler = Callable[["ValueReader", Block], Expression]

_ARITHMETIC = {word: operator for operator, word in ARITHMETIC.items()}
_LOGIC = {word: operator for operator, word in LOGIC.items()}
_COMPARISONS = {word: operator for operator, word in COMPARISONS.items()}
_MEMBERSHIPS = {operator: operator for operator in MEMBERSHIPS}
_CONSTANTS = {word: value for value, word in CONSTANTS.items()}


def is_disabled(block: Block) -> bool:
    """Whether the user has switched a block off."""
    return bool(block.disabledReasons) and MANUALLY_DISABLED in block.disabledReasons


class ValueReader:
    """Reads values.

    `problems` are what is wrong, by block. `ids` has the block of each node by the node's `id()`,
    `nodes` the node of each block, and `missing` what was put into an input where there was
    nothing to read.
    """

    def __init__(
        self, workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
    ) -> None:
        self.configurations = configurations
        self.variables = {variable.id: variable.name for variable in workspace.variables}
        self.problems: list[tuple[str, Diagnostic]] = []
        self.ids: dict[int, str] = {}
        self.nodes: dict[str, Expression] = {}
        self.missing: dict[tuple[str, str], Expression] = {}
        self.height = 0
        # As long as a node lives, no other has its `id()`.
        self.alive: list[Node] = []

    def report(self, block: Block, code: str, message: str) -> None:
        if len(self.problems) < MAX_PROBLEMS:
            self.problems.append((block.id, Diagnostic(code, message)))

    def note(self, node: Node, block: Block) -> None:
        """A node comes from a block."""
        self.ids[id(node)] = block.id
        self.alive.append(node)

    def made(self, node: Made, block: Block) -> Made:
        """A node, and those within it that have no block of their own, come from a block."""
        for one in within(node):
            self.ids.setdefault(id(one), block.id)
        return node

    # Values.

    def value(self, block: Block, name: str, instead: Expression | None = None) -> Expression:
        """What is plugged into an input; if nothing is, that is a problem and `instead` stands."""
        found = plugged(block, name)
        if found is not None:
            return self.expression(found, block)
        self.report(block, "missing-value", "this block needs a value here: plug one in")
        return self.without(block, name, instead)

    def without(self, block: Block, name: str, instead: Expression | None = None) -> Expression:
        """A stand-in for what is not in an input, or cannot be read."""
        node = self.stand_in(block, Constant(None) if instead is None else instead)
        self.missing[block.id, name] = node
        return node

    def stand_in(self, block: Block, node: Expression) -> Expression:
        self.note(node, block)
        return node

    def optional(self, block: Block, name: str) -> Expression | None:
        """What is plugged into an input, if anything is."""
        found = plugged(block, name)
        return None if found is None else self.expression(found, block)

    def truth(self, block: Block, name: str) -> Expression:
        return self.value(block, name, Constant(value=False))

    def number(self, block: Block, name: str) -> Expression:
        return self.value(block, name, Number("0"))

    def text(self, block: Block, name: str) -> Expression:
        return self.value(block, name, String(""))

    def list(self, block: Block, name: str) -> Expression:
        return self.value(block, name, List())

    def expression(self, block: Block, parent: Block) -> Expression:
        """A value block as an expression."""
        handler = VALUES.get(block.type)
        if handler is None:
            handler = _skill if block.type.startswith(SKILL) else _unknown
        if self.height == MAX_HEIGHT:
            self.report(parent, "too-deep", "too many values inside each other: use a variable")
            return self.stand_in(block, Constant(None))
        self.height += 1
        node = handler(self, block)
        self.height -= 1
        self.ids[id(node)] = block.id
        self.nodes[block.id] = node
        return node

    # What fields hold.

    def choice(self, block: Block, field: str, choices: Mapping[str, Found]) -> Found:
        """What a choice of a field stands for."""
        word = block.fields.get(field)
        if isinstance(word, str) and word in choices:
            return choices[word]
        self.report(block, "unknown-choice", f"`{field}` of this block offers no such choice")
        return next(iter(choices.values()))

    def words(self, block: Block, field: str) -> str:
        """The text of a field."""
        value = block.fields.get(field)
        return writable(value) if isinstance(value, str) else ""

    def name(self, block: Block, text: object) -> str:
        """A name; if it cannot be one, that is a problem and the nearest one stands."""
        if isinstance(text, str) and is_name(text):
            return text
        nearest = as_name(text) if isinstance(text, str) else "_"
        shown = text if isinstance(text, str) else ""
        message = (
            f"`{shown}` cannot be a name here: use letters, digits and _, such as `{nearest}`, and"
            " none of the words of the language"
        )
        self.report(block, "bad-name", message)
        return nearest

    def word(self, block: Block, text: object) -> str:
        """The name of a skill or an argument."""
        return text if isinstance(text, str) and is_word(text) else self.name(block, text)

    def variable(self, block: Block) -> Name:
        """The variable that a block's field chooses."""
        chosen = block.fields.get("VAR")
        name: FieldValue = None
        if isinstance(chosen, dict):
            name = self.variables.get(chosen.get("id", ""), chosen.get("name"))
        if name is None:
            self.report(block, "unknown-variable", "this block needs a variable: choose one")
            name = "x"
        node = Name(self.name(block, name))
        self.note(node, block)
        return node

    # Arguments.

    def items(self, block: Block, prefix: str, count: int) -> tuple[Expression, ...]:
        return tuple([self.value(block, f"{prefix}{place}") for place in range(count)])

    def arguments(self, block: Block) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        """The arguments of a call, and those that are given by name."""
        names = extra_list(block, "keywords")
        count = extra_count(block, "arguments")
        given = self.items(block, "ARG", count)
        keywords: dict[str, Keyword] = {}
        for place, name in enumerate(names, count):
            word = self.word(block, name)
            if word in keywords:
                message = f"the argument `{word}` is given twice: rename or remove one"
                self.report(block, "duplicate-argument", message)
                continue
            keywords[word] = Keyword(word, self.value(block, f"ARG{place}"))
        return given, tuple(keywords.values())

    def call(self, block: Block) -> Call | SkillCall:
        """A call of anything."""
        name = block.fields.get("NAME", extra(block, "name"))
        arguments, keywords = self.arguments(block)
        if isinstance(name, str) and name.startswith(SKILL_PREFIX):
            return skill_call(self.word(block, name[len(SKILL_PREFIX) :]), arguments, keywords)
        return Call(self.name(block, name), arguments, keywords)

    def own_call(self, block: Block) -> Call:
        """A call of a function of the user's."""
        count = len(extra_list(block, "params"))
        return Call(self.name(block, extra(block, "name")), self.items(block, "ARG", count))

    def skill(self, block: Block) -> Call | SkillCall:
        """A call of a skill, with the arguments that are not left to their defaults."""
        name = block.type[len(SKILL) :]
        configuration = self.configurations.get(name)
        if configuration is None:
            self.report(block, "unknown-skill", f"there is no skill `{name}` here: remove it")
            return skill_call(self.word(block, name), (), ())
        return skill_call(name, *self.skill_arguments(block, configuration))

    def skill_arguments(
        self, block: Block, configuration: BlockConfiguration
    ) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        present = {one.name: _is_given(block, one) for one in configuration.parameters}
        found = given([*present], present, notes_of(block))
        parameters = {one.name: one for one in configuration.parameters}
        return (
            tuple([self.argument(block, parameters[name]) for name in found.arguments]),
            tuple(
                [Keyword(name, self.argument(block, parameters[name])) for name in found.keywords]
            ),
        )

    def argument(self, block: Block, parameter: Parameter) -> Expression:
        """What is given for a parameter of a skill."""
        node = self.value(block, parameter.name)
        shadow = block.inputs[parameter.name].shadow if parameter.name in block.inputs else None
        if parameter.type != "apriltext" or shadow is not plugged(block, parameter.name):
            return node
        if shadow is not None and (number := tag(node, shadow)) is not node:
            self.alive.append(node)
            self.note(number, shadow)
            self.nodes[shadow.id] = node = number
        return node

    def place(self, block: Block, values: Expression) -> Expression:
        """The place in a list that a block's fields and inputs speak of."""
        where = block.fields.get("WHERE", "FROM_START")
        match where:
            case "FIRST":
                return Number("0")
            case "LAST":
                return Unary("-", Number("1"))
            case "FROM_END":
                return _from_end(self.number(block, "AT"))
            case "RANDOM":
                last = Binary("-", Call("len", (values,)), Number("1"))
                return Call("random", (Number("0"), last))
        return self.number(block, "AT")


def skill_call(
    name: str, arguments: tuple[Expression, ...], keywords: tuple[Keyword, ...]
) -> Call | SkillCall:
    """A call of a skill, in the form that the parser gives it."""
    kind = Call if name == "elapsedTime" else SkillCall
    return kind(name, arguments, keywords)


def plugged(block: Block, name: str) -> Block | None:
    """The block in an input, or else its shadow; None if it is empty or its block is disabled."""
    found = block.inputs.get(name)
    if found is None:
        return None
    inner = found.block or found.shadow
    return None if inner is None or is_disabled(inner) else inner


def extra(block: Block, name: str) -> object:
    """A part of a block's extra state."""
    return block.extraState.get(name) if isinstance(block.extraState, dict) else None


def extra_list(block: Block, name: str) -> list[object]:
    found = extra(block, name)
    return found[:MAX_INPUTS] if isinstance(found, list) else []


def extra_count(block: Block, name: str) -> int:
    found = extra(block, name)
    if isinstance(found, bool) or not isinstance(found, int):
        return 0
    return min(max(found, 0), MAX_INPUTS)


def _is_given(block: Block, parameter: Parameter) -> bool:
    """Whether the input of a parameter must be given, or holds something else than the default."""
    found = plugged(block, parameter.name)
    if found is None or parameter.required:
        return parameter.required
    return found is block.inputs[parameter.name].block or differs(found, parameter)


def _from_end(place: Expression) -> Expression:
    """The place counted from the end of one that Blockly counts from 0 there."""
    if isinstance(place, Number) and place.text.isdecimal():
        return Unary("-", Number(str(int(place.text) + 1)))
    return Binary("-", Unary("-", Number("1")), place)


def _unknown(reader: ValueReader, block: Block) -> Expression:
    reader.report(block, "unknown-block", f"`{block.type}` is no block that a program can have")
    return Constant(None)


def _skill(reader: ValueReader, block: Block) -> Expression:
    return reader.skill(block)


def _number(reader: ValueReader, block: Block) -> Expression:
    found = literals.number(block.fields.get("NUM"), notes_of(block))
    if found is None:
        reader.report(block, "bad-number", "this is no number: write one, such as 40")
        return Number("0")
    if isinstance(found, Unary):
        reader.note(found.operand, block)
    return found


def _text(_: ValueReader, block: Block) -> Expression:
    value = block.fields.get("TEXT")
    notes: Notes = NO_NOTES if block.data is None else notes_of(block)
    return literals.text(value if isinstance(value, str) else "", notes)


def _list(reader: ValueReader, block: Block) -> Expression:
    return List(reader.items(block, "ADD", extra_count(block, "itemCount")))


def _index(reader: ValueReader, block: Block) -> Expression:
    values = reader.list(block, "VALUE")
    if block.fields.get("MODE", "GET") != "GET":
        return reader.made(popped(reader, block, values), block)
    if block.fields.get("WHERE") == "RANDOM":
        return Call("choice", (values,))
    return reader.made(Index(values, reader.place(block, values)), block)


def popped(reader: ValueReader, block: Block, values: Expression) -> Call:
    """The removal of a value of a list."""
    if block.fields.get("WHERE") == "LAST":
        return Call("pop", (values,))
    return Call("pop", (values, reader.place(block, values)))


def _single(reader: ValueReader, block: Block) -> Expression:
    operand = reader.number(block, "NUM")
    match block.fields.get("OP"):
        case "NEG":
            return Unary("-", operand)
        case "POW10":
            return reader.made(Binary("**", Number("10"), operand), block)
    name, _ = reader.choice(block, "OP", FUNCTIONS_OF["math_single"])
    return Call(name, (operand,))


def _library(reader: ValueReader, block: Block) -> Expression:
    known = FUNCTIONS_OF[block.type]
    name, found = known[""] if "" in known else reader.choice(block, _field(known), known)
    return Call(name, tuple([reader.value(block, one) for one in found.inputs]))


def _field(known: Mapping[str, tuple[str, Library]]) -> str:
    return next(iter(known.values()))[1].field


def _chain(reader: ValueReader, block: Block) -> Expression:
    known = {*COMPARISONS, *MEMBERSHIPS}
    asked = extra_list(block, "operators")
    operators = tuple([one for one in asked if isinstance(one, str) and one in known])
    if not operators:
        reader.report(block, "unknown-choice", "this comparison compares nothing: remove it")
        return Constant(value=False)
    return Compare(operators, reader.items(block, "A", len(operators) + 1))


def _code(reader: ValueReader, block: Block) -> Expression:
    lines = reader.words(block, "CODE").split()
    text = reader.words(block, "CODE")
    if not lines:
        reader.report(block, "missing-value", "write a Python expression here")
        return Constant(None)
    if "\n" in text or "\r" in text:
        message = "a Python value stands on one line: use a block of Python lines for more"
        reader.report(block, "invalid-python", message)
        text = " ".join(lines)
    return RawExpression(text)


def _when_word(prefix: str) -> Handler:
    return lambda reader, block: Name(prefix + reader.name(block, block.fields.get("WHEN")))


VALUES: dict[str, Handler] = {
    **dict.fromkeys(FUNCTIONS_OF, _library),
    "math_single": _single,
    **dict.fromkeys(("math_number", "lb_slider", "lb_angle"), _number),
    **dict.fromkeys(("text", "lb_choice", "lb_colour", "lb_tag"), _text),
    "logic_boolean": lambda reader, block: Constant(reader.choice(block, "BOOL", _CONSTANTS)),
    "logic_null": lambda _reader, _block: Constant(None),
    "variables_get": lambda reader, block: reader.variable(block),
    "lb_state": _when_word("state_"),
    "lb_time": _when_word("time_"),
    "logic_operation": lambda reader, block: Binary(
        reader.choice(block, "OP", _LOGIC), reader.truth(block, "A"), reader.truth(block, "B")
    ),
    "math_arithmetic": lambda reader, block: Binary(
        reader.choice(block, "OP", _ARITHMETIC),
        reader.number(block, "A"),
        reader.number(block, "B"),
    ),
    "math_modulo": lambda reader, block: Binary(
        "%", reader.number(block, "DIVIDEND"), reader.number(block, "DIVISOR")
    ),
    "lb_floor_divide": lambda reader, block: Binary(
        "//", reader.number(block, "A"), reader.number(block, "B")
    ),
    "logic_negate": lambda reader, block: Unary("not", reader.truth(block, "BOOL")),
    "lb_positive": lambda reader, block: Unary("+", reader.number(block, "NUM")),
    "logic_compare": lambda reader, block: Compare(
        (reader.choice(block, "OP", _COMPARISONS),), reader_pair(reader, block)
    ),
    "lb_in": lambda reader, block: Compare(
        (reader.choice(block, "OP", _MEMBERSHIPS),), reader_pair(reader, block)
    ),
    "lb_compare_chain": _chain,
    "lists_create_with": _list,
    "lists_getIndex": _index,
    "procedures_callreturn": lambda reader, block: reader.own_call(block),
    "lb_call_value": lambda reader, block: reader.call(block),
    "lb_python_value": _code,
}


def reader_pair(reader: ValueReader, block: Block) -> tuple[Expression, Expression]:
    return reader.value(block, "A"), reader.value(block, "B")
