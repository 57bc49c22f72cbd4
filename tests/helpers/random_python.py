"""Random modules over the whole grammar of the Python that runs the tests, for Hypothesis.

Python's own syntax tree is built and written by `ast.unparse`; comments and blank lines are added
between its lines, and spaces within them stay as Python writes them.
"""

import ast
import sys
from functools import cache

from hypothesis import strategies as st

#: Names without and with a meaning in Block-Text or generated Python.
PLAIN = ("a", "b", "x_1", "ñ", "_", "__x", "self", "print", "range", "len", "list", "math", "Dog")
SPECIAL = ("match", "str", "end", "repeat", "function", "main", "when", "lambda_", "from_")
NAMES = st.sampled_from((*PLAIN, *SPECIAL))
TEXTS = st.text(st.sampled_from("ab ñ'\"\\\n\t`{}#%:🤖\r\0"), max_size=6)
NUMBERS = st.one_of(
    st.integers(0, 10**20),
    st.floats(0, allow_nan=False, allow_infinity=False),
    st.just(2j),
)
CONSTANTS = st.builds(
    ast.Constant,
    st.one_of(st.sampled_from((True, False, None, ...)), NUMBERS, TEXTS, st.binary(max_size=3)),
)
#: What a program that was copied without its robot may have.
SKILLS = ("robot.turn(90)", "robot.sleep(1)", "a = robot.get_distance()", "robot.say_Text('hi')")
HAS_TYPES = sys.version_info >= (3, 12)
HAS_DEFAULTS_OF_TYPES = sys.version_info >= (3, 13)
DEPTH = 3


def _few(strategy, least=0, most=2):
    return st.lists(strategy, min_size=least, max_size=most)


def _or_none(strategy):
    return st.none() | strategy


def _operators(kind):
    return st.sampled_from([operator() for operator in kind.__subclasses__()])


@cache
def _name(context):
    return st.builds(ast.Name, NAMES, st.just(context()))


# Values.


@cache
def values(depth=DEPTH):
    """An expression."""
    leaves = st.one_of(_name(ast.Load), CONSTANTS)
    if depth <= 0:
        return leaves
    return st.one_of(leaves, st.deferred(lambda: _nested_values(depth - 1)))


@cache
def _nested_values(depth):
    value, few = values(depth), _few(values(depth))
    starred = st.one_of(value, st.builds(ast.Starred, value, st.just(ast.Load())))
    loops = _few(_comprehensions(depth), 1)
    pairs = _few(st.tuples(_or_none(value), value))
    kinds = [
        st.builds(ast.BoolOp, _operators(ast.boolop), _few(value, 2, 3)),
        st.builds(ast.NamedExpr, _name(ast.Store), value),
        st.builds(ast.BinOp, value, _operators(ast.operator), value),
        st.builds(ast.UnaryOp, _operators(ast.unaryop), value),
        st.builds(ast.Lambda, _parameters(depth, typed=False), value),
        st.builds(ast.IfExp, value, value, value),
        pairs.map(
            lambda entries: ast.Dict([key for key, _ in entries], [item for _, item in entries])
        ),
        st.builds(ast.Set, _few(starred, 1)),
        st.builds(ast.ListComp, value, loops),
        st.builds(ast.SetComp, value, loops),
        st.builds(ast.DictComp, value, value, loops),
        st.builds(ast.GeneratorExp, value, loops),
        st.builds(ast.Await, value),
        st.builds(ast.Yield, _or_none(value)),
        st.builds(ast.YieldFrom, value),
        st.lists(st.tuples(_operators(ast.cmpop), value), min_size=1, max_size=2).flatmap(
            lambda comparisons: value.map(
                lambda left: ast.Compare(
                    left, [op for op, _ in comparisons], [operand for _, operand in comparisons]
                )
            )
        ),
        st.builds(ast.Call, value, _few(starred), _keywords(depth)),
        _texts_with_values(depth, ast.JoinedStr, ast.FormattedValue),
        st.builds(ast.Attribute, value, NAMES, st.just(ast.Load())),
        st.builds(ast.Subscript, value, _keys(depth), st.just(ast.Load())),
        st.builds(ast.List, _few(starred), st.just(ast.Load())),
        st.builds(ast.Tuple, _few(starred), st.just(ast.Load())),
        few.map(lambda elements: ast.List(elements, ast.Load())),
    ]
    return st.one_of(kinds)


@cache
def _comprehensions(depth):
    return st.builds(
        ast.comprehension,
        _targets(depth),
        values(depth),
        _few(values(depth)),
        st.sampled_from((0, 1)),
    )


@cache
def _keywords(depth):
    # Python refuses one name twice, though it parses it.
    names = _few(NAMES).map(lambda choices: list(dict.fromkeys(choices)))
    keywords = names.flatmap(
        lambda choices: st.tuples(
            *(st.builds(ast.keyword, st.just(name), values(depth)) for name in choices)
        )
    )
    return st.tuples(keywords, _few(st.builds(ast.keyword, st.none(), values(depth)), most=1)).map(
        lambda parts: [*parts[0], *parts[1]]
    )


