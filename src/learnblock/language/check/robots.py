"""Which robots can run a program: decided by what its skills need, before it runs."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.source.derivation import VALUE
from learnblock.i18n import Phrase
from learnblock.language.check.used_skills import skill_calls
from learnblock.language.tree.nodes import Constant, Expression, Program, SkillCall, String
from learnblock.senses import SENSES, UNSERVED, is_decoration, sense_of, served_by

Texts = Mapping[str, str | None]


@dataclass(frozen=True, slots=True)
class Demand:
    """The parts of a skill's call that decide what a robot needs for it.

    Args:
        skill: its block.
        texts: the text given for each parameter, also of True and False; None for what only the
            run will tell.
    """

    skill: BlockConfiguration
    texts: Texts

    @property
    def key(self) -> tuple[object, ...]:
        """The same for calls that demand the same."""
        return (self.skill.name, self.skill.needs, *sorted(self.texts.items(), key=str))

    @property
    def needs(self) -> tuple[str, ...]:
        """What it needs."""
        return self.skill.needed(self.texts)

    def lack(self, equipment: frozenset[str]) -> "Lack | None":
        """What a robot lacks for it; None if it can do it."""
        lacks = self.skill.lacks(equipment, self.texts)
        return Lack(self.skill, lacks, is_partial=lacks != self.needs) if lacks else None


@dataclass(frozen=True, slots=True)
class Lack:
    """A skill that a robot can't do.

    Args:
        skill: its block.
        needs: the senses or devices that the robot lacks.
        is_partial: whether it has others that the skill needs.
    """

    skill: BlockConfiguration
    needs: tuple[str, ...]
    is_partial: bool = False

    @property
    def is_harmless(self) -> bool:
        """Whether the program only loses decoration; a question without an answer is not."""
        return not self.skill.returns_value and all(map(is_decoration, self.needs))


@dataclass(frozen=True, slots=True)
class Verdict:
    """Whether a robot can run a program.

    Args:
        missed: the skills that would do nothing; they only decorate.
        refused: the skills without which the program can't run.
        served: what serves the senses of the program on the robot.
    """

    missed: tuple[Lack, ...] = ()
    refused: tuple[Lack, ...] = ()
    served: tuple[str, ...] = ()

    @property
    def runs(self) -> bool:
        """Whether it runs, at least without its decoration."""
        return not self.refused

    @property
    def phrase(self) -> Phrase:
        """The verdict in words."""
        if self.refused:
            return Phrase("check-robot-refused", devices=_devices(self.refused))
        if self.missed:
            return Phrase("check-robot-without", devices=_devices(self.missed))
        if self.served:
            return Phrase("check-robot-runs-with", devices=_serving(self.served))
        return Phrase("check-robot-runs")


def _devices(lacks: tuple[Lack, ...]) -> tuple[Phrase, ...]:
    needs = dict.fromkeys(need for lack in lacks for need in lack.needs)
    # Several senses may be served by one device, which is named once.
    return tuple({str(phrase): phrase for phrase in map(need_phrase, needs)}.values())


def serving(needs: Iterable[str], equipment: frozenset[str]) -> tuple[str, ...]:
    """What serves the senses among some needs on a robot; a device that is needed serves none."""
    ways = (served_by(need, equipment) for need in needs if need in SENSES)
    return tuple(dict.fromkeys(way for way in ways if way))


def asked(demanded: Iterable[Demand], equipment: frozenset[str] | None) -> tuple[str, ...]:
    """The devices and abilities that answer a program's questions on a robot, each once.

    Args:
        demanded: of `demands`.
        equipment: what the robot has; None if that is unknown.
    """
    needs = (need for demand in demanded if demand.skill.returns_value for need in demand.needs)
    answering = (_answering(need, equipment) for need in needs)
    return tuple(dict.fromkeys(answer for answer in answering if answer))


def _answering(need: str, equipment: frozenset[str] | None) -> str | None:
    if equipment is None:
        return next(iter(SENSES.get(need, (need,))))
    return served_by(need, equipment)


def serving_phrase(ways: Iterable[str]) -> Phrase:
    """What serves the senses of a skill on the chosen robot, in words."""
    return Phrase("check-serving", devices=_serving(ways))


def _serving(ways: Iterable[str]) -> tuple[Phrase, ...]:
    parts = (way.partition(":") for way in ways)
    return tuple(Phrase("check-serving-device", kind=kind, key=key) for kind, _, key in parts)


def need_phrase(need: str) -> Phrase:
    """What a skill needs, a sense or a device, as a noun phrase."""
    device = device_phrase(need)
    is_nobodys = need.partition(":")[0] in UNSERVED
    return Phrase("check-device-of-none", device=device) if is_nobodys else device


def device_phrase(need: str) -> Phrase:
    """What a skill needs, without a remark on the robots that have it."""
    kind, _, key = need.partition(":")
    return Phrase("check-device", kind=kind, key=key)


def calls_that_demand(
    program: Program,
    skills: Mapping[str, BlockConfiguration],
    functions: Mapping[str, BlockConfiguration],
    *,
    in_python: bool = False,
) -> Iterator[tuple[SkillCall, Demand]]:
    """Every call that demands something of a robot, in source order.

    Args:
        program: the tree.
        skills: the skills, by name.
        functions: of `learnblock.blocks.importable.Importable`.
        in_python: whether its author wrote Python.
    """
    foreign = {
        name: function for name, function in functions.items() if name not in program.functions
    }
    for call in skill_calls(program, skills, foreign, in_python=in_python):
        skill = _sense(call) or skills.get(call.name) or foreign.get(call.name)
        if skill is not None and skill.needs:
            yield call, _demand(call, skill)


def _sense(call: SkillCall) -> BlockConfiguration | None:
    """A method of `robot.senses` as a skill; None if only the run will tell which sense."""
    owner, _, method = call.name.partition(".")
    first_argument = _text(call.arguments[0]) if call.arguments else None
    sense = sense_of(method, first_argument) if owner == "senses" else None
    if sense is None:
        return None
    return BlockConfiguration("perceptual", "", call.name, shapes=VALUE, needs=(sense,))


def _demand(call: SkillCall, skill: BlockConfiguration) -> Demand:
    names = (parameter.name for parameter in skill.parameters)
    given = dict(zip(names, call.arguments, strict=False))
    given |= {keyword.name: keyword.value for keyword in call.keywords}
    return Demand(skill, {name: _text(value) for name, value in given.items()})


def _text(value: Expression) -> str | None:
    match value:
        case String(value=text):
            return text
        case Constant(value=bool() as is_so):
            return str(is_so)
    return None


def demands(
    program: Program,
    skills: Mapping[str, BlockConfiguration],
    functions: Mapping[str, BlockConfiguration] = MappingProxyType({}),
) -> tuple[Demand, ...]:
    """What a program demands of a robot; calls that demand the same are listed once."""
    called = (demand for _, demand in calls_that_demand(program, skills, functions))
    return tuple({demand.key: demand for demand in called}.values())


def verdict(demanded: tuple[Demand, ...], equipment: frozenset[str]) -> Verdict:
    """Decide whether a robot can meet all demands.

    Args:
        demanded: of `demands`.
        equipment: what the robot has; see `learnblock.senses.equipment`.
    """
    lacks = {
        (lack.skill.name, lack.needs): lack
        for demand in demanded
        if (lack := demand.lack(equipment))
    }
    return Verdict(
        missed=tuple(lack for lack in lacks.values() if lack.is_harmless),
        refused=tuple(lack for lack in lacks.values() if not lack.is_harmless),
        served=serving((need for demand in demanded for need in demand.needs), equipment),
    )
