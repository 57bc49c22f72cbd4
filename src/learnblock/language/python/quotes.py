"""Whether the quotes in f-strings are such that every version of Python takes them."""

import io
import tokenize
from contextlib import suppress

#: The tokens of f-strings, and since Python 3.14 of t-strings; Python 3.11 has one for a whole one.
_STARTS, _MIDDLES, _ENDS = (
    frozenset(
        getattr(tokenize, name)
        for name in (f"FSTRING_{part}", f"TSTRING_{part}")
        if hasattr(tokenize, name)
    )
    for part in ("START", "MIDDLE", "END")
)


def are_for_every_python(line: str) -> bool:
    """Whether no value in an f-string has the quotes of the f-string or a backslash.

    Python takes them since 3.12 (PEP 701), but a program is for every version that we support. The
    line need not be whole: it can be the first one of a block.
    """
    around: list[str] = []
    with suppress(tokenize.TokenError):
        for token in tokenize.generate_tokens(io.StringIO(line).readline):
            if token.type in _ENDS:
                around.pop()
            # The words of an f-string are in those around it.
            outer = around[:-1] if token.type in _MIDDLES else around
            if outer and ("\\" in token.string or any(end in token.string for end in outer)):
                return False
            if token.type in _STARTS:
                around.append(token.string.lstrip("fFrRtT"))
    return True
