"""The teacher's own rules: tried in their order, before ours."""

import re
from collections.abc import Callable, Iterator, Sequence

from learnblock.i18n import Phrase
from learnblock.language.tree.flow import is_endless
from learnblock.language.tree.nodes import Def, SkillCall, When
from learnblock.lessons.checks import Check
from learnblock.lessons.hints.guess import Guess, Hint
from learnblock.lessons.hints.situation import Situation, calls_in
from learnblock.lessons.hints.vocabulary import questions
from learnblock.lessons.lesson import HintRule


def teachers(situation: Situation, guesses: Sequence[tuple[int, Guess]]) -> Iterator[Hint]:
    """The hints of the step's own rules whose check fails and whose sign is seen.

    Args:
        situation: the program and its run.
        guesses: what our rules have found, each with the place of its check.
    """
    for number, rule in enumerate(situation.step.hint, 1):
        for verdict in situation.failed:
            if not _is_meant(rule, verdict.check):
                continue
            own = [guess for check, guess in guesses if check == verdict.index]
            if (lines := _seen(rule, situation, own)) is not None:
                because = Phrase(
                    "hint-teacher-because",
                    number=str(number),
                    sign=Phrase(f"hint-sign-{(rule.sign or 'none').replace('_', '-')}"),
                )
                yield Hint(f"teacher-{number}", rule.say, because, lines, verdict.index)
                break


def kind_of(check: Check) -> str:
    """The kind of a check, as lessons write it."""
    return str(check.__struct_config__.tag)


def _is_meant(rule: HintRule, check: Check) -> bool:
    return rule.check is None or rule.check in {check.name, kind_of(check)}


def _seen(rule: HintRule, situation: Situation, guesses: Sequence[Guess]) -> tuple[int, ...] | None:
    """The lines in which a rule's sign is seen; None if it is not seen."""
    if rule.sign is None:
        is_about = rule.about is None or rule.about in _names(situation)
        return _lines(situation, rule.about) if is_about else None
    if rule.sign in _DIRECT and (lines := _DIRECT[rule.sign](situation, rule.about)) is not None:
        return lines
    for guess in guesses:
        if guess.sign == rule.sign and (rule.about is None or rule.about in guess.about):
            return guess.lines
    return None


def _names(situation: Situation) -> set[str]:
    """Skills, functions and constructs of the program, for rules about one of them."""
    names: set[str] = set(situation.skills)
    for node in situation.statements:
        names.add(type(node).__name__.lower())
        if isinstance(node, Def | When):
            names.add(node.name)
    if situation.loops:
        names.add("loop")
    if any(is_endless(loop) for loop in situation.loops):
        names.add("forever")
    return names


def _lines(situation: Situation, about: str | None) -> tuple[int, ...]:
    """The lines that call a skill."""
    return tuple(
        node.span.line
        for node in situation.statements
        for call in calls_in(node, SkillCall)
        if about is not None and call.name == about
    )[:3]


def _never_asks(situation: Situation, about: str | None) -> tuple[int, ...] | None:
    skills = {call.skill for call in situation.calls} & questions()
    if about is not None:
        return _lines(situation, about) if about not in skills else None
    return () if situation.evidence is not None and not skills else None


def _never_runs(situation: Situation, about: str | None) -> tuple[int, ...] | None:
    if about is None or situation.evidence is None:
        return None
    if any(call.skill == about for call in situation.calls):
        return None
    lines = [
        node.span.line
        for node in situation.statements
        if any(call.name == about for call in calls_in(node, SkillCall))
        or (
            isinstance(node, Def | When)
            and node.name == about
            and not situation.body_ran(node.body)
        )
    ]
    return tuple(lines[:3]) or None


def _no_loop(situation: Situation, about: str | None) -> tuple[int, ...] | None:
    del about
    # What is inside an event runs again and again, too.
    has_event = any(isinstance(node, When) for node in situation.statements)
    return None if situation.loops or has_event else ()


def _collision(situation: Situation, about: str | None) -> tuple[int, ...] | None:
    hit = situation.evidence.collisions if situation.evidence else ()
    return () if any(about in {None, collision.text} for collision in hit) else None


def _error(situation: Situation, about: str | None) -> tuple[int, ...] | None:
    report = situation.evidence.report if situation.evidence else None
    if report is None or report.error is None:
        return None
    words = re.findall(r"\w+", str(report.error.get("text", "")))
    return () if about is None or about in words else None


#: Signs that the program or its run shows without our rules.
_DIRECT: dict[str, Callable[[Situation, str | None], tuple[int, ...] | None]] = {
    "never_asks": _never_asks,
    "never_runs": _never_runs,
    "no_loop": _no_loop,
    "collision": _collision,
    "error": _error,
}
