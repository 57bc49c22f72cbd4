"""Read value blocks as expressions. Missing or invalid values are reported and replaced."""

from collections.abc import Callable, Mapping, Sequence

from learnblock.blocks import BlockConfiguration, Parameter
from learnblock.blocks.toolbox import SKILL
from learnblock.i18n import Phrase
from learnblock.language.blocktext.nested_reader import MAX_HEIGHT
from learnblock.language.tree import texts
from learnblock.language.tree.nodes import (
    NOWHERE,
    Binary,
    Call,
    Compare,
    Conditional,
    Constant,
    Dictionary,
    Expression,
    Index,
    Keyword,
    List,
    Name,
    Number,
    RawExpression,
    SkillCall,
    String,
    Unary,
)
from learnblock.language.workspace import literals
from learnblock.language.workspace.arguments import differs, given, tag
from learnblock.language.workspace.block_reader import (
    BlockReader,
    extra,
    extra_count,
    extra_list,
    plugged,
)
from learnblock.language.workspace.blocks import Block
from learnblock.language.workspace.notes import NO_NOTES, Notes, notes_of
from learnblock.language.workspace.python_shapes import SPLITS, VALUE, Joiner, words_in
from learnblock.language.workspace.types import (
    ARITHMETIC,
    COMPARISONS,
    CONSTANTS,
    FUNCTIONS_OF,
    LOGIC,
    MEMBERSHIPS,
    SKILL_PREFIX,
    Library,
)

Handler = Callable[["ValueReader", Block], Expression]

_ARITHMETIC = {word: operator for operator, word in ARITHMETIC.items()}
_LOGIC = {word: operator for operator, word in LOGIC.items()}
_COMPARISONS = {word: operator for operator, word in COMPARISONS.items()}
_MEMBERSHIPS = {operator: operator for operator in MEMBERSHIPS}
_CONSTANTS = {word: value for value, word in CONSTANTS.items()}


