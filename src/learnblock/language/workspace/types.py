"""The types, fields and inputs of the blocks, for each element of the language."""

import re
import unicodedata
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from learnblock.blocks.ready_hats import READY_HATS
from learnblock.language.blocktext.lexer import KEYWORDS
from learnblock.language.tree.identifiers import MARKS, normal

COMMENT = "lb_comment"
MAIN, START, WHEN = "lb_main", "lb_start", "lb_when"
FUNCTION, ANSWERING_FUNCTION = "procedures_defnoreturn", "procedures_defreturn"
FOR_EACH, FOR_UNPACKING = "controls_forEach", "lb_for_unpacking"
FOREVER, WHILE = "lb_forever", "controls_whileUntil"
#: The blocks of a ``when``: with any condition or none, or ready with that of one skill.
WHENS = frozenset((WHEN, *READY_HATS))
#: The blocks that begin a part of the program; under any other block, only comments belong to it.
HATS = frozenset((MAIN, START, FUNCTION, ANSWERING_FUNCTION)) | WHENS

#: The prefix of unknown skills' names, which share a block with other calls.
SKILL_PREFIX = "function."

MANUALLY_DISABLED = "MANUALLY_DISABLED"

ARITHMETIC = MappingProxyType(
    {"+": "ADD", "-": "MINUS", "*": "MULTIPLY", "/": "DIVIDE", "**": "POWER"}
)
LOGIC = MappingProxyType({"and": "AND", "or": "OR"})
COMPARISONS = MappingProxyType(
    {"==": "EQ", "!=": "NEQ", "<": "LT", "<=": "LTE", ">": "GT", ">=": "GTE"}
)
MEMBERSHIPS = ("in", "not in")
CONSTANTS = MappingProxyType({True: "TRUE", False: "FALSE"})


class Library(NamedTuple):
    """One of Blockly's own blocks, which represents a library function.

    Args:
        type: the type of the block.
        inputs: the inputs for the arguments, in order.
        field: the field that selects the function, or "".
        value: the value of that field.
        extra: the extra state of the block.
    """

    type: str
    inputs: tuple[str, ...] = ()
    field: str = ""
    value: str = ""
    extra: object = None


def _family(kind: str, name: str, field: str, functions: str) -> dict[tuple[str, int], Library]:
    pairs = (pair.split("=") for pair in functions.split())
    return {(function, 1): Library(kind, (name,), field, value) for function, value in pairs}


def _of_lists(functions: str) -> dict[tuple[str, int], Library]:
    return {
        key: library._replace(extra=f'<mutation op="{library.value}"></mutation>')
        for key, library in _family("math_on_list", "LIST", "OP", functions).items()
    }


def _splitting(mode: str) -> Library:
    return Library("lists_split", ("INPUT", "DELIM"), "MODE", mode, {"mode": mode})


#: The blocks of functions, by name and number of arguments.
LIBRARY: Mapping[tuple[str, int], Library] = MappingProxyType(
    {
        ("len", 1): Library("lists_length", ("VALUE",)),
        ("random", 2): Library("math_random_int", ("FROM", "TO")),
        ("random_fraction", 0): Library("math_random_float"),
        ("pi", 0): Library("math_constant", (), "CONSTANT", "PI"),
        ("constrain", 3): Library("math_constrain", ("VALUE", "LOW", "HIGH")),
        ("atan2", 2): Library("math_atan2", ("Y", "X")),
        ("elapsedTime", 1): Library("lb_elapsed_time", ("SECONDS",)),
        ("input", 1): Library(
            "text_prompt_ext", ("TEXT",), "TYPE", "TEXT", '<mutation type="TEXT"></mutation>'
        ),
        ("strip", 1): Library("text_trim", ("TEXT",), "MODE", "BOTH"),
        ("find", 2): Library("text_indexOf", ("VALUE", "FIND"), "END", "FIRST"),
        ("replace", 3): Library("text_replace", ("TEXT", "FROM", "TO")),
        ("keys", 1): Library("lb_dictionary_keys", ("DICTIONARY",)),
        ("items", 1): Library("lb_dictionary_items", ("DICTIONARY",)),
        ("split", 2): _splitting("SPLIT"),
        ("join", 2): _splitting("JOIN"),
        **_family("math_single", "NUM", "OP", "sqrt=ROOT abs=ABS log=LN log10=LOG10 exp=EXP"),
        **_family(
            "math_trig", "NUM", "OP", "sin=SIN cos=COS tan=TAN asin=ASIN acos=ACOS atan=ATAN"
        ),
        **_family("math_round", "NUM", "OP", "round=ROUND ceil=ROUNDUP floor=ROUNDDOWN"),
        **_family(
            "text_changeCase", "TEXT", "CASE", "upper=UPPERCASE lower=LOWERCASE title=TITLECASE"
        ),
        **_of_lists(
            "sum=SUM min=MIN max=MAX mean=AVERAGE median=MEDIAN mode=MODE stdev=STD_DEV "
            "choice=RANDOM"
        ),
    }
)
#: The functions that each type of block can represent, by the value of its field.
FUNCTIONS_OF: Mapping[str, Mapping[str, tuple[str, Library]]] = MappingProxyType(
    {
        kind: {
            entry.value: (name, entry) for (name, _), entry in LIBRARY.items() if entry.type == kind
        }
        for kind in {entry.type for entry in LIBRARY.values()}
    }
)


def variable_fields(count: int) -> tuple[str, ...]:
    """The names of the fields with the variables of a loop: VAR, VAR1, VAR2 and so on."""
    return ("VAR", *(f"VAR{place}" for place in range(1, count)))


def is_word(text: str) -> bool:
    """Whether a string can name a skill or an argument."""
    return normal(text) == text


def is_name(text: str) -> bool:
    """Whether a string can name a variable, a function or a ``when``."""
    return is_word(text) and text not in KEYWORDS


def as_name(text: str) -> str:
    """The valid name most similar to a string."""
    plain = re.sub(rf"[^\w{MARKS}]+", "_", unicodedata.normalize("NFKC", text).strip())
    if not plain.isidentifier():
        plain = "_" + plain
    return plain + "_" if plain in KEYWORDS else plain
