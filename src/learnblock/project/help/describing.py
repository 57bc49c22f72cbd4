"""The meaning of the word at the cursor, and its definition."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal

from msgspec import Struct

from learnblock.blocks import BlockConfiguration
from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import attribute_from_python
from learnblock.language.check.robots import serving, serving_phrase
from learnblock.project.help.cursor import Cursor
from learnblock.project.help.vocabulary import Vocabulary
from learnblock.project.help.words import Words, library_parameters, signature

#: Words that are names, except at the beginning of a line.
_AT_START = frozenset(("repeat", "forever", "wait", "local", "python"))
_ONLY_BLOCKTEXT = frozenset(
    ("end", "main", "when", "activate", "deactivate", "function", "until", *_AT_START)
)


class Description(Struct, frozen=True, omit_defaults=True):
    """Help on a position of a text.

    Args:
        title: the name with its parameters; empty if there is no help.
        text: the help.
        needs: required devices that the chosen robot lacks.
        serves: what serves its senses on the chosen robot; None if it has none, or is unknown.
        line: the line of its definition in the same text, from 1; 0 for none.
        column: the column of its definition.
        from_column: the column where its name starts.
        to_column: the column after its name.
        sort: ``variable``, ``function`` or ``when`` if it can be renamed, else empty.
        name: the name for `Rename`.
    """

    title: str = ""
    text: str = ""
    needs: tuple[str, ...] = ()
    serves: Phrase | None = None
    line: int = 0
    column: int = 0
    from_column: int = 0
    to_column: int = 0
    sort: Literal["variable", "function", "when", ""] = ""
    name: str = ""


@dataclass(frozen=True)
class Meaning:
    """The meaning of a word.

    Args:
        title: the name with its parameters.
        text: the description.
        needs: devices that the robot lacks for it.
        serves: what serves its senses on the robot; None if it has none, or is unknown.
        defined: the beginning of the line that defines it; empty if there is none.
        sort: the kind of name if it can be renamed, else empty.
        name: the name for `Rename`.
        local: whether it is defined in the function around it.
    """

    title: str
    text: str = ""
    needs: tuple[str, ...] = ()
    defined: str = ""
    sort: str = ""
    name: str = ""
    local: bool = False
    serves: Phrase | None = None


@dataclass(frozen=True)
class Describer:
    """Finds the meaning of one word.

    Args:
        vocabulary: the names that are defined there.
        cursor: the text around the cursor.
        words: provides their descriptions.
    """

    vocabulary: Vocabulary
    cursor: Cursor
    words: Words

    def description(self) -> Description:
        """The word at the cursor or, inside the brackets of a call, the called function."""
        cursor = self.cursor
        if cursor.is_in_text:
            return Description()
        meaning = self.meaning(cursor.word) if cursor.word else None
        start, end = cursor.start, cursor.start + len(cursor.word)
        if meaning is None and not cursor.word and cursor.call:
            start = cursor.call.start
            end = start + len(cursor.call.name)
            meaning = self.called(cursor.call.name)
        return Description() if meaning is None else self.told(meaning, start, end)

    def told(self, meaning: Meaning, start: int, end: int) -> Description:
        line, column = self.definition(meaning)
        return Description(
            title=meaning.title,
            text=meaning.text,
            needs=meaning.needs,
            serves=meaning.serves,
            line=line,
            column=column,
            from_column=start + 1,
            to_column=end + 1,
            sort=meaning.sort,  # type: ignore[arg-type]
            name=meaning.name,
        )

    # Meanings.

    @property
    def is_python(self) -> bool:
        return self.vocabulary.notation == "python"

    @property
    def skills(self) -> Mapping[str, BlockConfiguration]:
        return self.vocabulary.document.target.configurations

    def meaning(self, word: str) -> Meaning | None:
        cursor = self.cursor
        if cursor.owner:
            return self.member(cursor.owner, word)
        if cursor.is_argument_name and (meaning := self.argument(word)):
            return meaning
        if cursor.word_before in {"activate", "deactivate", "when"} and not self.is_python:
            return self.when(word)
        for lookup in (self.state, self.keyword, self.own, self.function, self.variable, self.when):
            if meaning := lookup(word):
                return meaning
        return self.library(word)

    def member(self, owner: str, word: str) -> Meaning | None:
        if owner == ("robot" if self.is_python else "function"):
            if skill := self.skills.get(attribute_from_python(word) if self.is_python else word):
                return self.skill(skill, f"{owner}.{word}")
            text = self.words.about("robot_members", word) if self.is_python else ""
            return Meaning(f"{owner}.{word}", text) if text else None
        if self.is_python and owner in self.vocabulary.whens:
            text = self.words.about("when_members", word)
            return Meaning(f"{owner}.{word}", text) if text else None
        return None

    def skill(self, skill: BlockConfiguration, name: str) -> Meaning:
        equipment = self.vocabulary.document.target.equipment
        meaning = Meaning(name + signature(skill), self.words.tooltip(skill))
        if equipment is None:
            return meaning
        ways = serving(skill.needed(), equipment)
        serves = serving_phrase(ways) if ways else None
        return replace(meaning, needs=skill.lacks(equipment), serves=serves)

    def called(self, name: str) -> Meaning | None:
        """The called function, by its name and prefix."""
        owner, _, word = name.rpartition(".")
        return self.member(owner, word) if owner else self.function(word) or self.library(word)

    def argument(self, word: str) -> Meaning | None:
        """The name of an argument in a call."""
        call = self.cursor.call
        if call is None:
            return None
        owner, _, name = call.name.rpartition(".")
        skill = self.skills.get(name) if owner else None
        for parameter in skill.parameters if skill else ():
            if parameter.name == attribute_from_python(word):
                default = "" if parameter.required else repr(parameter.default)
                parts = [
                    self.words.parameter(parameter),
                    self.words.say("argument", call=call.name),
                ]
                parts += [self.words.say("default", value=default)] if default else []
                return Meaning(word, " · ".join(filter(None, parts)))
        return None

    def keyword(self, word: str) -> Meaning | None:
        if self.is_python and word == "robot":
            return Meaning(word, self.words.say("robot"))
        if word in _AT_START and not self.cursor.begins_line:
            return None
        if word == "until" and self.cursor.word_before != "wait":
            return None
        if self.is_python and word in _ONLY_BLOCKTEXT:
            return None
        text = self.words.about("keywords", word)
        return Meaning(word, text) if text else None

    def state(self, word: str) -> Meaning | None:
        """``state_X`` and ``time_X``."""
        match = self.vocabulary.state(word)
        if match is None:
            return None
        name, attribute = match
        text = self.words.say("state" if attribute == "active" else "time", name=name)
        return Meaning(word, text, defined=rf"when\s+{name}\b", sort="when", name=name)

    def own(self, word: str) -> Meaning | None:
        """A local variable of the function around it."""
        vocabulary = self.vocabulary
        if word not in vocabulary.own or vocabulary.owner is None:
            return None
        return Meaning(
            title=word,
            text=self.words.say("parameter", owner=vocabulary.owner.name),
            defined=rf"for\s+{word}\b|(?:def|when)\b",
            sort="variable",
            name=vocabulary.scoped(vocabulary.own[word]),
            local=True,
        )

    def variable(self, word: str) -> Meaning | None:
        name = self.vocabulary.variables.get(word)
        if name is None:
            return None
        defined = rf"{word}\s*(?:=(?!=)|[-+*/%]=)|for\s+{word}\b"
        return Meaning(word, self.words.say("variable"), (), defined, "variable", name)

    def function(self, word: str) -> Meaning | None:
        name = self.vocabulary.functions.get(word)
        if name is None:
            return None
        parameters = map(
            self.vocabulary.written, self.vocabulary.symbols.functions[name].parameters
        )
        title = f"{word}({', '.join(parameters)})"
        return Meaning(title, self.words.say("function"), (), rf"def\s+{word}\b", "function", name)

    def when(self, word: str) -> Meaning | None:
        name = self.vocabulary.whens.get(word)
        if name is None:
            return None
        condition = self.vocabulary.symbols.whens[name].condition
        text = self.words.say("when" if condition is None else "when_condition")
        defined = rf"(?:def|when)\s+{word}\b"
        return Meaning(word if self.is_python else f"when {word}", text, (), defined, "when", name)

    def library(self, word: str) -> Meaning | None:
        if not self.vocabulary.is_library(word):
            return None
        forms = [f"{word}({parameters})" for parameters in library_parameters(word)]
        return Meaning(", ".join(forms), self.words.about("functions", word))

    # Definitions.

    def definition(self, meaning: Meaning) -> tuple[int, int]:
        """The line and column, from 1; 0 if there is none."""
        if not meaning.defined:
            return 0, 0
        word = self.cursor.word or meaning.name
        if meaning.sort == "when" and self.vocabulary.state(word):
            word = meaning.name
        for number, line in self.lines(from_owner=meaning.local):
            if re.match(rf"\s*(?:{meaning.defined})", line):
                match = re.search(rf"\b{word}\b", line)
                if match:
                    return number, match.start() + 1
        return 0, 0

    def lines(self, *, from_owner: bool) -> Iterator[tuple[int, str]]:
        """The lines of the text with their numbers; for a local name, from its function's start."""
        lines = list(enumerate(self.vocabulary.text.split("\n"), 1))
        owner = self.vocabulary.owner
        if from_owner and owner:
            begins = re.compile(rf"\s*(?:def|when)\s+{owner.name}")
            starts = [index for index, (_, line) in enumerate(lines) if begins.match(line)]
            lines = lines[starts[0] :] if starts else lines
        yield from lines
