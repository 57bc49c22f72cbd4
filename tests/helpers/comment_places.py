"""Every place of a program where a comment may be, and what becomes of comments there.

A comment is known by its number, so that many can be tried at once. Those that share brackets
make a statement raw Python, though, so that comments are tried far apart, too (`apart`).
"""

import ast
import io
import random
import re
import sysconfig
import tokenize
import warnings
from collections import Counter
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from learnblock.language import format as format_program
from learnblock.language import from_python, from_workspace, parse, to_python, to_workspace
from learnblock.language.blocktext.lexer import tokenize as block_text_tokens
from places import ROOT
from workspaces import CONFIGURATIONS

EXAMPLES = sorted((ROOT / "examples").glob("**/*.bt"))
#: What makes a file a program, whose statements are read one by one, and not one raw block.
HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n"
_WORDS = "z{}z: 'kept' (as it is"
_REST = _WORDS.partition("{}z")[2]
_FOUND = re.compile(r"z(\d+)z([^\n]*)")
_MARKER = re.compile(r"#[# ]*(?:main|end|python)\s*")
_OPENING, _CLOSING = frozenset("([{"), frozenset(")]}")
#: A bracket that is never closed ends where one of these begins a line.
_OPENS_LINE = frozenset(("if", "else", "end", "for", "while", "def", "import", "when", "python"))
_RAW_HEADER = re.compile(r"^[ \t]*python[ \t]*:[ \t]*$", re.MULTILINE)


class Place(NamedTuple):
    """A place for a comment: where it is, and the white space around it."""

    offset: int
    before: str
    after: str = ""


class Fate(NamedTuple):
    """What became of comments: the first conversion that lost, doubled or changed each of them.

    `unstable` are the conversions that change something once more when they are repeated.
    """

    lost: dict
    doubled: dict
    changed: dict
    unstable: list


UNHARMED = Fate({}, {}, {}, [])


def library_files(count):
    """Return files of the standard library, always the same ones."""
    files = sorted(Path(sysconfig.get_path("stdlib")).glob("*.py"))
    texts = ((path, path.read_text("utf-8", errors="replace")) for path in files)
    # Such an import must come first, so that no line can make the file a program.
    usable = [path for path, text in texts if len(text) < 40_000 and "__future__" not in text]
    return sorted(random.Random(1).sample(usable, min(count, len(usable))))  # noqa: S311


def python_places(text):
    """Return every place of a Python file where its tokenizer allows a comment."""
    lines = _line_offsets(text)
    places, starts, indents = [], [(1, 0)], [0]
    depth = f_strings = 0
    last = "NL"
    for token in tokenize.generate_tokens(io.StringIO(text, newline="").readline):
        kind = tokenize.tok_name[token.type]
        start, end = (lines[line - 1] + column for line, column in (token.start, token.end))
        if kind in {"NEWLINE", "NL"}:
            if last not in {"COMMENT", "NEWLINE", "NL"}:
                places.append(Place(start, "  "))
            starts.append((token.start[0] + 1, indents[-1]))
        elif kind == "COMMENT" and not _MARKER.fullmatch(token.string):
            places.append(Place(end, " "))
        elif kind == "INDENT":
            indents.append(len(token.string))
        elif kind == "DEDENT":
            indents.pop()
        # Before Python 3.12, no comment was allowed in an f-string.
        f_strings += kind.endswith("STRING_START") - kind.endswith("STRING_END")
        if kind == "OP":
            depth += (token.string in _OPENING) - (token.string in _CLOSING)
        if depth and not f_strings and kind not in {"NL", "COMMENT"}:
            places.append(Place(end, "  ", "\n"))
        last = kind if kind not in {"INDENT", "DEDENT"} else last
    return [*places, *_own_lines(text, lines, starts)]


def _own_lines(text, lines, starts):
    """Return the places for comments on lines of their own, at each plausible indentation."""
    for line, above in starts:
        if line > len(lines) or (lines[line - 1] == len(text) and text[-1:] != "\n"):
            continue
        rest = text[lines[line - 1] :].partition("\n")[0]
        here = len(rest) - len(rest.lstrip(" ")) if rest.strip() else above
        for level in sorted({here, above, *range(0, max(here, above) + 8, 4)}):
            yield Place(lines[line - 1], " " * level, "\n")


