"""Lines that declare a variable as in JavaScript, C, Lua and others, and their Block-Text.

Where they come from, such a variable belongs to the function around it; so here it becomes `local`
in a function or a ``when``.
"""

from collections.abc import Callable, Sequence

from learnblock.language.blocktext.line_rules import NAME, WRITE_INSTEAD, Rule

DECLARED = "blocktext-declared"
#: What a variable is before it has a value, by a part of the word for its type.
_EMPTY = (
    ("list", "[]"),
    ("dict", "{}"),
    ("str", '""'),
    ("char", '""'),
    ("bool", "False"),
    ("[", "[]"),
    ("", "0"),
)
#: A word that declares what follows, and those that may be before or behind it.
_TYPE = (
    r"(?:var|let|const|val|dim|declare|variable|int|integer|float|double|byte|char|string|bool|boolean"
    r"|unsigned|u?int\d+_t|size_t|entero|booleano)"
)
_MORE = r"(?:public|private|protected|static|final|readonly|signed|long|short|mut)"
_DECLARING = rf"(?:{_MORE}\s+)*{_TYPE}(?:\s*\[\s*\])?\s+(?:(?:{_MORE}|{_TYPE})\s+(?=\w))*"
_LOCAL = rf"(?:set\s+)?local\s+(?:{_DECLARING})?"
#: The type behind a name, as in TypeScript, Python and BASIC.
_HINT = r"(?:\s*:\s*[^\W\d][\w.\[\]<>]*|\s+as\s+[^\W\d]\w*)"
_VALUE = r"([^\s=,()\[\]{}][^=,()\[\]{}]*?)"
_TYPE_OF_PYTHON = (
    r"(?:int|float|str|bool|list|dict|string|number|boolean|any)\b(?:\[[\w\[\], ]*\])?"
)


def _empty(prefix: str) -> Callable[[Sequence[str]], str]:
    """A line that gives a variable its first value."""

    def line(groups: Sequence[str]) -> str:
        keyword = groups[0].lower()
        value = next(value for part, value in _EMPTY if part in keyword)
        return f"{prefix}{groups[1]} = {value}"

    return line


def _several(start: str, prefix: str) -> tuple[Rule, ...]:
    """Rules for two variables that are declared in one line."""
    second = ("second", rf"{prefix}\2 = \4")
    names = rf"\s*{start}{NAME}\s*,\s*{NAME}\s*"
    return (
        Rule(
            rf"\s*{start}{NAME}\s*=\s*{_VALUE}\s*,\s*{NAME}\s*=\s*{_VALUE}\s*;?\s*$",
            rf"{prefix}\1 = \2",
            "blocktext-two-targets",
            (("second", rf"{prefix}\3 = \4"),),
        ),
        Rule(
            rf"{names}=\s*{_VALUE}\s*,\s*{_VALUE}\s*;?\s*$",
            rf"{prefix}\1 = \3",
            "blocktext-two-targets",
            (second,),
        ),
        Rule(
            rf"{names};?\s*$",
            rf"{prefix}\1 = 0",
            "blocktext-two-targets",
            (("second", rf"{prefix}\2 = 0"),),
        ),
    )


def _declared(start: str, prefix: str, code: str) -> tuple[Rule, ...]:
    """Rules for lines that begin with some words and a name."""
    return (
        *_several(start, prefix),
        Rule(rf"\s*(?P<wrong>{start}{NAME}{_HINT}?)\s*(?==[^=])", rf"{prefix}\2", code),
        Rule(rf"\s*{start}{NAME}{_HINT}?\s*;?\s*$", _empty(prefix), code),
        Rule(rf"\s*{start}{NAME}\s*([-+*/]=)\s*(\S.*?)\s*$", r"\1 \2 \3", WRITE_INSTEAD),
        Rule(
            rf"\s*{start}{NAME}\s*(?:==|:=|<-|:|\bto\b|\bis\b|\ba\b)?\s*([\d\"'].*?)\s*$",
            rf"{prefix}\1 = \2",
            WRITE_INSTEAD,
        ),
    )


_ANYWHERE = (
    Rule(r"\s*(?P<wrong>local\s+function)(?=\s+\w+\s*\()", "def"),
    Rule(rf"\s*(?P<wrong>(?:global|set)\s+{NAME})\s*(?==[^=])", r"\2"),
    Rule(
        rf"\s*(?:make|create|new|crear?)\s+(?:(?:a|an|the|una?|la)\s+)?(?:new\s+|nueva\s+)?variable"
        rf"\s+(?:(?:called|named|llamada)\s+)?{NAME}\s*$",
        r"\1 = 0",
    ),
    Rule(rf"\s*(?P<wrong>{NAME}\s*:\s*{_TYPE_OF_PYTHON})\s*(?==[^=])", r"\2", DECLARED),
    Rule(rf"\s*{NAME}\s*:\s*{_TYPE_OF_PYTHON}\s*$", _empty(""), DECLARED),
)

#: Rules for the statements of a function or a ``when``, and for all others.
IN_FUNCTIONS = (
    *_ANYWHERE,
    *_declared(_LOCAL, "local ", WRITE_INSTEAD),
    *_declared(_DECLARING, "local ", DECLARED),
)
OUTSIDE = (
    *_ANYWHERE,
    *_declared(_LOCAL, "", "blocktext-local-outside"),
    *_declared(_DECLARING, "", DECLARED),
)
