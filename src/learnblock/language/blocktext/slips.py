"""The slips that beginners make, each with what to write instead.

A function here takes the tokens around the position where parsing failed, and infers what was
meant.
"""

from collections.abc import Mapping
from types import MappingProxyType

from learnblock.errors import Diagnostic, nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.lexer import KEYWORDS, LINE_ENDS, Token
from learnblock.language.tree.characters import foreign, write_instead

_BRACES = Phrase("blocktext-braces")


def _replaced(pairs: Mapping[str, str]) -> dict[str, Phrase]:
    return {written: write_instead(written, instead) for written, instead in pairs.items()}


def _straight(marks: str, quote: str) -> dict[str, Phrase]:
    return {mark: Phrase("blocktext-straight-quote", found=mark, quote=quote) for mark in marks}


_CHARACTERS: Mapping[str, Phrase] = MappingProxyType(
    {
        **_straight("“”„«»", '"'),
        **_straight("\N{LEFT SINGLE QUOTATION MARK}\N{RIGHT SINGLE QUOTATION MARK}", "'"),
        **_replaced({"≤": "<=", "≥": ">=", "≠": "!=", "×": "*", "÷": "/", "^": "**"}),
        **_replaced(dict.fromkeys(("\N{EN DASH}", "—", "\N{MINUS SIGN}"), "-")),
        **_replaced({"&": "and", "|": "or", "!": "not"}),
        ";": Phrase("blocktext-semicolon"),
        "{": _BRACES,
        "}": _BRACES,
    }
)
_PYTHON_STATEMENTS = ("del", "raise", "assert", "yield", "await", "nonlocal")
_PYTHON_BLOCKS = ("class", "try", "except", "finally", "with", "match", "async")
#: They continue a ``try``.
HANDLERS = frozenset(("except", "finally"))
_OTHER_LANGUAGES: Mapping[str, Phrase] = MappingProxyType(
    {
        **_replaced({"elseif": "elif", "elsif": "elif", "function": "def", "func": "def"}),
        **_replaced(dict.fromkeys(("endif", "endwhile", "fi", "done"), "end")),
        "switch": Phrase("blocktext-switch"),
        "case": Phrase("blocktext-case"),
        "var": Phrase("blocktext-declaration", word="var"),
        "let": Phrase("blocktext-declaration", word="let"),
        "loop": Phrase("blocktext-loop"),
        "foreach": Phrase("blocktext-foreach"),
        "from": Phrase("blocktext-from"),
        **{word: Phrase("blocktext-python-statement", word=word) for word in _PYTHON_STATEMENTS},
        **{word: Phrase("blocktext-python-block", word=word) for word in _PYTHON_BLOCKS},
        "global": Phrase("blocktext-global"),
    }
)
_UNEXPECTED: Mapping[str, tuple[str, Phrase]] = MappingProxyType(
    {
        "=": ("assignment-in-condition", Phrase("blocktext-assignment-in-condition")),
        "is": ("unknown-word", Phrase("blocktext-is")),
        "then": ("unknown-word", write_instead("then", ":")),
        "&": ("unknown-word", write_instead("&", "and")),
        "|": ("unknown-word", write_instead("|", "or")),
    }
)
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
# Words that begin a block, in Block-Text or in a different language.
_ALL_BLOCK_OPENERS = frozenset(
    (
        *_BLOCK_OPENERS,
        "switch",
        "match",
        "case",
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
_STRING_PREFIXES = frozenset(("f", "r", "b", "u", "rb", "br", "fr", "rf"))
VALUES = frozenset(("name", "number", "string"))


class Slip(Exception):  # noqa: N818 - not an error: it unwinds the parser to the statement
    """The reason why a statement cannot be parsed."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class Rewritten(Slip):
    """The statement's line has been rewritten, and has to be read again."""


def at(token: Token, code: str, message: Phrase) -> Diagnostic:
    """A diagnostic that points at a token."""
    width = max(len(token.text.split("\n", 1)[0]), 1)
    return Diagnostic(code, message, token.line, token.column, token.column + width)


def slip(token: Token, code: str, message: Phrase) -> Slip:
    """A slip at a token."""
    return Slip(at(token, code, message))


def symbol(text: str) -> Phrase:
    """A symbol or reserved word, as a noun phrase."""
    return Phrase("blocktext-token", text=text)


def too_deep(token: Token) -> Slip:
    return slip(token, "too-deep", Phrase("blocktext-too-deep"))


def unexpected(token: Token, before: Token, wanted: Phrase) -> Slip:
    """A token instead of the expected one; `wanted` is a noun phrase."""
    if token.kind == "bad":
        return bad_character(token)
    if token.kind == "=" and before.kind in KEYWORDS:
        return reserved(before)
    if token.text in _UNEXPECTED:
        return slip(token, *_UNEXPECTED[token.text])
    message = Phrase("blocktext-expected", wanted=wanted, found=_described(token))
    return slip(token, "unexpected", message)


def reserved(token: Token) -> Slip:
    """A keyword where a name is expected."""
    return slip(token, "reserved-word", Phrase("blocktext-reserved-word", word=token.text))


def bad_character(token: Token) -> Slip:
    """A character that begins no token, such as a quote that is never closed."""
    mark = token.text[0]
    if mark in "\"'`":
        return slip(token, "missing-quote", Phrase("blocktext-missing-quote", quote=mark))
    message = _CHARACTERS.get(token.text) or foreign(token.text)
    meaningless = Phrase("blocktext-meaningless", found=token.text)
    return slip(token, "bad-character", message or meaningless)


def no_statement(token: Token) -> Slip:
    """A token that begins no statement."""
    if token.kind == "bad":
        return bad_character(token)
    message = Phrase("blocktext-no-statement", found=_described(token))
    return slip(token, "unexpected", message)


def opens_block(word: str) -> bool:
    """Whether an unknown word was meant to begin a block."""
    return word.lower() in _ALL_BLOCK_OPENERS or nearest(word, _OPENERS) in _BLOCK_OPENERS


def odd_statement(token: Token, following: Token, third: Token) -> Slip:  # noqa: PLR0911 - one per slip
    """A name that begins neither a call nor an assignment."""
    name = token.text
    if name in _OTHER_LANGUAGES:
        return slip(token, "unknown-word", _OTHER_LANGUAGES[name])
    if following.kind == "bad":
        return bad_character(following)
    if following.kind == ".":
        return dotted(token, third)
    if following.kind == "==":
        message = Phrase("blocktext-comparison-as-statement", name=name)
        return slip(following, "comparison-as-statement", message)
    if following.kind in {*VALUES, ":"} or following.kind in KEYWORDS:
        return _misspelled(token, following)
    if following.kind in {"+", "-"} and third.kind == following.kind:
        message = Phrase("blocktext-count", name=name, operator=following.kind)
        return slip(following, "unexpected", message)
    if following.kind in LINE_ENDS:
        return slip(token, "no-effect", Phrase("blocktext-name-alone", name=name))
    return slip(following, "unexpected", Phrase("blocktext-call-or-assignment", name=name))


def dotted(token: Token, third: Token) -> Slip:
    """A name followed by a dot."""
    if token.text in _ROBOTS:
        message = Phrase("blocktext-skill-of-robot", skill=third.text)
    else:
        message = Phrase("blocktext-dot", name=f"{token.text}.{third.text.strip()}")
    return slip(token, "unknown-dot", message)


def odd_name(token: Token, following: Token, third: Token) -> Slip:
    """A variable followed by a dot or a string."""
    if following.kind == ".":
        return dotted(token, third)
    if following.kind == "string" and token.text.lower() in _STRING_PREFIXES:
        is_f = token.text.lower() == "f"
        code = "blocktext-f-string-space" if is_f else "blocktext-string-prefix"
        message = Phrase(code, prefix=token.text)
        return slip(token, "string-prefix", message)
    return unexpected(following, token, Phrase("blocktext-wanted-operator"))


def no_value(token: Token, before: Token, operators: frozenset[str]) -> Slip:
    """A token that begins no expression."""
    if token.kind in KEYWORDS and token.kind not in operators:
        return reserved(token)
    doubled = token.text in {"/", "*"} and before.text in {"/", "*"}
    if doubled or (token.kind == "=" and before.kind in operators):
        message = Phrase("blocktext-without-space", operator=before.text + token.text)
        return slip(token, "unexpected", message)
    if before.text.strip():
        return unexpected(token, before, Phrase("blocktext-wanted-value-after", word=before.text))
    return unexpected(token, before, Phrase("blocktext-wanted-value"))


def next_value(token: Token, before: Token, closing: str) -> Slip:
    """A token in place of a comma or a closing bracket."""
    if token.kind in VALUES and before.kind in VALUES:
        message = Phrase("blocktext-missing-comma", first=before.text, second=token.text)
        return slip(token, "unexpected", message)
    either = Phrase("blocktext-wanted-either", first=",", second=closing)
    return unexpected(token, before, either)


def no_else(word: Token, token: Token) -> Slip:
    """A value with an ``if`` and no ``else``: half of a conditional value, or a statement."""
    if token.kind == ":":
        return slip(word, "two-statements", Phrase("blocktext-two-statements", word=word.text))
    return slip(word, "unexpected", Phrase("blocktext-if-without-else"))


def two_strings(token: Token, following: Token) -> Slip:
    """A string directly after a string."""
    if token.text in {'""', "''"} and following.column == token.column + 2:
        return slip(token, "triple-quote", Phrase("blocktext-triple-quote"))
    return slip(following, "unexpected", Phrase("blocktext-join-texts"))


def _misspelled(token: Token, following: Token) -> Slip:
    name = token.text
    if name.lower() in _OPENERS:
        return slip(token, "unknown-word", write_instead(name, name.lower()))
    near = nearest(name, _OPENERS)
    if near is not None:
        return slip(
            token, "unknown-word", Phrase("blocktext-unknown-word-near", word=name, near=near)
        )
    if following.kind in VALUES:
        return slip(following, "missing-brackets", Phrase("blocktext-missing-brackets", name=name))
    return slip(token, "unknown-word", Phrase("blocktext-unknown-word", word=name))


def _described(token: Token) -> Phrase:
    if token.kind in {"newline", "blank", "comment"}:
        return Phrase("blocktext-end-of-line")
    if token.kind == "eof":
        return Phrase("blocktext-end-of-program")
    return symbol(token.text)
