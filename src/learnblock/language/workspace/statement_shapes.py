"""Turn statements and definitions into shapes."""

from collections.abc import Callable
from typing import Any

from learnblock.blocks.ready_hats import READY_HATS, ready_hat
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Break,
    Call,
    Comment,
    Continue,
    Deactivate,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Item,
    Main,
    Name,
    Number,
    Pass,
    Perform,
    PythonBlock,
    PythonLine,
    Raw,
    Repeat,
    Return,
    Setup,
    SkillCall,
    WaitUntil,
    When,
    While,
    WithoutRobot,
)
from learnblock.language.workspace.notes import NO_NOTES, Notes
from learnblock.language.workspace.python_shapes import (
    BLOCK,
    LINE,
    block_parts,
    python_parts,
    raw_type,
)
from learnblock.language.workspace.shapes import (
    Shape,
    Shaper,
    any_call,
    at,
    entry,
    function_type,
    numbered,
    python_shape,
)
from learnblock.language.workspace.types import (
    ANSWERING_FUNCTION,
    FOR_EACH,
    FOR_UNPACKING,
    FOREVER,
    FUNCTION,
    MAIN,
    WHEN,
    WHILE,
    variable_fields,
)

_IDLE: Body = (Pass(),)


class StatementShaper(Shaper):
    """Turns statements into shapes."""

    def statement(self, node: Item | Main) -> Shape:
        return _SHAPES[type(node)](self, node)

    def perform(self, node: Perform) -> Shape:
        call = node.call
        shape = self.call_alone(call) if isinstance(call, Call) else self.skill_alone(call)
        return (shape or any_call("lb_call", call))._replace(ends=(node.comment,))

    def call_alone(self, call: Call) -> Shape | None:
        own = self.own_call(call, FUNCTION, "procedures_callnoreturn")
        if own is not None:
            return own
        if call.name in self.functions:
            answering = self.own_call(call, ANSWERING_FUNCTION, "procedures_callreturn")
            return answering and Shape("lb_do", values={"VALUE": call})
        return None if call.keywords else self.library_alone(call)

    def library_alone(self, call: Call) -> Shape | None:
        match call:
            case Call("pop", (values, key)) if self.is_entry(values, key):
                return entry("lb_dictionary_remove", Index(values, key))
        return _library_statement(call)

    def skill_alone(self, call: SkillCall) -> Shape | None:
        shape = self.skill(call, answers=False)
        if shape is None and self.skill(call, answers=True) is not None:
            return Shape("lb_do", values={"VALUE": call})
        return shape

    def ready_hat(self, node: When) -> Shape | None:
        """The shape of a ``when`` as a ready hat, if its condition is the call of its skill."""
        call = node.condition
        if not isinstance(call, SkillCall) or ready_hat(call.name) not in READY_HATS:
            return None
        shape = self.skill(call, answers=True)
        return shape and shape._replace(
            type=ready_hat(call.name),
            fields={"NAME": node.name},
            bodies=_busy({"DO": node.body}),
            ends=(node.comment,),
        )


def _library_statement(call: Call) -> Shape | None:
    """The shape of a library function if Blockly has a statement for it, else None."""
    match call:
        case Call("print", (value,)):
            return Shape("text_print", values={"TEXT": value})
        case Call("append", (values, value)):
            fields = {"MODE": "INSERT", "WHERE": "LAST"}
            return Shape("lists_setIndex", fields, {"LIST": values, "TO": value})
        case Call("insert", (values, index, value)):
            fields = {"MODE": "INSERT", "WHERE": "FROM_START"}
            return Shape("lists_setIndex", fields, {"LIST": values, "AT": index, "TO": value})
        case Call("pop", (values,)):
            return _removal("LAST", {"VALUE": values})
        case Call("pop", (values, index)):
            return _removal("FROM_START", {"VALUE": values, "AT": index})
    return None


def _removal(where: str, values: dict[str, Expression]) -> Shape:
    fields = {"MODE": "REMOVE", "WHERE": where}
    return Shape("lists_getIndex", fields, values, extra={"isStatement": True})


