"""Lines that pupils bring from Scratch, MakeCode, C and other languages, and their Block-Text.

Each rule is a pattern for a line, and the replacement for the group ``wrong``, or else for the
whole line. A pattern sees a line without its comment, with spaces in place of the characters in
strings, and is tried only on a line that cannot be read.
"""

import re
from collections.abc import Sequence

from learnblock.language.blocktext import python_lines, spoken_lines
from learnblock.language.blocktext.line_rules import NAME, REST, Rule, at_start
from learnblock.language.blocktext.several_targets import SEVERAL_TARGETS
from learnblock.language.tree.builtins import TEMPLATES

NAME_WITH_SPACE = Rule(
    rf"\s*(?P<wrong>(?!(?:if|while|for|when|def)\b){NAME}\s+{NAME})\s*(?==[^=])",
    r"\2_\3",
    "blocktext-name-with-space",
)
TEXT_WITHOUT_QUOTES = Rule(
    r".*?\((?P<wrong>\s*([^\W\d]\w*(?:\s+[^\W\d]\w*)+)[!?.]*)\s*\)",
    r'"\2"',
    "blocktext-text-in-quotes",
)

CURLY_QUOTES = Rule(
    r".*?(?P<wrong>[“”„«]([^“”„«»\"]*)[“”»]|‘([^‘’\"]*)’)", r'"\2\3"', "blocktext-straight-quotes"
)


_COMMENTS = (
    Rule(r"\s*(?P<wrong>//+|--+|/\*+)", "#", "blocktext-comment"),
    Rule(r"\s*(?P<wrong>(?!\s)(.*?)\s*\*/)\s*$", r"# \2", "blocktext-comment"),
)

_ENDS = (
    at_start(r"%end%\s*(?:%if%|%while%|%for%|%repeat%|%of%\s+\w+)\s*$", "end"),
    at_start(
        r"end\s*(?:if|while|repeat|for|when|def|main|function|forever)\s*$",
        "end",
    ),
    at_start(r"(?:end|%end%|fi|done|od|wend|next|fim)\s*[.;]?\s*$", "end"),
    Rule(r"\s*(?P<wrong>\}\s*else\s*if\b)", "elif"),
    Rule(r"\s*(?P<wrong>\}\s*else\s*\{)", "else:"),
    Rule(r"\s*(?P<wrong>\})\s*$", "end"),
)


def _counted(groups: Sequence[str]) -> str:
    """The loop that begins ``for (i = 0; i < 4;`` in C."""
    _, name, first, end = groups
    return f"for {name} from {first} to {int(end) - 1 if end.isdecimal() else end + ' - 1'}:"


def _with_commas(groups: Sequence[str]) -> str:
    """A list without its semicolons, except those in texts."""
    return re.sub(r"(\"[^\"]*\"|'[^']*')|;", lambda part: part[1] or ",", groups[0])


#: An item of a list: a number, a text or a variable.
_ITEM = (
    r"(?:-?\d[\d.]*|(?!(?:and|or|not|in|is|if|else|for)\b)[^\W\d]\w*"
    r"|\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*')"
)


def _with_missing_commas(groups: Sequence[str]) -> str:
    """A list with a comma after each item."""
    return f"[{', '.join(re.findall(_ITEM, groups[0]))}]"


_LOOPS = (
    Rule(
        r"\s*for\s*\(?\s*(?:int|let|var)?\s*(\w+)\s*=\s*(\w+)\s*;\s*\w+\s*<\s*(\w+)\s*;.*$",
        _counted,
    ),
    Rule(
        r"\s*for\s*\(?\s*(?:int|let|var)?\s*(\w+)\s*=\s*(\w+)\s*;\s*\w+\s*<=\s*(\w+)\s*;.*$",
        r"for \1 from \2 to \3:",
    ),
    Rule(r"\s*(?:repeat|%repeat%|for|loop)\s+(.+?)\s+(?:times|%times%)\s*:?\s*$", r"repeat \1:"),
    Rule(
        r"\s*(?:repeat|%repeat%|loop)\s+(?:until|%until%)\s+" + REST,
        r"while not (\1):",
    ),
    Rule(r"\s*(?:repeat|loop)\s+while\s+" + REST, r"while \1:"),
    Rule(
        r"\s*(?:wait|%wait%)\s+(?:unti?ll?|%until%)\s+" + REST,
        r"wait until \1",
    ),
    Rule(r"\s*(?:until|%until%)\s+" + REST, r"while not (\1):"),
    Rule(r"\s*(?:repeat|%repeat%)\s*:?\s*$", "forever:", "blocktext-repeat-number"),
    Rule(
        r"\s*(?:forever|repeat\s+forever|loop|%forever%|do)\s*:?\s*$",
        "forever:",
        "blocktext-endless",
    ),
    Rule(r"\s*for\s+(\d+)\s*:\s*$", r"repeat \1:"),
    Rule(r"\s*(?P<wrong>for\s*each)\b", "for"),
    Rule(
        rf"\s*%for%\s+{NAME}\s+%from%\s+(.+?)\s+%to%\s+" + REST,
        r"for \1 from \2 to \3:",
    ),
    Rule(rf"\s*%for%\s+(?:%each%\s+)?{NAME}\s+(?:%in%|in)\s+" + REST, r"for \1 in \2:"),
    Rule(
        rf"\s*for\s+{NAME}\s+(?:=|%from%)\s*(.+?)\s+(?:to|%to%)\s+" + REST,
        r"for \1 from \2 to \3:",
    ),
)

