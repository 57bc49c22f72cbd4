"""Parse Python with the standard library; errors are ours, and as many as are known slips."""

import ast
import warnings

from learnblock.errors import Diagnostic, ProgramError
from learnblock.i18n import Phrase
from learnblock.language.blocktext.lexer import MAX_CHARACTERS, too_long
from learnblock.language.blocktext.line_rules import reworded
from learnblock.language.python.foreign_lines import RULES
from learnblock.language.python.syntax_errors import error_in, syntax_message

#: The most known slips that are reported at once.
MAX_SLIPS = 10


def parsed(text: str, filename: str) -> ast.Module:
    """Parse a file.

    Raises:
        ProgramError: it is too long, too deep, or not Python.
    """
    if len(text) > MAX_CHARACTERS:
        raise ProgramError(filename, [Diagnostic("too-long", too_long(text))])
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.removeprefix("\ufeff"))
    except SyntaxError as error:
        raise ProgramError(filename, _syntax_errors(error, text), text) from None
    except (RecursionError, MemoryError):
        too_deep = Diagnostic("too-deep", Phrase("python-too-deep"))
        raise ProgramError(filename, [too_deep], text) from None
    except (ValueError, OverflowError) as error:
        message = Phrase("python-syntax", reason=str(error))
        raise ProgramError(filename, [Diagnostic("python-syntax", message)]) from None


def _syntax_errors(error: SyntaxError, text: str) -> list[Diagnostic]:
    """The first error, and those in other lines once the known slips are mended."""
    lines = text.split("\n")
    errors: list[Diagnostic] = []
    rest: SyntaxError | None = error
    while rest is not None and len(errors) < MAX_SLIPS:
        line = rest.lineno or 0
        code = lines[line - 1].partition("#")[0] if 0 < line <= len(lines) else ""
        rewording = reworded(code, RULES)
        if rewording is None or any(diagnostic.line == line for diagnostic in errors):
            break
        start, end = rewording.start + 1, rewording.end + 1
        message = _without_main(rewording.message, text)
        errors.append(Diagnostic("not-python", message, line, start, end))
        lines[line - 1] = rewording.line
        rest = error_in("\n".join(lines))
    return errors or [_syntax_error(error, text)]


def _without_main(message: Phrase, text: str) -> Phrase:
    """A program with `main` and calls of skills as in Block-Text is Block-Text as a whole."""
    if message.code == "python-main" and "function." in text:
        return Phrase("python-block-text", **message.values)
    return message


def _syntax_error(error: SyntaxError, text: str) -> Diagnostic:
    line, column = error.lineno or 0, error.offset or 0
    end = (error.end_offset or 0) if error.end_lineno == error.lineno else 0
    return Diagnostic("python-syntax", syntax_message(error, text), line, column, max(end, 0))
