"""What is suggested for the text at the cursor."""

from dataclasses import dataclass

from msgspec import Struct


class Completion(Struct, frozen=True, omit_defaults=True):
    """A suggestion for the text at the cursor.

    Args:
        label: the text to show and filter by.
        insert: the text to insert.
        sort: the kind: skill, function, variable, when, keyword, robot, library.
        detail: the parameters.
        help: one sentence of help.
        category: the category of a skill, as named in block sets.
    """

    label: str
    insert: str
    sort: str
    detail: str = ""
    help: str = ""
    category: str = ""


@dataclass(frozen=True)
class Completions:
    """Suggestions for the text from `from_column`, from 1, to the cursor."""

    from_column: int
    options: tuple[Completion, ...]
