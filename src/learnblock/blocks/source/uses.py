"""What the functions of a Python file need of a robot, read from their source.

A function that calls a skill needs whatever that skill needs. So users need not declare what their
own skills need, and a robot that lacks any of it is refused before the program starts.

What a function does only after ``robot.has(...)`` is not counted, because it can do without.
"""

import ast
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import reduce
from types import MappingProxyType

from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.devices import DEVICE_TYPES
from learnblock.senses import is_decoration, sense_of

#: The most parts of a name after the first: packages are seldom nested deeper.
_MOST_PARTS = 5


@dataclass(frozen=True, slots=True)
class SkillUse:
    """A call of something that may be a skill: an attribute of any object.

    Args:
        name: the attribute.
        arguments: the text given for each, also of True and False; None for what only the run will
            tell.
        keywords: the same by name.
    """

    name: str
    arguments: tuple[str | None, ...]
    keywords: tuple[tuple[str, str | None], ...]

    def needed(self, skill: BlockConfiguration) -> tuple[str, ...]:
        """What this call of a skill needs."""
        names = (parameter.name for parameter in skill.parameters)
        given = dict(zip(names, self.arguments, strict=False)) | dict(self.keywords)
        return skill.needed(given)


@dataclass(frozen=True, slots=True)
class UsedNames:
    """What a function or a class uses.

    Args:
        needs: the senses and devices that it reads itself.
        calls: its calls of what may be skills.
        mentions: every name in it, some of which may be functions, such as ``near`` and
            ``helpers.near``.
    """

    needs: frozenset[str] = frozenset()
    calls: tuple[SkillUse, ...] = ()
    mentions: frozenset[str] = frozenset()

    def needed(self, skills: Mapping[str, BlockConfiguration]) -> tuple[str, ...]:
        """What it needs, with the needs of the skills that it calls; sorted."""
        known = (call.needed(skills[call.name]) for call in self.calls if call.name in skills)
        return tuple(sorted(self.needs.union(*known)))

    def joined(self, other: "UsedNames") -> "UsedNames":
        """What both use."""
        mentions = self.mentions | other.mentions
        return UsedNames(self.needs | other.needs, self.calls + other.calls, mentions)


def uses_of(
    tree: ast.Module, imported: Mapping[str, UsedNames] = MappingProxyType({})
) -> dict[str, UsedNames]:
    """What each function and class at the top of a file uses, by its name.

    What it mentions counts as well.

    Args:
        tree: the file.
        imported: what the functions use that it imports, as it writes them.
    """
    kinds = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
    own = {
        statement.name: _uses(statement) for statement in tree.body if isinstance(statement, kinds)
    }
    return {name: _all(name, {**imported, **own}) for name in own}


def imported_names(
    tree: ast.Module, defined: Callable[[str], Mapping[str, UsedNames]]
) -> dict[str, UsedNames]:
    """What the functions and classes use that a file imports, as it writes them.

    They are ``follow`` or, after ``import helpers``, ``helpers.follow``.

    Args:
        tree: the file.
        defined: returns what is defined in a module; nothing if it is not beside the program.
    """
    names: dict[str, UsedNames] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                module = alias.asname or alias.name
                uses = defined(alias.name)
                names |= {f"{module}.{name}": value for name, value in uses.items()}
        elif isinstance(node, ast.ImportFrom) and node.module:
            uses = defined(node.module)
            for alias in node.names:
                if alias.name == "*":
                    names |= uses
                elif alias.name in uses:
                    names[alias.asname or alias.name] = uses[alias.name]
    return names


def with_needs(
    blocks: Iterable[BlockConfiguration],
    uses: Mapping[str, UsedNames],
    skills: Mapping[str, BlockConfiguration],
) -> Iterator[BlockConfiguration]:
    """Blocks with the needs of their functions, unless their configurations name some.

    Args:
        blocks: the blocks.
        uses: what each of the functions uses, by name.
        skills: all other skills, which they may call.
    """
    for block in blocks:
        names = () if block.needs else _all(block.name, uses).needed(skills)
        # A question is answered without its decoration, too.
        needs = [need for need in names if not (block.returns_value and is_decoration(need))]
        yield replace(block, needs=tuple(needs)) if needs else block


