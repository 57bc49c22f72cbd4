"""Rules about the conditions of a program: asked once, about the wrong side, never true."""

from collections.abc import Iterator
from typing import Any

from learnblock.language.tree.flow import condition_of, conditions, is_endless, is_loop
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Body,
    Call,
    Compare,
    Expression,
    If,
    Name,
    Number,
    SkillCall,
    Unary,
)
from learnblock.language.tree.traversal import bodies, statements, within
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import (
    Situation,
    asked_in,
    calls_in,
    can_leave,
    first_line,
    skills_in,
)
from learnblock.lessons.hints.vocabulary import (
    DRIVING,
    OBSTACLES,
    START,
    STOPPING,
    sensors,
    side,
)
from learnblock.lessons.judging import Verdict


def checked_once(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """An `if` asks a sensor once: it is in no loop, nor in a `when` that runs again and again."""
    if situation.program.whens.keys() - {START}:
        return
    main = situation.program.main.body if situation.program.main else ()
    starts = [when.body for when in situation.program.whens.values()]
    for node in (
        *situation.program.items,
        *main,
        *(statement for body in starts for statement in body),
    ):
        if isinstance(node, If):
            skills = {call.name for branch in node.branches for call in asked_in(branch.condition)}
            if skills & sensors():
                about = frozenset(skills | {"if"})
                yield Guess("checked-once", (node.span.line,), about, sign="no_loop")


def unchanged_variable(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The condition of a loop asks for variables that nothing in the loop changes."""
    for loop in situation.loops:
        condition = condition_of(loop)
        if condition is None or is_endless(loop) or can_leave(loop.body):
            continue
        inner = list(within(condition))
        names = {part.name for part in inner if isinstance(part, Name)}
        asks = any(isinstance(part, SkillCall | Call) for part in inner)
        if names and not asks and not _is_state(names) and not _sets(situation, loop.body, names):
            name = min(names)
            about = frozenset({*names, "variable"})
            surely = 5 if situation.body_ran(loop.body) else 0
            yield Guess(
                "unchanged-variable",
                (loop.span.line,),
                about,
                {"name": name},
                "too_late",
                surely,
            )


def _is_state(names: set[str]) -> bool:
    """Whether a name is that of a `when`, which changes by itself."""
    return any(name.startswith(("state_", "time_")) for name in names)


def _sets(situation: Situation, body: Body, names: set[str]) -> bool:
    functions = situation.program.functions
    for node in statements(body):
        if isinstance(node, Assign) and any(
            isinstance(part, Name) and part.name in names for part in within(node.target)
        ):
            return True
        for call in calls_in(node, Call):
            if call.name not in functions:
                # Such as `append`, which changes a list.
                if any(
                    isinstance(argument, Name) and argument.name in names
                    for argument in call.arguments
                ):
                    return True
            elif any(
                isinstance(statement, Assign) for statement in statements(functions[call.name].body)
            ):
                return True
    return False


def wrong_side(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A sensor on one side is answered by a movement to the wrong side."""
    for node in situation.statements:
        for condition, body in _reactions(node):
            skills = [call.name for call in asked_in(condition) if side(call.name)]
            turned = {_direction(call) for call in skills_in(body)} - {""}
            if len(skills) != 1 or len(turned) != 1 or _is_negated(condition):
                continue
            away = skills[0] in OBSTACLES
            if (side(skills[0]) == turned.pop()) == away:
                line = first_line(body)
                about = frozenset({skills[0]})
                yield Guess("wrong-side", (line,), about, sign="wrong_sign")


def _reactions(node: Any) -> Iterator[tuple[Expression, Body]]:
    if isinstance(node, If):
        yield from ((branch.condition, branch.body) for branch in node.branches)
        return
    condition = condition_of(node)
    if condition is not None:
        yield from ((condition, body) for body in bodies(node))


def _is_negated(condition: Expression) -> bool:
    return any(isinstance(part, Unary) and part.operator == "not" for part in within(condition))


def _direction(call: SkillCall) -> str:
    """The side to which a skill turns the robot; "" for none or an unknown one."""
    numbers = [number_of(argument) for argument in call.arguments]
    if call.name in {"turn", "set_orientation"}:
        return _by_sign(numbers[0]) if numbers else ""
    if call.name in {"set_move", "drive_arc"}:
        return _by_sign(numbers[1]) if len(numbers) > 1 else ""
    if call.name not in DRIVING or not side(call.name):
        return ""
    place = {"move_left": 1, "move_right": 1, "turn_left": 0, "turn_right": 0}.get(call.name)
    if place is not None and len(numbers) > place:
        return _by_sign(numbers[place])
    return side(call.name)


def _by_sign(number: float | None) -> str:
    if not number:
        return ""
    return "right" if number > 0 else "left"


def number_of(node: Expression) -> float | None:
    """The number that an expression is; None if it is not a plain number."""
    match node:
        case Number(text=text):
            try:
                return float(int(text, 0)) if text.lower().startswith("0x") else float(text)
            except ValueError:
                return None
        case Unary(operator="-", operand=Number() as number):
            value = number_of(number)
            return None if value is None else -value
    return None


def opposite_condition(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The robot drives on where it sees an obstacle, and gives way where there is none."""
    for node in situation.statements:
        if isinstance(node, If) and len(node.branches) == 1 and node.otherwise is not None:
            branch, other = node.branches[0], node.otherwise
            ahead = _sees_obstacle(branch.condition)
            if ahead is None:
                continue
            seeing, free = (branch, other) if ahead else (other, branch)
            if _drives_on(seeing.body) and _gives_way(free.body):
                lines = (node.branches[0].span.line,)
                yield Guess("opposite-condition", lines, frozenset({"if"}), surely=10)
        elif is_loop(node) and _sees_obstacle(condition_of(node)) and _drives_on(node.body):
            about = frozenset({"loop"})
            yield Guess("opposite-condition", (node.span.line,), about, surely=10)


def _sees_obstacle(condition: Expression | None) -> bool | None:
    """Whether a condition holds in front of an obstacle; None if it asks something else."""
    match condition:
        case Unary(operator="not", operand=inner):
            sees = _sees_obstacle(inner)
            return None if sees is None else not sees
        case SkillCall(name="is_obstacle_free"):
            return False
        case SkillCall(name="is_front_obstacle" | "is_bumped"):
            return True
        case Compare(operators=(operator,), operands=(SkillCall(name="get_min_distance"), _)):
            return operator in {"<", "<="}
    return None


def _drives_on(body: Body) -> bool:
    """Whether a body drives straight ahead, and does nothing else with the wheels."""
    calls = [call for call in skills_in(body) if call.name in DRIVING | STOPPING]
    return bool(calls) and all(_is_ahead(call) for call in calls)


def _is_ahead(call: SkillCall) -> bool:
    first = number_of(call.arguments[0]) if call.arguments else 1.0
    if call.name in {"move_straight", "drive_distance"}:
        return first is None or first > 0
    return (
        call.name == "set_move"
        and (first or 0) > 0
        and len(call.arguments) > 1
        and number_of(call.arguments[1]) == 0
    )


def _gives_way(body: Body) -> bool:
    calls = [call for call in skills_in(body) if call.name in DRIVING | STOPPING]
    return bool(calls) and not any(_is_ahead(call) for call in calls)


def impossible_condition(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """Two comparisons of one value can never both hold, or one of them always does."""
    for node in situation.statements:
        for condition in conditions(node):
            for part in within(condition):
                if isinstance(part, Binary) and part.operator in {"and", "or"} and _clash(part):
                    line = getattr(part.span, "line", 0) or node.span.line
                    values = {"joined": part.operator}
                    about = frozenset({"if", part.operator})
                    yield Guess("impossible-condition", (line,), about, values, "never_runs")


def _clash(node: Binary) -> bool:
    """Whether ``x < 3 and x > 5``, or ``x < 5 or x > 3``."""
    limits = [_limit(node.left), _limit(node.right)]
    first, second = limits
    if first is None or second is None or first[0] != second[0]:
        return False
    below = next((limit for limit in (first, second) if limit[1] in {"<", "<="}), None)
    above = next((limit for limit in (first, second) if limit[1] in {">", ">="}), None)
    if below is None or above is None:
        both_equal = first[1] == second[1]
        unequal = first[2] != second[2]
        is_never = both_equal and first[1] == "==" and node.operator == "and"
        is_always = both_equal and first[1] == "!=" and node.operator == "or"
        return unequal and (is_never or is_always)
    return below[2] <= above[2] if node.operator == "and" else below[2] >= above[2]


def _limit(node: Expression) -> tuple[Expression, str, float] | None:
    if not isinstance(node, Compare) or len(node.operators) != 1:
        return None
    left, right = node.operands
    turned = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
    operator, number = node.operators[0], number_of(right)
    if number is None:
        left, number, operator = right, number_of(left), turned.get(operator, operator)
    return None if number is None else (left, operator, number)
