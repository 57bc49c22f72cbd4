"""Rules about which statements ran, and for how long their commands lasted."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from learnblock.i18n import Phrase, Value
from learnblock.language.tree.flow import condition_of, is_endless, is_loop, is_waiting
from learnblock.language.tree.nodes import (
    Body,
    Break,
    If,
    Return,
    When,
)
from learnblock.lessons.checks import (
    Collided,
    Ends,
    EndsAt,
    Happens,
    InOrder,
    Never,
    Reaches,
    Shown,
)
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import (
    CallRun,
    Situation,
    asked_in,
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
    faces,
    questions,
    sensors,
)
from learnblock.lessons.judging import Verdict

#: Commands that are this close in time follow each other at once, seconds.
_AT_ONCE = 0.011
#: So often a condition is asked that ought to become true some time.
_OFTEN = 2


def no_wait(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """A command is replaced by the next one before any time has passed."""
    wheels = [call for call in situation.calls if call.skill in DRIVING | STOPPING]
    for first, then in _replaced(wheels, LASTING, situation):
        lines = (first.line, then.line) if then else (first.line,)
        yield Guess("no-wait", lines, frozenset({first.skill}), {}, "loop_without_wait")
    face_calls = [call for call in situation.calls if call.skill in faces()]
    surely = 0 if _is_about_faces(verdict) else -40
    for first, then in _replaced(face_calls, faces(), situation):
        if then:
            about, lines = frozenset({first.skill}), (first.line, then.line)
            yield Guess("no-wait", lines, about, {}, "loop_without_wait", surely)


def _replaced(
    calls: list[CallRun], lasting: frozenset[str], situation: Situation
) -> Iterator[tuple[CallRun, CallRun | None]]:
    """Commands of a line that never had any effect, each with what replaced it."""
    effective: defaultdict[int, bool] = defaultdict(bool)
    replaced: dict[int, tuple[CallRun, CallRun | None]] = {}
    for index, call in enumerate(calls):
        if call.skill not in lasting or _is_still(call):
            continue
        then = calls[index + 1] if index + 1 < len(calls) else None
        if then is None and situation.ended != "finished":
            effective[call.line] = True
            continue
        until = then.time if then else situation.end
        if until - call.time > _AT_ONCE or (then and then.line == call.line):
            effective[call.line] = True
        else:
            replaced.setdefault(call.line, (call, then))
    for line, pair in replaced.items():
        if line and not effective[line]:
            yield pair


def _is_still(call: CallRun) -> bool:
    """Whether a movement is none."""
    numbers = [number for number in call.arguments if isinstance(number, int | float)]
    return bool(numbers) and not any(numbers)


def _is_about_faces(verdict: Verdict) -> bool:
    match verdict.check:
        case Happens(what=Shown()):
            return True
        case InOrder(events=events):
            return any(isinstance(event, Shown) for event in events)
        case Reaches():
            return True
    return False


def never_runs(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A branch, a loop, a `when` or a function was there for something, and never ran."""
    if situation.evidence is None:
        return
    for node in situation.statements:
        if isinstance(node, If) and situation.ran(node):
            yield from _branches(situation, node)
        elif is_loop(node) and situation.ran(node) and not is_empty(node.body):
            if not situation.body_ran(node.body):
                yield _never(situation, node, node.body, condition_of(node), "loop")
        elif isinstance(node, When) and _waits_in_vain(situation, node):
            yield _never(situation, node, node.body, node.condition, "when", node.name)


def _waits_in_vain(situation: Situation, node: When) -> bool:
    """Whether a `when` has a condition and did not run."""
    is_meant = node.condition is not None and not is_empty(node.body)
    return is_meant and not situation.body_ran(node.body)


def _branches(situation: Situation, node: If) -> Iterator[Guess]:
    for part in parts(node):
        if situation.body_ran(part.body) or is_empty(part.body):
            continue
        condition = condition_of(part)
        yield _never(situation, part, part.body, condition, "if" if condition else "else")


def _never(situation: Situation, node: Any, body: Any, condition: Any, *about: str) -> Guess:
    skills = {call.name for call in asked_in(condition)} if condition is not None else set()
    names = frozenset({*about, *skills, *(call.name for call in skills_in(body))})
    times = situation.times_run[node.span.line]
    # What was asked for more than once had its chance.
    surely = 0 if skills & sensors() and times > _OFTEN else -5
    lines = (node.span.line,)
    if condition is None and is_loop(node):
        surely = -10
    return Guess("never-runs", lines, names, {}, "never_runs", surely)


