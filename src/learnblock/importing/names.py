"""Names of variables, functions and events, in the form that Block-Text allows."""

import re
import unicodedata

from learnblock.i18n import Phrase
from learnblock.importing.report import Reporting
from learnblock.language.blocktext.lexer import KEYWORDS
from learnblock.language.tree.identifiers import MARKS

_NOT_IN_NAMES = re.compile(rf"[^\w{MARKS}]+")
_LONGEST = 100


class Names:
    """Gives each name its legal form, and reports the names that change."""

    def __init__(self, reporting: Reporting) -> None:
        self.reporting = reporting

    def legal(self, name: str) -> str:
        """The name as Block-Text allows it: ``my lines`` becomes ``my_lines``."""
        new = legal(name)
        if new != name:
            self.reporting.change(Phrase("import-renamed", name=name[:_LONGEST], new=new))
        return new


def legal(name: str) -> str:
    """The name as Block-Text allows it."""
    candidate = _NOT_IN_NAMES.sub("_", unicodedata.normalize("NFKC", name))[:_LONGEST]
    candidate = candidate if candidate.isidentifier() else f"_{candidate}"
    if candidate.isidentifier() and candidate not in KEYWORDS:
        return candidate
    return f"{candidate}_" if candidate in KEYWORDS else "_"
