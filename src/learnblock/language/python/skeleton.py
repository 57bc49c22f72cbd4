"""Recognize the parts of a Python file that creates a robot like generated programs."""

import ast
from dataclasses import dataclass, field
from itertools import takewhile

from learnblock.language.python.robot_import import imports_robot, is_robot_module
from learnblock.language.tree.loads import bound_names

_LEARNBLOCK = "learnblock"
_NAMES = frozenset(("robot", "Robot"))


@dataclass(slots=True)
class Skeleton:
    """The statements of a file, split at the import and creation of the robot.

    Args:
        robot: the name of the robot, also where its two lines are missing; None in a program in
            which the name means something else.
        importing: the statement that imports ``Robot``; None in a program without a robot.
        creating: the statement ``robot = Robot(...)``.
        creation: its value.
        head: the other statements before `creating`.
        rest: the statements after it.
    """

    robot: str | None = "robot"
    importing: ast.ImportFrom | None = None
    creating: ast.Assign | None = None
    creation: ast.Call | None = None
    head: list[ast.stmt] = field(default_factory=list)
    rest: list[ast.stmt] = field(default_factory=list)

    @property
    def robot_line(self) -> int:
        """The line that creates the robot, or 0."""
        return 0 if self.creating is None else self.creating.lineno


def skeleton_of(tree: ast.Module) -> Skeleton | None:
    """The parts of a file, or None if it creates a robot of LearnBlock's in another way."""
    skeleton = _with_robot(tree)
    if skeleton is not None:
        return skeleton
    nodes = list(ast.walk(tree))
    if any(map(_imports_learnblock, nodes)):
        return None
    return Skeleton(robot=None if _names_robot(nodes) else "robot", rest=list(tree.body))


def _with_robot(tree: ast.Module) -> Skeleton | None:
    importing: ast.ImportFrom | None = None
    head: list[ast.stmt] = []
    for index, statement in enumerate(tree.body):
        match statement:
            case ast.ImportFrom() if imports_robot(statement):
                if importing is not None:
                    return None
                importing = statement
            case ast.Assign(
                targets=[ast.Name(id="robot")],
                value=ast.Call(func=ast.Name(id="Robot")) as creation,
            ):
                if importing is None:
                    return None
                rest = tree.body[index + 1 :]
                return Skeleton("robot", importing, statement, creation, head, rest)
            case ast.Import() | ast.ImportFrom() | ast.Expr(value=ast.Constant()):
                head.append(statement)
            case _:
                return None
    return None


def _imports_learnblock(node: ast.AST) -> bool:
    match node:
        case ast.ImportFrom(module=str(module), names=names, level=0):
            has_robot = any(alias.name == "Robot" for alias in names)
            return module.startswith(_LEARNBLOCK) or (has_robot and is_robot_module(module))
        case ast.Import(names=names):
            return any(alias.name.startswith(_LEARNBLOCK) for alias in names)
    return False


def _names_robot(nodes: list[ast.AST]) -> bool:
    """Whether a file has a robot's name for something of its own.

    One that only calls skills lacks its robot, which the check says.
    """
    owners = {id(node.value) for node in nodes if isinstance(node, ast.Attribute)}
    mentioned = {
        node.id
        for node in nodes
        if isinstance(node, ast.Name) and not (node.id == "robot" and id(node) in owners)
    }
    return not _NAMES.isdisjoint(mentioned | _imported(nodes) | set(bound_names(nodes)))


def _imported(nodes: list[ast.AST]) -> set[str]:
    """The names that a file imports, under whatever other names."""
    return {node.name for node in nodes if isinstance(node, ast.alias)}


def docstring_length(body: list[ast.stmt]) -> int:
    """How many statements at the head of a body are its docstring: one or none."""
    return int(bool(body) and is_text(body[0]))


def is_text(node: ast.AST) -> bool:
    """Whether a statement is only text, as docstrings are."""
    match node:
        case ast.Expr(value=ast.Constant(value=str())):
            return True
    return False


def leading_globals(body: list[ast.stmt]) -> list[ast.Global]:
    """The ``global`` statements at the head of a function, below its docstring."""
    below = body[docstring_length(body) :]
    return list(takewhile(lambda node: isinstance(node, ast.Global), below))  # type: ignore[arg-type]


def unusual(arguments: ast.arguments) -> bool:
    """Whether the parameters of a function are more than plain names."""
    return bool(
        arguments.posonlyargs
        or arguments.kwonlyargs
        or arguments.vararg
        or arguments.kwarg
        or arguments.defaults
        or any(argument.annotation for argument in arguments.args)
    )


def is_when(node: ast.FunctionDef) -> bool:
    """Whether a function is decorated as a ``when``."""
    match node.decorator_list:
        case [ast.Attribute(value=ast.Name(id="robot"), attr="when" | "when_start")]:
            return True
        case [
            ast.Call(
                func=ast.Attribute(value=ast.Name(id="robot"), attr="when"),
                args=[ast.Lambda(args=arguments)],
                keywords=[],
            )
        ]:
            return not (arguments.args or unusual(arguments))
    return False
