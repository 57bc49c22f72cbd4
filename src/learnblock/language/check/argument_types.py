"""The types of the arguments that each function of the language takes."""

from collections.abc import Mapping
from types import MappingProxyType

from learnblock.language.check.types import NUMBERS, TEXTS, Type

COLLECTIONS = frozenset((Type.LIST, Type.DICTIONARY))
#: What each function takes, by argument.
TAKES: Mapping[str, tuple[frozenset[Type], ...]] = MappingProxyType(
    {
        **dict.fromkeys(
            (
                *("abs", "round", "sqrt", "exp", "log", "log10", "floor", "ceil", "sin", "cos"),
                *("tan", "asin", "acos", "atan"),
            ),
            (NUMBERS,),
        ),
        **dict.fromkeys(("random", "atan2"), (NUMBERS, NUMBERS)),
        "constrain": (NUMBERS, NUMBERS, NUMBERS),
        "len": (TEXTS | COLLECTIONS,),
        "keys": (frozenset((Type.DICTIONARY,)),),
        **dict.fromkeys(("pop", "clear", "copy"), (COLLECTIONS,)),
        **dict.fromkeys(
            (
                *("append", "extend", "insert", "remove", "sort", "reverse"),
                *("shuffle", "mean", "median", "stdev", "sum"),
            ),
            (frozenset((Type.LIST,)),),
        ),
        **dict.fromkeys(("upper", "lower", "title", "strip", "find", "replace", "split"), (TEXTS,)),
    }
)
#: The functions that take a list and one item.
OF_ITEM = frozenset(("append", "remove"))
#: The functions that calculate with the items of a list.
OF_NUMBERS = frozenset(("sum", "mean", "median", "stdev"))
