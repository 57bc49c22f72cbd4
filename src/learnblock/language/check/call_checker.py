"""Check calls: whether the function exists and fits the arguments."""

from collections.abc import Iterable, Mapping
from itertools import pairwise

from learnblock.blocks import NUMBERS, BlockConfiguration, Parameter
from learnblock.blocks.old_names import todays_name
from learnblock.errors import nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import state_of
from learnblock.language.blocktext.other_names import FUNCTIONS as OTHER_FUNCTIONS
from learnblock.language.blocktext.other_names import (
    FUNCTIONS_AS_SKILLS,
    MOVE_STRAIGHT,
    SKILLS,
    SKILLS_WITH_VALUE,
)
from learnblock.language.check.findings import Findings, constant, python_error, unknown
from learnblock.language.python.syntax_errors import syntax_message
from learnblock.language.tree.builtins import BUILTINS, FUNCTIONS, TEMPLATES
from learnblock.language.tree.nodes import (
    Call,
    Def,
    Expression,
    Import,
    Item,
    Name,
    Number,
    Perform,
    RawExpression,
    SkillCall,
    Span,
    String,
)
from learnblock.language.tree.traversal import all_expressions
from learnblock.numerals import shown

# Quarter turns and their multiples.
_ANGLES = frozenset((90, 180, 270, 360))
#: From here on, a number of seconds was meant in milliseconds.
_MILLISECONDS = 100
#: The functions that are written as statements of their own.
_STATEMENTS = frozenset(
    (
        *("print", "input", "append", "extend", "insert", "remove", "pop", "clear", "sort"),
        *("reverse", "shuffle", "elapsedTime"),
    )
)
_OPEN_ENDED = frozenset(name for name, (_, most) in BUILTINS.items() if most is None)