class ValueReader(BlockReader):
    """Reads values; `joiner` knows the names that the workspace defines."""

    joiner: Joiner

    # Values.

    def value(
        self,
        block: Block,
        name: str,
        instead: Expression | None = None,
        message: str = "workspace-missing-value",
    ) -> Expression:
        """The value in an input; if there is none, report it and return `instead`."""
        inner = plugged(block, name)
        if inner is not None:
            return self.expression(inner, block)
        self.report(block, "missing-value", Phrase(message))
        return self.without(block, name, instead)

    def without(self, block: Block, name: str, instead: Expression | None = None) -> Expression:
        """A replacement for a missing or invalid value of an input."""
        node = self.stand_in(block, Constant(None) if instead is None else instead)
        self.missing[block.id, name] = node
        return node

    def stand_in(self, block: Block, node: Expression) -> Expression:
        self.note(node, block)
        return node

    def optional(self, block: Block, name: str) -> Expression | None:
        """The value in an input, if there is one."""
        inner = plugged(block, name)
        return None if inner is None else self.expression(inner, block)

    def truth(
        self, block: Block, name: str, message: str = "workspace-missing-condition"
    ) -> Expression:
        """The condition in an input; without one it is false, as in Scratch."""
        if (condition := self.optional(block, name)) is not None:
            return condition
        self.report(block, "missing-condition", Phrase(message), "warning")
        return self.without(block, name, Constant(value=False))

    def number(self, block: Block, name: str) -> Expression:
        return self.value(block, name, Number("0"), "workspace-missing-number")

    def text(self, block: Block, name: str) -> Expression:
        return self.value(block, name, String(""), "workspace-missing-text")

    def list(self, block: Block, name: str) -> Expression:
        return self.value(block, name, List(), "workspace-missing-list")

    def dictionary(self, block: Block) -> Expression:
        missing = "workspace-missing-dictionary"
        return self.value(block, "DICTIONARY", Dictionary(), missing)

    def key(self, block: Block) -> Expression:
        return self.text(block, "KEY")

    def expression(self, block: Block, parent: Block) -> Expression:
        """Read a value block."""
        handler = VALUES.get(block.type)
        if handler is None:
            handler = _skill if block.type.startswith(SKILL) else _unknown
        if self.height == MAX_HEIGHT:
            self.report(parent, "too-deep", Phrase("workspace-too-many-values"))
            return self.stand_in(block, Constant(None))
        self.height += 1
        node = handler(self, block)
        self.height -= 1
        self.ids[id(node)] = block.id
        self.nodes[block.id] = node
        return node

    # Arguments.

    def items(self, block: Block, prefix: str, count: int) -> tuple[Expression, ...]:
        return tuple([self.value(block, f"{prefix}{place}") for place in range(count)])

    def arguments(self, block: Block) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        """The positional and the keyword arguments of a call."""
        names = extra_list(block, "keywords")
        count = extra_count(block, "arguments")
        given = self.items(block, "ARG", count)
        keywords: dict[str, Keyword] = {}
        for place, name in enumerate(names, count):
            word = self.word(block, name)
            if word in keywords:
                message = Phrase("workspace-duplicate-argument", name=word)
                self.report(block, "duplicate-argument", message)
                continue
            keywords[word] = Keyword(word, self.value(block, f"ARG{place}"))
        return given, tuple(keywords.values())

    def call(self, block: Block) -> Call | SkillCall:
        """A call of any function or skill."""
        name = block.fields.get("NAME", extra(block, "name"))
        arguments, keywords = self.arguments(block)
        if isinstance(name, str) and name.startswith(SKILL_PREFIX):
            return skill_call(self.word(block, name[len(SKILL_PREFIX) :]), arguments, keywords)
        return Call(self.name(block, name), arguments, keywords)

    def python(
        self, block: Block, kind: str, words: Sequence[str], first: int = 0, part: int = 0
    ) -> str:
        """The Python of words and the values between them, from a number on."""
        places = range(first, first + len(words) - 1)
        values = [self.value(block, f"A{place}") for place in places]
        for value in values:
            self.note(value, block)
        spelled = "" if len(words) < 2 else "".join(notes_of(block).python[part : part + 1])
        return self.joiner.kept(spelled, words, values, SPLITS[kind]).strip() or "None"

    def own_call(self, block: Block) -> Call:
        """A call of a user's function."""
        count = len(extra_list(block, "params"))
        return Call(self.name(block, extra(block, "name")), self.items(block, "ARG", count))

    def skill(self, block: Block, name: str) -> Call | SkillCall:
        """A call of a skill, with the arguments that differ from their defaults."""
        configuration = self.configurations.get(name)
        if configuration is None:
            self.report(block, "unknown-skill", Phrase("workspace-unknown-skill", name=name))
            return skill_call(self.word(block, name), (), ())
        return skill_call(name, *self.skill_arguments(block, configuration))

    def skill_arguments(
        self, block: Block, configuration: BlockConfiguration
    ) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        present = {
            parameter.name: _is_given(block, parameter) for parameter in configuration.parameters
        }
        arguments = given([*present], present, notes_of(block))
        parameters = {parameter.name: parameter for parameter in configuration.parameters}
        return (
            tuple([self.argument(block, parameters[name]) for name in arguments.arguments]),
            tuple(
                [
                    Keyword(name, self.argument(block, parameters[name]))
                    for name in arguments.keywords
                ]
            ),
        )

    def argument(self, block: Block, parameter: Parameter) -> Expression:
        """The argument for a parameter of a skill."""
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
        """The index in a list, from the fields and inputs of a block."""
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
    """A call of a skill, as the parser would return it."""
    kind = Call if name == "elapsedTime" else SkillCall
    return kind(name, arguments, keywords)


def _is_given(block: Block, parameter: Parameter) -> bool:
    """Whether a parameter is required or its input differs from the default."""
    inner = plugged(block, parameter.name)
    if inner is None or parameter.required:
        return parameter.required
    return inner is block.inputs[parameter.name].block or differs(inner, parameter)


def _from_end(place: Expression) -> Expression:
    """The negative index for a position that Blockly counts from 0 at the end."""
    if isinstance(place, Number) and place.text.isdecimal():
        return Unary("-", Number(str(int(place.text) + 1)))
    return Binary("-", Unary("-", Number("1")), place)


def _unknown(reader: ValueReader, block: Block) -> Expression:
    reader.report(block, "unknown-block", Phrase("workspace-unknown-block", type=block.type))
    return Constant(None)


def _skill(reader: ValueReader, block: Block) -> Expression:
    return reader.skill(block, block.type[len(SKILL) :])


def _truth(reader: ValueReader, block: Block) -> Expression:
    return Constant(reader.choice(block, "BOOL", _CONSTANTS))


def _number(reader: ValueReader, block: Block) -> Expression:
    number = literals.number(block.fields.get("NUM"), notes_of(block))
    if number is None:
        reader.report(block, "bad-number", Phrase("workspace-bad-number"))
        return Number("0")
    if isinstance(number, Unary):
        reader.note(number.operand, block)
    return number


def _text(_: ValueReader, block: Block) -> Expression:
    value = block.fields.get("TEXT")
    notes: Notes = NO_NOTES if block.data is None else notes_of(block)
    return literals.text(value if isinstance(value, str) else "", notes)


def _list(reader: ValueReader, block: Block) -> Expression:
    return List(reader.items(block, "ADD", extra_count(block, "itemCount")))