_EVENTS = (
    Rule(r"\s*when\s+(?:green\s+)?flag(?:\s+is)?\s*clicked\s*:?\s*$", "main:"),
    Rule(
        r"\s*(?:on\s+start|begin|start|program|%start%)\s*:?\s*$",
        "main:",
    ),
    Rule(r"\s*(?:%at%|%when%)\s+.*%flag%.*$", "main:"),
    Rule(rf"\s*(?:when\s+i\s+receive|%receive%)\s+{NAME}\s*:?\s*$", r"when \1:"),
    Rule(
        rf"\s*(?:broadcast|%send%)\s+{NAME}\s*$",
        r"activate \1",
        "blocktext-broadcast",
        (("name", r"\1"),),
    ),
    Rule(
        r"\s*(?:when|on|%at%)\s+(?:.*\s)?(?:key|button|%key%)\b.*$",
        "when pressed:",
        "blocktext-no-event",
    ),
    Rule(
        r"\s*when\s+(\(.*\)|(?:function\.|not\b|\w+\s*[<>!=]=|\w+\s*[<>]).*?)\s*:\s*$",
        r"when seen = \1:",
        "blocktext-when-needs-name",
    ),
    Rule(rf"\s*(?P<wrong>when\s+{NAME})\s*\(\s*\)", r"when \2"),
)

_DEFINITIONS = (
    Rule(r"\s*(?:def\s+|void\s+|function\s+)?main\s*\(\s*\)\s*[:{]?\s*$", "main:"),
    Rule(rf"\s*(?:def|define|%define%|procedure|sub|to)\s+{NAME}\s*:\s*$", r"def \1():"),
    at_start(r"(?:define|%define%|%function%|procedure|func|fn|void)(?=\s+\w)", "def"),
    Rule(
        rf"\s*(?P<wrong>function)\s+{NAME}\s*(\([^)]*\))\s*[:{{]",
        "def",
        "blocktext-function-for-def",
        (("header", r"def \2\3:"),),
    ),
    Rule(rf"\s*(?:call|run|execute|%call%)\s+{NAME}\s*(?:\(\s*\))?\s*$", r"\1()"),
)

#: A line that ends in a brace, once its words are right.
_BRACES = (Rule(r"(?P<wrong>\s*\{)\s*$", ":"), Rule(r".*?\S(?P<wrong>\s*:?\s*\{)\s*$", ":"))

KEYWORDS = tuple(
    at_start(words, instead)
    for words, instead in (
        (r"(?:%else%|else)(?=\s*:)", "else"),
        ("%elif%|elseif|elsif|elif", "elif"),
        ("%if%|if", "if"),
        ("%while%|while", "while"),
        ("%main%|main", "main"),
        ("%repeat%|repeat", "repeat"),
        ("%for%|for", "for"),
        ("%when%|when", "when"),
        ("%import%|import", "import"),
        ("%activate%|activate", "activate"),
        ("%deactivate%|deactivate", "deactivate"),
        ("%break%|break", "break"),
        ("%return%|return", "return"),
        ("%continue%|continue", "continue"),
        ("%pass%|pass", "pass"),
        ("def", "def"),
    )
)

