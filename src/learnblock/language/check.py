"""What is wrong with a program that can be read: names, arguments, devices, likely slips."""

import ast
from collections.abc import Iterable, Iterator, Mapping

from learnblock.blocks.configuration import BlockConfiguration, Parameter
from learnblock.errors import Diagnostic, Severity, did_you_mean
from learnblock.language import markers
from learnblock.language.library import BUILTINS, FUNCTIONS, TEMPLATES
from learnblock.language.names import state_of
from learnblock.language.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Break,
    Call,
    Comment,
    Continue,
    Deactivate,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Item,
    Main,
    Name,
    Number,
    Pass,
    Program,
    Raw,
    RawExpression,
    Repeat,
    Return,
    Setup,
    SkillCall,
    Span,
    String,
    Unary,
    When,
    While,
    bodies,
    expressions,
    set_by,
    statements,
    within,
)

# CPython allows fewer than 100 levels of indentation, and 20 loops inside each other.
MAX_INDENTATION = 99
MAX_LOOPS = 20

_LOOPS = (While, Repeat, ForEach, ForRange)
_JUMPS = (Break, Continue, Return)
_SPELLINGS = {
    "true": "True",
    "false": "False",
    "none": "None",
    "null": "None",
    "nil": "None",
    "TRUE": "True",
    "FALSE": "False",
    "NONE": "None",
}


def check(
    program: Program,
    skills: Mapping[str, BlockConfiguration],
    devices: frozenset[str] | None = None,
) -> list[Diagnostic]:
    """All that can be said of a program without running it, in order of the text.

    Args:
        program: the tree.
        skills: what ``function.`` offers, by name.
        devices: what the chosen robot has, as ``Type:KEY``; None where no robot is chosen.
    """
    if _is_only_raw(program):
        return _raw_problems(program)
    checker = _Checker(program, skills, devices)
    checker.run()
    found = sorted(checker.diagnostics, key=lambda diagnostic: (diagnostic.line, diagnostic.column))
    return list(dict.fromkeys(found))


def _is_only_raw(program: Program) -> bool:
    return len(program.items) == 1 and program.main is None and isinstance(program.items[0], Raw)


def _raw_problems(program: Program) -> list[Diagnostic]:
    return [
        problem
        for item in program.items
        if isinstance(item, Raw) and (problem := _invalid_statements(item))
    ]


def _invalid_statements(node: Raw) -> Diagnostic | None:
    error = _python_error(node.text, "exec")
    if error is None:
        return None
    line = node.span.line + (error.lineno or 1)
    return Diagnostic("invalid-python", f"this is not Python: {error.msg}", line)


def _python_error(text: str, mode: str) -> SyntaxError | None:
    import warnings  # noqa: PLC0415 - wanted by raw Python only

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "", mode, ast.PyCF_ONLY_AST)
    except SyntaxError as error:
        return error
    except (ValueError, RecursionError, MemoryError) as error:
        return SyntaxError(str(error))
    return None


