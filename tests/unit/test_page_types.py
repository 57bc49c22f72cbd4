"""The build writes the page's types with few packages, and anew when a source of them changes."""

import ast
import subprocess
import sys
from collections import defaultdict
from fnmatch import fnmatch
from importlib import metadata
from pathlib import Path

import pytest
from msgspec import inspect

from build_parts import part_of_build
from learnblock.classroom import messages as classroom
from learnblock.lessons.checks import Check
from learnblock.monitor import worlds
from learnblock.monitor.sensors import Quantity
from learnblock.server import messages
from learnblock.server.typescript import structs_of
from places import ROOT

SENT = (
    messages.FROM_PAGE,
    messages.TO_PAGE,
    classroom.FromPupil,
    classroom.ToPupil,
    classroom.FromTeacher,
    classroom.ToTeacher,
    classroom.Join,
    classroom.Joined,
    classroom.NotJoined,
    classroom.AboutClass,
    worlds.WorldFile,
    worlds.RobotDescription,
    Quantity,
    Check,
)


@pytest.fixture(scope="module")
def writer():
    return part_of_build("hatch_types")


def sent_classes():
    """The names of all structs that a page sends or receives, and of their bases, by module."""
    structs = [struct for kind in SENT for struct in structs_of([inspect.type_info(kind)])]
    classes = defaultdict(set)
    for kind in {base for struct in structs for base in struct.cls.__mro__}:
        if kind.__module__.startswith("learnblock"):
            classes[kind.__module__].add(kind.__name__)
    return classes


def parsed(module):
    return ast.parse(Path(sys.modules[module].__file__).read_text(encoding="utf-8"))


def imports(tree):
    """The names that a module imports from ours, each with its module and its name there."""
    return {
        alias.asname or alias.name: (node.module, alias.name)
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and str(node.module).startswith("learnblock")
        for alias in node.names
    }


def origin(module, name):
    """The module that defines a name; a package passes on those of its modules."""
    if f"{module}.{name}" in sys.modules:
        return f"{module}.{name}"
    passed_on = imports(parsed(module)).get(name)
    return origin(*passed_on) if passed_on else module


def names_in(nodes):
    return {name.id for node in nodes for name in ast.walk(node) if isinstance(name, ast.Name)}


def imported_for(classes, module):
    """The modules from which a module takes the types and limits of the fields of its classes."""
    tree = parsed(module)
    structs = [node for node in tree.body if getattr(node, "name", "") in classes]
    fields = [node for struct in structs for node in struct.body if isinstance(node, ast.AnnAssign)]
    aliases = [
        node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and names_in(node.targets) & names_in(fields)
    ]
    named = names_in([*fields, *aliases])
    return {origin(*source) for name, source in imports(tree).items() if name in named}


def test_a_change_of_any_module_that_defines_what_is_sent_writes_the_types_anew(writer):
    classes = sent_classes()
    modules = {source for module in classes for source in imported_for(classes[module], module)}
    files = {Path(sys.modules[module].__file__) for module in modules.union(classes)}
    assert files - set(writer.sources(ROOT)) == set()


def test_uv_builds_again_when_a_source_of_the_page_changes_but_not_when_the_build_writes_one(
    writer,
):
    sources = set(part_of_build("hatch_build").page_sources(ROOT))
    written = {ROOT / file for file in [*writer.FILES, writer.HASH_FILE]}
    keys = {pattern: set(ROOT.glob(pattern)) for pattern in writer.cache_keys(ROOT)}
    assert sources - set().union(*keys.values()) == sources & written
    assert [pattern for pattern, files in keys.items() if not files] == []
    # A star of uv's also matches a slash.
    assert [(file, key) for file in written for key in keys if fnmatch(file, ROOT / key)] == []


def test_the_build_has_the_packages_that_the_types_need(writer):
    names = [requirement.partition(">")[0] for requirement in writer.requirements(ROOT)]
    assert sorted(names) == sorted(writer.IMPORTED)
    modules = ", ".join(module for module, _ in writer.FILES.values())
    code = f"import sys; import {modules}; print(*{{name.split('.')[0] for name in sys.modules}})"
    done = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True, timeout=60
    )
    packages = metadata.packages_distributions()
    loaded = {package for name in done.stdout.split() for package in packages.get(name, ())}
    required = {text.partition(">")[0] for text in metadata.requires("learnblock-studio")}
    assert loaded & required <= writer.IMPORTED
