"""The check of the source of custom blocks, which is not run."""

import ast
import warnings
from collections.abc import Iterator, Mapping
from types import CodeType

from learnblock.blocks import NUMBERS, Parameter
from learnblock.blocks.source.signature import Argument, FilePosition, Signature, signature
from learnblock.errors import Diagnostic, ProgramError, Severity
from learnblock.extensions.custom_blocks.imports_check import wrong_imports
from learnblock.extensions.custom_blocks.names_check import unknown_names, unknown_skills
from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import attribute_to_python
from learnblock.storage import skill_files

_ROBOT = "robot"


def wrong_source(source: str, filename: str, taken: Mapping[str, Phrase]) -> Iterator[Diagnostic]:
    """Check a Python file of skills.

    Args:
        source: the text of the file.
        filename: the name that Python's messages show.
        taken: the names that its functions cannot have, each with the reason.
    """
    try:
        tree, code = _compiled(source, filename)
    except ProgramError as error:
        yield from error.diagnostics
        return
    wrong = [*_wrong_parts(tree, taken)]
    yield from wrong
    # A hint or an import with a mistake is not reported a second time.
    lines = {diagnostic.line for diagnostic in wrong}
    yield from (
        diagnostic for diagnostic in unknown_names(tree, code) if diagnostic.line not in lines
    )
    own = {function.name for function in skill_files.functions(tree)}
    yield from unknown_skills(tree, {*taken, *own})


def _wrong_parts(tree: ast.Module, taken: Mapping[str, Phrase]) -> Iterator[Diagnostic]:
    functions = list(skill_files.functions(tree))
    heads = list(_wrong_heads(tree))
    yield from heads
    if not functions and not any(diagnostic.severity == "error" for diagnostic in heads):
        yield Diagnostic("no-function", Phrase("custom-no-function"))
    yield from _repeated(functions)
    for function in functions:
        yield from _wrong_function(signature(function), taken)
    yield from wrong_imports(tree)


def _compiled(source: str, filename: str) -> tuple[ast.Module, CodeType]:
    """The syntax tree of a source, and its code: compiling finds more mistakes.

    Raises:
        ProgramError: it is not valid Python.
    """
    if len(source) > skill_files.LARGEST:
        message = Phrase("custom-source-too-large", limit=skill_files.LARGEST)
        raise ProgramError(filename, [Diagnostic("too-large", message)])
    tree = skill_files.parse(source, filename)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            code = compile(source, filename, "exec", dont_inherit=True)
    except SyntaxError as error:
        place = (error.lineno or 0, error.offset or 0)
        message = Phrase("custom-not-python", reason=error.msg)
        raise ProgramError(filename, [Diagnostic("syntax-error", message, *place)]) from None
    except (ValueError, RecursionError, MemoryError, OverflowError) as error:
        message = Phrase("custom-not-python", reason=str(error))
        raise ProgramError(filename, [Diagnostic("syntax-error", message)]) from None
    return tree, code


def _wrong_heads(tree: ast.Module) -> Iterator[Diagnostic]:
    """Report public functions that cannot be blocks."""
    for statement in tree.body:
        if not isinstance(
            statement, ast.FunctionDef | ast.AsyncFunctionDef
        ) or statement.name.startswith("_"):
            continue
        start = statement.col_offset + (len("async def ") if _is_async(statement) else len("def "))
        place = FilePosition(statement.lineno, start + 1, start + 1 + len(statement.name))
        if _is_async(statement):
            yield _at(place, "async-function", Phrase("custom-async", name=statement.name))
        elif not (statement.args.posonlyargs or statement.args.args):
            yield _at(place, "no-robot", Phrase("custom-no-robot", name=statement.name), "warning")


def _is_async(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return isinstance(function, ast.AsyncFunctionDef)


def _repeated(functions: list[ast.FunctionDef]) -> Iterator[Diagnostic]:
    lines: dict[str, int] = {}
    for function in functions:
        if function.name in lines:
            line = str(lines[function.name])
            message = Phrase("custom-duplicate-function", name=function.name, line=line)
            yield _at(signature(function).place, "duplicate-name", message)
        lines[function.name] = function.lineno


def _wrong_function(skill: Signature, taken: Mapping[str, Phrase]) -> Iterator[Diagnostic]:
    if skill.name in taken:
        yield _at(skill.place, "name-taken", taken[skill.name])
    yield from _wrong_spelling(skill.name, skill.place)
    if skill.robot != _ROBOT:
        message = Phrase("custom-first-parameter", name=skill.name, parameter=skill.robot)
        yield _at(skill.place, "no-robot", message)
    for name in skill.unfit:
        message = Phrase("custom-unfit-parameter", name=skill.name, parameter=name)
        yield _at(skill.place, "unfit-parameter", message)
    for argument in skill.arguments:
        yield from _wrong_spelling(argument.name, argument.place)
        yield from _wrong_argument(skill.name, argument)


def _wrong_spelling(name: str, place: FilePosition) -> Iterator[Diagnostic]:
    """Report a name that Block-Text uses for a Python keyword, such as ``class_``."""
    plain = name.rstrip("_")
    if attribute_to_python(name) != name:
        yield _at(place, "bad-name", Phrase("custom-python-word", name=name, plain=plain))


def _wrong_argument(function: str, argument: Argument) -> Iterator[Diagnostic]:
    if argument.wrong:
        message = Phrase(
            "custom-bad-hint", parameter=argument.name, function=function, problem=argument.wrong
        )
        yield _at(argument.place, "bad-hint", message)
    elif argument.default is not None and (why := _objection(argument)):
        message = bad_default(argument.name, function, argument.default, why)
        yield _at(argument.place, "bad-default", message)


def bad_default(parameter: str, function: str, default: object, expected: Phrase) -> Phrase:
    """The message about a default that does not fit its parameter."""
    return Phrase(
        "custom-bad-default",
        parameter=parameter,
        function=function,
        default=f"{default!r:.40}",
        expected=expected,
    )


def _objection(argument: Argument) -> Phrase | None:
    """What the default of a parameter should be; None if it fits the hint."""
    kind, default = argument.field.type, argument.default
    is_number = isinstance(default, int | float) and not isinstance(default, bool)
    fits = {
        **dict.fromkeys(NUMBERS, (is_number, Phrase("block-expects-number"))),
        "string": (isinstance(default, str), Phrase("block-expects-text")),
        "boolean": (isinstance(default, bool), Phrase("block-expects-truth")),
        "list": (isinstance(default, list), Phrase("block-expects-list")),
        "apriltext": (
            isinstance(default, str) or (is_number and isinstance(default, int)),
            Phrase("block-expects-tag"),
        ),
    }
    fit, expected = fits.get(kind, (True, None))
    if not fit:
        return expected
    field = argument.field
    parameter = Parameter(argument.name, kind, range=field.range, choices=field.choices)
    return parameter.objection(default)


def _at(
    place: FilePosition, code: str, message: Phrase, severity: Severity = "error"
) -> Diagnostic:
    return Diagnostic(code, message, place.line, place.column, place.end_column, severity)
