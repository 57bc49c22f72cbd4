"""The slips that beginners make, each with what to do about it.

A function here is given the tokens round the place where reading failed, and says what was meant.
"""

from learnblock.errors import Diagnostic, did_you_mean
from learnblock.language.lexer import KEYWORDS, Token

_CHARACTERS = {
    "“": 'write a straight quote `"`',
    "”": 'write a straight quote `"`',
    "„": 'write a straight quote `"`',
    "«": 'write a straight quote `"`',
    "»": 'write a straight quote `"`',
    "‘": "write a straight quote `'`",
    "’": "write a straight quote `'`",
    "≤": "write `<=`",
    "≥": "write `>=`",
    "≠": "write `!=`",
    "×": "write `*`",
    "÷": "write `/`",
    "–": "write `-`",
    "—": "write `-`",
    "−": "write `-`",
    "&": "write `and`",
    "|": "write `or`",
    "!": "write `not`",
    "^": "a power is written `**`",
    ";": "write each statement on a line of its own",
    "{": "a block begins with `:` and closes with `end`",
    "}": "a block begins with `:` and closes with `end`",
    "@": "remove it",
}
_OTHER_LANGUAGES = {
    "elseif": "write `elif`",
    "elsif": "write `elif`",
    "switch": "write `if` and `elif`",
    "function": "write `def`",
    "func": "write `def`",
    "var": "write the name, `=` and the value",
    "let": "write the name, `=` and the value",
    "loop": "write `while True:` or `repeat`",
    "foreach": "write `for x in values:`",
    "endif": "a block closes with `end`",
    "endwhile": "a block closes with `end`",
    "fi": "a block closes with `end`",
    "done": "a block closes with `end`",
    "from": 'write `import "name"`',
    "class": "Block-Text has no classes: use a `python:` block",
    "try": "use a `python:` block",
    "with": "use a `python:` block",
    "global": "all variables are global: leave it out",
}
_UNEXPECTED = {
    "=": ("assignment-in-condition", "`=` sets a variable: to compare, write `==`"),
    "is": ("unknown-word", "`is` is not a word of Block-Text: to compare, write `==`"),
    "then": ("unknown-word", "`then` is not a word of Block-Text: write `:`"),
    "&": ("unknown-word", "`&` is not an operator: write `and`"),
    "|": ("unknown-word", "`|` is not an operator: write `or`"),
}
_BLOCK_OPENERS = ("if", "while", "repeat", "for", "when", "main", "def", "function")
_OPENERS = (
    *_BLOCK_OPENERS,
    "elif",
    "else",
    "end",
    "return",
    "break",
    "continue",
    "pass",
    "activate",
    "deactivate",
    "import",
)
# Words with which a block begins, here or in another language.
_ALL_BLOCK_OPENERS = frozenset(
    (
        *_BLOCK_OPENERS,
        "switch",
        "loop",
        "foreach",
        "func",
        "class",
        "try",
        "with",
        "until",
        "unless",
        "forever",
    )
)
_ROBOTS = frozenset(("robot", "functions", "fuction", "funtion", "Function"))
_STRING_PREFIXES = frozenset(("f", "r", "b", "u", "rb", "br", "fr"))
_VALUES = frozenset(("name", "number", "string"))
_LINE_ENDS = frozenset(("newline", "comment"))