def _quoted(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")


class _Checker:
    def __init__(
        self,
        program: Program,
        skills: Mapping[str, BlockConfiguration],
        devices: frozenset[str] | None,
    ) -> None:
        self.program, self.skills, self.devices = program, skills, devices
        self.diagnostics: list[Diagnostic] = []
        self.functions = program.functions
        self.whens = program.whens
        self.top = tuple(item for item in program.items if not isinstance(item, Def | When))
        self.main: Body = () if program.main is None else program.main.body
        self.everything = list(statements(program.items + self.main))
        self.imports = any(isinstance(item, Import) for item in program.items)
        self.raw_names = self.names_in_raw()
        self.assigned = self.assigned_anywhere()
        self.parameters: frozenset[str] = frozenset()  # of the function that is being checked

    def names_in_raw(self) -> set[str]:
        found: set[str] = set()
        for item in self.everything:
            if isinstance(item, Raw):
                found |= markers.raw_names(item.text) | _defined_names(item.text)
        return found

    def assigned_anywhere(self) -> set[str]:
        found = set(self.raw_names)
        for item in self.everything:
            if (name := set_by(item)) is not None:
                found.add(name)
        return found

    def report(self, code: str, message: str, span: Span, severity: Severity = "error") -> None:
        end = span.end_column if span.end_line == span.line else 0
        self.diagnostics.append(Diagnostic(code, message, span.line, span.column, end, severity))

    def run(self) -> None:
        self.duplicates()
        for item in self.program.items:
            if isinstance(item, Def):
                self.parameters = frozenset(item.parameters)
                self.block(item.body, 1, 0, within_def=True)
                self.parameters = frozenset()
            elif isinstance(item, When):
                self.own_expressions(item)
                self.block(item.body, 1, 0, within_def=False)
        self.block(self.top, 0, 0, within_def=False)
        self.block(self.main, 0, 0, within_def=False)
        self.unset_variables()
        self.unseen_sensors()

    def duplicates(self) -> None:
        seen: dict[str, Def | When] = {}
        for item in self.program.items:
            if not isinstance(item, Def | When):
                continue
            word = "def" if isinstance(item, Def) else "when"
            before = seen.get(f"{word} {item.name}")
            if before is not None:
                message = (
                    f"there are two `{word} {item.name}`, the first in line {before.span.line}: "
                    "rename one or join them"
                )
                self.report("duplicate-name", message, item.span)
            seen[f"{word} {item.name}"] = item
            if isinstance(item, Def) and item.name in self.assigned - self.raw_names:
                message = f"`{item.name}` is a function and a variable: rename one"
                self.report("duplicate-name", message, item.span)

    # Statements.

    def block(self, body: tuple[Item, ...], depth: int, loops: int, *, within_def: bool) -> None:
        self.unreachable(body)
        if depth == MAX_INDENTATION + 1 and body:
            message = (
                f"more than {MAX_INDENTATION} blocks inside each other are too many for Python: "
                "use a function of your own"
            )
            self.report("too-deep", message, body[0].span)
        for item in body:
            self.statement(item, depth, loops, within_def=within_def)

    def statement(self, item: Item, depth: int, loops: int, *, within_def: bool) -> None:
        if isinstance(item, Comment | Blank | Pass | Import):
            return
        self.own_expressions(item)
        if isinstance(item, Activate | Deactivate):
            self.activation(item)
        elif isinstance(item, Break | Continue) and not loops:
            word = type(item).__name__.lower()
            self.report("outside-loop", f"`{word}` works only inside a loop", item.span)
        elif isinstance(item, Return) and not within_def:
            self.report("outside-function", "`return` works only inside a `def`", item.span)
        elif isinstance(item, Raw) and (problem := _invalid_statements(item)):
            self.diagnostics.append(problem)
        elif isinstance(item, ForRange):
            self.whole_numbers(item)
        if isinstance(item, _LOOPS):
            loops += 1
            if loops == MAX_LOOPS + 1:
                message = f"more than {MAX_LOOPS} loops inside each other are too many for Python"
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
                reason = _reason(left)
                message = f"this is never reached: {reason} in line {left.span.line}"
                self.report("unreachable", message, item.span, "warning")
                return
            if _leaves(item):
                left = item
        if left is not None and self.main and body is self.top:
            message = f"this is never reached: {_reason(left)} in line {left.span.line}"
            self.report("unreachable", message, self.main[0].span, "warning")

    def activation(self, item: Activate | Deactivate) -> None:
        if item.name in self.whens or item.name in self.raw_names:
            return
        hint = did_you_mean(item.name, self.whens) or _write_one(item.name)
        word = "activate" if isinstance(item, Activate) else "deactivate"
        message = f"`{word} {item.name}`: there is no `when {item.name}`; {hint}"
        self.report("unknown-when", message, item.span)

    def whole_numbers(self, item: ForRange) -> None:
        for bound in (item.start, item.stop, item.step):
            number = bound.operand if isinstance(bound, Unary) else bound
            if isinstance(number, Number) and not _is_whole(number.text):
                message = f"`{number.text}`: `for ... from ... to` counts in whole numbers"
                self.report("wrong-type", message, number.span)
            elif isinstance(bound, String):
                self.report("wrong-type", "this is a text; a number is needed", bound.span)
            elif bound is item.step and isinstance(number, Number) and not int(number.text, 0):
                self.report("wrong-type", "with `step 0` the loop would never end", number.span)

    # Expressions.

    def own_expressions(self, item: Item) -> None:
        for expression in expressions(item):
            for node in within(expression):
                self.expression(node)
        if isinstance(item, Setup):
            return

    def expression(self, node: Expression) -> None:
        if isinstance(node, SkillCall):
            self.skill_call(node)
        elif isinstance(node, Call):
            self.call(node)
        elif isinstance(node, Name):
            self.state(node)
        elif isinstance(node, RawExpression):
            error = _python_error(node.text.strip(), "eval")
            if error is not None:
                self.report("invalid-python", f"this is not Python: {error.msg}", node.span)

    def state(self, node: Name) -> None:
        """``state_X`` and ``time_X`` of a ``when`` that does not exist."""
        prefix, _, name = node.name.partition("_")
        if prefix not in {"state", "time"} or not name or self.is_known(node.name):
            return
        if state_of(node.name, self.whens.keys()) is None:
            hint = did_you_mean(name, self.whens) or _write_one(name)
            message = f"`{node.name}`: there is no `when {name}`; {hint}"
            self.report("unknown-when", message, node.span)

    def is_known(self, name: str) -> bool:
        return name in self.assigned or name in self.parameters

    def skill_call(self, node: SkillCall) -> None:
        skill = self.skills.get(node.name)
        if skill is None:
            self.unknown_skill(node)
            return
        self.arguments(node, skill)
        if self.devices is not None and (missing := skill.lacks(self.devices)):
            self.missing_devices(node, skill, missing)

    def unknown_skill(self, node: SkillCall) -> None:
        if node.name in self.functions:
            advice = f"`{node.name}` is a function of your own: call it without `function.`"
        else:
            advice = did_you_mean(node.name, self.skills) or "see the palette for all there are"
        message = f"`function.{node.name}`: the robot has no such skill; {advice}"
        self.report("unknown-skill", message, node.span)

    def missing_devices(
        self, node: SkillCall, skill: BlockConfiguration, missing: tuple[str, ...]
    ) -> None:
        devices = _quoted(missing)
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
                    _quoted(known) or "none"
                )
                message = f"`{call}` has no argument `{keyword.name}`; {hint}"
                self.report("unknown-argument", message, keyword.span)
            elif keyword.name in given:
                message = f"`{call}` is given `{keyword.name}` twice"
                self.report("duplicate-argument", message, keyword.span)

    def missing(self, node: Call | SkillCall, call: str, names: list[str]) -> None:
        if names:
            self.report("missing-argument", f"`{call}` also needs {_quoted(names)}", node.span)

    def type_of(self, call: str, parameter: Parameter, value: Expression) -> None:
        if parameter.type in {"float", "int"} and isinstance(value, String):
            message = f"`{parameter.name}` of `{call}` is a number, not a text"
            plain = value.value.strip()
            if plain.replace(".", "", 1).lstrip("-").isdecimal():
                message += f": write {plain} without quotes"
            self.report("wrong-type", message, value.span)

    def call(self, node: Call) -> None:
        function = self.functions.get(node.name)
        if function is not None:
            self.own_call(node, function)
        elif node.name in FUNCTIONS:
            self.library_call(node)
        elif not self.imports and not self.is_known(node.name):
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
        if node.name in self.skills:
            advice = f"the robot's skill is called `function.{node.name}(...)`"
        elif node.name == "robot":
            advice = "`robot(...)` stands before everything else"
        else:
            skill = did_you_mean(node.name, self.skills)
            own = did_you_mean(node.name, [*self.functions, *FUNCTIONS])
            advice = own or skill.replace("`", "`function.", 1) or f"write a `def {node.name}`"
        message = f"`{node.name}`: there is no such function; {advice}"
        self.report("unknown-function", message, node.span)

    # Variables.

    def unset_variables(self) -> None:
        """Variables that are read and never set, or not yet set where the program starts."""
        if self.program.items or self.main:
            known = self.assigned | set(self.whens)
            for item in self.program.items:
                self.never_set(item, known)
            for statement in self.main:
                self.never_set(statement, known)
        _Order(self).run()

    def never_set(self, item: Item | Main, known: set[str]) -> None:
        own = set(item.parameters) if isinstance(item, Def) else set()
        for statement in statements((item,)):  # type: ignore[arg-type]
            targets = {id(statement.target)} if isinstance(statement, Assign) else set()
            if isinstance(statement, Assign) and statement.operator != "=":
                targets = set()
            for expression in expressions(statement):
                for node in within(expression):
                    if isinstance(node, Name) and id(node) not in targets:
                        self.read(node, known, own)

    def read(self, node: Name, known: set[str], own: set[str]) -> None:
        name = node.name
        if name in self.assigned or name in own or self.imports or name in _PYTHONS_OWN:
            return
        if name.partition("_")[0] in {"state", "time"} and "_" in name:
            return
        if name in self.whens:
            advice = f"to ask whether it is active, write `state_{name}`"
        elif name in self.functions:
            advice = f"it is a function: to call it, write `{name}(...)`"
        elif name in _SPELLINGS:
            advice = f"write `{_SPELLINGS[name]}`"
        elif name in self.skills:
            advice = f"the robot's skill is called `function.{name}(...)`"
        else:
            advice = did_you_mean(name, known | own) or f"set it first: `{name} = ...`"
        self.report("unknown-name", f"`{name}` has no value; {advice}", node.span)

    # Sensors.

    def unseen_sensors(self) -> None:
        """An ``if`` on a sensor outside any loop looks once, which is seldom meant."""
        for item in (*self.program.items, *self.main):
            if isinstance(item, If):
                self.looked_once(item)

    def looked_once(self, item: If) -> None:
        for branch in item.branches:
            for node in within(branch.condition):
                skill = self.skills.get(node.name) if isinstance(node, SkillCall) else None
                if skill is not None and skill.type == "perceptual":
                    message = (
                        f"`function.{skill.name}` is asked only once, when the program gets here: "
                        "to keep looking, put the `if` into `while True:` or use a `when`"
                    )
                    self.report("sensor-outside-loop", message, branch.span, "warning")
                    return


