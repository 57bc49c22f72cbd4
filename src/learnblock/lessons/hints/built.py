"""Rules about how a program is built: what its text alone shows."""

from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any

from learnblock.i18n import Phrase
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.tree.flow import condition_of, conditions, is_counted, is_endless, is_loop
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Binary,
    Body,
    Break,
    Call,
    Compare,
    Def,
    Expression,
    If,
    Item,
    Name,
    Number,
    Perform,
    Program,
    Return,
    SkillCall,
    String,
    Unary,
    When,
)
from learnblock.language.tree.traversal import bodies, statements, within
from learnblock.lessons.checks import Size, StaysOnLine, Uses
from learnblock.lessons.describing import uses_words
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import (
    NOTHING,
    Situation,
    asked_in,
    calls_in,
    first_line,
    is_empty,
    parts,
    skills_in,
)
from learnblock.lessons.hints.vocabulary import (
    DRIVING,
    LASTING,
    OBSTACLES,
    STOPPING,
    asks_line,
    sensors,
    side,
)
from learnblock.lessons.judging import Verdict
from learnblock.lessons.structure import count

#: The fewest statements that are worth a loop when they come again.
_LEAST_REPEATED = 2
#: Of each body so many statements are compared with each other.
_MOST_COMPARED = 60
_START = "start"
_LOOP_CONSTRUCTS = frozenset(("loop", "repeat", "forever"))


