"""Lines in the words of everyday language and of other tools' blocks, and their Block-Text."""

import re
from collections.abc import Sequence

from learnblock.language.blocktext.foreign_words import foreign_names
from learnblock.language.blocktext.line_rules import NAME, Rule
from learnblock.language.blocktext.other_names import SKILLS_WITH_VALUE
from learnblock.language.tree.builtins import FUNCTIONS, TEMPLATES

_BEHIND = r"(?<=[\w)\"'\]])\s+"
_AHEAD = r"(?=\s+[\w(\"'\[-])"
_VALUE = r"-?\w+(?:\.\w+)?(?:\([^()]*\))?"
_TEXT_OR_LIST = r"(\"[^\"]*\"|'[^']*'|\[[^\[\]]*\])"
_RECEIVERS = "|".join(
    sorted(
        {
            template.name
            for template in TEMPLATES.values()
            if 0 in template.receivers and template.name != "sublist"
        }
    )
)
#: The functions that have only one argument.
_CALLED = "|".join(sorted(FUNCTIONS - {"print", "random", "pi", "elapsedTime"}))
_KEYS = r"(up|down|left|right|space|enter|[a-z0-9])"
_PRESSED = r"when pressed = function.is_key_pressed("


def _pressed(groups: Sequence[str]) -> str:
    key = groups[1].lower()
    return f'{_PRESSED}"{foreign_names("keys").get(key, key)}"):'


def _plain_parameters(groups: Sequence[str]) -> str:
    """A definition with the names of its parameters alone."""
    _, name, parameters = groups[:3]
    plain = [
        re.split(r"[:=]", parameter, maxsplit=1)[0].strip(" *").split()
        for parameter in parameters.split(",")
    ]
    return f"def {name}({', '.join(words[-1] for words in plain if words)}):"


def _signature(parameters: str, ending: str, code: str) -> Rule:
    return Rule(rf"\s*def\s+{NAME}\s*\(({parameters})\)\s*{ending}:\s*$", _plain_parameters, code)


SIGNATURES = (
    _signature(r"[^()]*=(?:[^()]|\([^()]*\))*", r"(?:->[^:]*)?", "blocktext-default-value"),
    _signature(r"\s*\*[^()]*|[^()]*,\s*\*[^()]*", r"(?:->[^:]*)?", "blocktext-any-arguments"),
    _signature(r"[^()]*\w\s*:[^()]*", r"(?:->[^:]*)?", "blocktext-parameter-type"),
    _signature(r"[^()]*\w\s+\w[^()]*", r"(?:->[^:]*)?", "blocktext-parameter-type"),
    _signature(r"[^()]*", r"->[^:]*", "blocktext-result-type"),
)

EVENTS = (
    Rule(
        rf"\s*(?:when|on|if)\s+(?:the\s+)?(?:key\s+)?{_KEYS}\s*(?:arrow\s*)?(?:key\s*)?"
        r"(?:is\s+)?pressed\s*:?\s*$",
        _pressed,
    ),
    Rule(
        r"\s*(?:%at%|%when%)\s+(?:%itself%\s+)?%pressed%\w*\s+(?:%the_key%\s+)?"
        r"(%keys%|[a-z0-9])\s*:?\s*$",
        _pressed,
    ),
    Rule(
        r"\s*when\s+(?:is_)?(?:key_)?pressed\s*\(\s*([\"'][^\"']*[\"'])\s*\)\s*:?\s*$",
        rf"{_PRESSED}\1):",
    ),
    Rule(r"\s*when\s+(?:i|the\s+\w+|program)\s+starts?\s*:?\s*$", "main:"),
    Rule(r"\s*(?:on\s+)?green\s+flag(?:\s+clicked)?\s*:?\s*$", "main:"),
)

LOOPS = (
    Rule(r"\s*(?:do|%do%)\s+(.+?)\s+(?:times|%times%)\s*:?\s*$", r"repeat \1:"),
    Rule(
        rf"\s*for\s+{NAME}\s+(?:in\s+)?({_VALUE})\s*(?:\.\.\.?|to)\s*({_VALUE})\s*:?\s*$",
        r"for \1 from \2 to \3:",
    ),
    Rule(r"\s*for\s+(\w+)\s+in\s+(\d+)\.\.\.?(\w+)\s*:?\s*$", r"for \1 from \2 to \3:"),
    Rule(r"\s*unless\s+(\S.*?)\s*:?\s*$", r"if not (\1):"),
    Rule(r"\s*(?:forever|for\s*ever)\s+do\s*:?\s*$", "forever:"),
)

