"""Turn expressions into shapes: the content of a block, before its id is known."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.toolbox import SKILL
from learnblock.language.blocktext import names
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Body,
    Call,
    Comment,
    Compare,
    Conditional,
    Constant,
    Def,
    Dictionary,
    Expression,
    FString,
    Index,
    List,
    Name,
    Number,
    Program,
    RawExpression,
    Return,
    Setup,
    SkillCall,
    String,
    Unary,
)
from learnblock.language.tree.traversal import statements
from learnblock.language.workspace.arguments import given_by, noted
from learnblock.language.workspace.blocks import FieldValue
from learnblock.language.workspace.literals import literal
from learnblock.language.workspace.notes import NO_NOTES, Ends, Notes
from learnblock.language.workspace.python_shapes import VALUE, Sockets, python_parts
from learnblock.language.workspace.types import (
    ANSWERING_FUNCTION,
    ARITHMETIC,
    COMPARISONS,
    FUNCTION,
    LIBRARY,
    LOGIC,
    SKILL_PREFIX,
)

_LAST = Unary("-", Number("1"))
_NOTHING: Mapping[str, Any] = {}


class Shape(NamedTuple):
    """The content of a block.

    Args:
        type: the type of the block.
        fields: the fields by name; a variable is a `Name`.
        values: the plugged-in values, by input.
        bodies: the statements inside, by input.
        extra: its extra state.
        notes: details that the block cannot show.
        ends: the comments at the ends of its lines.
    """

    type: str
    fields: Mapping[str, FieldValue | Name] = _NOTHING
    values: Mapping[str, Expression] = _NOTHING
    bodies: Mapping[str, Body] = _NOTHING
    extra: Any = None
    notes: Notes = NO_NOTES
    ends: Ends = ()


class Signature(NamedTuple):
    """A user's function: the type of its block and its parameters."""

    type: str
    parameters: tuple[str, ...]


class Shaper:
    """Turns expressions into shapes, which depend on the names that the program defines.

    Args:
        program: the tree.
        configurations: the blocks of the skills, by name.
    """

    def __init__(self, program: Program, configurations: Mapping[str, BlockConfiguration]) -> None:
        self.configurations = configurations
        self.whens = program.whens.keys()
        self.functions = _functions(program)
        self.dictionaries = _dictionaries(program)
        self.sockets = Sockets(program)

    def value(self, node: Expression) -> Shape:
        return _SHAPES[type(node)](self, node)

    def name(self, node: Name) -> Shape:
        state = names.state_of(node.name, self.whens)
        if state is None:
            return Shape("variables_get", {"VAR": node})
        when, asked = state
        return Shape("lb_state" if asked == "active" else "lb_time", {"WHEN": when})

    def call(self, node: Call) -> Shape:
        """The shape of a call as a value."""
        own = self.own_call(node, ANSWERING_FUNCTION, "procedures_callreturn")
        return own or self.library_call(node) or any_call("lb_call_value", node)

    def library_call(self, node: Call) -> Shape | None:
        """The shape of a call if Blockly has a block for it, else None."""
        if node.keywords or node.name in self.functions:
            return None
        if node.name == "pop" and len(node.arguments) == 2 and self.is_entry(*node.arguments):
            return None
        if node.name == "pop" and 1 <= len(node.arguments) <= 2:
            return _pop(node.arguments)
        library = LIBRARY.get((node.name, len(node.arguments)))
        if library is None:
            return None
        fields = {library.field: library.value} if library.field else _NOTHING
        values = dict(zip(library.inputs, node.arguments, strict=True))
        return Shape(library.type, fields, values, extra=library.extra)

    def is_entry(self, values: Expression, index: Expression) -> bool:
        """Whether an index is a key of a dictionary, and not a position in a list."""
        if isinstance(values, Name) and values.name in self.dictionaries:
            return True
        return isinstance(index, String | FString)

    def own_call(self, node: Call, definition: str, kind: str) -> Shape | None:
        """The shape of a call of a user's function, or None if the call does not fit it."""
        function = self.functions.get(node.name)
        if function is None or function.type != definition or node.keywords:
            return None
        if len(function.parameters) != len(node.arguments):
            return None
        extra: dict[str, object] = {"name": node.name}
        if function.parameters:
            extra["params"] = list(function.parameters)
        return Shape(kind, values=numbered("ARG", node.arguments), extra=extra)

    def skill_call(self, node: SkillCall) -> Shape:
        """The shape of a call of a skill as a value."""
        return self.skill(node, answers=True) or any_call("lb_call_value", node)

    def skill(self, node: Call | SkillCall, *, answers: bool) -> Shape | None:
        """The shape of the skill's own block, or None if it does not fit the call."""
        configuration = self.configurations.get(node.name)
        if configuration is None or configuration.returns_value != answers:
            return None
        given = given_by(node, configuration)
        if given is None:
            return None
        values = dict(zip(given.arguments, node.arguments, strict=True))
        values.update((keyword.name, keyword.value) for keyword in node.keywords)
        return Shape(SKILL + node.name, values=values, notes=noted(node, configuration, values))

    def raw(self, node: RawExpression) -> Shape:
        """The shape of an expression of Python."""
        parts = python_parts(self.sockets, node)
        if parts is None:
            return Shape("lb_python_value", {"CODE": node.text})
        form, values = parts
        return python_shape(VALUE, {"words": list(form.words)}, values, (node.text,))


