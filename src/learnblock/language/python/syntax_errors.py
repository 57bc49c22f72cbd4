"""Messages about Python that cannot be parsed.

Python reports syntax errors only in English, so the frequent ones have our own messages.
"""

import ast
import re
import warnings

from learnblock.i18n import Phrase
from learnblock.language.tree.characters import foreign

# A complete Python message, and the code of our phrase; the named groups become its values.
_MESSAGES = tuple(
    (re.compile(pattern), code)
    for pattern, code in (
        (r"invalid syntax", "python-invalid-syntax"),
        (r"invalid syntax\. Perhaps you forgot a comma\?", "python-missing-comma"),
        (r"invalid syntax\. Maybe you meant '==' or ':=' instead of '='\?", "python-comparison"),
        (r"expected '(?P<symbol>.+)'", "python-expected"),
        (r"expected an indented block after .* on line (?P<line>\d+)", "python-missing-block"),
        (r"unexpected indent", "python-unexpected-indent"),
        (r"unindent does not match any outer indentation level", "python-uneven-indent"),
        (r"inconsistent use of tabs and spaces in indentation", "python-tabs-and-spaces"),
        (r"'(?P<symbol>.)' was never closed", "python-never-closed"),
        (r"unmatched '(?P<symbol>.)'", "python-unmatched"),
        (
            r"closing parenthesis '(?P<closing>.)' does not match opening parenthesis"
            r" '(?P<opening>.)'.*",
            "python-wrong-bracket",
        ),
        (r"unterminated (?:triple-quoted )?string literal .*", "python-missing-quote"),
        (r"unterminated (?:triple-quoted )?f-string literal .*", "python-missing-quote"),
        (r"unexpected EOF while parsing", "python-unexpected-end"),
        (r"invalid decimal literal", "python-bad-number"),
        (r"invalid character '(?P<character>.)' .*", "python-bad-character"),
        (r"invalid non-printable character (?P<character>U\+[0-9A-F]+)", "python-bad-character"),
        (r"cannot assign to .+ here\. Maybe you meant '==' instead of '='\?", "python-comparison"),
        (r"cannot assign to .+", "python-bad-target"),
        (r"unexpected character after line continuation character", "python-after-backslash"),
        (
            r"Missing parentheses in call to '(?P<function>\w+)'\. Did you mean .*",
            "python-call-without-brackets",
        ),
    )
)


_INDENTATION = 4
_LINE_END = re.compile(r"\r\n|\r|\n")
#: The word that opens a block, and what makes its first line complete.
_OPENER = re.compile(r"\s*(if|elif|else|while|for|def|class|try|except|finally|with)\b")
_HEADERS = {
    "elif": "if x: pass\n",
    "else": "if x: pass\n",
    "except": "try: pass\n",
    "finally": "try: pass\n",
}
#: The number of lines within which a bracket is expected to be closed.
_MOST_LINES = 20
_TEXT = re.compile(r"\"[^\"]*\"|'[^']*'|#.*")
_CLOSING = {"(": ")", "[": "]", "{": "}"}
_OPENING = {closing: symbol for symbol, closing in _CLOSING.items()}


def syntax_message(error: SyntaxError, text: str) -> Phrase:
    """The message about a syntax error in a text; Python's if we have none."""
    for pattern, code in _MESSAGES:
        match = pattern.fullmatch(error.msg)
        if match:
            message = Phrase(code, **match.groupdict())
            if code == "python-bad-character":
                return foreign(_character(match)) or message
            return _with_advice(message, error, _Lines(text))
    return Phrase("python-syntax", reason=error.msg)


def _character(match: re.Match[str]) -> str:
    """The character of a message, which may have its number in place of it."""
    text = match["character"]
    return chr(int(text[2:], 16)) if len(text) > 1 else text


class _Lines:
    """The lines of a text, as Python counts them."""

    def __init__(self, text: str) -> None:
        self.lines = _LINE_END.split(text)

    def __getitem__(self, number: int) -> str:
        # An error at the end of the text is below the last line.
        return self.lines[number - 1] if 0 < number <= len(self.lines) else ""


def _with_advice(message: Phrase, error: SyntaxError, lines: _Lines) -> Phrase:
    """A message with the correction that the lines of the program suggest."""
    number = error.lineno or 0
    if message.code == "python-missing-block":
        header = int(str(message.values["line"]))
        code = message.code if number > header and lines[number].strip() else "python-no-block"
        spaces = len(lines[header]) - len(lines[header].lstrip()) + _INDENTATION
        return Phrase(code, header=lines[header].strip(), spaces=spaces)
    if message.code == "python-expected" and message.values["symbol"] == ":":
        return _colon(lines[number]) or message
    if message.code == "python-invalid-syntax":
        return _closed_in_line(lines[number].strip()) or message
    if message.code == "python-never-closed":
        return _never_closed(str(message.values["symbol"]), lines, number)
    return message


def _colon(line: str) -> Phrase | None:
    """The message about a missing colon, if it is missing at the end of a block's first line."""
    opener = _OPENER.match(line)
    closed = f"{line.partition('#')[0].strip()}:"
    if opener is None or not _is_python(_HEADERS.get(opener[1], "") + closed + " pass"):
        return None
    return Phrase("blocktext-missing-colon", word=opener[1])


def _never_closed(symbol: str, lines: _Lines, number: int) -> Phrase:
    """The message about a bracket, with the whole line if it is closed at its end."""
    closing, line = _CLOSING[symbol], lines[number].strip()
    if (message := _closed_in_line(line)) is not None:
        return message
    for last in range(number + 1, number + _MOST_LINES):
        after = lines[last].strip()
        line += "\n" + after
        if after and not after.endswith(",") and _is_python(line + closing):
            values = {"symbol": symbol, "closing": closing, "after": after}
            return Phrase("python-never-closed-below", last=str(last), **values)
    return Phrase("python-never-closed", symbol=symbol, closing=closing)


def _closed_in_line(line: str) -> Phrase | None:
    """The message about the brackets of a line, if it is Python once they are closed."""
    missing = _missing(line)
    opener = _OPENER.match(line)
    if opener is None:
        closed = complete = line + missing
    else:
        closed = f"{line.removesuffix(':')}{missing}:"
        complete = f"{_HEADERS.get(opener[1], '')}{closed} pass"
    if not missing or line.endswith(",") or not _is_python(complete):
        return None
    values = {"closing": missing, "instead": closed}
    if len(missing) == 1:
        return Phrase("python-never-closed-in-line", symbol=_OPENING[missing], **values)
    return Phrase("python-brackets-never-closed", count=str(len(missing)), **values)


def _missing(line: str) -> str:
    """What closes the brackets of a line that it does not close itself."""
    missing: list[str] = []
    for mark in _TEXT.sub("", line):
        if mark in _CLOSING:
            missing.append(_CLOSING[mark])
        elif missing and mark == missing[-1]:
            missing.pop()
    return "".join(reversed(missing))


def _is_python(text: str) -> bool:
    return error_in(text) is None


def error_in(text: str) -> SyntaxError | None:
    """The first syntax error in Python source."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
    except SyntaxError as error:
        return error
    except (ValueError, RecursionError, MemoryError) as error:
        return SyntaxError(str(error))
    return None
