"""Messages about Python that cannot be parsed.

Python reports syntax errors only in English, so the frequent ones have our own messages.
"""

import re

from learnblock.i18n import Phrase

# A complete Python message, and the code of ours; the named groups become its values.
_MESSAGES = tuple(
    (re.compile(pattern), code)
    for pattern, code in (
        (r"invalid syntax", "python-invalid-syntax"),
        (r"invalid syntax\. Perhaps you forgot a comma\?", "python-missing-comma"),
        (r"invalid syntax\. Maybe you meant '==' or ':=' instead of '='\?", "python-comparison"),
        (r"expected '(?P<symbol>.+)'", "python-expected"),
        (r"expected an indented block.*", "python-missing-block"),
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
        (r"cannot assign to .+ here\. Maybe you meant '==' instead of '='\?", "python-comparison"),
        (r"cannot assign to .+", "python-bad-target"),
        (r"unexpected character after line continuation character", "python-after-backslash"),
        (
            r"Missing parentheses in call to '(?P<function>\w+)'\. Did you mean .*",
            "python-call-without-brackets",
        ),
    )
)


def syntax_message(error: SyntaxError) -> Phrase:
    """The message about a syntax error; Python's if we have none."""
    for pattern, code in _MESSAGES:
        found = pattern.fullmatch(error.msg)
        if found:
            return Phrase(code, **found.groupdict())
    return Phrase("python-syntax", reason=error.msg)
