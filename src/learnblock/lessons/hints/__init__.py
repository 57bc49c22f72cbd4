"""Hints for a program that fails checks: rules that look at its text and at its run.

Every rule is a function that looks at a `Situation` and yields guesses; `ranking` has the order.
Nothing is random, and nothing leaves the computer.
"""

from collections.abc import Sequence

from learnblock.evidence.evidence import Evidence
from learnblock.language.tree.nodes import Program
from learnblock.lessons.hints import built, driven, outcomes, ran
from learnblock.lessons.hints.guess import Hint
from learnblock.lessons.hints.ranking import ranked
from learnblock.lessons.hints.secrets import gives_away
from learnblock.lessons.hints.situation import Elsewhere, Situation
from learnblock.lessons.hints.teaching import teachers
from learnblock.lessons.judging import Verdict
from learnblock.lessons.lesson import Step
from learnblock.simulator import WorldDescription

__all__ = ["Elsewhere", "Hint", "gives_away", "hints"]

_RULES = (*built.RULES, *ran.RULES, *driven.RULES, *outcomes.RULES)
_NOWHERE_ELSE = Elsewhere()


def hints(
    step: Step,
    program: Program,
    verdicts: Sequence[Verdict],
    evidence: Evidence | None,
    *,
    world: WorldDescription | None = None,
    elsewhere: Elsewhere = _NOWHERE_ELSE,
) -> tuple[Hint, ...]:
    """Hints for a program that fails checks of a step, the best first.

    The teacher's rules come before ours. The same program and run always get the same hints.

    Args:
        step: the step.
        program: the program.
        verdicts: what its checks say.
        evidence: what is known of the run; None if there was none.
        world: the world; without it, nothing is known of the places of its goals.
        elsewhere: how the program did in other attempts.
    """
    situation = Situation(step, program, verdicts, evidence, world, elsewhere)
    guesses = [
        (verdict.index, guess)
        for verdict in situation.failed
        for rule in _RULES
        for guess in rule(situation, verdict)
    ]
    best = ranked(guesses)
    return (
        *teachers(situation, guesses),
        *(guess.hint(check) for check, guess in best),
    )