def _assign(shaper: StatementShaper, node: Assign) -> Shape:
    target = node.target
    if isinstance(target, Name):
        shape = _set(node, target)
    elif shaper.is_entry(target.value, target.index):
        shape = _set_entry(node, target)
    else:
        shape = _set_index(node, target)
    return shape._replace(ends=(node.comment,))


def _set(node: Assign, target: Name) -> Shape:
    match node.operator:
        case "=":
            kind = "lb_set_local" if node.is_local else "variables_set"
            return Shape(kind, {"VAR": target}, {"VALUE": node.value})
        case "+=":
            return Shape("math_change", {"VAR": target}, {"DELTA": node.value})
    return Shape("lb_change", {"VAR": target, "OP": node.operator}, {"VALUE": node.value})


def _set_entry(node: Assign, target: Index) -> Shape:
    if node.operator == "=":
        return entry("lb_dictionary_set", target, VALUE=node.value)
    shape = entry("lb_dictionary_change", target, VALUE=node.value)
    return shape._replace(fields={"OP": node.operator})


def _set_index(node: Assign, target: Index) -> Shape:
    if node.operator == "=":
        shape = at("SET", target.index, {"LIST": target.value})
        return shape._replace(type="lists_setIndex", values={**shape.values, "TO": node.value})
    values = {"LIST": target.value, "INDEX": target.index, "VALUE": node.value}
    return Shape("lb_change_index", {"OP": node.operator}, values)


def _if(_: StatementShaper, node: If) -> Shape:
    bodies = {f"DO{place}": branch.body for place, branch in enumerate(node.branches)}
    ends = [branch.comment for branch in node.branches]
    extra: dict[str, object] = {}
    if len(node.branches) > 1:
        extra["elseIfCount"] = len(node.branches) - 1
    if node.otherwise is not None:
        extra["hasElse"] = True
        bodies["ELSE"] = node.otherwise.body
        ends.append(node.otherwise.comment)
    conditions = numbered("IF", [branch.condition for branch in node.branches])
    return Shape("controls_if", {}, conditions, _busy(bodies), extra or None, NO_NOTES, tuple(ends))


def while_shape(node: While) -> Shape:
    """The shape of a loop with its condition, even if that is always true."""
    return _loop(WHILE, node, {"BOOL": node.condition}, {"MODE": "WHILE"})


def _while(_: StatementShaper, node: While) -> Shape:
    return _loop(FOREVER, node, {}, {}) if node.is_endless else while_shape(node)


def _for_range(_: StatementShaper, node: ForRange) -> Shape:
    values = {"FROM": node.start, "TO": node.stop}
    if node.step is not None:
        values["BY"] = node.step
    notes = Notes(step=True) if node.step == Number("1") else NO_NOTES
    shape = _loop("controls_for", node, values, {"VAR": node.target})
    return shape._replace(notes=notes)


def _for_each(_: StatementShaper, node: ForEach) -> Shape:
    fields = dict(zip(variable_fields(len(node.targets)), node.targets, strict=True))
    kind = FOR_EACH if len(fields) == 1 else FOR_UNPACKING
    shape = _loop(kind, node, {"LIST": node.values}, fields)
    return shape if len(fields) == 1 else shape._replace(extra={"variables": len(fields)})


def _loop(kind: str, node: Any, values: dict[str, Expression], fields: dict[str, Any]) -> Shape:
    return Shape(kind, fields, values, _busy({"DO": node.body}), ends=(node.comment,))


def _raw(_: StatementShaper, node: Raw) -> Shape:
    kind, notes = raw_type(node)
    return Shape(kind, {"CODE": node.text.removesuffix("\n")}, notes=notes)


def _python_line(shaper: StatementShaper, node: PythonLine) -> Shape:
    parts = python_parts(shaper.sockets, node)
    words = [node.text] if parts is None else list(parts[0].words)
    shape = python_shape(LINE, {"words": words}, parts[1] if parts else (), (node.text,))
    return shape._replace(ends=(node.comment,))