@cache
def _keys(depth):
    value = values(depth)
    part = st.builds(ast.Slice, _or_none(value), _or_none(value), _or_none(value))
    several = st.builds(ast.Tuple, _few(value | part, 1), st.just(ast.Load()))
    return st.one_of(value, part, several)


@cache
def _texts_with_values(depth, whole, part):
    # Before 3.12 a value in a text has no quote and no backslash of its own.
    value = values(depth) if HAS_TYPES else st.one_of(_name(ast.Load), NUMBERS.map(ast.Constant))
    fields = st.builds(
        part, value, st.sampled_from((-1, ord("r"), ord("s"), ord("a"))), _or_none(_formats(value))
    )
    text = st.text(st.sampled_from("ab {}ñ'"), min_size=1, max_size=4).map(ast.Constant)
    return st.builds(whole, _few(fields | text, 0, 3))


@cache
def _formats(value):
    spec = st.sampled_from((".1f", ">8", "x")).map(ast.Constant)
    width = st.builds(ast.FormattedValue, _name(ast.Load), st.just(-1), st.none())
    return st.builds(ast.JoinedStr, _few(spec | width, 1))


@cache
def _targets(depth):
    plain = [_name(ast.Store)]
    if depth > 0:
        inner = _targets(depth - 1)
        value = values(depth - 1)
        plain += [
            st.builds(ast.Attribute, value, NAMES, st.just(ast.Store())),
            st.builds(ast.Subscript, value, _keys(depth - 1), st.just(ast.Store())),
            st.builds(ast.Tuple, _few(inner, 1), st.just(ast.Store())),
            st.builds(ast.List, _few(inner, 1), st.just(ast.Store())),
            st.tuples(inner, inner).map(
                lambda targets: ast.Tuple(
                    [targets[0], ast.Starred(targets[1], ast.Store())], ast.Store()
                )
            ),
        ]
    return st.one_of(plain)


@st.composite
def _parameters(draw, depth, *, typed=True):
    kind = _or_none(values(depth)) if typed else st.none()
    arguments = [ast.arg(name) for name in draw(st.lists(NAMES, unique=True, max_size=5))]
    for argument in arguments:
        argument.annotation = draw(kind)
    places = st.integers(0, len(arguments))
    first, second, third = sorted((draw(places), draw(places), draw(places)))
    only, rest = arguments[second:third], arguments[third:]
    defaults = draw(st.lists(values(depth), max_size=second))
    others = draw(st.lists(_or_none(values(depth)), min_size=len(only), max_size=len(only)))
    vararg = rest.pop() if rest else None
    kwarg = rest.pop() if rest else None
    return ast.arguments(
        arguments[:first], arguments[first:second], vararg, only, others, kwarg, defaults
    )


# Statements.


@cache
def _body(depth, least=1):
    return st.lists(statements(depth), min_size=least, max_size=3)


@cache
def statements(depth=DEPTH):
    """A statement."""
    simple = _simple_statements()
    if depth <= 0:
        return simple
    return st.one_of(simple, st.deferred(lambda: _compound_statements(depth - 1)))


@cache
def _simple_statements():
    value, target = values(2), _targets(1)
    place = st.one_of(
        _name(ast.Store),
        st.builds(ast.Attribute, values(1), NAMES, st.just(ast.Store())),
        st.builds(ast.Subscript, values(1), values(1), st.just(ast.Store())),
    )
    kinds = [
        st.builds(ast.Expr, value),
        st.builds(ast.Return, _or_none(value)),
        st.builds(ast.Delete, _few(_deleted(), 1)),
        st.builds(ast.Assign, _few(target, 1), value, lineno=st.just(0)),
        st.builds(ast.AugAssign, place, _operators(ast.operator), value),
        st.builds(ast.AnnAssign, place, value, _or_none(value), st.just(0)),
        st.builds(ast.AnnAssign, _name(ast.Store), value, _or_none(value), st.just(1)),
        st.just(ast.Raise(None, None)),
        st.builds(ast.Raise, value, _or_none(value)),
        st.builds(ast.Assert, value, _or_none(value)),
        st.builds(ast.Import, _few(_aliases(dotted=True), 1)),
        st.builds(
            ast.ImportFrom,
            _or_none(NAMES),
            _few(_aliases(), 1) | st.just([ast.alias("*")]),
            st.integers(0, 2),
        ).map(lambda node: node if node.module or node.level else ast.Pass()),
        st.builds(ast.Global, _few(NAMES, 1)),
        st.builds(ast.Nonlocal, _few(NAMES, 1)),
        st.sampled_from((ast.Pass, ast.Break, ast.Continue)).map(lambda kind: kind()),
        st.sampled_from(SKILLS).map(lambda text: ast.parse(text).body[0]),
    ]
    if HAS_TYPES:
        kinds.append(st.builds(ast.TypeAlias, _name(ast.Store), _type_parameters(), value))
    return st.one_of(kinds)


