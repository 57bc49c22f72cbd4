"""Write the blocks of one line: a block and what is at its right, as Block-Text."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from learnblock.blocks import NUMBERS, BlockConfiguration, Parameter
from learnblock.blocks.old_names import todays_name
from learnblock.i18n import Phrase
from learnblock.importing.names import Names, legal
from learnblock.importing.project import BlockKind, OldBlock, OriginalProject, Value
from learnblock.importing.report import Reporting
from learnblock.importing.values import argument
from learnblock.language import recover
from learnblock.language.tree.strings import quote

#: Characters of a line that is shown in a report.
_SHOWN = 80
_EVENT_WORDS = ("activate", "deactivate")
_CONSTANTS = {"true": "True", "false": "False", "none": "None", "null": "None"}
_EVENT_PREFIXES = ("state_", "time_")


@dataclass(frozen=True)
class WrittenLine:
    """The text of a line.

    Args:
        text: as Block-Text.
        unknown: the skills in it that LearnBlock does not have.
    """

    text: str
    unknown: tuple[str, ...] = ()


class LineWriter:
    """Writes lines, and remembers which functions and events they use."""

    def __init__(
        self,
        project: OriginalProject,
        skills: Mapping[str, BlockConfiguration],
        reporting: Reporting,
    ) -> None:
        self.project, self.skills, self.reporting = project, skills, reporting
        self.names = Names(reporting)
        self.used: set[str] = set()
        self.called: dict[str, None] = {}
        self.events: dict[str, None] = {}
        #: The conditions of the events that statements subscribed to, by the event's name.
        self.heard: dict[str, str] = {}

    def condition(self, block: OldBlock | None, owner: str) -> str:
        """The condition at the right of a block; `False` if there is none that can be read."""
        line = WrittenLine("") if block is None else self.line(block)
        if line.unknown:
            self.report_unknown(line.unknown)
        elif not line.text:
            self.reporting.miss(Phrase("import-no-condition", name=owner))
        elif is_value(line.text):
            return line.text
        else:
            self.reporting.miss(Phrase("import-unread-line", text=shown(line.text)))
        return "False"

    def statement(self, block: OldBlock) -> str:
        """A line as a statement, or as a comment if it can't be one."""
        line = self.line(block)
        text = self.mended(line.text)
        if block.kind == BlockKind.SKILL and block.right is None and self.is_subscription(block):
            self.heard.setdefault(event_of(block), text)
        elif line.unknown:
            self.report_unknown(line.unknown)
        elif is_statement(text):
            return text
        else:
            self.reporting.miss(Phrase("import-unread-line", text=shown(line.text)))
        return f"# {' '.join(text.split())}"

    def is_subscription(self, block: OldBlock) -> bool:
        """Whether a block announces a message, which today's events ask for in their condition."""
        return block.name not in self.skills and self.skill_name(block.name) == "received"

    def mended(self, text: str) -> str:
        """A statement with the brackets that ``print`` has today."""
        word, _, rest = text.partition(" ")
        if word != "print" or (rest.startswith("(") and is_statement(f"print{rest}")):
            return text
        self.reporting.change(Phrase("import-print-brackets"))
        return f"print({rest})"

    def line(self, first: OldBlock) -> WrittenLine:
        """A block and what is at its right."""
        words: list[str] = []
        unknown: list[str] = []
        for block in self.row(first):
            if block.kind == BlockKind.SKILL and self.skill_name(block.name) is None:
                unknown.append(block.name)
            words.append(self.word(block))
        return WrittenLine(" ".join(words), tuple(unknown))

    def row(self, first: OldBlock) -> Iterator[OldBlock]:
        """A block and those at its right; each block is in one line only."""
        block: OldBlock | None = first
        while block is not None and block.id not in self.used:
            self.used.add(block.id)
            yield block
            block = self.project.blocks.get(block.right or "")

    def word(self, block: OldBlock) -> str:
        """The text of one block."""
        match block.kind:
            case BlockKind.SKILL:
                return self.skill(block)
            case BlockKind.VARIABLE:
                return self.variable(block)
            case BlockKind.FUNCTION | BlockKind.LIBRARY:
                return self.call(block)
        return self.control(block)

    def control(self, block: OldBlock) -> str:
        """An operator, a word of the language, a number or a text."""
        name = block.name
        if name.split(" ")[0] in _EVENT_WORDS:
            return self.switch(name, block.event)
        if len(name) > 1 and name[0] == name[-1] and name[0] in "\"'":
            return quote(name[1:-1])
        # Raw Python does not come from a project's file.
        name = " ".join(name.replace("`", "'").split())
        if not block.values:
            return _CONSTANTS.get(name, name)
        values = (argument(value, None, self.project.variables) for value in block.values)
        return f"{name}({', '.join(value or quote('') for value in values)})"

    def switch(self, name: str, event: str) -> str:
        """``activate X`` or ``deactivate X``."""
        word, _, event_name = name.partition(" ")
        target = event_name.strip() or event
        return f"{word} {self.event(target)}" if target else word

    def event(self, name: str) -> str:
        legal_name = self.names.legal(name)
        self.events.setdefault(legal_name)
        return legal_name

    def variable(self, block: OldBlock) -> str:
        if block.name.split(" ")[0] in _EVENT_WORDS and " " in block.name:
            return self.switch(block.name, block.event)
        for prefix in _EVENT_PREFIXES:
            if block.name.startswith(prefix) and block.name not in self.project.variables:
                return prefix + self.event(block.name.removeprefix(prefix))
        name = self.names.legal(block.name)
        if not block.values:
            return name
        value = argument(block.values[0], None, self.project.variables)
        if value is None:
            value = "0"
            self.reporting.miss(
                Phrase("import-argument-missing", skill=block.name, name=block.name, value=value)
            )
        return f"{name} = {value}"

    def call(self, block: OldBlock) -> str:
        name = self.names.legal(block.name)
        self.called.setdefault(name)
        return f"{name}()"

    # Skills.

    def skill_name(self, name: str) -> str | None:
        """Today's name of a skill, or None if there is no such skill."""
        return name if name in self.skills else todays_name(name, self.skills)

    def skill(self, block: OldBlock) -> str:
        name = self.skill_name(block.name)
        if name is None:
            values = (argument(value, None, self.project.variables) for value in block.values)
            return f"function.{self.names.legal(block.name)}({', '.join(filter(None, values))})"
        if name != block.name:
            self.reporting.change(Phrase("import-old-name", name=block.name, today=name))
        return f"function.{name}({', '.join(self.arguments(block, self.skills[name].parameters))})"

    def arguments(self, block: OldBlock, parameters: tuple[Parameter, ...]) -> Iterator[str]:
        for value in block.values[len(parameters) :]:
            self.reporting.miss(
                Phrase("import-argument-dropped", skill=block.name, value=shown(value.text))
            )
        values = block.values[: len(parameters)]
        for value, parameter in zip(values, parameters, strict=False):
            yield self.argument(block.name, value, parameter)
        for parameter in parameters[len(values) :]:
            if parameter.required:
                yield self.instead(block.name, parameter)

    def argument(self, skill: str, value: Value, parameter: Parameter) -> str:
        in_radians = self.project.in_radians
        exact = argument(value, parameter, self.project.variables)
        result = argument(value, parameter, self.project.variables, in_radians=in_radians)
        if result is None:
            return self.instead(skill, parameter)
        if exact is not None and exact != result:
            self.reporting.change(
                Phrase("import-degrees", skill=skill, radians=exact, degrees=result)
            )
        return result

    def instead(self, skill: str, parameter: Parameter) -> str:
        """A value for a field that holds none."""
        default = parameter.default
        if default is None:
            default = 0 if parameter.type in NUMBERS else ""
        text = quote(default) if isinstance(default, str) else str(default)
        self.reporting.miss(
            Phrase("import-argument-missing", skill=skill, name=parameter.name, value=text)
        )
        return text

    def report_unknown(self, skills: Collection[str]) -> None:
        for skill in skills:
            self.reporting.miss(Phrase("import-unknown-skill", skill=shown(skill)))


def event_of(block: OldBlock) -> str:
    """The name of the event for the message that a block announces."""
    message = block.values[0].text.strip("\"' ") if block.values else ""
    return legal(message) if message else "message"


def is_value(text: str) -> bool:
    """Whether a text is an expression of Block-Text on one line."""
    return "`" not in text and is_statement(f"x = ({text})") and is_statement(f"x = {text}")


def is_statement(text: str) -> bool:
    """Whether a text is one statement of Block-Text on one line."""
    program, mistakes = recover(text)
    return not mistakes and len(program.items) == 1 and program.main is None and "\n" not in text


def shown(text: str) -> str:
    """A text for a report, on one line and not too long."""
    line = " ".join(text.split())
    return line if len(line) <= _SHOWN else line[: _SHOWN - 1] + "…"