def python_shape(
    kind: str, extra: Mapping[str, Any], values: Sequence[Expression], spelled: tuple[str, ...]
) -> Shape:
    """The shape of Python with sockets for its values, which keeps how it was spelled."""
    notes = Notes(python=spelled) if values else NO_NOTES
    return Shape(kind, values=numbered("A", values), extra=dict(extra), notes=notes)


def any_call(kind: str, node: Call | SkillCall | Setup) -> Shape:
    """The shape of a call or a setup in a block that takes any arguments."""
    keywords = [keyword.name for keyword in node.keywords]
    values = (*node.arguments, *(keyword.value for keyword in node.keywords))
    extra = {"arguments": len(node.arguments), "keywords": keywords}
    if isinstance(node, Setup):
        return Shape(kind, values=numbered("ARG", values), extra=extra, ends=(node.comment,))
    name = node.name if isinstance(node, Call) else SKILL_PREFIX + node.name
    return Shape(kind, {"NAME": name}, numbered("ARG", values), extra={"name": name, **extra})


def numbered(prefix: str, values: Iterable[Expression]) -> dict[str, Expression]:
    """Values by the names of inputs, numbered from 0."""
    return {f"{prefix}{place}": value for place, value in enumerate(values)}


def at(mode: str, index: Expression, values: dict[str, Expression]) -> Shape:
    """The part of a shape that selects an item of a list."""
    if index == _LAST:
        return Shape("", {"MODE": mode, "WHERE": "LAST"}, values)
    return Shape("", {"MODE": mode, "WHERE": "FROM_START"}, {**values, "AT": index})


def entry(kind: str, node: Index, **more: Expression) -> Shape:
    """The shape of a block about one entry of a dictionary."""
    return Shape(kind, values={"DICTIONARY": node.value, "KEY": node.index, **more})


def function_type(node: Def) -> str:
    """The type of a function's block, which depends on whether its last line returns a value."""
    last = node.body[-1] if node.body else None
    if not isinstance(last, Return) or last.value is None or last.comment is not None:
        return FUNCTION
    lead = node.body[-2:-1]
    return FUNCTION if lead and type(lead[0]) is Comment else ANSWERING_FUNCTION


def _functions(program: Program) -> dict[str, Signature]:
    """The functions that Blockly's own blocks can call: to it, `A` and `a` are the same name."""
    functions: dict[str, Def | None] = {}
    for item in program.items:
        if isinstance(item, Def):
            key = item.name.lower()
            functions[key] = None if key in functions else item
    return {
        item.name: Signature(function_type(item), item.parameters)
        for item in functions.values()
        if item is not None
    }