def empty(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The program does nothing at all."""
    if not any(isinstance(node, Perform | Assign | Activate) for node in situation.statements):
        yield Guess("empty", sign="empty")


def empty_body(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A loop, a branch or a function has nothing in it."""
    for node in situation.statements:
        if isinstance(node, If):
            empty_parts = [part for part in parts(node) if is_empty(part.body)]
            for part in empty_parts:
                yield Guess("empty-body", (part.span.line,), frozenset({"if"}), sign="empty")
        elif isinstance(node, Def | When) and is_empty(node.body):
            yield Guess("empty-body", (node.span.line,), frozenset({node.name}), sign="empty")
        elif is_counted(node) and is_empty(node.body):
            yield Guess("empty-body", (node.span.line,), frozenset({"loop"}), sign="empty")


def unreachable(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """Statements come after a loop that never ends."""
    for body in _bodies(situation.program):
        endless: Item | None = None
        for node in body:
            if is_endless(node) and not _can_leave(node.body):
                endless = node
            elif endless and not isinstance(node, (*NOTHING, Def, When)):
                lines = (endless.span.line, node.span.line)
                yield Guess("unreachable", lines, frozenset({"forever"}), sign="never_runs")
                break


def _bodies(program: Program) -> Iterator[tuple[Item, ...]]:
    main = program.main.body if program.main else ()
    yield (*program.items, *main)
    for node in statements((*program.items, *main)):
        yield from bodies(node)


def _can_leave(body: Body) -> bool:
    return any(isinstance(node, Break | Return) for node in statements(body))


def not_called(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A function is defined and never called."""
    called = {call.name for node in situation.statements for call in calls_in(node, Call)}
    for name, function in situation.program.functions.items():
        if name not in called:
            lines = (function.span.line,)
            about = frozenset({name, "function"})
            yield Guess("not-called", lines, about, {"name": name}, "never_runs")


def never_started(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A `when` has no condition, and nothing activates it."""
    started = {node.name for node in situation.statements if isinstance(node, Activate)}
    for name, when in situation.program.whens.items():
        if when.condition is None and name != _START and name not in started:
            about = frozenset({name, "when"})
            lines = (when.span.line,)
            yield Guess("never-started", lines, about, {"name": name}, "never_runs")


def checked_once(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """An `if` asks a sensor once: it is in no loop, nor in a `when` that runs again and again."""
    if situation.program.whens.keys() - {_START}:
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
        if condition is None or is_endless(loop) or _can_leave(loop.body):
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


def message_name(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The program waits for a message that no robot of the step sends."""
    partners = situation.step.partners
    received = _messages(situation, {"received", "message_value"})
    sent = {*_messages(situation, {"send"}), *_sent_in_run(situation)}
    if not partners or not sent:
        return
    for name, line in received.items():
        if name not in sent and _was_asked(situation, name):
            about = frozenset({name, "received"})
            yield Guess("message-name", (line,), about, {"name": name}, "never_runs")


def _messages(situation: Situation, skills: set[str]) -> dict[str, int]:
    lines: dict[str, int] = {}
    for node in situation.statements:
        for call in calls_in(node, SkillCall):
            first = call.arguments[0] if call.arguments else String("go")
            if call.name in skills and isinstance(first, String):
                lines.setdefault(first.value, node.span.line)
    return lines


def _sent_in_run(situation: Situation) -> Iterator[str]:
    for line in situation.evidence.trace.steps() if situation.evidence else ():
        if isinstance(line.get("send"), str):
            yield line["send"]


def _was_asked(situation: Situation, name: str) -> bool:
    return any(
        call.skill in {"received", "message_value"} and (call.arguments or ("go",))[0] == name
        for call in situation.calls
    )


# Checks of how the program is built.


def not_used(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program lacks something that the step asks for, or has it too often."""
    check = verdict.check
    if not isinstance(check, Uses):
        return
    values: dict[str, Any] = {"what": uses_words(check)}
    used = count(situation.program, check)
    about = frozenset(filter(None, (check.construct, check.skill, check.function)))
    if check.at_most is not None and used > check.at_most:
        lines = _where_used(situation, check)
        yield Guess("used-too-often", lines, about, values)
    elif check.construct in _LOOP_CONSTRUCTS:
        repeated = repeated_lines(situation)
        yield Guess("no-loop", repeated, about | {"loop"}, values, "no_loop")
    elif check.skill in sensors():
        yield Guess("never-asks", (), about, values, "never_asks")
    else:
        yield Guess("not-used", (), about, values, "never_runs")


def _where_used(situation: Situation, check: Uses) -> tuple[int, ...]:
    kind: type[Any] = SkillCall if check.skill else Call
    name = check.skill or check.function
    lines = [
        node.span.line
        for node in situation.statements
        for call in calls_in(node, kind)
        if call.name == name
    ]
    return tuple(dict.fromkeys(lines))[:3] if name else ()


def too_large(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program has more blocks than the step allows."""
    if isinstance(verdict.check, Size):
        lines = repeated_lines(situation)
        if lines:
            yield Guess("repetition", lines, frozenset({"loop"}), sign="no_loop")
        else:
            yield Guess("too-large", sign=None)


def repeated(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The same statements come one after the other, and the program has no loop."""
    if not situation.loops and (lines := repeated_lines(situation)):
        yield Guess("no-loop", lines, frozenset({"loop"}), {"what": _A_LOOP}, "no_loop", -40)


_A_LOOP = Phrase("hint-a-loop")


def repeated_lines(situation: Situation) -> tuple[int, ...]:
    """The first lines of equal runs of statements that follow each other."""
    for body in _bodies(situation.program):
        acting = (node for node in body if not isinstance(node, (*NOTHING, Def, When)))
        plain = list(islice(acting, _MOST_COMPARED))
        texts = [format_program(Program((node,))) for node in plain]
        for length in range(len(plain) // 2, 0, -1):
            for start in range(len(plain) - 2 * length + 1):
                again = texts[start : start + length]
                is_worth = length >= _LEAST_REPEATED or again == texts[start + 2 : start + 3]
                if again == texts[start + length : start + 2 * length] and is_worth:
                    return plain[start].span.line, plain[start + length].span.line
    return ()


def missing_sensor(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program asks no sensor at all, or none that sees lines where it should follow one."""
    skills = situation.skills & sensors()
    if isinstance(verdict.check, StaysOnLine) and not any(map(asks_line, skills)):
        values = {"what": Phrase("hint-a-line-sensor")}
        yield Guess("never-asks", (), frozenset({"line"}), values, "never_asks", 20)


def waitless_loop(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A loop drives, and no time passes in it."""
    for loop in situation.loops:
        drives = [call for call in skills_in(loop.body) if call.name in LASTING | STOPPING]
        calls = (call for condition in conditions(loop) for call in asked_in(condition))
        asks = any(call.name in sensors() for call in (*skills_in(loop.body), *calls))
        if drives and not asks and not situation.waits(loop.body):
            about = frozenset({"loop", type(loop).__name__.lower()})
            yield Guess("loop-without-wait", (loop.span.line,), about, sign="loop_without_wait")


RULES: tuple[Callable[[Situation, Verdict], Iterator[Guess]], ...] = (
    empty,
    empty_body,
    unreachable,
    not_called,
    never_started,
    checked_once,
    unchanged_variable,
    wrong_side,
    opposite_condition,
    impossible_condition,
    message_name,
    not_used,
    too_large,
    repeated,
    missing_sensor,
    waitless_loop,
)