def _f_string(reader: ValueReader, block: Block) -> Expression:
    count = extra_count(block, "itemCount")
    parts = [reader.text(block, f"ADD{place}") for place in range(count)]
    return reader.made(texts.f_string(parts, NOWHERE) or texts.added(parts, NOWHERE), block)


def _dictionary(reader: ValueReader, block: Block) -> Expression:
    count = extra_count(block, "items")
    entries = [
        (reader.text(block, f"KEY{place}"), reader.value(block, f"VALUE{place}"))
        for place in range(count)
    ]
    return Dictionary(tuple([key for key, _ in entries]), tuple([value for _, value in entries]))


def _index(reader: ValueReader, block: Block) -> Expression:
    values = reader.list(block, "VALUE")
    if block.fields.get("MODE", "GET") != "GET":
        return reader.made(popped(reader, block, values), block)
    if block.fields.get("WHERE") == "RANDOM":
        return Call("choice", (values,))
    return reader.made(Index(values, reader.place(block, values)), block)


def popped(reader: ValueReader, block: Block, values: Expression) -> Call:
    """The call that removes a value from a list."""
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


#: What the blocks of a function say about an empty slot, if it takes no number.
_MISSING = {
    "lists_length": "workspace-missing-text-or-list",
    "math_on_list": "workspace-missing-list",
    "lb_dictionary_keys": "workspace-missing-dictionary",
    "lb_dictionary_items": "workspace-missing-dictionary",
}


def _library(reader: ValueReader, block: Block) -> Expression:
    known = FUNCTIONS_OF[block.type]
    name, library = known[""] if "" in known else reader.choice(block, _field(known), known)
    missing = _MISSING.get(block.type, "workspace-missing-value")
    return Call(name, tuple([reader.value(block, name, None, missing) for name in library.inputs]))


def _field(known: Mapping[str, tuple[str, Library]]) -> str:
    return next(iter(known.values()))[1].field


def _chain(reader: ValueReader, block: Block) -> Expression:
    known = {*COMPARISONS, *MEMBERSHIPS}
    written = extra_list(block, "operators")
    operators = tuple([name for name in written if isinstance(name, str) and name in known])
    if not operators:
        reader.report(block, "unknown-choice", Phrase("workspace-empty-comparison"))
        return Constant(value=False)
    return Compare(operators, reader.items(block, "A", len(operators) + 1))


def _code(reader: ValueReader, block: Block) -> Expression:
    lines = reader.words(block, "CODE").split()
    text = reader.words(block, "CODE")
    if not lines:
        reader.report(block, "missing-value", Phrase("workspace-missing-python"))
        return Constant(None)
    if "\n" in text or "\r" in text:
        reader.report(block, "invalid-python", Phrase("workspace-python-lines"))
        text = " ".join(lines)
    return RawExpression(text)


def _form(reader: ValueReader, block: Block) -> Expression:
    return RawExpression(reader.python(block, VALUE, words_in(extra(block, "words"))))


def _when_word(prefix: str) -> Handler:
    return lambda reader, block: Name(prefix + reader.name(block, block.fields.get("WHEN")))


VALUES: dict[str, Handler] = {
    **dict.fromkeys(FUNCTIONS_OF, _library),
    "math_single": _single,
    **dict.fromkeys(("math_number", "lb_slider", "lb_angle"), _number),
    **dict.fromkeys(("text", "lb_choice", "lb_colour", "lb_tag"), _text),
    **dict.fromkeys(("logic_boolean", "lb_truth"), _truth),
    "logic_null": lambda _reader, _block: Constant(None),
    "variables_get": lambda reader, block: reader.variable(block),
    "lb_state": _when_word("state_"),
    "lb_time": _when_word("time_"),
    "logic_operation": lambda reader, block: Binary(
        reader.choice(block, "OP", _LOGIC),
        reader.truth(block, "A", "workspace-missing-side"),
        reader.truth(block, "B", "workspace-missing-side"),
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
    "logic_ternary": lambda reader, block: Conditional(
        condition=reader.truth(block, "IF"),
        yes=reader.value(block, "THEN"),
        no=reader.value(block, "ELSE"),
    ),
    "text_join": _f_string,
    "lb_dictionary": _dictionary,
    "lb_dictionary_get": lambda reader, block: Index(reader.dictionary(block), reader.key(block)),
    "lists_create_with": _list,
    "lists_getIndex": _index,
    "procedures_callreturn": lambda reader, block: reader.own_call(block),
    "lb_call_value": lambda reader, block: reader.call(block),
    "lb_python_value": _code,
    VALUE: _form,
}


def reader_pair(reader: ValueReader, block: Block) -> tuple[Expression, Expression]:
    return reader.value(block, "A"), reader.value(block, "B")