class _Order:
    """Follows the top level and `main` in the order in which they run, to find unset variables."""

    def __init__(self, checker: _Checker) -> None:
        self.checker = checker
        self.reported: set[str] = set()

    def run(self) -> None:
        checker = self.checker
        set_so_far = set(checker.raw_names)
        for item in checker.program.items:
            if isinstance(item, Def | When):
                # Whoever calls it may do so after anything; what it sets may be set already.
                set_so_far.update(_sets(item.body))
        self.block((*checker.program.items, *checker.main), set_so_far)

    def block(self, body: tuple[Item, ...], known: set[str]) -> None:
        for item in body:
            if isinstance(item, Def | When):
                continue
            self.reads(item, known)
            if (name := set_by(item)) is not None:
                known.add(name)
            # What one branch sets counts as set: we only say what is certain.
            for inner in bodies(item):
                self.block(inner, known)

    def reads(self, item: Item, known: set[str]) -> None:
        targets: set[int] = set()
        if (isinstance(item, Assign) and item.operator == "=") or isinstance(
            item, ForEach | ForRange
        ):
            targets = {id(item.target)}
        for expression in expressions(item):
            for node in within(expression):
                if isinstance(node, Name) and id(node) not in targets:
                    self.read(node, known)

    def read(self, node: Name, known: set[str]) -> None:
        name = node.name
        if name in known or name in self.reported or name not in self.checker.assigned:
            return
        self.reported.add(name)
        message = f"`{name}` is read here before it is set: write `{name} = ...` above"
        self.checker.report("unset-variable", message, node.span)


