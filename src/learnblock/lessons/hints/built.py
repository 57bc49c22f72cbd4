"""Rules about how a program is built: what its text alone shows."""

from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any

from learnblock.i18n import Phrase
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.tree.flow import conditions, is_counted, is_endless
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Call,
    Def,
    If,
    Item,
    Perform,
    Program,
    SkillCall,
    String,
    When,
)
from learnblock.language.tree.traversal import bodies, statements
from learnblock.lessons.checks import Size, StaysOnLine, Uses
from learnblock.lessons.describing import uses_words
from learnblock.lessons.hints.conditions import (
    checked_once,
    impossible_condition,
    opposite_condition,
    unchanged_variable,
    wrong_side,
)
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import (
    NOTHING,
    Situation,
    asked_in,
    calls_in,
    can_leave,
    is_empty,
    parts,
    skills_in,
)
from learnblock.lessons.hints.vocabulary import (
    LASTING,
    START,
    STOPPING,
    asks_line,
    sensors,
)
from learnblock.lessons.judging import Verdict
from learnblock.lessons.structure import count

#: The fewest statements that are worth a loop when they come again.
_LEAST_REPEATED = 2
#: Of each body so many statements are compared with each other.
_MOST_COMPARED = 60
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
            if is_endless(node) and not can_leave(node.body):
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
        if when.condition is None and name != START and name not in started:
            about = frozenset({name, "when"})
            lines = (when.span.line,)
            yield Guess("never-started", lines, about, {"name": name}, "never_runs")


def message_name(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """The program waits for a message that no robot of the step sends."""
    partners = situation.step.partners
    received = _messages(situation, {"received", "message_value"})
    messages = {*_messages(situation, {"send"}), *_sent_in_run(situation)}
    if not partners or not messages:
        return
    for name, line in received.items():
        if name not in messages and _was_asked(situation, name):
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
    uses = count(situation.program, check)
    about = frozenset(filter(None, (check.construct, check.skill, check.function)))
    if check.at_most is not None and uses > check.at_most:
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