def _dictionaries(program: Program) -> frozenset[str]:
    """The variables that hold dictionaries."""
    main = () if program.main is None else program.main.body
    return frozenset(
        statement.target.name
        for statement in statements((*program.items, *main))
        if type(statement) is Assign
        and type(statement.value) is Dictionary
        and type(statement.target) is Name
    )


def _pop(arguments: tuple[Expression, ...]) -> Shape:
    values = {"VALUE": arguments[0]}
    if len(arguments) == 1:
        return Shape("lists_getIndex", {"MODE": "GET_REMOVE", "WHERE": "LAST"}, values)
    fields = {"MODE": "GET_REMOVE", "WHERE": "FROM_START"}
    return Shape("lists_getIndex", fields, {**values, "AT": arguments[1]})


def _literal(_: Shaper, node: Expression) -> Shape:
    value = literal(node)
    if value is None:
        return Shape("logic_null")
    return Shape(value.type, {value.field: value.value}, notes=value.notes)


def _unary(shaper: Shaper, node: Unary) -> Shape:
    match node.operator:
        case "not":
            return Shape("logic_negate", values={"BOOL": node.operand})
        case "+":
            return Shape("lb_positive", values={"NUM": node.operand})
    if isinstance(node.operand, Number):
        return _literal(shaper, node)
    return Shape("math_single", {"OP": "NEG"}, {"NUM": node.operand})


def _binary(_: Shaper, node: Binary) -> Shape:
    values = {"A": node.left, "B": node.right}
    match node.operator:
        case "and" | "or":
            return Shape("logic_operation", {"OP": LOGIC[node.operator]}, values)
        case "%":
            return Shape("math_modulo", values={"DIVIDEND": node.left, "DIVISOR": node.right})
        case "//":
            return Shape("lb_floor_divide", values=values)
    return Shape("math_arithmetic", {"OP": ARITHMETIC[node.operator]}, values)


def _compare(_: Shaper, node: Compare) -> Shape:
    if len(node.operators) > 1:
        extra = {"operators": list(node.operators)}
        return Shape("lb_compare_chain", values=numbered("A", node.operands), extra=extra)
    operator = node.operators[0]
    values = {"A": node.operands[0], "B": node.operands[1]}
    if operator in COMPARISONS:
        return Shape("logic_compare", {"OP": COMPARISONS[operator]}, values)
    return Shape("lb_in", {"OP": operator}, values)


def _conditional(_: Shaper, node: Conditional) -> Shape:
    values = {"IF": node.condition, "THEN": node.yes, "ELSE": node.no}
    return Shape("logic_ternary", values=values)


def _dictionary(_: Shaper, node: Dictionary) -> Shape:
    values = {**numbered("KEY", node.keys), **numbered("VALUE", node.values)}
    return Shape("lb_dictionary", values=values, extra={"items": len(node.keys)})


def _index(shaper: Shaper, node: Index) -> Shape:
    if shaper.is_entry(node.value, node.index):
        return entry("lb_dictionary_get", node)
    return at("GET", node.index, {"VALUE": node.value})._replace(type="lists_getIndex")


def _f_string(_: Shaper, node: FString) -> Shape:
    extra = {"itemCount": len(node.parts)}
    return Shape("text_join", values=numbered("ADD", node.parts), extra=extra)


def _list(_: Shaper, node: List) -> Shape:
    extra = {"itemCount": len(node.items)}
    return Shape("lists_create_with", values=numbered("ADD", node.items), extra=extra)


_SHAPES: dict[type[Expression], Callable[[Shaper, Any], Shape]] = {
    Number: _literal,
    String: _literal,
    FString: _f_string,
    Constant: _literal,
    Name: Shaper.name,
    Call: Shaper.call,
    SkillCall: Shaper.skill_call,
    List: _list,
    Dictionary: _dictionary,
    Index: _index,
    Unary: _unary,
    Binary: _binary,
    Compare: _compare,
    Conditional: _conditional,
    RawExpression: Shaper.raw,
}
