"""What a rule finds, and the hint that is made of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from learnblock.i18n import Phrase, Value
from learnblock.lessons.lesson import Sign
from learnblock.lessons.texts import Title


@dataclass(frozen=True)
class Hint:
    """A hint for a program that fails a check.

    Args:
        rule: its rule, such as ``hint-wrong-sign``; of the teacher's rules ``teacher-1``.
        levels: up to three: what to look at, which part, how in general. They are shown one after
            the other, and none of them is a statement of a solution.
        because: why this hint was chosen, for the teacher.
        lines: the lines of the pupil's program that it is about, from 1.
        check: the place of the failing check among those of the step, from 0.
    """

    rule: str
    levels: tuple[Phrase | Title, ...]
    because: Phrase
    lines: tuple[int, ...] = ()
    check: int = 0


@dataclass(frozen=True)
class Guess:
    """What may be wrong.

    Args:
        rule: the rule, such as ``wrong-sign``.
        lines: the lines of the program that it is about.
        about: skills, constructs and names that it is about, for rules of teachers.
        values: for the words.
        sign: the sign of teachers' rules that it is.
        surely: what is added to the rule's weight if the run shows it beyond doubt.
    """

    rule: str
    lines: tuple[int, ...] = ()
    about: frozenset[str] = frozenset()
    values: Mapping[str, Value] = field(default_factory=dict)
    sign: Sign | None = None
    surely: int = 0

    def hint(self, check: int) -> Hint:
        """The hint, in words.

        Args:
            check: the place of the failing check.
        """
        values = {**self.values, "where": where(self.lines)}
        look = Phrase(f"hint-{self.rule}-look", **values)
        part = Phrase(f"hint-{self.rule}-part", **values)
        how = Phrase(f"hint-{self.rule}-how", **values)
        levels = (look, part, how) if self.lines else (look, how)
        because = Phrase(f"hint-{self.rule}-because", **values)
        return Hint(f"hint-{self.rule}", levels, because, self.lines, check)


def where(lines: tuple[int, ...]) -> Phrase:
    """Lines in words, such as ``line 3`` or ``lines 3, 5``."""
    if len(lines) == 1:
        return Phrase("hint-where-line", line=str(lines[0]))
    return Phrase("hint-where-lines", lines=tuple(map(str, lines)))
