"""What a child may claim about a program: its lines, its errors and the devices that it lacks.

The child keeps to it, so that nothing an honest program does is refused, and its host checks it
(`learnblock.runtime.validation`). Every program's process loads this module, so it imports little.
"""

import re

from learnblock.devices import DEVICE_TYPES
from learnblock.i18n import can_be_said, parts
from learnblock.i18n.phrase import Phrase
from learnblock.senses import METHODS, SENSES

#: The most characters of each text of an error, its texts in all, and how deep they are nested.
LONGEST_TEXT, MOST_PARTS, DEEPEST_PHRASE = 2100, 300, 12
#: The child's own message that it could not be contained; believed only before the program begins.
NOT_CONTAINED = "run-not-contained"
#: What only the host can say about the end of a run.
_OF_HOST = frozenset(
    {
        "run-blocked", "run-finished", "run-killed", "run-link-closed", "run-lost", "run-no-call",
        "run-no-robot", "run-process-ended", "run-processor-time", "run-stopped",
        "run-stopped-by-signal", "run-time-limit", "run-too-many-files", "run-too-many-threads",
        "run-too-much-disk", "run-too-much-output",
    }
)  # fmt: skip
#: The areas of words that are no errors of a program, but say what commands and pages do.
_OTHER_AREAS = frozenset(
    {"calls", "class", "cli", "doctor", "grade", "hint", "miss", "page", "report"}
)
_SENSE = re.compile("|".join(method.replace("{}", r"\w{1,50}") for method in {*METHODS.values()}))
#: The longest key of a device, in characters.
_LONGEST_KEY = 200


def last_line(python: str) -> int:
    """The number of the last line of a program."""
    return python.count("\n") + 1


def is_of_program(phrase: Phrase) -> bool:
    """Whether a phrase can be the message of a program's error, in every language."""
    return is_sayable(phrase) and all(map(_is_of_program, parts(phrase)))


def is_sayable(phrase: Phrase) -> bool:
    """Whether a phrase can be shown in every language, and is not too long."""
    return _is_small(phrase) and can_be_said(phrase)


def is_need(text: str) -> bool:
    """Whether a text names a device, such as ``Camera:ROBOT``, or a sense."""
    kind, _, key = text.partition(":")
    is_device = kind in DEVICE_TYPES or kind == "Detector"
    is_key = len(key) <= _LONGEST_KEY and (not key or key.isprintable())
    return (is_device and is_key) or text in SENSES or _SENSE.fullmatch(text) is not None


def _is_small(phrase: Phrase) -> bool:
    for count, part in enumerate(parts(phrase, DEEPEST_PHRASE)):
        text = part.code if isinstance(part, Phrase) else part
        is_long = isinstance(text, str) and len(text) > LONGEST_TEXT
        if part is None or is_long or count >= MOST_PARTS:
            return False
    return True


def _is_of_program(part: object) -> bool:
    if not isinstance(part, Phrase):
        return True
    area = part.code.partition("-")[0]
    return part.code not in {*_OF_HOST, NOT_CONTAINED} and area not in _OTHER_AREAS
