"""Whether what a program calls exists, can be called so, and works with the robot's devices."""

from collections.abc import Iterable

from learnblock.blocks.configuration import NUMBERS, BlockConfiguration, Parameter
from learnblock.errors import Severity, did_you_mean
from learnblock.language.findings import Findings, python_error, quoted, write_one
from learnblock.language.library import BUILTINS, FUNCTIONS, TEMPLATES
from learnblock.language.names import state_of
from learnblock.language.nodes import (
    Call,
    Def,
    Expression,
    Import,
    Item,
    Name,
    Number,
    RawExpression,
    SkillCall,
    String,
    Unary,
    expressions,
    within,
)
from learnblock.language.workspace_literals import value_of

_OPEN_ENDED = frozenset(name for name, (_, most) in BUILTINS.items() if most is None)


class CallChecker:
    """Checks each expression by itself."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.report = findings.report
        self.parameters: frozenset[str] = frozenset()  # of the function that is being checked

    def own_expressions(self, item: Item) -> None:
        """The expressions of a statement, without those of the bodies within it."""
        for expression in expressions(item):
            for node in within(expression):
                self.expression(node)

    def expression(self, node: Expression) -> None:
        if isinstance(node, SkillCall):
            self.skill_call(node)
        elif isinstance(node, Call):
            self.call(node)
        elif isinstance(node, Name):
            self.state(node)
        elif isinstance(node, RawExpression):
            error = python_error(node.text.strip(), "eval")
            if error is not None:
                self.report("invalid-python", f"this is not Python: {error.msg}", node.span)

    def state(self, node: Name) -> None:
        """``state_X`` and ``time_X`` of a ``when`` that does not exist."""
        prefix, _, name = node.name.partition("_")
        if prefix not in {"state", "time"} or not name or self.is_known(node.name):
            return
        if state_of(node.name, self.findings.whens.keys()) is None:
            hint = did_you_mean(name, self.findings.whens) or write_one(name)
            message = f"`{node.name}`: there is no `when {name}`; {hint}"
            self.report("unknown-when", message, node.span)

    def is_known(self, name: str) -> bool:
        return name in self.findings.assigned or name in self.parameters

    def imported(self, node: Import) -> None:
        """An ``import`` names something that is there."""
        importable = self.findings.importable
        if importable is None or node.module in importable:
            return
        hint = did_you_mean(node.module, importable.names)
        known = f"there are {quoted(importable.names)}" if importable.names else "there is none yet"
        message = (
            f'`import "{node.module}"`: there is no such library; {hint or known}; import its file'
            f" with `learnblock library import`, or put {node.module}.py beside the program"
        )
        self.report("unknown-library", message, node.span)

    def skill_call(self, node: SkillCall) -> None:
        skill = self.findings.skills.get(node.name)
        if skill is None:
            self.unknown_skill(node)
            return
        if skill.library and skill.library not in self.findings.imported:
            self.not_imported(node, skill)
        self.arguments(node, skill)
        if self.findings.devices is not None and (missing := skill.lacks(self.findings.devices)):
            self.missing_devices(node, skill, missing)

    def not_imported(self, node: SkillCall, skill: BlockConfiguration) -> None:
        message = (
            f"`function.{node.name}` belongs to the library `{skill.library}`: write"
            f' `import "{skill.library}"` above everything else'
        )
        self.report("not-imported", message, node.span)

    def unknown_skill(self, node: SkillCall) -> None:
        if node.name in self.findings.functions:
            advice = f"`{node.name}` is a function of your own: call it without `function.`"
        elif broken := self.findings.broken.get(node.name):
            advice = f"the file that it stands in is wrong: {broken}"
        else:
            hint = did_you_mean(node.name, self.findings.skills)
            advice = hint or "see the palette for all there are"
        message = f"`function.{node.name}`: the robot has no such skill; {advice}"
        self.report("unknown-skill", message, node.span)

    def missing_devices(
        self, node: SkillCall, skill: BlockConfiguration, missing: tuple[str, ...]
    ) -> None:
        devices = quoted(missing)
        if skill.returns_value:
            effect = "it can never answer"
        elif "Base" in missing:
            effect = "it cannot move"
        else:
            effect = "it has no effect"
        severity: Severity = "warning" if effect == "it has no effect" else "error"
        message = f"`function.{node.name}` needs {devices}, which this robot lacks: {effect}"
        self.report("missing-device", message, node.span, severity)

    def arguments(self, node: SkillCall, skill: BlockConfiguration) -> None:
        parameters = skill.parameters
        call = f"function.{node.name}"
        self.too_many(node, call, tuple(parameter.name for parameter in parameters))
        given = {parameter.name for parameter in parameters[: len(node.arguments)]}
        known = {parameter.name: parameter for parameter in parameters}
        self.keywords(node, call, given, known.keys())
        given |= {keyword.name for keyword in node.keywords}
        missing = [one.name for one in parameters if one.required and one.name not in given]
        self.missing(node, call, missing)
        for parameter, value in zip(parameters, node.arguments, strict=False):
            self.type_of(call, parameter, value)
        for keyword in node.keywords:
            if keyword.name in known:
                self.type_of(call, known[keyword.name], keyword.value)

    def too_many(self, node: Call | SkillCall, call: str, parameters: tuple[str, ...]) -> None:
        if len(node.arguments) > len(parameters):
            takes = f"takes {_count(len(parameters), 'argument')}"
            names = f" ({', '.join(parameters)})" if parameters else ""
            message = f"`{call}` {takes}{names}, not {len(node.arguments)}"
            self.report("argument-count", message, node.arguments[len(parameters)].span)

    def keywords(
        self, node: Call | SkillCall, call: str, given: set[str], known: Iterable[str]
    ) -> None:
        for keyword in node.keywords:
            if keyword.name not in known:
                hint = did_you_mean(keyword.name, known) or "known are: " + (
                    quoted(known) or "none"
                )
                message = f"`{call}` has no argument `{keyword.name}`; {hint}"
                self.report("unknown-argument", message, keyword.span)
            elif keyword.name in given:
                message = f"`{call}` is given `{keyword.name}` twice"
                self.report("duplicate-argument", message, keyword.span)

    def missing(self, node: Call | SkillCall, call: str, names: list[str]) -> None:
        if names:
            self.report("missing-argument", f"`{call}` also needs {quoted(names)}", node.span)

    def type_of(self, call: str, parameter: Parameter, value: Expression) -> None:
        if parameter.type in NUMBERS and isinstance(value, String):
            message = f"`{parameter.name}` of `{call}` is a number, not a text"
            plain = value.value.strip()
            if plain.replace(".", "", 1).lstrip("-").isdecimal():
                message += f": write {plain} without quotes"
            self.report("wrong-type", message, value.span)
            return
        constant = _constant(value)
        if constant is not None and (objection := parameter.objection(constant)):
            shown = repr(constant).removesuffix(".0")
            message = f"`{parameter.name}` of `{call}` is {shown} here; {objection}"
            self.report("unusual-value", message, value.span, "warning")

    def call(self, node: Call) -> None:
        function = self.findings.functions.get(node.name)
        if function is not None:
            self.own_call(node, function)
        elif node.name in FUNCTIONS:
            self.library_call(node)
        elif not self.findings.imports and not self.is_known(node.name):
            self.unknown_function(node)

    def own_call(self, node: Call, function: Def) -> None:
        self.too_many(node, node.name, function.parameters)
        given = set(function.parameters[: len(node.arguments)])
        self.keywords(node, node.name, given, function.parameters)
        given |= {keyword.name for keyword in node.keywords}
        self.missing(node, node.name, [one for one in function.parameters if one not in given])

    def library_call(self, node: Call) -> None:
        counts = _argument_counts(node.name)
        least, most = min(counts), max(counts)
        number = len(node.arguments)
        if number < least or (node.name not in _OPEN_ENDED and number > most):
            wanted = _count(least, "argument") if least == most else f"{least} to {most} arguments"
            if node.name in _OPEN_ENDED:
                wanted = f"at least {_count(least, 'argument')}"
            self.report("argument-count", f"`{node.name}` takes {wanted}, not {number}", node.span)
        elif node.keywords and node.name not in BUILTINS:
            message = f"`{node.name}` has no argument `{node.keywords[0].name}`"
            self.report("unknown-argument", message, node.keywords[0].span)

    def unknown_function(self, node: Call) -> None:
        if node.name in self.findings.skills:
            advice = f"the robot's skill is called `function.{node.name}(...)`"
        elif node.name == "robot":
            advice = "`robot(...)` stands before everything else"
        else:
            skill = did_you_mean(node.name, self.findings.skills)
            own = did_you_mean(node.name, [*self.findings.functions, *FUNCTIONS])
            advice = own or skill.replace("`", "`function.", 1) or f"write a `def {node.name}`"
        message = f"`{node.name}`: there is no such function; {advice}"
        self.report("unknown-function", message, node.span)


def _constant(node: Expression) -> float | str | None:
    """A number or a text that is written out."""
    match node:
        case String(value=text):
            return text
        case Number(text=spelled):
            return value_of(spelled)
        case Unary(operator="-", operand=Number(text=spelled)):
            value = value_of(spelled)
            return None if value is None else -value
    return None


def _argument_counts(name: str) -> list[int]:
    if name == "elapsedTime":
        return [1]
    if name in BUILTINS:
        least, most = BUILTINS[name]
        return [least, least if most is None else most]
    return [count for known, count in TEMPLATES if known == name]


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")
