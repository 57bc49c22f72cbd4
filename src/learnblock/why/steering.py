"""What a call of a skill makes the robot's wheels do, by its name and its numbers."""

import ast
from typing import Any

from learnblock.runtime.log.nodes import Node
from learnblock.why.wording import (
    BACK,
    CURVE_LEFT,
    CURVE_RIGHT,
    FORWARD,
    SPIN_LEFT,
    SPIN_RIGHT,
    STAND,
    movement,
)

#: The effect of skills on the wheels; for the others their arguments decide.
_FIXED = {
    "move_straight": FORWARD,
    "move_left": CURVE_LEFT,
    "move_right": CURVE_RIGHT,
    "turn_left": SPIN_LEFT,
    "turn_right": SPIN_RIGHT,
    "stop_bot": STAND,
    "turn_90_left": SPIN_LEFT,
    "turn_90_right": SPIN_RIGHT,
    "turn_back": SPIN_RIGHT,
    "drive_distance": FORWARD,
    "go_to": FORWARD,
    "slow_down": STAND,
}


def may_do(node: Node, name: str) -> bool:
    """Whether a call could cause a movement, given by its name."""
    if _turns_either_way(node):
        return not name or name.startswith("spin")
    movement_name = movement_of(node)
    if not name:
        return movement_name is not None and "-" in movement_name
    if movement_name is None:
        return False
    return name in (movement_name, movement_name.replace("curve", "spin"))


def _turns_either_way(node: Node) -> bool:
    """Whether only a value decides the side to which a call turns the robot."""
    is_unknown = node.name == "turn" and not _numbers(node.text) and "(" in node.text
    return node.name == "set_orientation" or (is_unknown and not node.text.endswith("()"))


def movement_of(node: Node) -> str | None:
    """What a call makes the robot do, by its name and the numbers in it; None if unknown."""
    numbers = _numbers(node.text)
    if node.name == "set_move":
        return movement(*numbers[:2]) if len(numbers) > 1 else FORWARD
    if node.name == "turn":
        return SPIN_LEFT if numbers and numbers[0] < 0 else SPIN_RIGHT
    if node.name == "drive_arc":
        return CURVE_LEFT if len(numbers) > 1 and numbers[1] < 0 else CURVE_RIGHT
    if node.name in ("move_straight", "drive_distance") and numbers and numbers[0] < 0:
        return BACK
    return _FIXED.get(node.name)


def written_values(text: str) -> list[Any]:
    """The arguments of a call as written: plain values, and other expressions as text."""
    try:
        call = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError):
        return []
    return [_written(argument) for argument in call.args] if isinstance(call, ast.Call) else []


def _written(argument: ast.expr) -> Any:
    try:
        return ast.literal_eval(argument)
    except ValueError:
        return ast.unparse(argument)


def _numbers(text: str) -> list[float]:
    """The arguments of a call that are plain numbers, up to the first that is not."""
    try:
        call = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError):
        return []
    numbers: list[float] = []
    for argument in call.args if isinstance(call, ast.Call) else ():
        try:
            value = ast.literal_eval(argument)
        except ValueError:
            return numbers
        if not isinstance(value, int | float):
            return numbers
        numbers.append(float(value))
    return numbers
