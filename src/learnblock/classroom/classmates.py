"""The classmates of a pupil, as far as the pupil may know them."""

from collections.abc import Iterator, Mapping

from learnblock.classroom.desk import Desk
from learnblock.classroom.pair_messages import Classmate
from learnblock.classroom.roster import Roster, names_of


def name_of(roster: Roster, desk: Desk) -> str:
    """What the teacher calls a pupil."""
    return names_of(roster.pupils).get(desk.pupil.id, desk.pupil.name)


def classmates_here(roster: Roster, desks: Mapping[str, Desk], desk: Desk) -> Iterator[Classmate]:
    """The classmates of a pupil who are here, in the order in which they joined."""
    for id, name in names_of(roster.pupils).items():  # noqa: A001 - as in `Pupil`
        other = desks.get(id)
        if other and other is not desk and other.own_pages:
            yield Classmate(id, name)
