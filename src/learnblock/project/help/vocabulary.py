"""The names that are defined at a position of a text, as spelled in that notation."""

import re
from dataclasses import dataclass
from functools import cached_property

from learnblock.language import recover
from learnblock.language.blocktext import names
from learnblock.language.blocktext.names import state_of
from learnblock.language.edit.symbols import Symbols
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.language.tree.nodes import Def, When
from learnblock.project.document.document import Document
from learnblock.project.document.views import Notation

_TOP_LEVEL = re.compile(r"(?:async\s+)?def\s+(\w+)|\S")


@dataclass(frozen=True)
class Vocabulary:
    """The names of the program.

    Args:
        document: the program.
        notation: the notation of the text.
        line: the line of the position, from 1.
    """

    document: Document
    notation: Notation
    line: int

    @property
    def text(self) -> str:
        document = self.document
        return document.blocktext if self.notation == "blocktext" else document.python

    @cached_property
    def symbols(self) -> Symbols:
        """The names of the program, even while its Block-Text has errors."""
        unread = self.document.unread
        if self.notation == "blocktext" and unread and unread.view == "blocktext":
            return Symbols(recover(unread.text)[0])
        return Symbols(self.document.block_tree)

    @cached_property
    def owner(self) -> Def | When | None:
        """The function or ``when`` around the position."""
        if self.notation == "blocktext":
            return self.symbols.owner(self.line)
        name = self._python_owner()
        when = self.whens.get(name)
        return self.symbols.whens[when] if when else self.symbols.functions.get(self._plain(name))

    @cached_property
    def own(self) -> dict[str, str]:
        """The local variables of `owner`, by their spelling here, with that in Block-Text."""
        own = self.symbols.own(self.owner) if self.owner else ()
        return {self.written(name): name for name in own}

    @cached_property
    def variables(self) -> dict[str, str]:
        """The variables of the whole program, in the same form."""
        return {self.written(name): name for name in self.symbols.variables}

    @cached_property
    def functions(self) -> dict[str, str]:
        """The user's functions, in the same form."""
        return {self.written(name): name for name in self.symbols.functions}

    @cached_property
    def whens(self) -> dict[str, str]:
        """The ``when``s, in the same form."""
        if self.notation == "blocktext":
            return {name: name for name in self.symbols.whens}
        clashing = self._clashes()
        return {names.when_to_python(name, clashing): name for name in self.symbols.whens}

    def written(self, name: str) -> str:
        """A variable or function as spelled in this notation."""
        return name if self.notation == "blocktext" else names.to_python(name)

    def scoped(self, name: str) -> str:
        """A variable's name for `Rename`, with its function if others have the same name."""
        owner = self.owner
        if owner is None or name not in self.symbols.own(owner):
            return name
        others = [item for item in self.symbols.items if name in self.symbols.own(item)]
        ambiguous = name in self.symbols.variables or len(others) > 1
        return f"{owner.name}.{name}" if ambiguous else name

    def state(self, word: str) -> tuple[str, str] | None:
        """The ``when`` and the attribute that ``state_X`` or ``time_X`` means, in Block-Text."""
        if self.notation == "python":
            return None
        return state_of(word, self.symbols.whens.keys())

    def is_library(self, word: str) -> bool:
        """Whether this is the name of a language function here."""
        return word in FUNCTIONS and word not in self.symbols.functions

    def _plain(self, python_name: str) -> str:
        return names.from_python(python_name) or ""

    def _python_owner(self) -> str:
        """The Python function that contains the line; None at the top level."""
        lines = self.text.split("\n")[: self.line]
        if not lines or lines[-1][:1].strip():
            match = _TOP_LEVEL.match(lines[-1]) if lines else None
            return (match[1] if match else None) or ""
        for line in reversed(lines):
            if match := _TOP_LEVEL.match(line):
                return match[1] or ""
        return ""

    def _clashes(self) -> dict[str, int]:
        """As in `python_writer`: of the other names, only those similar to a ``when``'s."""
        watched = {names.stem(name) for name in self.symbols.whens}
        own = {name for item in self.symbols.items for name in self.symbols.own(item)}
        others = {*self.symbols.variables, *self.symbols.functions, *own, *self.symbols.in_python}
        return names.clashes(name for name in others if names.stem(name) in watched)
