"""The functions of the language other than the robot's skills, and their Python."""

import ast
import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

# The minimum and maximum number of arguments (None: any number). The names are Python's.
BUILTINS: Mapping[str, tuple[int, int | None]] = MappingProxyType(
    {
        "abs": (1, 1),
        "float": (0, 1),
        "input": (0, 1),
        "int": (0, 2),
        "len": (1, 1),
        "list": (0, 1),
        "max": (1, None),
        "min": (1, None),
        "print": (0, None),
        "round": (1, 2),
        "sorted": (1, 1),
        "str": (0, 1),
        "sum": (1, 2),
    }
)

# Blockly's standard Math, Text and Lists categories. Angles are degrees, positions start at 0.
_TEMPLATES = """
sqrt(x)                     math.sqrt({0})
exp(x)                      math.exp({0})
log(x)                      math.log({0})
log10(x)                    math.log10({0})
floor(x)                    math.floor({0})
ceil(x)                     math.ceil({0})
sin(angle)                  math.sin(math.radians({0}))
cos(angle)                  math.cos(math.radians({0}))
tan(angle)                  math.tan(math.radians({0}))
asin(x)                     math.degrees(math.asin({0}))
acos(x)                     math.degrees(math.acos({0}))
atan(x)                     math.degrees(math.atan({0}))
atan2(y, x)                 math.degrees(math.atan2({0}, {1}))
pi()                        math.pi
constrain(x, low, high)     min(max({0}, {1}), {2})
random(low, high)           random.randint({0}, {1})
random_fraction()           random.random()
choice(values)              random.choice({0})
shuffle(values)             random.shuffle({0})
mean(values)                statistics.mean({0})
median(values)              statistics.median({0})
mode(values)                statistics.mode({0})
stdev(values)               statistics.pstdev({0})
append(values, x)           {0}.append({1})
extend(values, more)        {0}.extend({1})
insert(values, index, x)    {0}.insert({1}, {2})
remove(values, x)           {0}.remove({1})
pop(values)                 {0}.pop()
pop(values, index)          {0}.pop({1})
clear(values)               {0}.clear()
copy(values)                {0}.copy()
sort(values)                {0}.sort()
reverse(values)             {0}.reverse()
index(values, x)            {0}.index({1})
count(values, x)            {0}.count({1})
keys(dictionary)            list({0}.keys())
items(dictionary)           list({0}.items())
enumerate(values)           list(enumerate({0}))
sublist(values, start, end) {0}[{1}:{2}]
upper(text)                 {0}.upper()
lower(text)                 {0}.lower()
title(text)                 {0}.title()
strip(text)                 {0}.strip()
find(text, part)            {0}.find({1})
replace(text, old, new)     {0}.replace({1}, {2})
split(text, separator)      {0}.split({1})
join(values, separator)     {1}.join({0})
"""


@dataclass(frozen=True, slots=True)
class Template:
    """The Python of a library function.

    Args:
        name: its name in Block-Text.
        parameters: the names of its parameters.
        python: the expression, with ``{0}`` for the first argument.
        receivers: the arguments before a dot or a bracket.
        module: the module that it needs, or "".
        pattern: the expression as Python's own tree, with names such as ``_0`` for the arguments.
    """

    name: str
    parameters: tuple[str, ...]
    python: str
    receivers: frozenset[int]
    module: str
    pattern: ast.expr


def _template(line: str) -> Template:
    signature, python = re.split(r"\s{2,}|(?<=\)) ", line, maxsplit=1)
    name, _, rest = signature.partition("(")
    parameters = tuple(filter(None, rest.rstrip(")").split(", ")))
    receivers = frozenset(int(digit) for digit in re.findall(r"\{(\d)\}[.\[]", python))
    module = re.match(r"(math|random|statistics)\.", python)
    source = python.format(*(f"_{index}" for index in range(len(parameters))))
    pattern = ast.parse(source, mode="eval").body
    return Template(name, parameters, python, receivers, module[1] if module else "", pattern)


TEMPLATES: Mapping[tuple[str, int], Template] = MappingProxyType(
    {
        (template.name, len(template.parameters)): template
        for template in map(_template, _TEMPLATES.strip().splitlines())
    }
)
#: The functions whose values a loop takes one after the other, without making a list of them.
LOOPED: Mapping[str, str] = MappingProxyType(
    {"items": "{0}.items()", "enumerate": "enumerate({0})"}
)
FUNCTIONS = frozenset(BUILTINS) | {name for name, _ in TEMPLATES} | {"elapsedTime"}
MODULES = ("math", "random", "statistics")


def is_builtin(name: str, arguments: int) -> bool:
    """Whether `name` is a built-in function of Python that takes this number of arguments."""
    if name not in BUILTINS:
        return False
    least, most = BUILTINS[name]
    return least <= arguments and (most is None or arguments <= most)


def recognized(node: ast.expr) -> tuple[Template, list[ast.expr]] | None:
    """The library function of a Python expression, with its arguments, or None."""
    for template in _BY_SHAPE.get(_shape(node), ()):
        parts: dict[str, ast.expr] = {}
        if _matches(template.pattern, node, parts):
            return template, [parts[f"_{index}"] for index in range(len(template.parameters))]
    return None


def _shape(node: ast.AST) -> str:
    """A key for ruling out most templates quickly."""
    match node:
        case ast.Call(func=ast.Attribute(attr=name)) | ast.Call(func=ast.Name(id=name)):
            return name
        case ast.Attribute(attr=name):
            return "." + name
        case ast.Subscript():
            return "[]"
        case _:
            return ""


def _matches(pattern: object, node: object, parts: dict[str, ast.expr]) -> bool:
    if isinstance(pattern, ast.Name) and pattern.id.startswith("_"):
        if isinstance(node, ast.expr) and not isinstance(node, ast.Starred):
            parts[pattern.id] = node
            return True
        return False
    if type(pattern) is not type(node):
        return False
    if isinstance(pattern, ast.AST):
        return all(
            _matches(getattr(pattern, name), getattr(node, name), parts) for name in pattern._fields
        )
    if isinstance(pattern, list) and isinstance(node, list):
        return len(pattern) == len(node) and all(
            _matches(part, other, parts) for part, other in zip(pattern, node, strict=True)
        )
    return pattern == node


def _by_shape() -> dict[str, tuple[Template, ...]]:
    shapes: dict[str, tuple[Template, ...]] = {}
    for template in TEMPLATES.values():
        shape = _shape(template.pattern)
        shapes[shape] = (*shapes.get(shape, ()), template)
    return shapes


_BY_SHAPE = _by_shape()
