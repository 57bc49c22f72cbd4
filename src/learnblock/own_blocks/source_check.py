"""What is wrong with the source of blocks, told without running it."""

import ast
import warnings
from collections.abc import Iterator, Mapping

from learnblock import skill_files
from learnblock.blocks.configuration import NUMBERS, Parameter
from learnblock.blocks.signature import Argument, Place, Signature, signature
from learnblock.errors import Diagnostic, ProgramError, Severity
from learnblock.language.names import attribute_to_python
from learnblock.own_blocks.imports_check import wrong_imports

_ROBOT = "robot"
_EXAMPLE = "such as `def dance(robot, times: int = 3):`"


def wrong_source(source: str, filename: str, taken: Mapping[str, str]) -> Iterator[Diagnostic]:
    """What is wrong with a file of skills.

    Args:
        source: its text.
        filename: for Python's own messages.
        taken: names that its functions cannot have, each with a sentence that says why.
    """
    try:
        tree = _compiled(source, filename)
    except ProgramError as error:
        yield from error.diagnostics
        return
    functions = list(skill_files.functions(tree))
    heads = list(_wrong_heads(tree))
    yield from heads
    if not functions and not any(one.severity == "error" for one in heads):
        message = f"there is no function in it that takes the robot: write one, {_EXAMPLE}"
        yield Diagnostic("no-function", message)
    yield from _repeated(functions)
    for one in functions:
        yield from _wrong_function(signature(one), taken)
    yield from wrong_imports(tree)


def _compiled(source: str, filename: str) -> ast.Module:
    """The tree of a text that Python can compile as well, which finds some more mistakes.

    Raises:
        ProgramError: it cannot.
    """
    if len(source) > skill_files.LARGEST:
        message = f"the text is longer than {skill_files.LARGEST:,} characters"
        raise ProgramError(filename, [Diagnostic("too-large", message)])
    tree = skill_files.parse(source, filename)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(source, filename, "exec", dont_inherit=True)
    except SyntaxError as error:
        place = (error.lineno or 0, error.offset or 0)
        message = f"this is no Python: {error.msg}"
        raise ProgramError(filename, [Diagnostic("syntax-error", message, *place)]) from None
    except (ValueError, RecursionError, MemoryError, OverflowError) as error:
        message = f"this is no Python: {error}"
        raise ProgramError(filename, [Diagnostic("syntax-error", message)]) from None
    return tree


def _wrong_heads(tree: ast.Module) -> Iterator[Diagnostic]:
    """Public functions that make no block."""
    for one in tree.body:
        if not isinstance(one, ast.FunctionDef | ast.AsyncFunctionDef) or one.name.startswith("_"):
            continue
        start = one.col_offset + (len("async def ") if _is_async(one) else len("def "))
        place = Place(one.lineno, start + 1, start + 1 + len(one.name))
        if _is_async(one):
            message = f"`{one.name}` is `async`, which no block can be: write `def {one.name}`"
            yield _said("async-function", message, place)
        elif not (one.args.posonlyargs or one.args.args):
            message = (
                f"`{one.name}` takes no robot, so it makes no block: make `robot` its first"
                f" parameter, or call it `_{one.name}` if it only helps others"
            )
            yield _said("no-robot", message, place, "warning")


def _is_async(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return isinstance(function, ast.AsyncFunctionDef)


def _repeated(functions: list[ast.FunctionDef]) -> Iterator[Diagnostic]:
    seen: dict[str, int] = {}
    for one in functions:
        if one.name in seen:
            message = (
                f"there is a `{one.name}` in line {seen[one.name]} already: only this one counts,"
                " so rename one of them"
            )
            yield _said("duplicate-name", message, signature(one).place)
        seen[one.name] = one.lineno


def _wrong_function(one: Signature, taken: Mapping[str, str]) -> Iterator[Diagnostic]:
    if one.name in taken:
        message = f"`{one.name}`: {taken[one.name]}; choose another name"
        yield _said("name-taken", message, one.place)
    yield from _wrong_spelling(one.name, one.place)
    if one.robot != _ROBOT:
        message = (
            f"the first parameter of `{one.name}` is `{one.robot}`, and it is given the robot: call"
            f" it `robot` and put the others behind it, {_EXAMPLE}"
        )
        yield _said("no-robot", message, one.place)
    for name in one.unfit:
        message = (
            f"`{one.name}`: no block can give `{name}`: take away the `*`, or give it a default"
        )
        yield _said("unfit-parameter", message, one.place)
    for argument in one.arguments:
        yield from _wrong_spelling(argument.name, argument.place)
        yield from _wrong_argument(one.name, argument)


def _wrong_spelling(name: str, place: Place) -> Iterator[Diagnostic]:
    """A name that Block-Text has for a word of Python, such as ``class_``."""
    plain = name.rstrip("_")
    if attribute_to_python(name) != name:
        message = (
            f"`{name}` means `{plain}` in Block-Text, where it is spelled without `_`: choose"
            " another name"
        )
        yield _said("bad-name", message, place)


def _wrong_argument(function: str, one: Argument) -> Iterator[Diagnostic]:
    if one.wrong:
        message = f"`{one.name}` of `{function}`: {one.wrong}"
        yield _said("bad-hint", message, one.place)
    elif one.default is not None and (why := _objection(one)):
        message = f"`{one.name}` of `{function}`: the default is {one.default!r:.40}, but {why}"
        yield _said("bad-default", message, one.place)


def _objection(one: Argument) -> str:
    """Why the default of a parameter is none that its hint allows; empty if it is one."""
    kind, default = one.field.type, one.default
    is_number = isinstance(default, int | float) and not isinstance(default, bool)
    fits = {
        **dict.fromkeys(NUMBERS, (is_number, "a number is expected")),
        "string": (isinstance(default, str), "a text is expected"),
        "boolean": (isinstance(default, bool), "True or False is expected"),
        "list": (isinstance(default, list), "a list is expected"),
        "apriltext": (
            isinstance(default, str) or (is_number and isinstance(default, int)),
            "the number or the name of a tag is expected",
        ),
    }
    fit, expected = fits.get(kind, (True, ""))
    if not fit:
        return expected
    field = one.field
    parameter = Parameter(one.name, kind, range=field.range, choices=field.choices)
    return parameter.objection(default)


def _said(code: str, message: str, place: Place, severity: Severity = "error") -> Diagnostic:
    return Diagnostic(code, message, place.line, place.column, place.end_column, severity)
