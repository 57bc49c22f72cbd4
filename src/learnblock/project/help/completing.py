"""Completions at the cursor."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from learnblock.blocks import BlockConfiguration, Parameter
from learnblock.language.blocktext.names import attribute_to_python
from learnblock.language.tree.builtins import BUILTINS, FUNCTIONS
from learnblock.language.tree.nodes import Def
from learnblock.project.help.arguments import value_options
from learnblock.project.help.completion import Completion
from learnblock.project.help.cursor import Cursor, OpenCall
from learnblock.project.help.vocabulary import Vocabulary
from learnblock.project.help.words import Words, library_parameters, signature

# `${...}` marks the next cursor position, as in CodeMirror's snippets.
_BLOCKTEXT_STATEMENTS: Mapping[str, tuple[str, str]] = {
    "if": ("if", "if ${condition}:\n    ${pass}\nend"),
    "if else": ("if", "if ${condition}:\n    ${pass}\nelse:\n    pass\nend"),
    "elif": ("elif", "elif ${condition}:\n    ${pass}"),
    "else": ("else", "else:\n    ${pass}"),
    "while": ("while", "while ${condition}:\n    ${pass}\nend"),
    "forever": ("forever", "forever:\n    ${pass}\nend"),
    "repeat": ("repeat", "repeat ${1:4}:\n    ${2:pass}\nend"),
    "for in": ("for", "for ${x} in ${values}:\n    ${pass}\nend"),
    "for from to": ("for", "for ${1:i} from ${2:1} to ${3:10}:\n    ${4:pass}\nend"),
    "wait until": ("wait", "wait until ${condition}"),
    "break": ("break", "break"),
    "continue": ("continue", "continue"),
    "return": ("return", "return"),
    "pass": ("pass", "pass"),
    "end": ("end", "end"),
    "python": ("python", "python:\n    ${}\nend"),
}
_BLOCKTEXT_ITEMS: Mapping[str, tuple[str, str]] = {
    "def": ("def", "def ${name}():\n    ${pass}\nend"),
    "main": ("main", "main:\n    ${pass}\nend"),
    "when": ("when", "when ${name}:\n    ${pass}\nend"),
    "when =": ("when", "when ${name} = ${condition}:\n    ${pass}\nend"),
    "import": ("import", 'import "${name}"'),
}
#: What a function sets is its own in Python anyway.
_BLOCKTEXT_IN_FUNCTIONS: Mapping[str, tuple[str, str]] = {
    "local": ("local", "local ${1:name} = ${2:0}"),
}
_PYTHON_STATEMENTS: Mapping[str, tuple[str, str]] = {
    "if": ("if", "if ${condition}:\n    ${pass}"),
    "if else": ("if", "if ${condition}:\n    ${pass}\nelse:\n    pass"),
    "elif": ("elif", "elif ${condition}:\n    ${pass}"),
    "else": ("else", "else:\n    ${pass}"),
    "while": ("while", "while ${condition}:\n    ${pass}"),
    "while True": ("while", "while True:\n    ${pass}"),
    "for in": ("for", "for ${x} in ${values}:\n    ${pass}"),
    "for range": ("repeat", "for _ in range(${1:4}):\n    ${2:pass}"),
    "break": ("break", "break"),
    "continue": ("continue", "continue"),
    "return": ("return", "return"),
    "pass": ("pass", "pass"),
}
_PYTHON_ITEMS: Mapping[str, tuple[str, str]] = {
    "def": ("def", "def ${name}():\n    ${pass}"),
    "@robot.when": ("when", "@robot.when\ndef ${name}():\n    ${pass}"),
    "@robot.when(lambda: ...)": (
        "when",
        "@robot.when(lambda: ${condition})\ndef ${name}():\n    ${pass}",
    ),
}
_VALUES = ("True", "False", "None", "and", "or", "not", "in")
_WHEN_MEMBERS = {"active": "active", "time": "time"} | {
    name: f"{name}()" for name in ("activate", "deactivate")
}
_ROBOT_MEMBERS = {"when": "when", "when_start": "when_start", "run": "run()"} | {
    "elapsedTime": "elapsedTime(${seconds})",
    "wait_until": "wait_until(lambda: ${condition})",
}


@dataclass(frozen=True)
class Completer:
    """Finds the completions at one cursor position.

    Args:
        vocabulary: the names that are defined there.
        cursor: the text around the cursor.
        words: provides their descriptions.
    """

    vocabulary: Vocabulary
    cursor: Cursor
    words: Words

    def options(self) -> Iterator[Completion]:
        """All completions, regardless of what has been typed."""
        cursor = self.cursor
        if cursor.is_in_text:
            return
        if cursor.owner:
            yield from self.members(cursor.owner)
        elif self.is_python:
            yield from self.anything()
        elif cursor.word_before in {"activate", "deactivate"}:
            yield from self.whens()
        elif cursor.word_before == "import":
            yield from self.libraries()
        elif cursor.word_before not in {"def", "when"}:
            yield from self.anything()

    @property
    def is_python(self) -> bool:
        return self.vocabulary.notation == "python"

    @property
    def skills(self) -> Mapping[str, BlockConfiguration]:
        return self.vocabulary.document.target.configurations

    def libraries(self) -> Iterator[Completion]:
        for name in self.vocabulary.document.target.importable.names:
            yield Completion(f'"{name}"', f'"{name}"', "library")

    # After a dot.

    def members(self, owner: str) -> Iterator[Completion]:
        if owner == ("robot" if self.is_python else "function"):
            yield from self.skill_options("")
            if self.is_python:
                yield from self.fixed(_ROBOT_MEMBERS, "robot_members")
        elif self.is_python and owner in self.vocabulary.whens:
            yield from self.fixed(_WHEN_MEMBERS, "when_members")

    def fixed(self, members: Mapping[str, str], kind: str) -> Iterator[Completion]:
        for name, insert in members.items():
            help_ = self.words.about(kind, name)
            yield Completion(name, self.called(name, insert), "robot", help=help_)

    def skill_options(self, prefix: str) -> Iterator[Completion]:
        for skill in self.skills.values():
            if skill.name == "elapsedTime":
                # In Block-Text it is a separate function; in Python it is among the others.
                continue
            name = prefix + (attribute_to_python(skill.name) if self.is_python else skill.name)
            yield Completion(
                label=name,
                insert=self.called(name, name + _brackets(skill)),
                sort="skill",
                detail=signature(skill),
                help=self.words.tooltip(skill),
                category=skill.category,
            )

    def called(self, name: str, insert: str) -> str:
        """The text to insert: only the name if there are already brackets."""
        return name if self.cursor.behind.startswith("(") else insert

    # Everywhere else.

    def anything(self) -> Iterator[Completion]:
        if self.cursor.call is not None:
            yield from self.arguments(self.cursor.call)
        if self.cursor.begins_line:
            yield from self.statements()
        else:
            yield from self.values()
        yield from self.variables()
        yield from self.functions()
        yield from self.library()
        yield from self.skill_options("robot." if self.is_python else "function.")

    def statements(self) -> Iterator[Completion]:
        keywords = dict(_PYTHON_STATEMENTS if self.is_python else _BLOCKTEXT_STATEMENTS)
        if not self.cursor.before[: self.cursor.start]:
            keywords |= _PYTHON_ITEMS if self.is_python else _BLOCKTEXT_ITEMS
        elif not self.is_python and isinstance(self.vocabulary.owner, Def):
            keywords |= _BLOCKTEXT_IN_FUNCTIONS
        for label, (word, insert) in keywords.items():
            help_ = self.words.about("keywords", word)
            yield Completion(label, insert, "keyword", help=help_)
        for name, plain in self.vocabulary.whens.items():
            for verb in ("activate", "deactivate"):
                insert = f"{name}.{verb}()" if self.is_python else f"{verb} {plain}"
                help_ = self.words.about("keywords", verb)
                yield Completion(insert, insert, "when", help=help_)

    def values(self) -> Iterator[Completion]:
        for word in _VALUES:
            yield Completion(word, word, "keyword", help=self.words.about("keywords", word))
        for name, plain in self.vocabulary.whens.items():
            state = f"{name}.active" if self.is_python else f"state_{plain}"
            time = f"{name}.time" if self.is_python else f"time_{plain}"
            yield Completion(state, state, "when", help=self.words.say("state", name=plain))
            yield Completion(time, time, "when", help=self.words.say("time", name=plain))

    def whens(self) -> Iterator[Completion]:
        for name, plain in self.vocabulary.whens.items():
            condition = self.vocabulary.symbols.whens[plain].condition
            help_ = self.words.say("when" if condition is None else "when_condition")
            yield Completion(name, name, "when", help=help_)

    def variables(self) -> Iterator[Completion]:
        vocabulary, typed = self.vocabulary, self.cursor.word
        for name in vocabulary.own:
            owner = vocabulary.owner.name if vocabulary.owner else ""
            yield Completion(name, name, "variable", help=self.words.say("parameter", owner=owner))
        names = vocabulary.variables.keys() | vocabulary.symbols.set_in_python
        others = names - vocabulary.own.keys() - vocabulary.functions.keys() - {typed}
        for name in sorted(others):
            yield Completion(name, name, "variable", help=self.words.say("variable"))

    def functions(self) -> Iterator[Completion]:
        for name, plain in self.vocabulary.functions.items():
            parameters = [
                self.vocabulary.written(parameter)
                for parameter in self.vocabulary.symbols.functions[plain].parameters
            ]
            yield Completion(
                label=name,
                insert=self.called(name, name + _fields(parameters)),
                sort="function",
                detail=f"({', '.join(parameters)})",
                help=self.words.say("function"),
            )

    def library(self) -> Iterator[Completion]:
        for name in sorted(FUNCTIONS):
            if not self.offers(name):
                continue
            parameters = library_parameters(name)[0]
            yield Completion(
                label=name,
                insert=self.called(name, f"{name}(${{}})" if parameters else f"{name}()"),
                sort="function",
                detail=f"({parameters})",
                help=self.words.about("functions", name),
            )

    def offers(self, name: str) -> bool:
        """Whether this is the name of a language function in this notation."""
        return self.vocabulary.is_library(name) and (not self.is_python or name in BUILTINS)

    def arguments(self, call: OpenCall) -> Iterator[Completion]:
        """The keyword arguments of a call that are not given yet."""
        yield from self.likely_values(call)
        for name, detail, help_ in self.named(call):
            if name not in call.keywords:
                yield Completion(f"{name}=", f"{name}=", "variable", detail, help_)

    def likely_values(self, call: OpenCall) -> Iterator[Completion]:
        """The possible values of the current argument, if there are only a few."""
        if parameter := next(iter(self.expected(call)), None):
            yield from value_options(parameter)

    def expected(self, call: OpenCall) -> tuple[Parameter, ...]:
        """The parameters of a skill that have no argument yet."""
        owner, _, name = call.name.rpartition(".")
        if owner != ("robot" if self.is_python else "function") or name not in self.skills:
            return ()
        return self.skills[name].parameters[call.commas - len(call.keywords) :]

    def named(self, call: OpenCall) -> Iterator[tuple[str, str, str]]:
        for missing in self.expected(call):
            default = "" if missing.required else repr(missing.default)
            yield attribute_to_python(missing.name), default, self.words.parameter(missing)
        if call.name in self.vocabulary.functions:
            function = self.vocabulary.symbols.functions[self.vocabulary.functions[call.name]]
            for parameter in function.parameters[call.commas - len(call.keywords) :]:
                yield self.vocabulary.written(parameter), "", ""


def _brackets(skill: BlockConfiguration) -> str:
    required = [parameter.name for parameter in skill.parameters if parameter.required]
    if required or not skill.parameters:
        return _fields(required)
    return "(${})"


def _fields(parameters: list[str]) -> str:
    return "(" + ", ".join(f"${{{name}}}" for name in parameters) + ")"