class Slip(Exception):  # noqa: N818 - it is not an error of ours, it unwinds to the statement
    """What keeps a statement from being read."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


def at(token: Token, code: str, message: str) -> Diagnostic:
    """What is wrong at a token."""
    width = max(len(token.text.split("\n", 1)[0]), 1)
    return Diagnostic(code, message, token.line, token.column, token.column + width)


def slip(token: Token, code: str, message: str) -> Slip:
    """What keeps a statement from being read, at a token."""
    return Slip(at(token, code, message))


def too_deep(token: Token) -> Slip:
    message = "this is nested too deeply: give a part of it a name of its own"
    return slip(token, "too-deep", message)


def unexpected(token: Token, before: Token, wanted: str) -> Slip:
    """Another token than the one that is `wanted`."""
    if token.kind == "bad":
        return bad_character(token)
    if token.kind == "=" and before.kind in KEYWORDS:
        return reserved(before)
    if token.text in _UNEXPECTED:
        return slip(token, *_UNEXPECTED[token.text])
    return slip(token, "unexpected", f"{wanted} is needed here, not {_described(token)}")


def reserved(token: Token) -> Slip:
    """A keyword where a name belongs."""
    message = f"`{token.text}` is a word of the language: choose another name"
    return slip(token, "reserved-word", message)


def bad_character(token: Token) -> Slip:
    """A character that begins no token, such as a quote that nothing closes."""
    mark = token.text[0]
    if mark in "\"'`":
        message = f"no closing {mark} on this line: write {mark} where the text ends"
        return slip(token, "missing-quote", message)
    advice = _CHARACTERS.get(token.text, "it has no meaning in Block-Text: remove it")
    return slip(token, "bad-character", f"`{token.text}`: {advice}")


def no_statement(token: Token) -> Slip:
    """A token that begins no statement."""
    if token.kind == "bad":
        return bad_character(token)
    return slip(token, "unexpected", f"a statement cannot begin with {_described(token)}")


def opens_block(word: str) -> bool:
    """Whether an unknown word was meant to begin a block."""
    if word.lower() in _ALL_BLOCK_OPENERS:
        return True
    return did_you_mean(word, _OPENERS) in {f"did you mean `{one}`?" for one in _BLOCK_OPENERS}


def odd_statement(token: Token, following: Token, third: Token) -> Slip:  # noqa: PLR0911 - one a slip
    """What was meant by a name that begins neither a call nor an assignment?"""
    name = token.text
    if name in _OTHER_LANGUAGES:
        message = f"`{name}` is not a word of Block-Text: {_OTHER_LANGUAGES[name]}"
        return slip(token, "unknown-word", message)
    if following.kind == "bad":
        return bad_character(following)
    if following.kind == ".":
        return dotted(token, third)
    if following.kind == "==":
        message = f"`==` compares: to set `{name}`, write `{name} = ...`"
        return slip(following, "comparison-as-statement", message)
    if following.kind in {*_VALUES, ":"} or following.kind in KEYWORDS:
        return _misspelled(token, following)
    if following.kind in {"+", "-"} and third.kind == following.kind:
        message = f"to count, write `{name} {following.kind}= 1`"
        return slip(following, "unexpected", message)
    if following.kind in _LINE_ENDS:
        message = f"`{name}` alone does nothing: to call it, write `{name}()`"
        return slip(token, "no-effect", message)
    message = f"`{name}` must be followed by `(` for a call or by `=` to set it"
    return slip(following, "unexpected", message)


def dotted(token: Token, third: Token) -> Slip:
    """A name with a dot behind it."""
    if token.text in _ROBOTS:
        message = f"`{token.text}.{third.text}`: a skill is called `function.{third.text}(...)`"
    else:
        message = (
            f"`{token.text}.{third.text}`: Block-Text has no `.` except in `function.`; "
            "put Python between backticks or in a `python:` block"
        )
    return slip(token, "unknown-dot", message)


def odd_name(token: Token, following: Token, third: Token) -> Slip:
    """A variable with a dot or a text behind it."""
    if following.kind == ".":
        return dotted(token, third)
    if following.kind == "string" and token.text.lower() in _STRING_PREFIXES:
        message = f"Block-Text has no `{token.text}` before a text: join with `+` and `str(...)`"
        return slip(token, "string-prefix", message)
    return unexpected(following, token, "an operator")


def no_value(token: Token, before: Token, operators: frozenset[str]) -> Slip:
    """A token that begins no expression."""
    if token.kind in KEYWORDS and token.kind not in operators:
        return reserved(token)
    if token.kind == "=" and before.kind in operators:
        return slip(token, "unexpected", f"write `{before.text}=` without a blank")
    if token.text in {"/", "*"} and before.text in {"/", "*"}:
        return slip(token, "unexpected", f"write `{before.text}{token.text}` without a blank")
    wanted = f"a value after `{before.text}`" if before.text.strip() else "a value"
    return unexpected(token, before, wanted)


def two_strings(token: Token, following: Token) -> Slip:
    """A text right behind a text."""
    if token.text in {'""', "''"} and following.column == token.column + 2:
        message = "a text has one quote on each side; write `\\n` for a new line in it"
        return slip(token, "triple-quote", message)
    return slip(following, "unexpected", "join two texts with `+`")


def _misspelled(token: Token, following: Token) -> Slip:
    name = token.text
    if name.lower() in _OPENERS:
        return slip(token, "unknown-word", f"`{name}` is written `{name.lower()}`")
    hint = did_you_mean(name, _OPENERS)
    if following.kind in _VALUES and not hint:
        message = f"to call `{name}`, write its arguments in brackets: `{name}(...)`"
        return slip(following, "missing-brackets", message)
    return slip(token, "unknown-word", f"`{name}` begins no statement" + (hint and f"; {hint}"))


def _described(token: Token) -> str:
    if token.kind in {"newline", "blank", "comment"}:
        return "the end of the line"
    if token.kind == "eof":
        return "the end of the program"
    return f"`{token.text}`"
