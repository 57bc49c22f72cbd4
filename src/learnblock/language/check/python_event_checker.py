"""Find slips in the events of a Python program: functions below ``@robot.when``."""

import ast
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from learnblock.errors import Severity, nearest
from learnblock.i18n import Phrase

_EVENTS = ("when", "when_start")
#: Conditions that would be checked only once, when the program is read.
_CONDITIONS = (ast.Call, ast.Compare, ast.BoolOp, ast.UnaryOp)


class EventSlip(NamedTuple):
    """A slip, and the part of the program that it is in."""

    node: ast.expr
    message: Phrase
    severity: Severity = "error"


def event_slips(nodes: Iterable[ast.AST]) -> Iterator[EventSlip]:
    """Find the slips among all nodes of a program."""
    events: list[ast.expr] = []
    runs = False
    for node in nodes:
        match node:
            case ast.FunctionDef(decorator_list=decorators):
                events += filter(_is_event, decorators)
                yield from filter(None, map(_of_decorator, decorators))
            case ast.Expr(value=value) if _is_event(value):
                yield EventSlip(value, Phrase("python-event-without-at", name=_name(value)))
            case ast.Call(
                func=ast.Attribute(value=ast.Name(id="robot"), attr="wait_until"),
                args=[condition],
            ) if isinstance(condition, _CONDITIONS):
                yield EventSlip(condition, _without_lambda("wait_until", condition))
            case ast.Attribute(value=ast.Name(id="robot"), attr="run"):
                runs = True
    if events and not runs:
        yield EventSlip(events[0], Phrase("python-never-run"), "warning")


def _of_decorator(node: ast.expr) -> EventSlip | None:
    match _called(node):
        case ast.Attribute(value=ast.Name(id="robot"), attr=name) if name not in _EVENTS:
            return EventSlip(node, _unknown(name))
        case ast.Name(id=name) if name in _EVENTS:
            message = Phrase("python-event-of-robot", found=f"@{name}", name=name)
            return EventSlip(node, message)
    match node:
        case ast.Call(args=[condition]) if _is_event(node) and isinstance(condition, _CONDITIONS):
            return EventSlip(condition, _without_lambda("when", condition))
    return None


def _without_lambda(method: str, condition: ast.expr) -> Phrase:
    code = "python-event-without-lambda" if method == "when" else "python-wait-without-lambda"
    return Phrase(code, condition=ast.unparse(condition))


def _unknown(name: str) -> Phrase:
    near = nearest(name, _EVENTS)
    if near is None:
        return Phrase("python-unknown-event", found=f"@robot.{name}")
    return Phrase("python-unknown-event-near", found=f"@robot.{name}", near=near)


def _is_event(node: ast.expr) -> bool:
    match _called(node):
        case ast.Attribute(value=ast.Name(id="robot"), attr=name):
            return name in _EVENTS
    return False


def _name(node: ast.expr) -> str:
    called = _called(node)
    return called.attr if isinstance(called, ast.Attribute) else ""


def _called(node: ast.expr) -> ast.expr:
    return node.func if isinstance(node, ast.Call) else node
