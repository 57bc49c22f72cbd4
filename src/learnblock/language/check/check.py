"""Check a program that could be parsed: names, arguments, devices, likely slips."""

from collections.abc import Mapping
from operator import attrgetter

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.importable import Importable
from learnblock.errors import Diagnostic
from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import state_of
from learnblock.language.check.call_checker import CallChecker
from learnblock.language.check.device_checker import check_devices
from learnblock.language.check.endings import LOOPS
from learnblock.language.check.findings import Findings, is_whole, python_error
from learnblock.language.check.flow_checker import FlowChecker
from learnblock.language.check.handled_errors import without_handled
from learnblock.language.check.plain_name_checker import check_plain_names
from learnblock.language.check.python_checker import check_python, has_other_robot
from learnblock.language.check.shared_variable_checker import check_shared_variables
from learnblock.language.check.speed_checker import check_speeds
from learnblock.language.check.type_checker import check_types
from learnblock.language.check.variable_checker import check_variables
from learnblock.language.python.syntax_errors import syntax_message
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Blank,
    Break,
    Call,
    Comment,
    Continue,
    Deactivate,
    Def,
    ForRange,
    If,
    Import,
    Item,
    Name,
    Number,
    Pass,
    Program,
    PythonBlock,
    PythonLine,
    Raw,
    Return,
    Setup,
    SkillCall,
    Span,
    String,
    Unary,
    WaitUntil,
    When,
    WithoutRobot,
    is_only_raw,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    bodies,
    statements,
    targets,
    within,
)
from learnblock.wheels import Drivetrain

# CPython allows fewer than 100 levels of indentation, and 20 loops inside each other.
MAX_INDENTATION = 99
MAX_LOOPS = 20


def check(
    program: Program,
    skills: Mapping[str, BlockConfiguration],
    equipment: frozenset[str] | None = None,
    importable: Importable | None = None,
    *,
    python: str | None = None,
    drivetrain: Drivetrain | None = None,
) -> list[Diagnostic]:
    """Find the errors and likely mistakes of a program without running it, in source order.

    Args:
        program: the tree.
        skills: the skills of the robot, by name.
        equipment: what the chosen robot has, see `learnblock.senses.equipment`; None if no robot
            is chosen.
        importable: the modules that an ``import`` can name; None if unknown.
        python: the text of the program, if its author wrote Python.
        drivetrain: what the wheels of the chosen robot can do, if known.
    """
    findings = Findings(program, skills, equipment, importable, in_python=python is not None)
    if _is_only_raw(program):
        findings.diagnostics.extend(_raw_problems(program))
    elif program.is_without_robot:
        _Checker(findings).run_without_robot()
    else:
        _Checker(findings).run()
    if not (program.is_without_robot and python is not None and has_other_robot(python)):
        check_devices(findings)
        if drivetrain is not None:
            check_speeds(findings, drivetrain)
    if python is not None:
        check_python(python, findings)
    mistakes = without_handled(findings.diagnostics, findings.everything)
    diagnostics = sorted(mistakes, key=attrgetter("line", "column"))
    return list(dict.fromkeys(diagnostics))


def _is_only_raw(program: Program) -> bool:
    return program.main is None and is_only_raw(program.items)


def _raw_problems(program: Program) -> list[Diagnostic]:
    return [
        problem
        for item in program.items
        if isinstance(item, Raw) and (problem := _invalid_statements(item))
    ]


def _invalid_statements(node: Raw) -> Diagnostic | None:
    error = python_error(node.text, "exec")
    if error is None:
        return None
    line = node.span.line + (error.lineno or 1)
    return Diagnostic("invalid-python", syntax_message(error, node.text), line)