def passing_wait(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A loop or a wait until something happens is over as soon as it begins."""
    if situation.evidence is None:
        return
    for node in situation.statements:
        condition = condition_of(node)
        if condition is None or is_endless(node) or not situation.ran(node):
            continue
        skills = {call.name for call in asked_in(condition)}
        if is_loop(node):
            if skills & questions() and not situation.body_ran(node.body):
                about = frozenset({"loop", *skills})
                yield Guess("opposite-condition", (node.span.line,), about, surely=2)
        elif is_waiting(node) and skills & sensors() and _asked_once(situation, skills):
            about = frozenset({"wait", *skills})
            # It is also why the command before it has no time.
            yield Guess("opposite-condition", (node.span.line,), about, surely=15)


def _asked_once(situation: Situation, skills: set[str]) -> bool:
    times = sum(call.skill in skills for call in situation.calls)
    return times <= len(skills)


def never_asks(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """A robot that bumps into things, or misses its goal elsewhere, asks no sensor."""
    if situation.evidence is None or _is_decided_by_text(verdict):
        return
    skills = {call.skill for call in situation.calls} & sensors()
    offered = _offered(situation)
    bumped = _has_bumped(situation, verdict)
    if bumped and not skills & OBSTACLES:
        values = {"what": Phrase("hint-a-distance-sensor")}
        # A step without sensors may ask for numbers that are right.
        surely = 10 if offered & OBSTACLES else 0 if situation.step.variants else -10
        yield Guess("never-asks", _moving(situation), OBSTACLES, values, "never_asks", surely)
    elif not skills and offered:
        what = Phrase("hint-a-sensor")
        yield Guess("never-asks", (), offered, {"what": what}, "never_asks")


def _moving(situation: Situation) -> tuple[int, ...]:
    calls = [call for call in situation.calls if call.skill in DRIVING and call.line]
    if not calls:
        return ()
    hit = situation.evidence.collisions if situation.evidence else ()
    until = hit[0].moment.time if hit else situation.end
    before = [call for call in calls if call.time <= until]
    return (before[-1].line,) if before else ()


def _offered(situation: Situation) -> frozenset[str]:
    """The sensors among the blocks that a step shows."""
    blocks = situation.step.blocks
    if not isinstance(blocks, tuple):
        return frozenset()
    return frozenset(block.removeprefix("function.") for block in blocks) & sensors()


def _has_bumped(situation: Situation, verdict: Verdict) -> bool:
    if isinstance(verdict.check, Never) and isinstance(verdict.check.what, Collided):
        return True
    return bool(situation.evidence and situation.evidence.collisions) and isinstance(
        verdict.check, Reaches
    )


def _is_decided_by_text(verdict: Verdict) -> bool:
    return verdict.at is None


def collision(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot bumped into something: what drove it there."""
    if situation.evidence is None or not situation.evidence.collisions:
        return
    if not _has_bumped(situation, verdict):
        return
    hit = situation.evidence.collisions[0]
    about = frozenset({hit.text})
    values: Mapping[str, Value] = {"thing": hit.text, "time": round(hit.moment.time, 1)}
    asks = any(call.skill in OBSTACLES for call in situation.calls)
    yield Guess("collision", _moving(situation), about, values, "collision", 3 if asks else 0)


def motors_on(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot drives on after its task, as nothing stops it."""
    wheels = [call for call in situation.calls if call.skill in DRIVING | STOPPING]
    if not wheels or wheels[-1].skill not in LASTING or _is_still(wheels[-1]):
        return
    last = wheels[-1]
    is_looping = any(_in_endless(loop, last.line) for loop in situation.loops)
    if situation.program.whens.keys() - {"start"} or is_looping:
        return
    if situation.end - last.time > 1 and not isinstance(verdict.check, Happens):
        # One that looks at nothing bumps into things because of that.
        blind = not {call.skill for call in situation.calls} & sensors()
        surely = -15 if blind and situation.evidence and situation.evidence.collisions else 0
        yield Guess("motors-on", (last.line,), frozenset({last.skill}), {}, "too_late", surely)


def _in_endless(loop: Any, line: int) -> bool:
    inside = loop.span.line <= line <= loop.span.end_line
    return is_endless(loop) and inside


def stop_missing(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot ends a loop with a sensor, and then nothing stops it while the program goes on."""
    if not situation.skills & LASTING or situation.skills & STOPPING or not _wants_stop(verdict):
        return
    for node in situation.statements:
        if is_endless(node) and not _leaves(node.body):
            calls = [call for call in skills_in(node.body) if call.name in DRIVING]
            if calls and all(call.name == "move_straight" for call in calls):
                line = first_line(node.body)
                yield Guess("motors-on", (line,), frozenset({"move_straight"}), {}, "too_late", -10)


def _leaves(body: Body) -> bool:
    return any(isinstance(node, Break | Return) for node in body)


def _wants_stop(verdict: Verdict) -> bool:
    return isinstance(verdict.check, EndsAt | Reaches | Never | Ends)


def unused_function(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """A function is called somewhere, and that place was never reached."""
    if situation.evidence is None:
        return
    for function in situation.program.functions.values():
        if is_empty(function.body) or situation.body_ran(function.body):
            continue
        about = frozenset({function.name, "function"})
        yield Guess("never-runs", (function.span.line,), about, {}, "never_runs", -8)


RULES: tuple[Callable[[Situation, Verdict], Iterator[Guess]], ...] = (
    no_wait,
    never_runs,
    passing_wait,
    never_asks,
    collision,
    motors_on,
    stop_missing,
    unused_function,
)