_ACTIONS = (
    Rule(r"\s*(?:set|%set%)\s+(\w+)\s+(?:to|%set_to%)\s+(.+?)\s*$", r"\1 = \2"),
    Rule(r"\s*(?:change|%change%)\s+(\w+)\s+(?:by|%change_by%)\s+(.+?)\s*$", r"\1 += \2"),
    Rule(
        r"\s*(?:wait|sleep|pause|%wait%|%pause%)\s+([\d.]+|\w+)\s*(?:s|secs?|seconds?|%seconds%)?\s*$",
        r"function.sleep(\1)",
    ),
    Rule(
        r"\s*(?:say|%say%|speak)\s+((?P<quote>[\"'])[^\"']*(?P=quote)|\w+)\s*$",
        r"function.say_Text(\1)",
    ),
    Rule(
        r"\s*(?:ask|%ask%)\s+((?P<quote>[\"'])[^\"']*(?P=quote))(?:\s+and\s+wait)?\s*$",
        r"answer = input(\1)",
    ),
    Rule(r"\s*(?:print|%print%|echo|show)\s+(\S.*?)\s*$", r"print(\1)"),
    Rule(
        r"\s*(?:go|move|drive|%go%|forward)\s+[\d.]+\s+(?:steps?|%steps%)\s*$",
        "function.move_straight(40)",
        "blocktext-steps",
    ),
    Rule(
        r"\s*(?:go|move|drive|%go%|forward)(?:\s+(?:forwards?|straight|[\d.]+))*\s*$",
        "function.move_straight(40)",
        "blocktext-drive",
    ),
    Rule(
        r"\s*(?:turn|%turn%)\s+(?:right|%right%)\s+([\d.]+)\s*(?:degrees?|%degrees%|°)?\s*$",
        r"function.turn(\1)",
    ),
    Rule(
        r"\s*(?:turn|%turn%)\s+(?:left|%left%)\s+([\d.]+)\s*(?:degrees?|%degrees%|°)?\s*$",
        r"function.turn(-\1)",
    ),
    Rule(r"\s*(?:turn|%turn%)\s+(right|left)\s*$", r"function.turn_\1()"),
    Rule(r"\s*(?:turn|%turn%)\s+(-?[\d.]+)\s*(?:degrees?|%degrees%|°)?\s*$", r"function.turn(\1)"),
    Rule(
        r"\s*(?:stop|%stop%)\s+(?:all|everything|%everything%|this\s+script)\s*$",
        "function.stop_bot()",
        "blocktext-stop-all",
    ),
    Rule(r"\s*(?:stop|%stop%|%halt%)(?:\s+robot)?\s*$", "function.stop_bot()"),
)

_ASSIGNMENTS = (
    Rule(
        r"\s*[^\W\d]\w*\s*[-+*/]?=\s*(?P<wrong>(\d+)\.(\d{3}),(\d+))\s*$",
        r"\2\3.\4",
        "blocktext-decimal-comma",
    ),
    NAME_WITH_SPACE,
    Rule(rf"\s*(?P<wrong>{NAME}-{NAME})\s*(?==[^=])", r"\2_\3", "blocktext-name-with-hyphen"),
    Rule(rf"\s*(?P<wrong>(\d+){NAME})\s*(?==[^=])", r"\3\2", "blocktext-name-with-digit"),
    Rule(rf"\s*([\d.]+)\s*(?:=|->)\s*{NAME}\s*$", r"\2 = \1"),
    Rule(rf"\s*{NAME}\s*(?P<wrong>:=|<-|=>)", "="),
    Rule(rf"\s*(?P<wrong>\+\+\s*{NAME})\s*$", r"\2 += 1"),
    Rule(
        r"\s*[^\W\d]\w*\s*[-+*/]?=\s*(?P<wrong>(\d+),(\d+))\s*$",
        r"\2.\3",
        "blocktext-decimal-comma",
    ),
    # The second value does not use the first variable, which would be set by then.
    Rule(
        rf"\s*{NAME}\s*,\s*{NAME}\s*=\s*([^\s=,()\[\]][^,()\[\]]*?)\s*,"
        r"\s*(?!.*\b\1\b)([^\s,()\[\]][^,()\[\]]*?)\s*$",
        r"\1 = \3",
        "blocktext-two-targets",
        (("second", r"\2 = \4"),),
    ),
    Rule(
        rf"\s*{NAME}\s*,\s*{NAME}\s*=\s*\2\s*,\s*\1\s*$",
        r"\1 = \2",
        "blocktext-swap",
        (("first", r"\1"), ("second", r"\2")),
    ),
    Rule(rf"\s*{NAME}\s*,\s*{NAME}\s*=[^=].*$", r"\1 = 0", "blocktext-second-assignment"),
    *SEVERAL_TARGETS,
    Rule(
        rf"\s*{NAME}\s*=\s*{NAME}\s*=\s*([^\s=<>][^=]*?)\s*$",
        r"\2 = \3",
        "blocktext-two-targets",
        (("second", r"\1 = \2"),),
    ),
    Rule(
        rf"\s*({NAME}\s*[-+*/]\s*\w+)\s*=\s*([^\s=<>][^=]*?)\s*$",
        r"\2 = 0",
        "blocktext-sum-as-target",
        (("name", r"\2"), ("sum", r"\1"), ("value", r"\3")),
    ),
)

