"""What a browser keeps so that a pupil or the teacher need not say again who they are."""

import hashlib
import hmac
from collections.abc import Iterable
from dataclasses import dataclass

from starlette.requests import HTTPConnection

from learnblock.classroom.roster import Pupil, Roster

_TEACHER = "teacher"


@dataclass(frozen=True)
class Badges:
    """Signed names of pupils, and of the teacher.

    Args:
        roster: the class, whose secret signs them.
    """

    roster: Roster

    def of_pupil(self, pupil: Pupil) -> str:
        """The badge of a pupil, valid until the pupil gets another PIN."""
        return self._signed(f"{pupil.id}.{pupil.badges}")

    def of_teacher(self) -> str:
        """The badge of the teacher."""
        return self._signed(_TEACHER)

    def is_key(self, key: str) -> bool:
        """Whether this is the teacher's key, which gives a browser the teacher's badge."""
        return _same(key, self.roster.key)

    def is_teacher(self, badge: str) -> bool:
        """Whether a badge is the teacher's."""
        return _same(badge, self.of_teacher())

    def pupil(self, badge: str) -> Pupil | None:
        """The pupil with this badge; None if it is not valid, or not any more."""
        pupil = self.roster.find(badge.partition(".")[0])
        return pupil if pupil and _same(badge, self.of_pupil(pupil)) else None

    def _signed(self, text: str) -> str:
        signature = hmac.digest(self.roster.secret.encode(), text.encode(), hashlib.sha256)
        return f"{text}.{signature.hex()}"


@dataclass(frozen=True)
class Visitors:
    """Who sends a request, by the badges that its browser keeps.

    Args:
        badges: those of the class.
        cookie: the name under which browsers keep a pupil's badge.
    """

    badges: Badges
    cookie: str

    @property
    def teachers_cookie(self) -> str:
        """The name under which a browser keeps the teacher's badge."""
        return f"{self.cookie}_teacher"

    def is_teacher(self, request: HTTPConnection) -> bool:
        """Whether the teacher asks."""
        return self.badges.is_teacher(request.cookies.get(self.teachers_cookie, ""))

    def pupil(self, request: HTTPConnection) -> Pupil | None:
        """The pupil who asks; None if no pupil does."""
        return self.badges.pupil(request.cookies.get(self.cookie, ""))

    def person(self, headers: Iterable[tuple[bytes, bytes]]) -> str:
        """Who sends these headers; "" for a stranger."""
        request = HTTPConnection({"type": "http", "headers": list(headers)})
        if self.is_teacher(request):
            return _TEACHER
        pupil = self.pupil(request)
        return pupil.id if pupil else ""


def _same(first: str, second: str) -> bool:
    return hmac.compare_digest(first.encode(), second.encode())