class _Checker:
    """Walks through the statements of a program."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.report = findings.report
        self.calls = CallChecker(findings)
        self.flow = FlowChecker(findings)

    def run(self) -> None:
        self.duplicates()
        self.values_of_events()
        for item in self.findings.program.items:
            if isinstance(item, Def):
                self.calls.parameters = frozenset(item.parameters)
                self.block(item.body, 1, 0, within_def=True)
                self.calls.parameters = frozenset()
            elif isinstance(item, When):
                self.calls.own_expressions(item)
                self.block(item.body, 1, 0, within_def=True)
            elif isinstance(item, Import):
                self.calls.imported(item)
        self.block(self.findings.top, 0, 0, within_def=False)
        self.block(self.findings.main, 0, 0, within_def=False)
        check_variables(self.findings)
        check_shared_variables(self.findings)
        check_types(self.findings)
        self.flow.run()
        self.sensors_outside_loops()

    def run_without_robot(self) -> None:
        """Check only what is certain without a robot: an imported module may define anything."""
        for item in self.findings.everything:
            if isinstance(item, AnyPython):
                self.python(item)
        check_shared_variables(self.findings)
        if self.findings.in_python:
            # The check of Python's names says where the robot's two lines belong, too.
            return
        check_plain_names(self.findings)
        use = next(filter(_uses_robot, self.findings.everything), None)
        if use is not None:
            self.report("without-robot", Phrase("check-without-robot"), use.span)

    def duplicates(self) -> None:
        variables = self.findings.assigned - self.findings.raw_names
        seen: dict[str, Def | When] = {}
        for item in self.findings.program.items:
            if not isinstance(item, Def | When):
                continue
            word = "def" if isinstance(item, Def) else "when"
            before = seen.get(f"{word} {item.name}")
            if before is not None:
                message = Phrase(
                    "check-defined-twice", word=word, name=item.name, line=str(before.span.line)
                )
                self.report("duplicate-name", message, item.span)
            seen[f"{word} {item.name}"] = item
            if isinstance(item, Def) and item.name in variables:
                message = Phrase("check-function-and-variable", name=item.name)
                self.report("duplicate-name", message, item.span)

    def values_of_events(self) -> None:
        """Report variables and parameters that have the name of an event's state or time."""
        for item in self.findings.everything:
            place = {target.name: target.span for target in targets(item)}
            for name in _used_parameters(item) if isinstance(item, Def) else place:
                state = state_of(name, self.findings.whens.keys())
                if state is not None:
                    self.value_of_event(name, *state, place.get(name, item.span))

    def value_of_event(self, name: str, event: str, value: str, span: Span) -> None:
        code = self.findings.worded("check-value-of-event", "check-value-of-event-python")
        message = Phrase(code, name=name, event=event, value=value)
        self.report("value-of-event", message, span)

    def block(self, body: tuple[Item, ...], depth: int, loops: int, *, within_def: bool) -> None:
        self.flow.unreachable(body)
        if depth == MAX_INDENTATION + 1 and body:
            message = Phrase("check-too-many-blocks", limit=MAX_INDENTATION)
            self.report("too-deep", message, body[0].span)
        for item in body:
            self.statement(item, depth, loops, within_def=within_def)

    def statement(self, item: Item, depth: int, loops: int, *, within_def: bool) -> None:
        if isinstance(item, Comment | Blank | Pass | Import | WithoutRobot):
            return
        self.calls.own_expressions(item)
        self.calls.unused(item)
        if isinstance(item, Activate | Deactivate):
            self.activation(item)
        elif isinstance(item, Break | Continue) and not loops:
            word = type(item).__name__.lower()
            self.report("outside-loop", Phrase("check-outside-loop", word=word), item.span)
        elif isinstance(item, Return) and not within_def:
            self.report("outside-function", Phrase("check-outside-function"), item.span)
        elif isinstance(item, AnyPython):
            self.python(item)
        elif isinstance(item, ForRange):
            self.whole_numbers(item)
        if isinstance(item, PythonBlock):
            loops = 0 if item.has_scope else loops
            within_def = within_def or item.defers
        if isinstance(item, LOOPS) or (isinstance(item, PythonBlock) and item.is_loop):
            loops += 1
            self.loops(item, loops)
        for body in bodies(item):
            self.block(body, depth + 1, loops, within_def=within_def)

    def loops(self, item: Item, depth: int) -> None:
        if depth == MAX_LOOPS + 1:
            message = Phrase("check-too-many-loops", limit=MAX_LOOPS)
            self.report("too-deep", message, item.span)

    def python(self, item: AnyPython) -> None:
        """Report what is no Python."""
        if isinstance(item, Raw):
            self.findings.diagnostics += filter(None, [_invalid_statements(item)])
            return
        is_decorator = isinstance(item, PythonLine) and item.text.startswith("@")
        error = python_error(item.text + ("\nclass _: pass" if is_decorator else ""), "exec")
        if error is not None:
            message = syntax_message(error, item.text)
            self.report("invalid-python", message, item.span._replace(end_column=0))

    def activation(self, item: Activate | Deactivate) -> None:
        if item.name in self.findings.raw_names:
            return
        if item.name in self.findings.whens:
            self.activation_of_condition(item)
            return
        self.report("unknown-when", self.findings.unknown_when(item.name), item.span)

    def activation_of_condition(self, item: Activate | Deactivate) -> None:
        """Report a change of an event that its condition undoes in the next cycle.

        Both together start its time again.
        """
        statements = self.findings.everything
        changes = [
            statement for statement in statements if isinstance(statement, Activate | Deactivate)
        ]
        alone = {type(change) for change in changes if change.name == item.name} == {type(item)}
        if alone and self.findings.whens[item.name].condition is not None:
            code = self.findings.worded("check-follows-condition", "check-follows-condition-python")
            word = type(item).__name__.lower()
            message = Phrase(code, name=item.name, word=word)
            self.report("follows-condition", message, item.span, "warning")

    def whole_numbers(self, item: ForRange) -> None:
        for bound in (item.start, item.stop, item.step):
            number = bound.operand if isinstance(bound, Unary) else bound
            if isinstance(number, Number) and not is_whole(number.text):
                message = Phrase("check-whole-number", number=number.text)
                self.report("wrong-type", message, number.span)
            elif isinstance(bound, String):
                self.report("wrong-type", Phrase("check-text-for-number"), bound.span)
            elif bound is item.step and isinstance(number, Number) and not int(number.text, 0):
                self.report("wrong-type", Phrase("check-step-zero"), number.span)

    def sensors_outside_loops(self) -> None:
        """Report an ``if`` on a sensor outside any loop: it checks once, rarely the intention."""
        for item in (*self.findings.program.items, *self.findings.main):
            if isinstance(item, If):
                self.sensor_outside_loop(item)

    def sensor_outside_loop(self, item: If) -> None:
        for branch in item.branches:
            for node in within(branch.condition):
                skill = self.findings.skills.get(node.name) if isinstance(node, SkillCall) else None
                if skill is not None and skill.type == "perceptual":
                    called = self.findings.called(skill.name)
                    code = self.findings.worded(
                        "check-sensor-outside-loop", "check-sensor-outside-loop-python"
                    )
                    message = Phrase(code, skill=called)
                    self.report("sensor-outside-loop", message, branch.span, "warning")
                    return


def _uses_robot(item: Item) -> bool:
    if isinstance(item, When | Activate | Deactivate | Setup | WaitUntil):
        return True
    calls = (node for node in all_expressions(item) if isinstance(node, Call | SkillCall))
    return any(isinstance(call, SkillCall) or call.name == "elapsedTime" for call in calls)


def _used_parameters(function: Def) -> list[str]:
    """The parameters that the body of a function reads."""
    read = {
        node.name
        for item in statements(function.body)
        for node in all_expressions(item)
        if isinstance(node, Name)
    }
    return [name for name in function.parameters if name in read]