def _python_block(shaper: StatementShaper, node: PythonBlock) -> Shape:
    words, values, bodies = block_parts(shaper.sockets, node)
    shape = python_shape(BLOCK, {"parts": words}, values, tuple(part.header for part in node.parts))
    inside = _busy({f"DO{place}": body for place, body in enumerate(bodies)})
    return shape._replace(bodies=inside, ends=tuple(part.comment for part in node.parts))


def _def(_: StatementShaper, node: Def) -> Shape:
    kind = function_type(node)
    # The writer makes them variables of the workspace.
    extra = {"params": [{"name": name, "id": name} for name in node.parameters]}
    shape = Shape(kind, {"NAME": node.name}, extra=extra if node.parameters else None)
    shape = shape._replace(ends=(node.comment,))
    if kind == FUNCTION:
        return shape._replace(bodies=_busy({"STACK": node.body}))
    *body, last = node.body
    notes = NO_NOTES
    if body and isinstance(body[-1], Blank):
        body, notes = body[:-1], Notes(apart=True)
    result = {"RETURN": last.value} if isinstance(last, Return) and last.value is not None else {}
    return shape._replace(values=result, bodies={"STACK": tuple(body)}, notes=notes)


def when_shape(node: When) -> Shape:
    """The shape of a ``when`` whose condition, if any, is a block of its own."""
    values = {} if node.condition is None else {"CONDITION": node.condition}
    extra = {"condition": node.condition is not None}
    bodies = _busy({"DO": node.body})
    return Shape(WHEN, {"NAME": node.name}, values, bodies, extra, ends=(node.comment,))


def _when(shaper: StatementShaper, node: When) -> Shape:
    return shaper.ready_hat(node) or when_shape(node)


def _busy(bodies: dict[str, Body]) -> dict[str, Body]:
    """The bodies; those that do nothing have no blocks."""
    return {name: () if body == _IDLE else body for name, body in bodies.items()}


def _word(kind: str, **fields: str) -> Callable[[StatementShaper, Any], Shape]:
    return lambda _, node: Shape(kind, fields, ends=(node.comment,))


def _activation(kind: str) -> Callable[[StatementShaper, Any], Shape]:
    return lambda _, node: Shape(kind, {"WHEN": node.name}, ends=(node.comment,))


def _return(_: StatementShaper, node: Return) -> Shape:
    values = {} if node.value is None else {"VALUE": node.value}
    return Shape("lb_return", values=values, ends=(node.comment,))


_SHAPES: dict[type[Item | Main], Callable[[StatementShaper, Any], Shape]] = {
    Comment: lambda _, node: Shape("lb_comment", {"TEXT": node.text}),
    Perform: StatementShaper.perform,
    Assign: _assign,
    If: _if,
    While: _while,
    Repeat: lambda _, node: _loop("controls_repeat_ext", node, {"TIMES": node.count}, {}),
    ForEach: _for_each,
    ForRange: _for_range,
    WaitUntil: lambda _, node: Shape(
        "lb_wait_until", values={"CONDITION": node.condition}, ends=(node.comment,)
    ),
    Break: _word("controls_flow_statements", FLOW="BREAK"),
    Continue: _word("controls_flow_statements", FLOW="CONTINUE"),
    Pass: _word("lb_pass"),
    Return: _return,
    Activate: _activation("lb_activate"),
    Deactivate: _activation("lb_deactivate"),
    Raw: _raw,
    PythonLine: _python_line,
    PythonBlock: _python_block,
    WithoutRobot: lambda _, _node: Shape("lb_without_robot"),
    Import: lambda _, node: Shape("lb_import", {"MODULE": node.module}, ends=(node.comment,)),
    Setup: lambda _, node: any_call("lb_setup", node),
    Def: _def,
    When: _when,
    Main: lambda _, node: Shape(MAIN, bodies=_busy({"DO": node.body})),
}
