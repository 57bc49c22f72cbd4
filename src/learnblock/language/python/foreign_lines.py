"""Lines that pupils bring from Block-Text, Scratch, C and their language, and their Python.

Like `learnblock.language.blocktext.foreign_lines`, but for a line that Python cannot read.
"""

from learnblock.language.blocktext.foreign_lines import (
    CURLY_QUOTES,
    KEYWORDS,
    NAME_WITH_SPACE,
    OPERATORS,
    TEXT_WITHOUT_QUOTES,
)
from learnblock.language.blocktext.line_rules import NAME, REST, Rule, at_start

_LOOPS = (
    Rule(
        r"\s*(?:repeat|%repeat%)\s+(.+?)(?:\s+(?:times|%times%))?\s*:\s*$",
        r"for i in range(\1):",
    ),
    Rule(r"\s*(?:repeat|%repeat%)\s+(?:until|%until%)\s+" + REST, r"while not (\1):"),
    Rule(
        r"\s*(?:wait|%wait%)\s+(?:unti?ll?|%until%)\s+" + REST,
        r"robot.wait_until(lambda: \1)",
    ),
    Rule(r"\s*until\s+" + REST, r"while not (\1):"),
    Rule(r"\s*(?:forever|loop|repeat\s+forever|%forever%)\s*:?\s*$", "while True:"),
    Rule(rf"\s*for\s+{NAME}\s+from\s+(.+?)\s+to\s+" + REST, r"for \1 in range(\2, \3 + 1):"),
    Rule(
        rf"\s*for\s*\(?\s*(?:int|let|var)?\s*{NAME}\s*=\s*(\w+)\s*;\s*\w+\s*<\s*(\w+)\s*;.*$",
        r"for \1 in range(\2, \3):",
    ),
    Rule(r"\s*for\s.*\bin\s+(?P<wrong>range\s+(\w+))\s*:", r"range(\2)"),
)
#: How `when` is written and misspelled.
_WHEN = "(?:when|whem|wehn|whne|whn|wen|hwen|%when%)"
_BLOCK_TEXT = (
    *(
        Rule(pattern, "", "python-when", (("decorator", decorator), ("name", r"\1")))
        for pattern, decorator in (
            (rf"\s*{_WHEN}\s+(start)\s*:\s*$", "@robot.when_start"),
            (rf"\s*{_WHEN}\s+{NAME}\s*:\s*$", "@robot.when"),
            (rf"\s*{_WHEN}\s+{NAME}\s*=\s*(\S.*?)\s*:\s*$", r"@robot.when(lambda: \2)"),
        )
    ),
    Rule(r"\s*@robot\.when\(\s*(?P<wrong>lambda)\s+(?=robot\b)", "lambda: "),
    Rule(r"\s*main\s*:\s*$", "", "python-main"),
    Rule(r"\s*when\s+\w.*:\s*$", "", "python-block-text"),
    Rule(rf"\s*(activate|deactivate)\s+{NAME}\s*$", r"\2.\1()"),
)
_DEFINE = "function|func|fn|define|%define%|void|procedure"
_DEFINITIONS = (
    Rule(rf"\s*(?:{_DEFINE})\s+{NAME}\s*(\([^()]*\))\s*:?\s*\{{?\s*$", r"def \1\2:"),
    Rule(rf"\s*(?P<wrong>{_DEFINE})(?=\s+{NAME})", "def"),
    Rule(rf"\s*def\s+{NAME}\s*:\s*$", r"def \1():"),
)
_WORDS = (
    Rule(r"\s*(?P<wrong>\}?\s*else\s+if)\b", "elif"),
    at_start(r"elseif|elsif|%elif%", "elif"),
    Rule(r"\s*(?P<wrong>[^\W\d]\w*)\s*(?P<plus>\+\+|--)\s*$", "", "python-count"),
)
_BRACES = (
    Rule(r".*?\S(?P<wrong>\s*:?\s*\{)\s*$", ":"),
    Rule(r"\s*(?P<wrong>\})\s*$", "", "python-brace"),
)
_CALLS = (
    Rule(r"\s*print\s+([\"'][^\"']*[\"'](?:\s*[,+]\s*\w+)*|\w+)\s*$", r"print(\1)"),
    Rule(r"\s*(?P<wrong>robot\.(\w+)\s+(-?[\d.]+|[\"'][^\"']*[\"']))\s*$", r"robot.\2(\3)"),
    TEXT_WITHOUT_QUOTES,
    Rule(
        r"\s*(?P<wrong>(?:var|let|const|int|float|double|string|bool|char)\s+(\w+))\s*(?==[^=])",
        r"\2",
        "blocktext-declared",
    ),
    NAME_WITH_SPACE,
)

RULES: tuple[Rule, ...] = (
    CURLY_QUOTES,
    *_LOOPS,
    *_BLOCK_TEXT,
    *_DEFINITIONS,
    *_WORDS,
    *KEYWORDS,
    *_BRACES,
    *OPERATORS,
    *_CALLS,
)
