"""In which order the parts of a program are drawn as stacks, and which program drawn stacks form.

What runs first is drawn first: the statements outside of `main`, `main`, and below them the
definitions that they use, so that the beginning of a program is in sight however long the rest is.
"""

from collections.abc import Iterable, Iterator, Sequence

from learnblock.language.blocktext.order import definitions_first
from learnblock.language.blocktext.parser import without_robot_first
from learnblock.language.tree.layout import normalized
from learnblock.language.tree.nodes import Blank, Comment, Def, Item, Main, Program, When
from learnblock.language.workspace.statement_reader import Group, spaced


def arranged(groups: Sequence[Group]) -> Program:
    """The program of stacks in their drawn order, without blank lines that the layout adds."""
    place = next(
        (i for i, group in enumerate(groups) if type(group.statement) is Main), len(groups)
    )
    main, behind = groups[place : place + 1], groups[place + 1 :]
    # Comments stay below `main` only if nothing else is below it.
    if not all(type(group.statement) is Comment for group in behind):
        groups = [*groups[:place], *behind, *main]
    items = normalized(definitions_first(without_robot_first(spaced(groups))))
    at = next((i for i, item in enumerate(items) if isinstance(item, Main)), len(items))
    above, mains, below = items[:at], items[at : at + 1], items[at + 1 :]
    return Program(tuple(above), mains[0] if mains else None, tuple(below))  # type: ignore[arg-type]


def drawn(program: Program) -> list[Group]:
    """The statements and definitions of a program in the order in which they are drawn.

    An order in which the program would no longer be the same is not used.
    """
    main = () if program.main is None else (program.main,)
    whole = grouped((*program.items, *main, *program.ending))
    return next((order for order in _orders(whole) if arranged(order) == program), whole)


def grouped(items: Iterable[Item | Main]) -> list[Group]:
    """Group statements with the comments directly above them; other comments stay alone."""
    groups: list[Group] = []
    lead: list[Blank | Comment] = []
    for item in items:
        if isinstance(item, Blank):
            groups += _alone(lead)
            lead = [item]
        elif isinstance(item, Comment):
            lead.append(item)
        else:
            groups.append(Group(tuple(lead), item))
            lead = []
    return groups + _alone(lead)


def _orders(groups: Sequence[Group]) -> Iterator[list[Group]]:
    """Orders that show more of what runs first, the best one first."""
    main = [group for group in groups if type(group.statement) is Main]
    others = [group for group in groups if type(group.statement) is not Main]
    top, definitions, run, rest = _parts(others)
    yield [*top, *run, *main, *definitions, *rest]
    yield [*top, *main, *definitions, *run, *rest]
    yield [*top, *run, *definitions, *rest, *main]


def _parts(groups: Sequence[Group]) -> list[list[Group]]:
    """What is above the first definitions, those, the statements below them, and the rest."""
    kinds = [isinstance(group.statement, Def | When) for group in groups]
    parts: list[list[Group]] = []
    start = 0
    for wanted in (False, True, False):
        end = next((i for i in range(start, len(kinds)) if kinds[i] is not wanted), len(kinds))
        parts.append(list(groups[start:end]))
        start = end
    return [*parts, list(groups[start:])]


def _alone(lead: Sequence[Blank | Comment]) -> list[Group]:
    """Comments without a statement directly below."""
    comments = [item for item in lead if isinstance(item, Comment)]
    blank = tuple(item for item in lead if isinstance(item, Blank))
    return [Group(() if place else blank, comment) for place, comment in enumerate(comments)]
