"""The meaning of Python's frequent errors, for readers who do not know Python's terms."""

import re
from collections import Counter
from collections.abc import Mapping
from traceback import walk_tb

from learnblock.i18n import Phrase, Value
from learnblock.runtime.failed_code import FailedCode
from learnblock.runtime.own_words import in_own_words

#: A type of error, the pattern of its text, and the code of what it means. The groups of the
#: pattern are values of the phrase; those named after a type are nouns.
_MEANINGS: tuple[tuple[type[Exception], str, str], ...] = (
    (ZeroDivisionError, r".*", "run-means-zero-division"),
    (RecursionError, r".*", "run-means-recursion"),
    (MemoryError, r".*", "run-means-memory"),
    (OverflowError, r".*", "run-means-overflow"),
    (IndexError, r"pop from empty .*|.*empty sequence.*", "run-means-empty"),
    (IndexError, r".*index out of range", "run-means-index"),
    (KeyError, r"(?P<key>.+)", "run-means-key"),
    (ValueError, r"The truth value of an array .*", "run-means-picture"),
    (ModuleNotFoundError, r"No module named '(?P<module>.+)'.*", "run-means-module"),
    (
        ImportError,
        r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'.*",
        "run-means-attribute-of-module",
    ),
    (FileNotFoundError, r".*?: (?P<file>.+)", "run-means-file"),
    (
        UnboundLocalError,
        r".*local variable '(?P<name>\w+)'.*",
        "run-means-local",
    ),
    (NameError, r"name '(?P<name>\w+)' is not defined.*", "run-means-name"),
    (
        AttributeError,
        r"'NoneType' object has no attribute '(?P<name>\w+)'.*",
        "run-means-attribute-of-nothing",
    ),
    (
        AttributeError,
        r"'str' object has no attribute '(?P<name>append|extend|insert)'.*",
        "run-means-attribute-of-text",
    ),
    (AttributeError, r"'Robot' object has no attribute '(?P<name>\w+)'.*", "run-means-skill"),
    (
        AttributeError,
        r"'(?P<type>\w+)' object has no attribute '(?P<name>\w+)'.*",
        "run-means-attribute",
    ),
    (
        AttributeError,
        r"module '(?P<module>[\w.]+)' has no attribute '(?P<name>\w+)'.*",
        "run-means-attribute-of-module",
    ),
    (
        TypeError,
        r"can only concatenate str \(not \"(?:int|float)\"\) to str",
        "run-means-join-number",
    ),
    (TypeError, r"can only concatenate str \(not \"(?P<type>\w+)\"\) to str", "run-means-join"),
    (
        TypeError,
        r"can only concatenate list \(not \"(?P<type>\w+)\"\) to list",
        "run-means-join-list",
    ),
    (
        TypeError,
        r"unsupported operand type\(s\) for (?P<operator>\S+?)(?: or \S+)?: .*NoneType.*",
        "run-means-nothing",
    ),
    (TypeError, r"'(?P<operator>[<>]=?)' not supported .*NoneType.*", "run-means-nothing"),
    (
        TypeError,
        r"unsupported operand type\(s\) for \+=?: '(?:int|float)' and 'str'",
        "run-means-join-number",
    ),
    (
        TypeError,
        r"unsupported operand type\(s\) for (?P<operator>\S+?)(?: or \S+)?:"
        r" '(?:int|float|str)' and '(?:int|float|str)'",
        "run-means-calculation",
    ),
    (
        TypeError,
        r"unsupported operand type\(s\) for (?P<operator>\S+?)(?: or \S+)?:"
        r" '(?P<type>\w+)' and '(?P<other_type>\w+)'",
        "run-means-operands",
    ),
    (
        TypeError,
        r"'(?P<operator>[<>]=?)' not supported between instances of"
        r" '(?:str' and '(?:int|float)|(?:int|float)' and 'str)'",
        "run-means-comparison-with-text",
    ),
    (
        TypeError,
        r"'(?P<operator>[<>]=?)' not supported between instances of"
        r" '(?P<type>\w+)' and '(?P<other_type>\w+)'",
        "run-means-comparison",
    ),
    (TypeError, r"can't multiply sequence by non-int of type 'float'", "run-means-multiply"),
    (
        TypeError,
        r"can't multiply sequence by non-int of type '(?P<type>\w+)'",
        "run-means-multiply-by-other",
    ),
    (
        TypeError,
        r"'(?P<type>\w+)' object cannot be interpreted as an integer",
        "run-means-whole-number",
    ),
    (TypeError, r"must be real number, not (?P<type>\w+)", "run-means-number"),
    (TypeError, r"bad operand type for .*: '(?P<type>\w+)'", "run-means-number"),
    (TypeError, r"'(?P<type>\w+)' object is not callable", "run-means-call"),
    (TypeError, r"'(?P<type>\w+)' object is not subscriptable", "run-means-items"),
    (TypeError, r"'(?P<type>\w+)' object is not iterable", "run-means-iteration"),
    (
        TypeError,
        r"cannot unpack non-iterable (?P<type>\w+) object",
        "run-means-unpack-single",
    ),
    (TypeError, r"object of type '(?:int|float)' has no len\(\)", "run-means-length-of-number"),
    (TypeError, r"object of type '(?P<type>\w+)' has no len\(\)", "run-means-length"),
    (
        TypeError,
        r"(?:list|string|tuple) indices must be integers.* not '?str'?",
        "run-means-position-in-quotes",
    ),
    (TypeError, r"(?:list|string|tuple) indices must be integers.*", "run-means-position"),
    (
        TypeError,
        r"'str' object does not support item assignment",
        "run-means-letter-assignment",
    ),
    (
        TypeError,
        r"'(?P<type>\w+)' object does not support item assignment",
        "run-means-item-assignment",
    ),
    (
        TypeError,
        r"(?:\w+\.)*(?P<function>\w+)\(\) missing \d+ required .*: (?P<names>.+)",
        "run-means-missing-argument",
    ),
    (
        TypeError,
        r"(?:\w+\.)*(?P<function>\w+)\(\) takes (?:from \d+ to )?(?P<most>\d+) .*"
        r" but (?P<given>\d+) w.* given",
        "run-means-too-many-arguments",
    ),
    (
        TypeError,
        r"(?:\w+\.)*(?P<function>\w+)\(\) got an unexpected keyword argument '(?P<name>\w+)'.*",
        "run-means-unknown-argument",
    ),
    (
        ValueError,
        r"invalid literal for int\(\) with base 10: (?P<text>'[-+]?\d*\.\d+')",
        "run-means-int-of-decimal",
    ),
    (
        ValueError,
        r"invalid literal for int\(\) with base 10: (?P<text>.+)",
        "run-means-int",
    ),
    (ValueError, r"could not convert string to float: (?P<text>.+)", "run-means-float"),
    (ValueError, r"math domain error|expected a .*input.*", "run-means-domain"),
    (
        ValueError,
        r"(?:no )?(?P<function>max|min|f?mean|median|mode)\b.* (?:empty|at least one)\b.*",
        "run-means-empty-without",
    ),
    (ValueError, r".*empty (?:sequence|iterable)|.*argument is empty", "run-means-empty"),
    (ValueError, r".*at least one data point.*", "run-means-empty"),
    (ValueError, r".*at least two data points.*", "run-means-two-items"),
    (ValueError, r"empty range .*", "run-means-range"),
    (ValueError, r".*(?:is )?not in list", "run-means-not-in-list"),
    (ValueError, r"empty separator", "run-means-separator"),
    (
        ValueError,
        r"not enough values to unpack \(expected (?P<before>\d+), got (?P<after>\d+)\)",
        "run-means-unpack-few",
    ),
    (
        ValueError,
        r"too many values to unpack \(expected (?P<before>\d+).*\)",
        "run-means-unpack-many",
    ),
    (ValueError, r"not enough values to unpack.*", "run-means-unpack"),
)

