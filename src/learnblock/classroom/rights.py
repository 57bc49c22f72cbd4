"""Who may what: the table that every message of a page in a class passes.

Each message says it itself, by its base; what is not in the table is refused.
"""

from collections.abc import Mapping
from typing import get_args

from learnblock.classroom import messages as ours
from learnblock.server import messages
from learnblock.server.messages.base import Role

#: The roles that may send each kind of message.
RIGHTS: Mapping[str, frozenset[Role]] = {
    kind.__name__: kind.roles for kind in get_args(messages.FROM_PAGE | ours.FromPupil)
}

#: The kinds of messages that a guest's page may send the server of the pupil who has invited the
#: guest, and those that it gets from there: neither the program nor anything that is kept.
FROM_GUEST = frozenset({messages.HoldKeys.__name__})
TO_GUEST = frozenset(
    kind.__name__
    for kind in (
        messages.Bumped, messages.Drawing, messages.Ended, messages.KeysWanted, messages.Opened,
        messages.RobotLink, messages.RunState, messages.Scene, messages.Sound, messages.TabOpened,
        messages.Tabs, messages.Telemetry, messages.Welcome,
    )
)  # fmt: skip


def may(role: Role, kind: str) -> bool:
    """Whether a page in this role may send a message of this kind."""
    return role in RIGHTS.get(kind, frozenset())