_CALLS = (
    Rule(r".*?(?P<wrong>\[[^\[\]]*;[^\[\]]*\])", _with_commas, "blocktext-comma-in-list"),
    Rule(r".*\[[^\]]*(?P<wrong>;)", ",", "blocktext-comma-in-list"),
    Rule(
        rf".*?(?P<wrong>\[\s*{_ITEM}(?:\s*,\s*{_ITEM})*\s+{_ITEM}(?:\s*[\s,]\s*{_ITEM})*\s*\])",
        _with_missing_commas,
        "blocktext-comma-in-list",
    ),
    Rule(r".*?\b(?P<wrong>function\s*[,:;\s]\s*([^\W\d]\w*))(?=\s*\()", r"function.\2"),
    Rule(r"\s*(?P<wrong>function\.(\w+)\s*[-\s]\s*([^\W\d]\w*))\s*\(", r"function.\2_\3"),
    Rule(r"\s*(?P<wrong>function\.(\w+)\s*\[([^\]]*)\])\s*$", r"function.\2(\3)"),
    Rule(r"\s*(?P<wrong>function\.(\w+)\s+(-?[\d.]+|[\"'][^\"']*[\"']))\s*$", r"function.\2(\3)"),
    Rule(r".*\([^()]*?(?P<wrong>\b([^\W\d]\w*)\s*:)(?=[^()]*\))", r"\2="),
    Rule(
        r".*?(?P<wrong>(?<![\w.])(\d+(?:\.\d+)?)\s*(?:°|º|%|mm|cm|m|ms|s|secs?|seconds?|%seconds%|degrees?|%degrees%|steps)(?=\s*[,)]))",
        r"\2",
        "blocktext-unit",
    ),
    TEXT_WITHOUT_QUOTES,
    Rule(r".*?(?P<wrong>´([^´]*)´)", r'"\2"', "blocktext-straight-quotes"),
    Rule(r".*?(?P<wrong>''\s*([^']+)'')", r'"\2"', "blocktext-two-quotes"),
)

OPERATORS = (
    *(
        Rule(rf".*?(?P<wrong>{wrong})", instead)
        for wrong, instead in (
            (r"=>", ">="),
            (r"=<", "<="),
            (r"<>", "!="),
            (r"!==", "!="),
            (r"===|=\s+=", "=="),
            (r"&&?", "and"),
            (r"\|\|?", "or"),
            (r"!(?!=)", "not "),
            (r"(?<=\w)\s+mod(?=\s)", " %"),
            (r"(?<=\w)\s+div(?=\s)", " //"),
        )
    ),
    Rule(r".*?\d\s+(?P<wrong>x)\s+\d", "*", "blocktext-multiply"),
    Rule(r".*?(?<![\w.])(?P<wrong>(\d+)\s*\()", r"\2 * (", "blocktext-multiply"),
    Rule(
        r"\s*(?:if|elif|while|when)\b.*?\b([^\W\d]\w*)\s*(?:[<>]=?|[!=]=)\s*[^\s:]+\s+"
        r"(?P<wrong>(or|and)\s+([<>]=?|[!=]=))",
        r"\3 \1 \4",
        "blocktext-name-again",
    ),
    Rule(r"\s*(?:if|elif|while|when)\b.*?(?<=[\w)\"'])\s+(?P<wrong>%and%)\s+(?=[\w(\"'-])", "and"),
    Rule(r"\s*(?:if|elif|while|when)\b.*?(?<=[\w)\"'])\s+(?P<wrong>%or%)\s+(?=[\w(\"'-])", "or"),
    Rule(r".*?\b(?:if|elif|while|and|or|=|\()\s*(?P<wrong>%not%)\s+(?=[\w(])", "not"),
    Rule(
        r"\s*(?:if|elif|while|repeat|for|when)\b.*?(?P<wrong>\s+(?:then|%then%|do)\s*:?)\s*$",
        ":",
    ),
)

_METHODS = "|".join(
    sorted(
        {
            template.name
            for template in TEMPLATES.values()
            if 0 in template.receivers and template.name != "sublist"
        }
    )
)
_FUNCTIONS = "|".join(sorted({name for name, _ in TEMPLATES}))

