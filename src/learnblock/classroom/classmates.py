"""The classmates of a pupil, as far as the pupil may know them."""

from collections.abc import Callable, Iterator, Mapping

from learnblock.classroom.desk import Desk
from learnblock.classroom.pair_messages import Classmate
from learnblock.classroom.roster import Roster, names_of
from learnblock.errors import LearnBlockError

#: Seconds after which a classmate who has declined may be asked by the same pupil again.
_PAUSE = 60.0


def name_of(roster: Roster, desk: Desk) -> str:
    """What the teacher calls a pupil."""
    return names_of(roster.pupils).get(desk.pupil.id, desk.pupil.name)


def classmates_here(roster: Roster, desks: Mapping[str, Desk], desk: Desk) -> Iterator[Classmate]:
    """The classmates of a pupil who are here, in the order in which they joined."""
    for id, name in names_of(roster.pupils).items():  # noqa: A001 - as in `Pupil`
        other = desks.get(id)
        if other and other is not desk and other.own_pages:
            yield Classmate(id, name)


def classmate_here(roster: Roster, desks: Mapping[str, Desk], desk: Desk, pupil: str) -> Desk:
    """The desk of a classmate who is here.

    Args:
        roster: the pupils.
        desks: their desks, by their ids.
        desk: of the pupil whose classmate it is.
        pupil: the id of the classmate.

    Raises:
        LearnBlockError: there is no such classmate, or not now.
    """
    if all(classmate.id != pupil for classmate in classmates_here(roster, desks, desk)):
        raise LearnBlockError("class-classmate-away")
    return desks[pupil]


class Refusals:
    """When pupils have declined what a classmate has offered.

    Args:
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, now: Callable[[], float]) -> None:
        self._now = now
        #: By the ids of the pupil who has asked and of the classmate.
        self._times: dict[tuple[str, str], float] = {}

    def add(self, asker: Desk, classmate: Desk) -> None:
        """Note that a classmate has declined."""
        self._times[asker.pupil.id, classmate.pupil.id] = self._now()

    def require_none(self, asker: Desk, classmate: Desk, name: str) -> None:
        """Require that a classmate has not declined a moment ago.

        Args:
            asker: the pupil who asks.
            classmate: the pupil who is asked.
            name: what the teacher calls the classmate.

        Raises:
            LearnBlockError: the classmate has.
        """
        declined = self._times.get((asker.pupil.id, classmate.pupil.id))
        if declined is not None and self._now() - declined < _PAUSE:
            raise LearnBlockError("class-classmate-declined", name=name)