# Python sets them in every file.
_PYTHONS_OWN = frozenset(("__name__", "__file__"))
_OPEN_ENDED = frozenset(name for name, (_, most) in BUILTINS.items() if most is None)


def _argument_counts(name: str) -> list[int]:
    if name == "elapsedTime":
        return [1]
    if name in BUILTINS:
        least, most = BUILTINS[name]
        return [least, least if most is None else most]
    return [count for known, count in TEMPLATES if known == name]


def _sets(body: Body) -> Iterator[str]:
    for item in statements(body):
        if isinstance(item, Assign) and isinstance(item.target, Name):
            yield item.target.name


def _write_one(name: str) -> str:
    return f"write one, or check the name `{name}`"


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
    """Whether a ``break``, or raw Python that may hold one, leaves the loop of this body."""
    for item in body:
        if isinstance(item, Break | Raw):
            return True
        if not isinstance(item, _LOOPS) and any(map(_breaks, bodies(item))):
            return True
    return False


def _reason(item: Item) -> str:
    if isinstance(item, _JUMPS):
        return f"`{type(item).__name__.lower()}` leaves"
    return "the loop `while True` never ends" if isinstance(item, While) else "every branch leaves"


def _is_whole(text: str) -> bool:
    try:
        int(text, 0)
    except ValueError:
        return False
    return True


def _defined_names(text: str) -> set[str]:
    """What raw Python imports and defines."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return set()
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.alias):
            found.add((node.asname or node.name).partition(".")[0])
    return found
