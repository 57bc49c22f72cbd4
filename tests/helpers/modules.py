"""The modules of the package, and what they import."""

import ast
from functools import cache
from pathlib import Path

from places import ROOT

PACKAGE = ROOT / "src" / "learnblock"


@cache
def modules():
    """Return the source of each module, by its dotted name; templates are no modules."""
    files = (file for file in sorted(PACKAGE.rglob("*.py")) if "templates" not in file.parts)
    return {name_of(file): file.read_text("utf-8") for file in files}


@cache
def tree_of(source):
    """Return the tree of a module's source."""
    return ast.parse(source)


def name_of(file):
    """Return the dotted name of a file's module."""
    parts = Path(file).relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts).removesuffix(".__init__")


def imports_of(source, names):
    """Return those of some modules that a module imports, also in functions and only for types."""
    imports = set()
    for node in ast.walk(tree_of(source)):
        if isinstance(node, ast.Import):
            imports |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            wholes = {f"{node.module}.{alias.name}" for alias in node.names}
            inner = wholes & names
            imports |= inner if inner == wholes else {*inner, node.module}
    return imports & names


def circles(graph):
    """Return the groups of nodes from each of which an arrow leads to each other one.

    Args:
        graph: for each node, where its arrows lead.
    """
    reached = {node: reachable(graph, node) for node in graph}
    groups = {
        frozenset(other for other in reached[node] if node in reached[other])
        for node in graph
        if node in reached[node]
    }
    return sorted(sorted(group) for group in groups)


def reachable(graph, start):
    """Return the nodes to which arrows lead from a node."""
    nodes, ahead = set(), [*graph[start]]
    while ahead:
        node = ahead.pop()
        if node not in nodes:
            nodes.add(node)
            ahead += graph[node]
    return nodes
