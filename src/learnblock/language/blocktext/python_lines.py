"""Python that Block-Text has only between backticks, and what to write instead."""

import sys
from collections.abc import Sequence

from learnblock.language.blocktext.line_rules import NAME, Rule

#: Packages that learners have heard of; no library of LearnBlock has such a name.
_PACKAGES = (
    "cv2|ev3dev2|gpiozero|guizero|irobot_edu_sdk|machine|matplotlib|microbit|numpy|pandas|PIL|pgzrun"
    "|pybricks|pygame|requests|scipy|serial|sklearn|tensorflow|torch"
)
_MODULES = "|".join(sorted(name for name in sys.stdlib_module_names if name[0] != "_"))


def _in_backticks(groups: Sequence[str]) -> str:
    return f"`{groups[0]}`"


IMPORTS = (
    # What comes with Python is no library of LearnBlock.
    Rule(
        rf"\s*(?P<wrong>(?:import|from)\s+(?:{_MODULES}|{_PACKAGES})\b(?!\s*\().*?)\s*$",
        _in_backticks,
    ),
    # Nor is what is imported under another name, or from inside a package.
    Rule(
        r"\s*(?P<wrong>(?:import|from)\s+[^\W\d]\w*(?:\.\w+|\s.*\bas\s+\w).*?)\s*$", _in_backticks
    ),
)
MATCH = Rule(r"\s*(?P<wrong>match\b\s*(?![=.,:\[])(\S.*?)\s*:)\s*$", r"`match \2`:")
#: Parts of a ``match``; elsewhere they come from another language.
CASES = (
    Rule(r"\s*(?P<wrong>case\b\s*(?![=.,:])(\S.*?)\s*:?)\s*$", r"`case \2`:"),
    Rule(r"\s*(?P<wrong>(?:default|otherwise)\s*:)\s*$", "`case _`:"),
)
_OWNER = rf"(?!(?:functions?|fuction|funtion|robot)\b){NAME}"
#: What has a dot in it, such as `turtle.forward` and `pets[0].name`.
_DOTTED = rf"{_OWNER}(?:\[[^\[\]]*\]|\([^()]*\))*\.[^\W\d]\w*"
#: A variable that is set inside an expression.
_WALRUS = rf"{NAME}\s*:=\s*([^(),:\s](?:[^(),]|\([^()]*\))*?)"
#: Operators that other rules would take for those of other languages.
OPERATORS = (
    Rule(rf"\s*(?P<wrong>{NAME}\s*(?:[|&^@]|<<|>>)=\s*[^\s=].*?)\s*$", _in_backticks),
    Rule(r".*?(?:=|\breturn\b)\s*(?P<wrong>~?\w+\s*(?:<<|>>|@)\s*\w+|~\w+)\s*$", _in_backticks),
    # A loop and an `elif` find the value again and again, or only now.
    Rule(rf"\s*(?:while|elif)\b.*?(?P<wrong>\(\s*{_WALRUS}\s*\))", _in_backticks),
    *(
        Rule(pattern, r"\2", "blocktext-walrus", (("line", r"\2 = \3"),))
        for pattern in (
            rf".*?(?<![\w)\]])(?P<wrong>\(\s*{_WALRUS}\s*\))",
            rf".*?[(\[,]\s*(?P<wrong>{_WALRUS})\s*(?=[,)\]])",
        )
    ),
)
DOTS = (
    Rule(rf"\s*(?P<wrong>{_DOTTED}\s*\(.*\)|{_DOTTED}\s*[-+*/]?=\s*[^\s=].*?)\s*$", _in_backticks),
    Rule(rf"\s*(?:{NAME}\s*=|return\b)\s*(?P<wrong>{_DOTTED}(?:\s*\(.*\))?)\s*$", _in_backticks),
)
OTHERS = (
    # A decorator.
    Rule(r"\s*(?P<wrong>@\s*[^\W\d][\w.]*(?:\(.*\))?)\s*$", _in_backticks),
    # A list or a dictionary as the arguments of a call.
    Rule(r"\s*(?P<wrong>[^\W\d]\w*\((?:.*,)?\s*\*\*?\s*[^\W\d\s].*\))\s*$", _in_backticks),
    Rule(r".*?\bin\s+(?P<wrong>\(([^()`]*,[^()`]*?),?\s*\))", r"[\2]"),
    Rule(
        r"(?!.*\b(?:def|for)\b).*?(?:[=(,\[+*]|\breturn\b)\s*(?P<wrong>\([^()`]*,[^()`]*\))",
        _in_backticks,
        "blocktext-tuple",
    ),
    Rule(
        r"(?!.*\sfor\s).*?(?:[=(,\[]|\breturn\b)\s*(?P<wrong>\{\s*[^\s{}:=`][^{}:=`]*\})",
        _in_backticks,
        "blocktext-set",
    ),
)
