"""Recognize the parts of a Python file that creates a robot like generated programs."""

import ast
from dataclasses import dataclass, field


@dataclass(slots=True)
class Skeleton:
    """The statements of a file, split at the import and creation of the robot.

    Args:
        importing: the statement that imports ``Robot``.
        creating: the statement ``robot = Robot(...)``.
        head: the other statements before `creating`.
        rest: the statements after it.
    """

    importing: ast.ImportFrom
    creating: ast.Assign
    creation: ast.Call
    head: list[ast.stmt] = field(default_factory=list)
    rest: list[ast.stmt] = field(default_factory=list)


def skeleton_of(tree: ast.Module) -> Skeleton | None:
    """The parts of a file, or None if it does not create a robot in this way."""
    importing: ast.ImportFrom | None = None
    head: list[ast.stmt] = []
    for index, statement in enumerate(tree.body):
        match statement:
            case ast.ImportFrom(names=[ast.alias(name="Robot", asname=None)], level=0):
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
                return Skeleton(importing, statement, creation, head, rest)
            case ast.Import() | ast.ImportFrom() | ast.Expr(value=ast.Constant()):
                head.append(statement)
            case _:
                return None
    return None


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
