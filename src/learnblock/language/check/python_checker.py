"""Check a program that its author wrote in Python, including the parts that stay Python."""

import ast
import builtins
import re
from collections import Counter
from collections.abc import Iterable

from learnblock.blocks.source.importable import missing_import
from learnblock.errors import Severity, nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.other_names import FUNCTIONS, VALUES
from learnblock.language.check.findings import Findings, unknown
from learnblock.language.check.python_event_checker import event_slips
from learnblock.language.check.python_order_checker import early_uses
from learnblock.language.python.generation import DEFAULT_ROBOT
from learnblock.language.python.robot_import import imports_robot
from learnblock.language.python.skeleton import unusual
from learnblock.language.tree.characters import write_instead
from learnblock.language.tree.loads import bound_names, parsed
from learnblock.language.tree.nodes import Span

#: The names that every program in Python has.
PYTHON_NAMES = frozenset((*dir(builtins), "__file__", "__doc__", "__spec__", "__annotations__"))
#: With these, a program can define names that cannot be found by reading the program.
DYNAMIC = frozenset(("exec", "eval", "globals", "locals", "vars", "__import__", "setattr"))
#: Attributes of a robot that have a name similar to that of a skill.
_OF_CLIENT = frozenset(("has_extra_camera", "learn", "read", "stop", "time", "wait_until"))
#: The statements and values in which a robot is used in a wrong way.
_USES = frozenset((ast.Assign, ast.Expr, ast.If, ast.While, ast.Attribute))
_DECIMAL = re.compile(r"(\d+),(\d+)")


def check_python(text: str, findings: Findings) -> None:
    """Report the names that a program in Python uses and never sets, and slips with the robot."""
    try:
        tree = ast.parse(text.removeprefix("\ufeff"))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    _PythonChecker(text, tree, findings).run()


