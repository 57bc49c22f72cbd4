"""The values that a block configuration (JSON) describes."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal

from learnblock.devices import FIRST_KEY
from learnblock.errors import LearnBlockError
from learnblock.fields import Range
from learnblock.i18n import Phrase
from learnblock.senses import ASKED_BY_DEVICE, served_by

ParameterType = Literal[
    "float", "int", "string", "boolean", "list", "apriltext", "choice", "colour", "angle"
]
Returns = Literal["any", "boolean"]
#: The types that are numbers, and can have a range.
NUMBERS: tuple[ParameterType, ...] = ("float", "int", "angle")
#: The signs that have words; a zero has those of the first.
SIGNS = POSITIVE, NEGATIVE = ("positive", "negative")

_COLOUR = re.compile(r"#[0-9a-fA-F]{6}")


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of a skill.

    Args:
        name: the parameter's name in the function.
        type: the kind of values that the field accepts.
        default: the default of that type: a float, int, str, bool, list or None; see `required`.
        required: whether every call must give a value, because there is no default.
        translations: the name for readers, by upper-case language code.
        range: the range of a number, if it is limited.
        choices: the strings of the type ``choice``; of a ``string`` only the usual ones.
        choice_names: translations of the choices, by the choice and then by upper-case language
            code; programs contain the choice itself.
        directions: the words for a ``positive`` and a ``negative`` number, such as *right* and
            *left*, by upper-case language code; empty if the sign has no word. Programs contain
            the sign.
        needs: what a call needs if it gives True, such as the sense of one side; empty if that does
            not depend on it.
    """

    name: str
    type: ParameterType
    default: object = None
    required: bool = False
    translations: Mapping[str, str] = field(default_factory=dict)
    range: Range | None = None
    choices: tuple[str, ...] = ()
    choice_names: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    directions: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    needs: str = ""

    @property
    def is_number(self) -> bool:
        return self.type in NUMBERS

    def objection(self, value: object) -> Phrase | None:
        """A suggestion if the field does not offer a number or string; None if it does.

        >>> str(Parameter("speed", "float", range=Range(0, 100)).objection(120))
        'Choose a number from 0 to 100.'
        """
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if self.range and is_number and not self.range.holds(value):  # type: ignore[arg-type]
            return Phrase("block-expects-range", least=self.range.least, most=self.range.most)
        if self.type == "choice" and value not in self.choices:
            return Phrase("block-expects-choice", choices=tuple(map(repr, self.choices)))
        if self.type == "colour" and not is_colour(value):
            return Phrase("block-expects-colour")
        return None


def is_colour(value: object) -> bool:
    """Whether it is a string such as ``#ff8800``."""
    return isinstance(value, str) and bool(_COLOUR.fullmatch(value))


@dataclass(frozen=True, slots=True)
class BlockConfiguration:
    """One skill as a block.

    Args:
        type: the kind, which sets the colour: motor, perceptual, proprioceptive, express, control,
            operator or others.
        category: the tab of the palette.
        name: the function's name, as programs write it.
        parameters: in the order of the function's signature.
        shapes: ``blockVertical`` is a statement, ``blockLeft`` and ``blockBoth`` are values.
        languages: the label, by upper-case language code; see `learnblock.blocks.labels`.
        tooltip: a sentence of help, by upper-case language code.
        needs: what it needs to have an effect: a sense such as ``black-line``, or a device:
            ``Base``, ``JointMotor:CAMERA`` for the one with that key, ``RGBLed:{slot}`` for the one
            whose key the parameter gives; see `learnblock.senses`. If parameters have needs of
            their own, these are those of a call without arguments.
        returns: the kind of a value: ``boolean`` for a question, whose block is hexagonal.
        library: the library that a program must import, if any.
        titles: the name of the tab of a library, by upper-case language code.
    """

    type: str
    category: str
    name: str
    parameters: tuple[Parameter, ...] = ()
    shapes: tuple[str, ...] = ("blockVertical",)
    languages: Mapping[str, str] = field(default_factory=dict)
    tooltip: Mapping[str, str] = field(default_factory=dict)
    needs: tuple[str, ...] = ()
    returns: Returns = "any"
    library: str = ""
    titles: Mapping[str, str] = field(default_factory=dict)

    @property
    def returns_value(self) -> bool:
        """True for a question or a measure, False for a statement."""
        return "blockVertical" not in self.shapes

    def lacks(
        self, equipment: frozenset[str], arguments: Mapping[str, str | None] = MappingProxyType({})
    ) -> tuple[str, ...]:
        """The needs that a robot can't serve.

        Args:
            equipment: what the robot has; see `learnblock.senses.equipment`.
            arguments: the text that a call gives for a parameter; None if only the run will tell.
        """
        return tuple(need for need in self.needed(arguments) if served_by(need, equipment) is None)

    def needed(self, arguments: Mapping[str, str | None] = MappingProxyType({})) -> tuple[str, ...]:
        """What a call needs.

        Parameters that only the run will tell count as True; if none is True, all count.

        Args:
            arguments: as for `lacks`.
        """
        choices = [parameter for parameter in self.parameters if parameter.needs]
        active = [
            choice.needs
            for choice in choices
            if arguments.get(choice.name, str(choice.default)) != "False"
        ]
        if choices:
            return tuple(active or [choice.needs for choice in choices])
        return tuple(self._chosen(need, arguments) for need in self.needs)

    def _chosen(self, need: str, arguments: Mapping[str, str | None]) -> str:
        """A need with the key that its parameter gives; any key will do if that is open."""
        kind, _, key = need.partition(":")
        if not key.startswith("{"):
            return need
        name = key.strip("{}")
        default = next(
            (parameter.default for parameter in self.parameters if parameter.name == name), None
        )
        value = arguments.get(name, default)
        device = kind if value in (None, FIRST_KEY) else f"{kind}:{value}"
        return ASKED_BY_DEVICE.get(device, device)


class Configurations(Mapping[str, BlockConfiguration]):
    """Blocks by name, and the errors of files that could not be read.

    Args:
        blocks: by name.
        broken: why the skills of invalid files cannot be used, by name of the skill.
        problems: the errors of invalid files.
    """

    def __init__(
        self,
        blocks: Mapping[str, BlockConfiguration],
        broken: Mapping[str, Phrase],
        problems: tuple[LearnBlockError, ...],
    ) -> None:
        self._blocks = blocks
        self.broken = broken
        self.problems = problems

    def __getitem__(self, name: str) -> BlockConfiguration:
        return self._blocks[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._blocks)

    def __len__(self) -> int:
        return len(self._blocks)

    def extended(self, more: Mapping[str, BlockConfiguration]) -> "Configurations":
        """These blocks and others, which replace those with the same name."""
        broken = {name: why for name, why in self.broken.items() if name not in more}
        return Configurations({**self._blocks, **more}, broken, self.problems)