@cache
def _deleted():
    return st.one_of(
        _name(ast.Del),
        st.builds(ast.Subscript, values(1), _keys(1), st.just(ast.Del())),
        st.builds(ast.Attribute, values(1), NAMES, st.just(ast.Del())),
    )


@cache
def _aliases(*, dotted=False):
    name = st.sampled_from(("math", "os.path", "a.b")) if dotted else NAMES
    return st.builds(ast.alias, name, _or_none(NAMES))


@cache
def _type_parameters():
    value = {"default_value": _or_none(values(1))} if HAS_DEFAULTS_OF_TYPES else {}
    kinds = [
        st.builds(ast.TypeVar, NAMES, _or_none(values(1)), **value),
        st.builds(ast.ParamSpec, NAMES, **value),
        st.builds(ast.TypeVarTuple, NAMES, **value),
    ]
    return _few(st.one_of(kinds))


@cache
def _compound_statements(depth):
    body, rest = _body(depth), _body(depth, 0)
    value, target = values(2), _targets(1)
    types = {"type_params": _type_parameters()} if HAS_TYPES else {}
    handlers = _few(
        st.tuples(value, _or_none(NAMES), body).map(lambda parts: ast.ExceptHandler(*parts)), 1
    )
    items = _few(st.builds(ast.withitem, value, _or_none(target)), 1)
    kinds = [
        *(
            st.builds(
                kind,
                NAMES,
                _parameters(1),
                body,
                _few(value),
                _or_none(value),
                lineno=st.just(0),
                **types,
            )
            for kind in (ast.FunctionDef, ast.AsyncFunctionDef)
        ),
        st.builds(ast.ClassDef, NAMES, _few(value), _keywords(1), body, _few(value), **types),
        *(
            st.builds(kind, target, value, body, rest, lineno=st.just(0))
            for kind in (ast.For, ast.AsyncFor)
        ),
        st.builds(ast.While, value, body, rest),
        st.builds(ast.If, value, body, rest),
        *(st.builds(kind, items, body, lineno=st.just(0)) for kind in (ast.With, ast.AsyncWith)),
        st.builds(ast.Match, value, _few(_cases(depth), 1)),
        *(st.builds(kind, body, handlers, rest, rest) for kind in (ast.Try, ast.TryStar)),
        st.builds(ast.Try, body, st.just([]), st.just([]), body),
    ]
    return st.one_of(kinds)


@cache
def _cases(depth):
    return st.builds(ast.match_case, _patterns(2), _or_none(values(1)), _body(depth))


@cache
def _patterns(depth):
    value = st.one_of(
        st.integers(0, 9).map(ast.Constant),
        TEXTS.map(ast.Constant),
        st.builds(ast.Attribute, _name(ast.Load), NAMES, st.just(ast.Load())),
    )
    bound = NAMES.filter(lambda name: name != "_")
    kinds = [
        st.builds(ast.MatchValue, value),
        st.sampled_from((True, False, None)).map(ast.MatchSingleton),
        st.builds(ast.MatchAs, st.none(), _or_none(bound)),
    ]
    if depth > 0:
        inner = _patterns(depth - 1)
        kinds += [
            st.builds(ast.MatchSequence, _few(inner)),
            st.builds(ast.MatchAs, inner, bound),
            st.builds(ast.MatchOr, _few(inner, 2, 3)),
            st.tuples(_few(st.tuples(value, inner)), _or_none(bound)).map(
                lambda parts: ast.MatchMapping(
                    [key for key, _ in parts[0]], [pattern for _, pattern in parts[0]], parts[1]
                )
            ),
            st.tuples(_name(ast.Load), _few(inner), _few(st.tuples(NAMES, inner))).map(
                lambda parts: ast.MatchClass(
                    parts[0],
                    parts[1],
                    [key for key, _ in parts[2]],
                    [pattern for _, pattern in parts[2]],
                )
            ),
        ]
    return st.one_of(kinds)


# Files.


@st.composite
def modules(draw):
    """The text of a module that Python reads, with comments and blank lines."""
    body = draw(st.lists(statements(), min_size=1, max_size=5))
    try:
        text = ast.unparse(ast.fix_missing_locations(ast.Module(body, [])))
        tree = ast.parse(text)
    except (SyntaxError, ValueError):
        # `ast.unparse` writes some trees, such as texts in texts before 3.12, in no valid way.
        return "pass\n"
    starts = {node.lineno: node.col_offset for node in ast.walk(tree) if isinstance(node, ast.stmt)}
    lines = []
    for number, line in enumerate(text.split("\n"), 1):
        extra = draw(st.sampled_from((0, 0, 0, 0, 1, 2, 3))) if number in starts else 0
        if extra == 1 and not line.lstrip().startswith(("else", "elif")):
            lines.append("")
        elif extra == 2:
            lines.append(line[: starts[number]] * line[: starts[number]].isspace() + "# note")
        lines.append(line)
    return "\n".join(lines) + "\n"