#: The groups of the patterns that are numbers.
_COUNTS = frozenset(("before", "after"))


def explanation(error: Exception, text: str, failed: FailedCode) -> Phrase | None:
    """What an error of a program means and what to do; None if it is not a frequent one.

    Args:
        error: as it was raised.
        text: its message.
        failed: the code that raised it.
    """
    for kind, pattern, code in _MEANINGS:
        if isinstance(error, kind) and (match := re.fullmatch(pattern, text, re.DOTALL)):
            meaning = Phrase(code, **_values(error, match.groupdict()))
            return in_own_words(meaning, failed)
    return None


def _values(error: Exception, groups: Mapping[str, str]) -> dict[str, Value]:
    if isinstance(error, RecursionError):
        return {"function": _most_frequent(error)}
    if "most" in groups:
        # A method counts the robot as one value more on both sides.
        excess = int(groups["given"]) - int(groups["most"])
        return {"function": groups["function"], "excess": excess}
    return {name: _value(name, text) for name, text in groups.items()}


def _value(name: str, text: str) -> Value:
    if name in _COUNTS:
        return int(text)
    return Phrase("run-type", type=text) if name.endswith("type") else text


def _most_frequent(error: Exception) -> str:
    """The name of the function that was running most often when an error was raised."""
    names = Counter(frame.f_code.co_name for frame, _ in walk_tb(error.__traceback__))
    return next((name for name, _ in names.most_common(1)), "")
