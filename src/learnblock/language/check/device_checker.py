"""Check whether the robot has what the skills of a program need."""

from learnblock.errors import Severity
from learnblock.i18n import Phrase
from learnblock.language.check.findings import Findings
from learnblock.language.check.robots import Lack, calls_that_demand, need_phrase
from learnblock.language.tree.nodes import SkillCall


def check_devices(findings: Findings) -> None:
    """Report the calls of skills for which the chosen robot lacks a sense or a device."""
    equipment = findings.equipment
    if equipment is None:
        return
    functions = findings.importable.functions if findings.importable else {}
    for call, demand in calls_that_demand(
        findings.program, findings.skills, functions, in_python=findings.in_python
    ):
        if lack := demand.lack(equipment):
            is_foreign = call.name in functions
            called = call.name if is_foreign else findings.called(call.name)
            _missing_devices(findings, call, called, lack)


def _missing_devices(findings: Findings, call: SkillCall, called: str, lack: Lack) -> None:
    devices = tuple(map(need_phrase, lack.needs))
    severity: Severity = "warning" if lack.is_harmless else "error"
    kind, _, key = lack.needs[0].partition(":")
    named = _keys(findings, kind) if key and lack.needs[0] not in lack.skill.needs else ()
    if named:
        message = Phrase(
            "check-no-device-of-name",
            device=need_phrase(kind),
            key=key,
            skill=called,
            known=named,
        )
    elif lack.skill.returns_value:
        message = Phrase("check-skill-without-answer", skill=called, devices=devices)
    elif lack.is_harmless:
        code = "check-skill-partly" if lack.is_partial else "check-skill-without-effect"
        message = Phrase(code, skill=called, devices=devices)
    else:
        message = Phrase("check-skill-impossible", skill=called, devices=devices)
    findings.report("missing-device", message, call.span, severity)


def _keys(findings: Findings, kind: str) -> tuple[str, ...]:
    """The keys of the robot's devices of a type."""
    devices = (device.partition(":") for device in findings.equipment or ())
    return tuple(sorted(key for own, _, key in devices if own == kind and key))