OPERATORS = (
    *(
        Rule(rf".*?{_BEHIND}(?P<wrong>{wrong}){_AHEAD}", instead)
        for wrong, instead in (
            (
                r"(?:is\s+)?(?:greater|more|bigger|higher|larger)\s+(?:than\s+)?or\s+equal(?:\s+to)?",
                ">=",
            ),
            (r"(?:is\s+)?(?:less|smaller|lower|fewer)\s+(?:than\s+)?or\s+equal(?:\s+to)?", "<="),
            (r"(?:is\s+)?(?:greater|more|bigger|higher|larger)\s+than|is\s+above", ">"),
            (r"(?:is\s+)?(?:less|smaller|lower|fewer)\s+than|is\s+below", "<"),
            ("%more%", ">"),
            ("%less%", "<"),
            (r"is\s+not\s+equal\s+to|(?:does\s+)?not\s+equals?|is\s+not(?!\s+in\b)", "!="),
            (r"is\s+equal\s+to|equals?(?:\s+to)?|%equal%|is", "=="),
            ("plus|%plus%", "+"),
            ("minus|%minus%", "-"),
            (r"times|multiplied\s+by|%multiplied%", "*"),
            (r"divided\s+by|%divided%|over", "/"),
        )
    ),
    Rule(
        rf".*?\b(?P<wrong>({_VALUE})\s+(?:is\s+)?between\s+({_VALUE})\s+and\s+({_VALUE}))",
        r"\3 <= \2 <= \4",
    ),
    Rule(
        rf".*?\b(?P<wrong>({_VALUE})\s+in\s+({_VALUE})\s*(?:to|\.\.)\s*({_VALUE}))",
        r"\3 <= \2 <= \4",
    ),
    Rule(rf".*?(?P<wrong>({_VALUE}\s*<=?\s*[^\W\d]\w*)\s+and\s+(<=?))", r"\2 \3"),
    Rule(
        rf".*?\b(?P<wrong>(?:pick\s+)?random\s+(?:number\s+)?(?:from\s+|between\s+)?({_VALUE})\s+"
        rf"(?:to|and)\s+({_VALUE}))",
        r"random(\2, \3)",
    ),
    Rule(
        rf".*?\b(?P<wrong>%random%\s+({_VALUE})\s+%up_to%\s+({_VALUE}))",
        r"random(\2, \3)",
    ),
)


#: The rules know no capitals.
_CALLS_WITH_VALUE = {name.lower(): call for name, call in SKILLS_WITH_VALUE.items()}


def _of_robot(groups: Sequence[str]) -> str:
    """Our call for one of another tool's robot, such as ``robot.forward(10)``."""
    _, _, name, value = groups[:4]
    return f"function.{_CALLS_WITH_VALUE[name.lower()].format(value).replace('--', '')}"


#: Tried before the rule for every ``robot.`` of Python.
ROBOT = (
    Rule(
        rf".*?\b(?P<wrong>(?:robot|functions|Function)\.({'|'.join(sorted(_CALLS_WITH_VALUE))})"
        r"\(\s*(-?[\w.]+|\"[^\"]*\"|'[^']*')\s*\))",
        _of_robot,
    ),
)

CALLS = (
    Rule(rf".*?(?P<wrong>{_TEXT_OR_LIST}\.({_RECEIVERS})\s*\(\s*\))", r"\3(\2)"),
    Rule(rf".*?(?P<wrong>{_TEXT_OR_LIST}\.({_RECEIVERS})\s*\(\s*(?=[^\s)]))", r"\3(\2, "),
    Rule(rf".*?(?P<wrong>{_TEXT_OR_LIST}\.(?:length|size|len)\b(?:\s*\(\s*\))?)", r"len(\2)"),
    Rule(
        rf".*?(?<![\w.])(?P<wrong>({_CALLED})\s+([^\W\d]\w*|[\d.]+|\"[^\"]*\"|'[^']*'))(?=\s*(?:[:)]|$))",
        r"\2(\3)",
    ),
)
