"""Check whether the robot can drive and turn as fast as a program demands."""

from collections.abc import Iterator

from learnblock.blocks import BlockConfiguration
from learnblock.i18n import Phrase
from learnblock.language.check.findings import Findings, constant
from learnblock.language.check.used_skills import skill_calls
from learnblock.language.tree.nodes import Expression, RawExpression, SkillCall
from learnblock.language.workspace.literals import value_of
from learnblock.wheels import Drivetrain

#: The names of the parameters for a speed forward, in mm/s, and for one of turning, in degrees/s.
_FORWARD, _TURNING = ("advSpeed", "adv"), ("rotSpeed", "rot")
#: A speed from which on it is written with an exponent.
_LONG = 1e6


def check_speeds(findings: Findings, drivetrain: Drivetrain) -> None:
    """Warn of speeds that are written in a call and beyond what the robot can do.

    Args:
        findings: of the program.
        drivetrain: what the robot's wheels can do.
    """
    for call in skill_calls(findings.program, findings.skills, in_python=findings.in_python):
        skill = findings.skills.get(call.name)
        if skill is None or "Base" not in skill.needs:
            continue
        given = dict(_numbers(call, skill))
        adv, rot = _speed(given, _FORWARD), _speed(given, _TURNING)
        reached = drivetrain.reachable(adv, rot)
        if reached != (adv, rot):
            message = _message((adv, rot), reached)
            findings.report("beyond-robot", message, call.span, "warning")


def _numbers(call: SkillCall, skill: BlockConfiguration) -> Iterator[tuple[str, float]]:
    """The numbers of a call by parameter, as far as they are known before the program runs."""
    values: dict[str, Expression | None] = dict.fromkeys(
        parameter.name for parameter in skill.parameters
    )
    values |= dict(zip(values, call.arguments, strict=False))
    values |= {keyword.name: keyword.value for keyword in call.keywords}
    defaults = {parameter.name: parameter.default for parameter in skill.parameters}
    for name, value in values.items():
        number = defaults.get(name) if value is None else _number(value)
        if isinstance(number, int | float):
            yield name, float(number)


def _number(value: Expression) -> float | str | None:
    if isinstance(value, RawExpression):
        return value_of(value.text.strip())
    return constant(value)


def _speed(given: dict[str, float], names: tuple[str, ...]) -> float:
    return next((given[name] for name in names if name in given), 0.0)


def _message(demanded: tuple[float, float], reached: tuple[float, float]) -> Phrase:
    (adv, rot), (driven, turned) = demanded, reached
    if not rot:
        return Phrase("check-too-fast", speed=_rounded(adv), most=_rounded(driven))
    if not adv:
        return Phrase("check-turns-too-fast", speed=_rounded(rot), most=_rounded(turned))
    return Phrase(
        "check-curve-too-fast",
        adv=_signed(adv),
        rot=_signed(rot),
        most=_signed(driven),
        turned=_signed(turned),
    )


def _rounded(speed: float) -> str:
    """A speed without its direction, in at most six digits."""
    return f"{abs(speed):.6g}" if abs(speed) >= _LONG else f"{abs(speed):.0f}"


def _signed(speed: float) -> str:
    return f"-{_rounded(speed)}" if speed < 0 else _rounded(speed)