class _PythonChecker:
    def __init__(self, text: str, tree: ast.Module, findings: Findings) -> None:
        self.text, self.tree, self.findings = text, tree, findings
        self.nodes = list(ast.walk(tree))
        self.times_bound = Counter(bound_names(self.nodes))
        self.bound = set(self.times_bound)
        # A warning does not hide the error at its place.
        errors = [
            diagnostic for diagnostic in findings.diagnostics if diagnostic.severity == "error"
        ]
        self.told = {(error.line, error.column) for error in errors}
        self.is_other_robot = _is_other_robot(self.nodes, self.bound)
        self.callees = {id(call.func) for call in self.nodes if isinstance(call, ast.Call)}
        self.seen: set[str] = set()

    def run(self) -> None:
        for node in self.nodes:
            match node:
                case ast.ImportFrom() | ast.Import() if _lacks_module(node):
                    self.report(Phrase("python-robot-import", module=_MODULE), node)
                case ast.Assign(value=ast.Tuple(elts=[ast.Constant(), ast.Constant()])):
                    self.decimal_comma(node.value)
            if type(node) in _USES and not self.is_other_robot:
                self.use_of_robot(node)
        for slip in event_slips(self.nodes):
            self.report(slip.message, slip.node, slip.severity)
        if not self.makes_names():
            for use in early_uses(self.tree, self.bound):
                self.report(use.message, use.node)
            self.names()
            if not self.is_other_robot:
                self.skills()
            self.calls()

    def use_of_robot(self, node: ast.AST) -> None:
        match node:
            case ast.Assign():
                self.assignment(node)
            case ast.Expr(value=value) | ast.If(test=value) | ast.While(test=value):
                self.skill_without_brackets(value)
            case ast.Attribute(value=ast.Name(id="Robot"), attr=skill):
                self.robot_class(node, skill)

    def makes_names(self) -> bool:
        """Whether the program may define names that cannot be found by reading it."""
        return "*" in self.bound or any(
            isinstance(node, ast.Name) and node.id in DYNAMIC for node in self.nodes
        )

    def assignment(self, node: ast.Assign) -> None:
        match node:
            case ast.Assign(targets=[ast.Name(id="robot")], value=ast.Name(id="Robot")):
                self.report(Phrase("python-robot-not-created"), node.value)
            case ast.Assign(
                targets=[ast.Name(id="robot")], value=ast.Call(func=ast.Name(id="robot"))
            ):
                self.report(Phrase("python-robot-lower-case"), node.value)

    def decimal_comma(self, node: ast.expr) -> None:
        match = _DECIMAL.fullmatch(ast.get_source_segment(self.text, node) or "")
        if match is not None:
            instead = f"{match[1]}.{match[2]}"
            message = Phrase("blocktext-decimal-comma", found=match[0], instead=instead)
            self.report(message, node, "warning")

    def skill_without_brackets(self, node: ast.expr) -> None:
        """Report ``robot.stop_bot`` as a statement or a condition."""
        while isinstance(node, ast.UnaryOp):
            node = node.operand
        match node:
            case ast.Attribute(value=ast.Name(id="robot"), attr=skill):
                if skill in self.findings.skills:
                    message = Phrase("python-skill-without-brackets", skill=skill)
                    self.report(message, node)

    def robot_class(self, node: ast.Attribute, skill: str) -> None:
        if skill in self.findings.skills and "robot" in self.bound:
            self.report(Phrase("python-robot-class", skill=skill), node)

    def skills(self) -> None:
        """Report misspelled skills in parts that stay Python."""
        for node in self.nodes:
            match node:
                case ast.Call(func=ast.Attribute(value=ast.Name(id="robot"), attr=skill) as named):
                    self.misspelled(named, skill)

    def misspelled(self, node: ast.expr, skill: str) -> None:
        known = self.findings.skills
        if skill in known or skill in _OF_CLIENT or "Robot" not in self.bound:
            return
        near = nearest(skill, known)
        if near is not None:
            self.report(Phrase("check-unknown-skill-near", name=skill, near=near), node)

    def calls(self) -> None:
        """Report calls with other arguments than the function takes, in parts that stay Python."""
        known = {
            node.name: [argument.arg for argument in node.args.args]
            for node in self.tree.body
            if isinstance(node, ast.FunctionDef)
            and not (node.decorator_list or unusual(node.args))
            and self.times_bound[node.name] == 1
        }
        for node in self.nodes:
            match node:
                case ast.Call(func=ast.Name(id=name)) if name in known and not _unpacks(node):
                    self.arguments(node, name, known[name])

    def arguments(self, node: ast.Call, name: str, parameters: list[str]) -> None:
        given = {*parameters[: len(node.args)], *(keyword.arg for keyword in node.keywords)}
        missing = tuple(parameter for parameter in parameters if parameter not in given)
        if missing:
            message = Phrase("check-missing-argument", call=name, count=len(missing), names=missing)
            self.report(message, node)
        elif len(node.args) > len(parameters):
            first = node.args[: len(parameters)]
            message = Phrase(
                "check-too-many-arguments",
                call=name,
                most=len(parameters),
                parameters=tuple(parameters),
                given=len(node.args),
                instead=f"{name}({', '.join(map(ast.unparse, first))})",
            )
            self.report(message, node.args[len(parameters)])

    def names(self) -> None:
        owners = {
            id(node.value): node.attr for node in self.nodes if isinstance(node, ast.Attribute)
        }
        for node in self.nodes:
            if not isinstance(node, ast.Name) or not isinstance(node.ctx, ast.Load):
                continue
            if node.id in self.bound or node.id in PYTHON_NAMES or node.id in self.seen:
                continue
            self.seen.add(node.id)
            self.report(self.unknown(node, owners.get(id(node))), node)

    def unknown(self, node: ast.Name, attribute: str | None) -> Phrase:  # noqa: PLR0911 - one per slip
        """The message about a name that the program never sets."""
        name = node.id
        if name == "robot" and not self.is_other_robot:
            if "Robot" in self.bound:
                return Phrase("python-robot-not-created")
            return Phrase("python-no-robot", module=_MODULE)
        if name == "function" and attribute is not None:
            return Phrase("python-function", skill=attribute)
        if name == "end":
            return Phrase("python-end")
        if missing := missing_import(name, before_dot=attribute is not None):
            return missing
        if name in VALUES:
            return write_instead(name, VALUES[name])
        if name in self.findings.skills:
            return Phrase("check-skill-as-name", name=name, skill=self.findings.called(name))
        return self.similar(name, is_called=id(node) in self.callees)

    def similar(self, name: str, *, is_called: bool) -> Phrase:
        sort = "function" if is_called else "name"
        if is_called and name in FUNCTIONS:
            advice = Phrase("check-write", instead=f"{FUNCTIONS[name]}(...)")
            return Phrase("check-unknown-function-meant", name=name, advice=advice)
        public = (
            name_of_builtin
            for name_of_builtin in PYTHON_NAMES
            if is_called and name_of_builtin.islower()
        )
        return unknown(sort, name, nearest(name, [*self.bound, *public]))

    def report(
        self, message: Phrase, node: ast.stmt | ast.expr, severity: Severity = "error"
    ) -> None:
        start = (node.lineno, node.col_offset + 1)
        if start in self.told:
            return
        self.told.add(start)
        end = node.end_lineno or node.lineno, (node.end_col_offset or 0) + 1
        # In Block-Text, the same mistake has this code, so that the page lists it once.
        code = "without-robot" if message.code == "python-no-robot" else "python-slip"
        self.findings.report(code, message, Span(*start, *end), severity)


_MODULE = DEFAULT_ROBOT.rpartition(".")[2]


def has_other_robot(text: str) -> bool:
    """Whether a program in Python has another class Robot, such as that of gpiozero."""
    if "Robot" not in text:
        return False
    nodes = list(ast.walk(parsed(text.removeprefix("\ufeff"))))
    return _is_other_robot(nodes, bound_names(nodes))


def _is_other_robot(nodes: list[ast.AST], bound: Iterable[str]) -> bool:
    if "Robot" not in bound:
        return False
    return not any(_lacks_module(node) or imports_robot(node) for node in nodes)


def _lacks_module(node: ast.AST) -> bool:
    """Whether a statement is meant to import a robot of LearnBlock's, but without its module."""
    match node:
        case (
            ast.ImportFrom(module="learnblock", names=[ast.alias(name="Robot")])
            | ast.Import(names=[ast.alias(name="Robot")])
        ):
            return True
    return False


def _unpacks(node: ast.Call) -> bool:
    """Whether the number of a call's arguments is only known when it runs."""
    return any(isinstance(arg, ast.Starred) for arg in node.args) or any(
        keyword.arg is None for keyword in node.keywords
    )
