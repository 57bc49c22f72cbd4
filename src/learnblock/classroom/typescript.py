"""The types of a class's pages, written from `learnblock.classroom.messages`.

The build writes them into ``frontend/src/protocol/classroom.ts``.
"""

from learnblock.classroom import messages as ours
from learnblock.classroom.pins import Picture
from learnblock.classroom.programs import ClassPrograms
from learnblock.classroom.record import PupilRecord
from learnblock.server.typescript import module

_HEADER = """\
/** The conversation of a class; written by `hatch_types.py`. */

import type { Phrase } from "../i18n";
import type { RobotDescription, WorldFile } from "./world";
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
    joining = (ours.Join, ours.TryWord, ours.Joined, ours.NotJoined, ours.AboutClass)
    return module(_HEADER, unions, aliases, (*joining, PupilRecord, ClassPrograms))