def block_text_places(text):
    """Return every place of a program in Block-Text where a comment is allowed."""
    lines = _line_offsets(text)
    places = [Place(header.end(), "  ") for header in _RAW_HEADER.finditer(text)]
    places += [Place(0, level, "\n") for level in ("", "    ")]
    depth, last, in_f_string = 0, "newline", False
    for token, following in pairwise(block_text_tokens(text).tokens):
        start = lines[token.line - 1] + token.column - 1
        if token.kind == "newline":
            if last not in {"newline", "blank", "comment"}:
                places.append(Place(start, "  "))
            below = lines[token.line] if token.line < len(lines) else len(text)
            places += [Place(below, level, "\n") for level in ("", "    ", "        ")]
        elif token.kind == "comment":
            places.append(Place(start + len(token.text), " "))
        in_f_string = (in_f_string or token.kind == "f-string") and token.kind != "newline"
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        # At the end of a line, a brace may also be one of C's.
        breaks = token.kind != "{" and following.text not in _OPENS_LINE | {"\n"}
        if depth and not in_f_string and breaks:
            places.append(Place(start + len(token.text), "  ", "\n"))
        last = token.kind
    return places


def apart(places, distance):
    """Return the places in groups, in which they are that far from each other."""
    return [places[first::distance] for first in range(min(distance, len(places)))]


def with_comments(text, places):
    """Return a program with a comment at each of the places; the first is number 0."""
    order = sorted(range(len(places)), key=lambda number: (places[number].offset, number))
    parts, position = [], 0
    for number in order:
        offset, before, after = places[number]
        parts += [text[position:offset], before, "# ", _WORDS.format(number), after]
        position = offset
    return "".join([*parts, text[position:]])


def same_python(one, other):
    """Return whether two Python files mean the same."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return ast.dump(ast.parse(one)) == ast.dump(ast.parse(other))
        except SyntaxError:
            return False


def squeezed(text, choice):
    """Return a Python file with some statements on the line above, where Python allows that."""
    lines = text.split("\n")
    number = 1
    while number < len(lines):
        above, line = lines[number - 1 : number + 1]
        joined = f"{above}{' ' if above.endswith(':') else '; '}{line.lstrip()}"
        shorter = [*lines[: number - 1], joined, *lines[number + 1 :]]
        if above and line and choice.random() < 0.4 and same_python(text, "\n".join(shorter)):
            lines = shorter
        else:
            number += 1
    return "\n".join(lines)


def fate(text, places, read=from_python):
    """Put comments at places of a program, and convert it in all directions, repeatedly.

    `read` is `from_python` or, for Block-Text, `parse`.
    """
    tree = read(with_comments(text, places))
    block_text = format_program(tree)
    again = parse(block_text)
    python = to_python(again).text
    unstable = _unstable(block_text, again, python)
    converted = {"Block-Text": block_text, "Python": python, "kept Python": to_python(tree).text}
    empty = to_workspace(read(text), CONFIGURATIONS).workspace
    for way, before in (("blocks", None), ("blocks without comments", empty)):
        workspace = to_workspace(tree, CONFIGURATIONS, before).workspace
        program = from_workspace(workspace, CONFIGURATIONS).program
        converted[way] = to_python(program).text
        if converted[way] != python or format_program(program) != block_text:
            unstable.append(way)
    return Fate(*_counted(converted, len(places)), unstable)


def _unstable(block_text, again, python):
    program = from_python(python)
    rounds = {
        "Block-Text": format_program(again) == block_text,
        "Python": to_python(program).text == python,
        "Python to Block-Text": format_program(program) == block_text,
    }
    return [way for way, is_stable in rounds.items() if not is_stable]


def _counted(converted, count):
    lost, doubled, different = {}, {}, {}
    for way, text in converted.items():
        counts = Counter()
        for number, rest in _FOUND.findall(text):
            counts[int(number)] += 1
            if rest != _REST:
                different.setdefault(int(number), way)
        for number in range(count):
            if counts[number] != 1:
                (doubled if counts[number] else lost).setdefault(number, way)
    return lost, doubled, different


def _line_offsets(text):
    offsets = [0]
    for line in io.StringIO(text, newline=""):
        offsets.append(offsets[-1] + len(line))
    return offsets