_PYTHON = (
    Rule(
        r"\s*(?P<wrong>from\s+learnblock\b.*|robot\s*=\s*\w+\(.*\)|import\s+learnblock.*)\s*$",
        "pass",
        "blocktext-python-file",
    ),
    Rule(
        r"\s*(?P<wrong>(?:import|from)\s+(?:math|random|time|statistics)\b.*)$",
        "pass",
        "blocktext-import-not-needed",
    ),
    *python_lines.IMPORTS,
    Rule(r"\s*(?P<wrong>import\s+([^\W\d]\w*))\s*$", r'import "\2"'),
    Rule(r"\s*(?P<wrong>from\s+([^\W\d]\w*)\s+import\b.*)$", r'import "\2"'),
    *python_lines.OTHERS,
    Rule(rf"\s*del\s+{NAME}\[\s*(\S.*?)\s*\]\s*$", r"pop(\1, \2)"),
    Rule(r".*?\b(?P<wrong>math\.pi)\b(?!\s*\()", "pi()"),
    Rule(r".*?\b(?P<wrong>random\.random\s*\(\s*\))", "random_fraction()"),
    Rule(r".*?\b(?P<wrong>random\.(?:randint|randrange))(?=\s*\()", "random"),
    Rule(r".*?\b(?P<wrong>time\.sleep)(?=\s*\()", "function.sleep"),
    Rule(rf".*?\b(?P<wrong>(?:math|random|statistics)\.({_FUNCTIONS}))(?=\s*\()", r"\2"),
    Rule(r".*?\b(?P<wrong>basic\.show(?:Number|String|Leds|Icon))(?=\s*\()", "print"),
    Rule(
        r".*?\b(?P<wrong>basic\.pause\s*\(\s*(\d+)\s*\))",
        lambda groups: f"function.sleep({int(groups[2]) / 1000:g})",
    ),
    Rule(r".*?\b(?P<wrong>(?:console\.log|System\.out\.println))(?=\s*\()", "print"),
    Rule(
        rf".*?\b(?P<wrong>(?:robot|functions|fuction|funtion|Function)\.({NAME}))(?=\s*\()",
        r"function.\2",
    ),
    Rule(r".*?\b(?P<wrong>([^\W\d]\w*)\.(?:length|size|len)\b(?:\s*\(\s*\))?)", r"len(\2)"),
    Rule(rf".*?\b(?P<wrong>([^\W\d]\w*)\.({_METHODS})\s*\(\s*\))", r"\3(\2)"),
    Rule(rf".*?\b(?P<wrong>([^\W\d]\w*)\.({_METHODS})\s*\(\s*([^\s()][^()]*)\))", r"\3(\2, \4)"),
    Rule(rf".*?\b(?P<wrong>([^\W\d]\w*)\.({_METHODS})\s*\(\s*(?=[^\s)]))", r"\3(\2, "),
    Rule(
        rf"\s*{NAME}\s*=\s*(?P<wrong>([^=?]*?[^=?\s])\s*\?\s*([^:]*?\S)\s*:\s*(\S.*?))\s*$",
        r"\4 if \3 else \5",
    ),
    Rule(
        rf"\s*{NAME}\s*=\s*(?P<wrong>lambda\b\s*(?!\s)([\w\s,]*?)\s*:\s*(\S.*?))\s*$",
        r"`\2`",
        "blocktext-lambda",
        (("header", r"def \1(\3):"), ("value", r"\4")),
    ),
    *python_lines.DOTS,
    *(
        Rule(
            rf"\s*{NAME}\s*=\s*(?P<wrong>{wrong}.*?)\s*$",
            r"`\2`",
            code,
            (("line", r"\1 = `\2`"),),
        )
        for wrong, code in ((r"[\[{].*\sfor\s", "blocktext-comprehension"),)
    ),
)

RULES = (
    CURLY_QUOTES,
    *_COMMENTS,
    *_ENDS,
    python_lines.MATCH,
    *spoken_lines.EVENTS,
    *_EVENTS,
    *_LOOPS,
    *spoken_lines.LOOPS,
    *spoken_lines.SIGNATURES,
    *_DEFINITIONS,
    *_ACTIONS,
    *KEYWORDS,
    *python_lines.OPERATORS,
    *_ASSIGNMENTS,
    *_BRACES,
    *spoken_lines.ROBOT,
    *_PYTHON,
    *OPERATORS,
    *spoken_lines.OPERATORS,
    *spoken_lines.CALLS,
    *_CALLS,
)
