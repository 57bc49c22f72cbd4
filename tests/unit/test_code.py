"""How the code is written: names say what they hold, and modules import in one direction."""

import ast
import re
import tomllib
from collections import defaultdict

import pytest

from modules import circles, imports_of, modules, tree_of
from places import TESTS

DOUBLETS = TESTS / "cases" / "doublets.toml"
#: The lines of a module and of a function.
LONGEST_MODULE, LONGEST_FUNCTION = 450, 50
#: Longer modules, with the reason.
LONG_MODULES = {
    "learnblock.language.tree.nodes": "one list: the nodes of the tree",
    "learnblock.robots.ev3.agent": "one file, since it is copied to the brick",
}
#: The same for functions.
LONG_FUNCTIONS: dict[str, list[str]] = {}
#: Names of values that say nothing about them.
PARTICIPLES = ("found", "said", "told")
#: Modules that may have them: fields of messages, where the message's name says what, and a
#: parameter that tests of other people's robots may pass by name.
WITH_PARTICIPLES = ("learnblock.server.messages.", "learnblock.testing.robot")


def loops_over(name, source):
    """Count the loops of a module whose variable, or one of them, has a name."""
    if not re.search(rf"\bfor\b.*\b{name}\b", source):
        return 0
    return sum(
        isinstance(part, ast.Name) and part.id == name
        for loop in ast.walk(tree_of(source))
        if isinstance(loop, ast.For | ast.AsyncFor | ast.comprehension)
        for part in ast.walk(loop.target)
    )


def names_value(name, source):
    """Return whether a module gives a variable or a parameter this name."""
    return bool(re.search(rf"\b{name}\b", source)) and any(
        (isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node.id == name)
        or (isinstance(node, ast.arg) and node.arg == name)
        or (isinstance(node, ast.MatchAs) and node.name == name)
        for node in ast.walk(tree_of(source))
    )


def public_classes():
    """Return the modules that define each public class."""
    classes = defaultdict(list)
    for module, source in modules().items():
        for node in tree_of(source).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                classes[node.name].append(module)
    return classes


def long_functions(source):
    """Return the names of a module's functions that are longer than a reader takes in at once."""
    return [
        node.name
        for node in ast.walk(tree_of(source))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and node.end_lineno - node.lineno >= LONGEST_FUNCTION
    ]


def listed_doublets():
    """Return how often each class name may be taken."""
    groups = tomllib.loads(DOUBLETS.read_text("utf-8"))
    return {name: count for group in groups.values() for name, count in group["names"].items()}


def test_a_loop_names_what_it_holds():
    assert [module for module, source in modules().items() if loops_over("one", source)] == []


@pytest.mark.parametrize("name", PARTICIPLES)
def test_a_value_is_not_called_by_a_participle(name):
    named = [module for module, source in modules().items() if names_value(name, source)]
    assert [module for module in named if not module.startswith(WITH_PARTICIPLES)] == []


def test_a_module_is_one_noun():
    long = {name for name, source in modules().items() if source.count("\n") > LONGEST_MODULE}
    assert long - LONG_MODULES.keys() == set()


def test_a_function_is_read_at_once():
    long = {name: long_functions(source) for name, source in modules().items()}
    assert {name: functions for name, functions in long.items() if functions} == LONG_FUNCTIONS


def test_a_name_of_a_class_is_taken_once():
    listed = listed_doublets()
    taken = {name: where for name, where in public_classes().items() if len(where) > 1}
    assert {name: where for name, where in taken.items() if len(where) > listed.get(name, 1)} == {}


def test_the_list_of_doublets_names_only_doublets():
    classes = public_classes()
    assert [name for name in listed_doublets() if len(classes[name]) < 2] == []


def test_no_modules_import_each_other():
    sources = modules()
    names = frozenset(sources)
    graph = {module: imports_of(source, names) - {module} for module, source in sources.items()}
    assert circles(graph) == []


@pytest.mark.parametrize(
    ("loop", "count"),
    [
        ("for one in ones: pass", 1),
        ("[x for x, one in pairs]", 1),
        ("for one, (x, y) in pairs: pass", 1),
        ("for (x, one), y in pairs: pass", 1),
        ("any(x is one for x in (one, two) if one in ones)", 0),
        ("# for every one in it", 0),
        ("for x in some: print(one)", 0),
    ],
)
def test_a_loop_over_a_pronoun_is_found(loop, count):
    assert loops_over("one", loop) == count


@pytest.mark.parametrize(
    ("graph", "expected"),
    [
        ({"a": ["b"], "b": ["c"], "c": []}, []),
        ({"a": ["b"], "b": ["c"], "c": ["a"], "d": ["a"]}, [["a", "b", "c"]]),
        ({"a": ["b"], "b": ["a"], "c": ["d", "a"], "d": ["c"]}, [["a", "b"], ["c", "d"]]),
    ],
)
def test_circles_are_found(graph, expected):
    assert circles(graph) == expected


def test_an_import_in_a_function_and_one_for_types_count():
    source = (
        "from p.a import A\nfrom p import b\n"
        "if TYPE_CHECKING:\n    from p.c import C\n"
        "def f():\n    import p.d\n"
    )
    assert imports_of(source, {"p", "p.a", "p.b", "p.c", "p.d", "p.e"}) == {
        "p.a",
        "p.b",
        "p.c",
        "p.d",
    }
