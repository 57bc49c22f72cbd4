"""Find variables that are never set."""

from learnblock.errors import nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.slips import write_instead
from learnblock.language.check.findings import Findings
from learnblock.language.check.other_names import VALUES
from learnblock.language.check.variable_order_checker import evaluated
from learnblock.language.tree.nodes import Def, Item, Name
from learnblock.language.tree.traversal import statements

# Python sets these in every file.
_PYTHONS_OWN = frozenset(("__name__", "__file__"))


def check_variables(findings: Findings) -> None:
    _Values(findings).run()


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
            for node in evaluated(statement):
                if isinstance(node, Name):
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
