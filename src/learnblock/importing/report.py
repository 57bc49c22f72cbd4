"""What an import changed, and what it could not carry over."""

from dataclasses import dataclass, field

from learnblock.i18n import Phrase


@dataclass(frozen=True)
class ImportReport:
    """What an import changed, and what it could not carry over.

    Args:
        changed: what has the same meaning in other words.
        missing: what is not in the new program, each by its name.
    """

    changed: tuple[Phrase, ...] = ()
    missing: tuple[Phrase, ...] = ()


@dataclass
class Reporting:
    """Collects the sentences of a report, each once."""

    changed: dict[Phrase, None] = field(default_factory=dict)
    missing: dict[Phrase, None] = field(default_factory=dict)

    def change(self, phrase: Phrase) -> None:
        self.changed.setdefault(phrase)

    def miss(self, phrase: Phrase) -> None:
        self.missing.setdefault(phrase)

    def report(self) -> ImportReport:
        return ImportReport(tuple(self.changed), tuple(self.missing))
