"""How the code is written: names say what they hold, and modules import in one direction."""

import ast
import tomllib
from collections import Counter, defaultdict

import pytest

from modules import circles, folder_of, imports_of, modules
from places import TESTS

#: So many loops of each folder still call what they hold `one`: a number may only fall.
LOOPS_OVER_ONE = {
    "classroom": 6,
    "ice": 3,
    "lessons": 169,
    "project": 31,
    "robots": 18,
    "running": 18,
    "runtime": 11,
    "server": 105,
}
#: Modules that import each other, with the reason; the list may only become shorter.
CIRCLES = {
    "learnblock.classroom.desk learnblock.classroom.relay": "the desk is told what a relay hears",
    "learnblock.classroom.room learnblock.classroom.teaching learnblock.classroom.wall": (
        "the room shows its wall, and teaching needs both"
    ),
    "learnblock.runtime.child learnblock.runtime.conversation learnblock.runtime.error_phrases"
    " learnblock.runtime.process learnblock.runtime.remote learnblock.runtime.validation"
    " learnblock.runtime.variables": (
        "a process that only forks runs the child's main function in itself"
    ),
    "learnblock.server.runs.player learnblock.server.runs.playing learnblock.server.runs.reporter"
    " learnblock.server.runs.watcher": "what plays a run reports to its player",
    "learnblock.server.sessions.archive learnblock.server.sessions.coach"
    " learnblock.server.sessions.part learnblock.server.sessions.run_judge"
    " learnblock.server.sessions.runs learnblock.server.sessions.session": (
        "the parts of a session know the session"
    ),
}
DOUBLETS = TESTS / "cases" / "doublets.toml"


def loops_over(name):
    """Count the loops of each folder whose variable has a name."""
    counts = Counter()
    for module, tree in modules().items():
        loops = (
            node
            for node in ast.walk(tree)
            if isinstance(node, ast.For | ast.AsyncFor | ast.comprehension)
        )
        counts[folder_of(module)] += sum(
            isinstance(part, ast.Name) and part.id == name
            for loop in loops
            for part in ast.walk(loop.target)
        )
    return +counts


def public_classes():
    """Return the modules that define each public class."""
    found = defaultdict(list)
    for module, tree in modules().items():
        for node in tree.body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                found[node.name].append(module)
    return found


def listed_doublets():
    """Return how often each class name may be taken."""
    groups = tomllib.loads(DOUBLETS.read_text("utf-8"))
    return {name: count for group in groups.values() for name, count in group["names"].items()}


def test_a_loop_names_what_it_holds():
    loops = loops_over("one")
    more = {
        folder: loops[folder] for folder in loops if loops[folder] > LOOPS_OVER_ONE.get(folder, 0)
    }
    assert more == {}


def test_a_name_of_a_class_is_taken_once():
    listed = listed_doublets()
    taken = {name: where for name, where in public_classes().items() if len(where) > 1}
    assert {name: where for name, where in taken.items() if len(where) > listed.get(name, 1)} == {}


def test_the_list_of_doublets_names_only_doublets():
    classes = public_classes()
    assert [name for name in listed_doublets() if len(classes[name]) < 2] == []


def test_no_modules_import_each_other():
    trees = modules()
    graph = {
        module: imports_of(tree, frozenset(trees)) - {module} for module, tree in trees.items()
    }
    assert [group for group in map(" ".join, circles(graph)) if group not in CIRCLES] == []


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
    assert imports_of(ast.parse(source), {"p", "p.a", "p.b", "p.c", "p.d", "p.e"}) == {
        "p.a",
        "p.b",
        "p.c",
        "p.d",
    }
