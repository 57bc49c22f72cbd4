"""Programs in the Block-Text of the original LearnBlock, such as those of its libraries."""

import re
from collections.abc import Mapping

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.old_names import todays_name
from learnblock.errors import Diagnostic, ProjectError
from learnblock.i18n import Phrase
from learnblock.importing.report import Reporting
from learnblock.language import parse
from learnblock.language.tree.nodes import Program

#: Bytes of a file of a library.
LARGEST_LIBRARY = 1024 * 1024

_PRINT = re.compile(r"^(\s*)print(?!\s*\()[ \t]+(\S.*?)[ \t]*$", re.MULTILINE)
_SKILL = re.compile(r"\bfunction\.(\w+)")


def parse_old(
    data: bytes, filename: str, skills: Mapping[str, BlockConfiguration], reporting: Reporting
) -> Program:
    """Read old Block-Text, with today's names of skills and the brackets of ``print``.

    Raises:
        FileError: it is too large, or isn't Block-Text either.
    """

    def today(match: re.Match[str]) -> str:
        name = match[1]
        name_today = None if name in skills else todays_name(name, skills)
        if name_today is None:
            return match[0]
        reporting.change(Phrase("import-old-name", name=name, today=name_today))
        return f"function.{name_today}"

    text = decoded(data, filename).removeprefix("\ufeff")
    mended, printed = _PRINT.subn(r"\1print(\2)", text)
    if printed:
        reporting.change(Phrase("import-print-brackets"))
    return parse(_SKILL.sub(today, mended.replace("\r\n", "\n")), filename)


def decoded(data: bytes, filename: str) -> str:
    """Decode a file of a library.

    Raises:
        ProjectError: it is too large.
    """
    if len(data) > LARGEST_LIBRARY:
        message = Phrase("import-too-large", size=len(data), limit=LARGEST_LIBRARY)
        raise ProjectError(filename, [Diagnostic("too-large", message)])
    return data.decode("utf-8", "replace")
