"""The types of a class's pages, written from `learnblock.classroom.messages`.

python -m learnblock.classroom.typescript > frontend/src/protocol/classroom.ts
"""

import sys

from learnblock.classroom import messages as ours
from learnblock.classroom.pins import Picture
from learnblock.server.typescript import module

_HEADER = """\
/** The conversation of a class; written by `python -m learnblock.classroom.typescript`. */

import type { Phrase } from "../i18n";
"""


def typescript() -> str:
    """The whole module."""
    unions = {
        "FromPupil": ours.FromPupil,
        "ToPupil": ours.ToPupil,
        "FromTeacher": ours.FromTeacher,
        "ToTeacher": ours.ToTeacher,
    }
    aliases = {"Picture": Picture, "Writing": ours.Writing}
    return module(
        _HEADER, unions, aliases, (ours.Join, ours.Joined, ours.NotJoined, ours.AboutClass)
    )


if __name__ == "__main__":
    sys.stdout.write(typescript())