def _all(name: str, uses: Mapping[str, UsedNames]) -> UsedNames:
    """What something uses, and in turn what it mentions."""
    seen: dict[str, UsedNames] = {}
    ahead = [name]
    while ahead:
        names = ahead.pop()
        if names in uses and names not in seen:
            seen[names] = uses[names]
            ahead += uses[names].mentions
    return reduce(UsedNames.joined, seen.values(), UsedNames())


def _uses(definition: ast.stmt) -> UsedNames:
    nodes = list(_unguarded(definition))
    calls = [node for node in nodes if isinstance(node, ast.Call)]
    names = {node.id for node in nodes if isinstance(node, ast.Name)}
    attributes = [node for node in nodes if isinstance(node, ast.Attribute)]
    names |= {node.attr for node in attributes}
    return UsedNames(
        frozenset(filter(None, map(_read, calls))),
        tuple(filter(None, map(_skill_use, calls))),
        frozenset(names.union(map(dotted, attributes))),
    )


def _unguarded(root: ast.AST) -> Iterator[ast.AST]:
    """The nodes that the code reaches even if `robot.has(...)` is never true."""
    waiting = [root]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += _unguarded_parts(node)


def _unguarded_parts(node: ast.AST) -> Iterator[ast.AST]:
    guarded = _guarded_field(node)
    is_and = isinstance(node, ast.BoolOp) and isinstance(node.op, ast.And)
    guards = _asks if is_and else _returns_without
    for field, value in ast.iter_fields(node):
        if field != guarded:
            parts = value if isinstance(value, list) else [value]
            yield from _until(guards, (part for part in parts if isinstance(part, ast.AST)))


def _guarded_field(node: ast.AST) -> str | None:
    match node:
        case ast.If(test=test) | ast.IfExp(test=test):
            return "body" if _asks(test) else "orelse" if _asks_for_none(test) else None
    return None


def _until(guards: Callable[[ast.AST], bool], parts: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """The parts up to the first one that guards the others; it is the last."""
    for part in parts:
        yield part
        if guards(part):
            return


def _returns_without(part: ast.AST) -> bool:
    """Whether a statement ends a function or a round of a loop if the robot lacks a device."""
    match part:
        case ast.If(test=test, body=[*_, ast.Return() | ast.Raise() | ast.Continue()]):
            return _asks_for_none(test)
    return False


def _asks(test: ast.AST) -> bool:
    """Whether a condition is true only if the robot has a device: ``robot.has(Camera)``."""
    match test:
        case ast.Call(func=ast.Attribute(value=ast.Name(), attr="has")):
            return True
        case ast.BoolOp(op=ast.And(), values=values):
            return any(map(_asks, values))
    return False


def _asks_for_none(test: ast.AST) -> bool:
    """Whether a condition is true whenever the robot lacks a device."""
    match test:
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return _asks(operand)
        case ast.BoolOp(op=ast.Or(), values=values):
            return any(map(_asks_for_none, values))
    return False


def _read(call: ast.Call) -> str | None:
    """The sense or device that a call reads: ``robot.senses.heading()``, ``robot.read(Camera)``."""
    match call:
        case ast.Call(func=ast.Attribute(value=ast.Attribute(attr="senses"), attr=method)):
            return sense_of(method, text_of(call.args[0]) if call.args else None)
        case ast.Call(func=ast.Attribute(attr="read"), args=[ast.Name(id=kind), *_]):
            return kind if kind in DEVICE_TYPES else None
    return None


def _skill_use(call: ast.Call) -> SkillUse | None:
    if not isinstance(call.func, ast.Attribute):
        return None
    keywords = tuple(
        (keyword.arg, text_of(keyword.value)) for keyword in call.keywords if keyword.arg
    )
    return SkillUse(call.func.attr, tuple(map(text_of, call.args)), keywords)


def dotted(node: ast.expr) -> str:
    """The name of a function as a program writes it, such as ``helpers.follow``; else empty."""
    parts: list[str] = []
    while isinstance(node, ast.Attribute) and len(parts) < _MOST_PARTS:
        parts.append(node.attr)
        node = node.value
    return ".".join((node.id, *reversed(parts))) if isinstance(node, ast.Name) else ""


def text_of(value: ast.expr) -> str | None:
    """The text of a literal text, True or False; None for what only the run will tell."""
    match value:
        case ast.Constant(value=str(text)):
            return text
        case ast.Constant(value=bool() as is_so):
            return str(is_so)
    return None
