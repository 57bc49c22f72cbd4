"""How much one person may use in a class: the one table, which `docs/class.md` shows.

A pupil is counted by desk, whatever the devices; a visitor without a badge by network address.
"""

from collections.abc import Mapping
from typing import Literal, NamedTuple, get_args

from learnblock import names
from learnblock.classroom.hand_ins import MOST_HAND_INS
from learnblock.classroom.roster import EXPECTED, MOST_ALIKE, MOST_PUPILS
from learnblock.server import messages
from learnblock.server.http.connections import MOST_KNOWN, MOST_UNKNOWN
from learnblock.server.http.requests import LEAST_RATE, PATIENCE
from learnblock.server.messages.base import Pace
from learnblock.server.sessions.quota import MOST_PROJECTS
from learnblock.server.sessions.sessions import MOST_RUNS

MEGABYTE = 1024 * 1024


# Why: docs/decisions.md, "Limits belong to a person"
class Limit(NamedTuple):
    """A row of the table.

    Args:
        what: is limited.
        most: the limit.
        whose: what is counted.
        beyond: what happens to one more.
    """

    what: str
    most: str
    whose: Literal["pupil", "address", "name", "class", "request"]
    beyond: str


#: The pages that a pupil may have open.
OPEN_PAGES = 8
#: The pace of everything that a pupil sends; a message counts once for each 64 kB.
PACE, WEIGHT = Pace(minute=2400, burst=200), 64 * 1024
#: The pace of what costs the computer more.
PACES: Mapping[str, Pace] = {
    kind.__name__: kind.pace for kind in get_args(messages.FROM_PAGE) if kind.pace
}
#: The limit of a request's body in bytes, that is, of a kept run that is brought along, and the
#: seconds within which it must arrive.
LARGEST_UPLOAD, UPLOAD_PATIENCE = 40_000_000, 120.0
#: What a pupil's server may use, in bytes: data in memory, the largest file, and the whole folder;
#: and the memory of all programs of a pupil together.
SERVER_MEMORY, LARGEST_FILE, DISK = 1500 * MEGABYTE, 64 * MEGABYTE, 1000 * MEGABYTE
PROGRAMS_MEMORY = 2048 * MEGABYTE
#: The pace of invitations into one's world.
INVITING = Pace(minute=6, burst=3)
#: The pace of showing programs, and the most that wait for a classmate's answer.
SHOWING, MOST_OFFERS = Pace(minute=6, burst=3), 3
#: What a guest's page gets of a world: kilobytes, and pictures of what moves in a second.
GUEST_KILOBYTES, GUEST_PICTURES = Pace(minute=1800, burst=3000), 10
#: The pace of new pupils.
JOINING = Pace(minute=6, burst=5)
#: Wrong attempts without a wait, and the seconds of the first wait.
WRONG_BY_NAME, WRONG_BY_ADDRESS = (5, 10.0), (60, 5.0)


def _pace(pace: Pace) -> str:
    return f"{pace.minute:g} a minute, {pace.burst} at once"


_REFUSED, _WAITS, _CLOSED = "refused in words", "has to wait", "the oldest is closed"

LIMITS: tuple[Limit, ...] = (
    Limit("open pages", f"{OPEN_PAGES}", "pupil", _REFUSED),
    Limit("projects whose programs run", f"{MOST_RUNS}", "pupil", _REFUSED),
    Limit("started runs", _pace(PACES["Run"]), "pupil", _REFUSED),
    Limit("checks of a lesson's step", _pace(PACES["CheckStep"]), "pupil", _REFUSED),
    Limit("pages to take home", _pace(PACES["ExportRun"]), "pupil", _REFUSED),
    Limit("hand-ins", _pace(PACES["HandIn"]), "pupil", _REFUSED),
    Limit("steps handed in", f"{MOST_HAND_INS}", "pupil", _REFUSED),
    Limit("tries of a custom block", _pace(PACES["TryCustomBlock"]), "pupil", _REFUSED),
    Limit("new projects", f"{MOST_PROJECTS} a minute", "pupil", _REFUSED),
    Limit("messages, in units of 64 kB", _pace(PACE), "pupil", _WAITS),
    Limit(
        "uploads of runs",
        f"one at a time, {LARGEST_UPLOAD // 1_000_000} MB, {UPLOAD_PATIENCE:g} seconds",
        "pupil",
        _REFUSED,
    ),
    Limit("invitations into one's world", _pace(INVITING), "pupil", _REFUSED),
    Limit("programs shown to teacher and classmates", _pace(SHOWING), "pupil", _REFUSED),
    Limit("classmates' programs without an answer", f"{MOST_OFFERS}", "pupil", _REFUSED),
    Limit(
        "what a guest is shown of a world",
        f"{GUEST_PICTURES} pictures and {GUEST_KILOBYTES.minute / 60:g} kB a second",
        "pupil",
        _WAITS,
    ),
    Limit("memory of the pupil's server", f"{SERVER_MEMORY // MEGABYTE} MB", "pupil", _REFUSED),
    Limit(
        "memory of all programs", f"{PROGRAMS_MEMORY // MEGABYTE} MB", "pupil", "the largest ends"
    ),
    Limit("files", f"{DISK // MEGABYTE} MB", "pupil", "new ones are refused in words"),
    Limit("connections that wait for the browser", f"{MOST_KNOWN}", "pupil", _CLOSED),
    Limit("the same without a badge", f"{MOST_UNKNOWN}", "address", _CLOSED),
    Limit(
        "half a request, or half a TLS handshake", f"{PATIENCE:g} seconds", "request", "is closed"
    ),
    Limit(
        "a slow upload", f"{LEAST_RATE // 1000} kB a second", "request", "is closed"
    ),
    Limit("wrong PINs, however the name is spelled", f"{WRONG_BY_NAME[0]}", "name", _WAITS),
    Limit("wrong words and PINs", f"{WRONG_BY_ADDRESS[0]}", "address", _WAITS),
    Limit("new pupils", _pace(JOINING), "address", _WAITS),
    Limit("pupils of one name, however it is spelled", f"{MOST_ALIKE}", "class", _REFUSED),
    Limit("new pupils without asking the teacher", f"{EXPECTED}", "class", "the wall asks"),
    Limit("pupils", f"{MOST_PUPILS}", "class", _REFUSED),
    Limit("characters of a name, as people see them", f"{names.LONGEST}", "name", _REFUSED),
)  # fmt: skip
