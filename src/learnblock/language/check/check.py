"""Check a program that could be parsed: names, arguments, devices, likely slips."""

from collections.abc import Mapping
from operator import attrgetter

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.importable import Importable
from learnblock.errors import Diagnostic
from learnblock.i18n import Phrase
from learnblock.language.check.call_checker import CallChecker
from learnblock.language.check.findings import Findings, python_error
from learnblock.language.check.python_checker import check_python
from learnblock.language.check.type_checker import check_types
from learnblock.language.check.variable_checker import check_variables
from learnblock.language.python.syntax_errors import syntax_message
from learnblock.language.tree.nodes import (
    Activate,
    Blank,
    Body,
    Break,
    Comment,
    Continue,
    Deactivate,
    Def,
    ForEach,
    ForRange,
    If,
    Import,
    Item,
    Number,
    Pass,
    Program,
    Raw,
    Repeat,
    Return,
    SkillCall,
    String,
    Unary,
    When,
    While,
    is_only_raw,
)
from learnblock.language.tree.traversal import bodies, within

# CPython allows fewer than 100 levels of indentation, and 20 loops inside each other.
MAX_INDENTATION = 99
MAX_LOOPS = 20

_LOOPS = (While, Repeat, ForEach, ForRange)
_JUMPS = (Break, Continue, Return)


def check(
    program: Program,
    skills: Mapping[str, BlockConfiguration],
    devices: frozenset[str] | None = None,
    importable: Importable | None = None,
    *,
    python: str | None = None,
) -> list[Diagnostic]:
    """Find the errors and likely mistakes of a program without running it, in source order.

    Args:
        program: the tree.
        skills: the skills of the robot, by name.
        devices: the devices of the chosen robot, as ``Type:KEY``; None if no robot is chosen.
        importable: the modules that an ``import`` can name; None if unknown.
        python: the text of the program, if its author wrote Python.
    """
    findings = Findings(program, skills, devices, importable, in_python=python is not None)
    if _is_only_raw(program):
        findings.diagnostics.extend(_raw_problems(program))
    else:
        _Checker(findings).run()
    if python is not None:
        check_python(python, findings)
    found = sorted(findings.diagnostics, key=attrgetter("line", "column"))
    return list(dict.fromkeys(found))


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

    def run(self) -> None:
        self.duplicates()
        for item in self.findings.program.items:
            if isinstance(item, Def):
                self.calls.parameters = frozenset(item.parameters)
                self.block(item.body, 1, 0, within_def=True)
                self.calls.parameters = frozenset()
            elif isinstance(item, When):
                self.calls.own_expressions(item)
                self.block(item.body, 1, 0, within_def=False)
            elif isinstance(item, Import):
                self.calls.imported(item)
        self.block(self.findings.top, 0, 0, within_def=False)
        self.block(self.findings.main, 0, 0, within_def=False)
        check_variables(self.findings)
        check_types(self.findings)
        self.sensors_outside_loops()

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

    def block(self, body: tuple[Item, ...], depth: int, loops: int, *, within_def: bool) -> None:
        self.unreachable(body)
        if depth == MAX_INDENTATION + 1 and body:
            message = Phrase("check-too-many-blocks", limit=MAX_INDENTATION)
            self.report("too-deep", message, body[0].span)
        for item in body:
            self.statement(item, depth, loops, within_def=within_def)

    def statement(self, item: Item, depth: int, loops: int, *, within_def: bool) -> None:
        if isinstance(item, Comment | Blank | Pass | Import):
            return
        self.calls.own_expressions(item)
        if isinstance(item, Activate | Deactivate):
            self.activation(item)
        elif isinstance(item, Break | Continue) and not loops:
            word = type(item).__name__.lower()
            self.report("outside-loop", Phrase("check-outside-loop", word=word), item.span)
        elif isinstance(item, Return) and not within_def:
            self.report("outside-function", Phrase("check-outside-function"), item.span)
        elif isinstance(item, Raw) and (problem := _invalid_statements(item)):
            self.findings.diagnostics.append(problem)
        elif isinstance(item, ForRange):
            self.whole_numbers(item)
        if isinstance(item, _LOOPS):
            loops += 1
            if loops == MAX_LOOPS + 1:
                message = Phrase("check-too-many-loops", limit=MAX_LOOPS)
                self.report("too-deep", message, item.span)
        for body in bodies(item):
            self.block(body, depth + 1, loops, within_def=within_def)

    def unreachable(self, body: tuple[Item, ...]) -> None:
        """Report the first statement that can never be reached."""
        left: Item | None = None
        for item in body:
            if isinstance(item, Comment | Blank | Def | When):
                continue
            if left is not None:
                self.report("unreachable", _unreachable(left), item.span, "warning")
                return
            if _leaves(item):
                left = item
        if left is not None and self.findings.main and body is self.findings.top:
            main = self.findings.main[0].span
            self.report("unreachable", _unreachable(left), main, "warning")

    def activation(self, item: Activate | Deactivate) -> None:
        if item.name in self.findings.whens or item.name in self.findings.raw_names:
            return
        self.report("unknown-when", self.findings.unknown_when(item.name), item.span)

    def whole_numbers(self, item: ForRange) -> None:
        for bound in (item.start, item.stop, item.step):
            number = bound.operand if isinstance(bound, Unary) else bound
            if isinstance(number, Number) and not _is_whole(number.text):
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
                    message = Phrase("check-sensor-outside-loop", skill=called)
                    self.report("sensor-outside-loop", message, branch.span, "warning")
                    return


def _leaves(item: Item) -> bool:
    """Whether nothing that follows in the same body can ever be reached."""
    if isinstance(item, _JUMPS):
        return True
    if isinstance(item, While):
        endless = getattr(item.condition, "value", None) is True
        return endless and not _breaks(item.body)
    if isinstance(item, If) and item.otherwise is not None:
        return all(any(map(_leaves, body)) for body in bodies(item))
    return False


def _breaks(body: Body) -> bool:
    """Whether a ``break``, or raw Python that may contain one, leaves the loop of this body."""
    for item in body:
        if isinstance(item, Break | Raw):
            return True
        if not isinstance(item, _LOOPS) and any(map(_breaks, bodies(item))):
            return True
    return False


def _unreachable(left: Item) -> Phrase:
    """The message about a statement after one that never continues."""
    line = str(left.span.line)
    if isinstance(left, _JUMPS):
        word = type(left).__name__.lower()
        return Phrase("check-unreachable-after-jump", word=word, line=line)
    if isinstance(left, While):
        return Phrase("check-unreachable-after-loop", line=line)
    return Phrase("check-unreachable-after-branches", line=line)


def _is_whole(text: str) -> bool:
    try:
        int(text, 0)
    except ValueError:
        return False
    return True