class CallChecker:
    """Checks each expression on its own."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.report = findings.report
        self.parameters: frozenset[str] = frozenset()  # those of the checked function

    def own_expressions(self, item: Item) -> None:
        """Check the expressions of a statement, except those in its bodies."""
        for node in all_expressions(item):
            self.expression(node)

    def expression(self, node: Expression) -> None:
        if isinstance(node, SkillCall):
            self.skill_call(node)
        elif isinstance(node, Call):
            self.call(node)
        elif isinstance(node, Name):
            self.state(node)
        elif isinstance(node, RawExpression):
            text = node.text.strip()
            error = python_error(text, "eval")
            if error is not None:
                self.report("invalid-python", syntax_message(error, text), node.span)

    def state(self, node: Name) -> None:
        """Report ``state_X`` and ``time_X`` of a ``when`` that does not exist."""
        prefix, _, name = node.name.partition("_")
        if prefix not in {"state", "time"} or not name or self.is_known(node.name):
            return
        if state_of(node.name, self.findings.whens.keys()) is None:
            self.report("unknown-when", self.findings.unknown_when(name), node.span)

    def is_known(self, name: str) -> bool:
        return name in self.findings.assigned or name in self.parameters

    def imported(self, node: Import) -> None:
        """Report an ``import`` of a library that does not exist."""
        importable = self.findings.importable
        if importable is None or node.module in importable:
            return
        name, known = node.module, tuple(importable.names)
        near = nearest(name, known)
        if near is not None:
            message = Phrase("check-unknown-library-near", name=name, near=near)
        elif known:
            message = Phrase("check-unknown-library", name=name, known=known)
        else:
            message = Phrase("check-no-libraries", name=name)
        self.report("unknown-library", message, node.span)

    def unused(self, item: Item) -> None:
        """Report a question as a statement of its own: nothing uses its answer."""
        if not isinstance(item, Perform):
            return
        node = item.call
        if isinstance(node, SkillCall):
            skill = self.findings.skills.get(node.name)
            is_question = skill is not None and not skill.library and skill.returns_value
            call = self.findings.called(node.name)
        else:
            is_plain = node.name in FUNCTIONS and self.findings.is_of_language(node.name)
            is_question, call = is_plain and node.name not in _STATEMENTS, node.name
        if is_question:
            message = Phrase("check-unused-answer", call=call, spelled=f"{call}(...)")
            self.report("unused-answer", message, node.span, "warning")

    def skill_call(self, node: SkillCall) -> None:
        skill = self.findings.skills.get(node.name)
        if skill is None:
            self.unknown_skill(node)
            return
        if skill.library and skill.library not in self.findings.imported:
            self.not_imported(node, skill)
        self.arguments(node, skill)

    def not_imported(self, node: SkillCall, skill: BlockConfiguration) -> None:
        message = Phrase("check-not-imported", skill=node.name, library=skill.library)
        self.report("not-imported", message, node.span)

    def unknown_skill(self, node: SkillCall) -> None:
        if node.name == "wait_until":
            # In Python it is a method of the robot that takes a function.
            if not self.findings.in_python:
                self.report("unknown-skill", Phrase("check-wait-until"), node.span)
            return
        self.report("unknown-skill", self.unknown_skill_message(node), node.span)

    def unknown_skill_message(self, node: SkillCall) -> Phrase:
        name = node.name
        if name in self.findings.functions:
            return Phrase("check-function-as-skill", name=name)
        if reason := self.findings.broken.get(name):
            return Phrase("check-skill-with-error", name=name, reason=reason)
        skills = self.findings.skills
        near = todays_name(name, skills)
        if near is None and (meant := self.meant(SKILLS, node)) is not None:
            return Phrase("check-unknown-skill-meant", name=name, advice=self.advice(meant))
        return unknown("skill", name, near or nearest(name, skills))

    def meant(self, names: Mapping[str, str], node: Call | SkillCall) -> str | None:
        """Our skill call for one of another language, with its value if there is one."""
        call = self.with_value(node) or names.get(node.name)
        known = call is not None and call.partition("(")[0] in self.findings.skills
        return self.findings.called(call) if call is not None and known else None

    def with_value(self, node: Call | SkillCall) -> str | None:
        call = SKILLS_WITH_VALUE.get(node.name)
        if call is None or len(node.arguments) != 1 or node.keywords:
            return None
        number = constant(node.arguments[0])
        if isinstance(number, int | float):
            if call.startswith("sleep") and number >= _MILLISECONDS:
                number /= 1000
            return call.format(shown(number)).replace("--", "")
        value = self.findings.spelled(node.arguments[0])
        return None if value.endswith(("...", "...)")) else call.format(value)

    def advice(self, call: str) -> Phrase:
        """The advice to write a call, which may need another one that ends what it begins."""
        if call != self.findings.called(MOVE_STRAIGHT):
            return Phrase("check-write", instead=call)
        sleep, stop = self.findings.called("sleep(2)"), self.findings.called("stop_bot()")
        return Phrase("check-keeps-driving", instead=call, sleep=sleep, stop=stop)

    def arguments(self, node: SkillCall, skill: BlockConfiguration) -> None:
        parameters = skill.parameters
        call = self.findings.called(node.name)
        self.too_many(node, call, tuple(parameter.name for parameter in parameters))
        given = {parameter.name for parameter in parameters[: len(node.arguments)]}
        known = {parameter.name: parameter for parameter in parameters}
        self.keywords(node, call, given, known.keys())
        given |= {keyword.name for keyword in node.keywords}
        missing = [
            parameter.name
            for parameter in parameters
            if parameter.required and parameter.name not in given
        ]
        self.missing(node, call, missing)
        for parameter, value in zip(parameters, node.arguments, strict=False):
            self.type_of(call, parameter, value)
        for keyword in node.keywords:
            if keyword.name in known:
                self.type_of(call, known[keyword.name], keyword.value)

    def too_many(self, node: Call | SkillCall, call: str, parameters: tuple[str, ...]) -> None:
        if len(node.arguments) <= len(parameters):
            return
        if (decimal := _decimal_comma(node.arguments)) is not None:
            message, span = decimal
            self.report("argument-count", message, span)
        else:
            message = Phrase(
                "check-too-many-arguments",
                call=call,
                most=len(parameters),
                parameters=parameters,
                given=len(node.arguments),
                instead=self.without_rest(node, call, len(parameters)),
            )
            self.report("argument-count", message, node.arguments[len(parameters)].span)

    def without_rest(self, node: Call | SkillCall, call: str, most: int) -> str:
        """A call with its first arguments, which leave no parameter for a named one."""
        return f"{call}({', '.join(map(self.findings.spelled, node.arguments[:most]))})"

    def keywords(
        self, node: Call | SkillCall, call: str, given: set[str], known: Iterable[str]
    ) -> None:
        for keyword in node.keywords:
            if keyword.name not in known:
                message = _unknown_argument(call, keyword.name, tuple(known))
                self.report("unknown-argument", message, keyword.span)
            elif keyword.name in given:
                message = Phrase("blocktext-duplicate-argument", name=keyword.name)
                self.report("duplicate-argument", message, keyword.span)

    def missing(self, node: Call | SkillCall, call: str, names: list[str]) -> None:
        if names:
            message = Phrase(
                "check-missing-argument", call=call, count=len(names), names=tuple(names)
            )
            self.report("missing-argument", message, node.span)

    def type_of(self, call: str, parameter: Parameter, value: Expression) -> None:
        if parameter.type in NUMBERS and isinstance(value, String):
            message = Phrase("check-number-expected", call=call, parameter=parameter.name)
            plain = value.value.strip()
            if plain.replace(".", "", 1).lstrip("-").isdecimal():
                message = Phrase(
                    "check-number-in-quotes", call=call, parameter=parameter.name, number=plain
                )
            self.report("wrong-type", message, value.span)
            return
        given = constant(value)
        # `turn` has both, an angle and then a speed.
        if parameter.name == "rotSpeed" and given in _ANGLES and not call.endswith(".turn"):
            self.speed_as_angle(call, given, value)
        elif call.endswith(".sleep") and isinstance(given, int | float) and given < 0:
            message = Phrase("check-negative-wait", seconds=repr(given).removesuffix(".0"))
            self.report("unusual-value", message, value.span)
        elif given is not None and parameter.objection(given):
            message = _unusual_value(call, parameter, repr(given).removesuffix(".0"))
            self.report("unusual-value", message, value.span, "warning")

    def speed_as_angle(self, call: str, angle: object, value: Expression) -> None:
        """Report ``turn_left(90)``, which does not turn by 90 degrees."""
        sign = "-" if call.endswith("_left") else ""
        turn = f"{self.findings.called('turn')}({sign}{angle:g})"
        side = "left" if sign else "right"
        message = Phrase(
            "check-speed-as-angle", call=call, speed=f"{angle:g}", turn=turn, side=side
        )
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
        self.missing(node, node.name, [name for name in function.parameters if name not in given])

    def library_call(self, node: Call) -> None:
        counts = _argument_counts(node.name)
        number = len(node.arguments)
        most = None if node.name in _OPEN_ENDED else max(counts)
        if number < min(counts) or (most is not None and number > most):
            message = _argument_count(node.name, min(counts), most, number)
            self.report("argument-count", message, node.span)
        elif node.keywords and node.name not in BUILTINS:
            message = Phrase("check-no-named-arguments", call=node.name, name=node.keywords[0].name)
            self.report("unknown-argument", message, node.keywords[0].span)

    def unknown_function(self, node: Call) -> None:
        unknown_range = node.name == "range" and node.name not in self.findings.skills
        message = _counting(node) if unknown_range else self.unknown_function_message(node)
        self.report("unknown-function", message, node.span)

    def unknown_function_message(self, node: Call) -> Phrase:
        name = node.name
        if name in self.findings.skills:
            return Phrase("check-skill-as-name", name=name, skill=self.findings.called(name))
        if name == "robot":
            return Phrase("check-robot-not-first")
        if (instead := self.function_meant(node)) is not None:
            return Phrase("check-unknown-function-meant", name=name, advice=self.advice(instead))
        return unknown("function", name, self.similar_function(name))

    def function_meant(self, node: Call) -> str | None:
        """Our call for a function name from another language."""
        if node.name in OTHER_FUNCTIONS:
            return f"{OTHER_FUNCTIONS[node.name]}(...)"
        return self.meant(FUNCTIONS_AS_SKILLS, node)

    def similar_function(self, name: str) -> str | None:
        skills = self.findings.skills
        if (today := todays_name(name, skills)) is not None:
            return self.findings.called(today)
        near = nearest(name, [*self.findings.functions, *FUNCTIONS])
        if near is None and (skill := nearest(name, skills)) is not None:
            return self.findings.called(skill)
        return near


def _counting(node: Call) -> Phrase:
    """The message about ``range(4)``, with the loops that it means or an example of them."""
    spelled = [argument.text for argument in node.arguments if isinstance(argument, Number)]
    whole = [int(text) for text in spelled if text.isdecimal()]
    first, end = 0, 4
    if 1 <= len(whole) == len(node.arguments) <= 2 and [0, *whole][-2] < whole[-1]:
        first, end = [0, *whole][-2:]
    return Phrase("check-range", count=str(end - first), first=str(first), last=str(end - 1))


def _decimal_comma(arguments: tuple[Expression, ...]) -> tuple[Phrase, Span] | None:
    """The message about ``0,5`` among arguments, and where it is."""
    for left, other in pairwise(arguments):
        if not (isinstance(left, Number) and isinstance(other, Number)):
            continue
        first, last = left.span, other.span
        if last.column == first.end_column + 1 and (left.text + other.text).isdecimal():
            written, instead = f"{left.text},{other.text}", f"{left.text}.{other.text}"
            message = Phrase("blocktext-decimal-comma", found=written, instead=instead)
            return message, first._replace(end_column=last.end_column)
    return None


def _argument_counts(name: str) -> list[int]:
    if name == "elapsedTime":
        return [1]
    if name in BUILTINS:
        least, most = BUILTINS[name]
        return [least, least if most is None else most]
    return [count for known, count in TEMPLATES if known == name]


def _argument_count(call: str, least: int, most: int | None, given: int) -> Phrase:
    """The message about a call with too few or too many arguments."""
    if most is None:
        return Phrase("check-too-few-arguments", call=call, least=least, given=given)
    if least == most:
        return Phrase("check-argument-count", call=call, count=least, given=given)
    return Phrase("check-argument-range", call=call, least=least, most=most, given=given)


def _unknown_argument(call: str, name: str, known: tuple[str, ...]) -> Phrase:
    near = nearest(name, known)
    if near is not None:
        return Phrase("check-unknown-argument-near", call=call, name=name, near=near)
    if known:
        return Phrase("check-unknown-argument", call=call, name=name, known=known)
    return Phrase("check-no-arguments", call=call)


def _unusual_value(call: str, parameter: Parameter, value: str) -> Phrase:
    """The message about a constant that the field of a parameter does not offer."""
    name = parameter.name
    if parameter.type == "choice":
        return _unknown_choice(call, parameter, value)
    if parameter.range is None:
        return Phrase("check-not-a-colour", call=call, parameter=name, value=value)
    least, most = parameter.range.least, parameter.range.most
    return Phrase(
        "check-outside-range", call=call, parameter=name, value=value, least=least, most=most
    )


def _unknown_choice(call: str, parameter: Parameter, value: str) -> Phrase:
    about = {"call": call, "parameter": parameter.name, "value": value}
    choices = tuple(map(repr, parameter.choices))
    near = nearest(value, choices)
    if near is not None:
        return Phrase("check-unknown-choice-near", **about, near=near)
    return Phrase("check-unknown-choice", **about, choices=choices)
