"""Find variables that are never set, or read before they are set."""

from collections.abc import Iterator

from learnblock.errors import nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.slips import write_instead
from learnblock.language.check.findings import Findings
from learnblock.language.check.other_names import VALUES
from learnblock.language.tree.nodes import Assign, Body, Def, ForEach, ForRange, Item, Name, When
from learnblock.language.tree.traversal import bodies, expressions, set_by, statements, within

# Python sets these in every file.
_PYTHONS_OWN = frozenset(("__name__", "__file__"))


def check_variables(findings: Findings) -> None:
    _Values(findings).run()
    _Order(findings).run()


class _Values:
    """Finds variables that are never set."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.known = findings.assigned | set(findings.whens)

    def run(self) -> None:
        for item in (*self.findings.program.items, *self.findings.main):
            self.never_set(item)

    def never_set(self, item: Item) -> None:
        own = set(item.parameters) if isinstance(item, Def) else set()
        for statement in statements((item,)):
            for node in _read_names(statement):
                self.read(node, own)

    def read(self, node: Name, own: set[str]) -> None:
        findings, name = self.findings, node.name
        if name in findings.assigned or name in own or findings.imports or name in _PYTHONS_OWN:
            return
        if name.startswith(("state_", "time_")):
            return
        findings.report("unknown-name", self.advice(name, own), node.span)

    def advice(self, name: str, own: set[str]) -> Phrase:
        if name in self.findings.whens:
            return Phrase("check-when-as-variable", name=name)
        if name in self.findings.functions:
            return Phrase("check-function-as-variable", name=name)
        if name in VALUES:
            return write_instead(name, VALUES[name])
        if name in self.findings.skills:
            return Phrase("check-skill-as-name", name=name, skill=self.findings.called(name))
        near = nearest(name, self.known | own)
        if near is None:
            return Phrase("check-unknown-name", name=name)
        return Phrase("check-unknown-name-near", name=name, near=near)


class _Order:
    """Follows the top level and `main` in the order in which they run."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.reported: set[str] = set()

    def run(self) -> None:
        program = self.findings.program
        set_so_far = set(self.findings.raw_names)
        for item in program.items:
            if isinstance(item, Def | When):
                # It may be called at any time, so the variables that it sets may already be set.
                set_so_far.update(_sets(item.body))
        self.block((*program.items, *self.findings.main), set_so_far)

    def block(self, body: tuple[Item, ...], known: set[str]) -> None:
        for item in body:
            if isinstance(item, Def | When):
                continue
            for node in _read_names(item):
                self.read(node, known)
            if (name := set_by(item)) is not None:
                known.add(name)
            # A variable set in one branch counts as set: only definite errors are reported.
            for inner in bodies(item):
                self.block(inner, known)

    def read(self, node: Name, known: set[str]) -> None:
        name = node.name
        if name in known or name in self.reported or name not in self.findings.assigned:
            return
        self.reported.add(name)
        self.findings.report(
            "unset-variable", Phrase("check-read-before-set", name=name), node.span
        )


def _read_names(item: Item) -> Iterator[Name]:
    """The variables that a statement reads, without the bodies inside it."""
    target: object = None
    if (isinstance(item, Assign) and item.operator == "=") or isinstance(item, ForEach | ForRange):
        target = item.target
    for expression in expressions(item):
        if expression is not target or not isinstance(target, Name):
            yield from (node for node in within(expression) if isinstance(node, Name))


def _sets(body: Body) -> Iterator[str]:
    for item in statements(body):
        if isinstance(item, Assign) and isinstance(item.target, Name):
            yield item.target.name
