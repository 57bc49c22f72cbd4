"""Read the fields and the extra state of blocks, and report their problems."""

from collections.abc import Mapping
from typing import TypeVar

from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic, Severity
from learnblock.i18n import Phrase
from learnblock.language.tree.nodes import Expression, Name, Node
from learnblock.language.tree.traversal import within
from learnblock.language.workspace.blocks import Block, FieldValue, Workspace
from learnblock.language.workspace.notes import writable
from learnblock.language.workspace.types import MANUALLY_DISABLED, as_name, is_name, is_word

# No user reads more problems at once, and no real block has more inputs.
MAX_PROBLEMS = 100
MAX_INPUTS = 1000

Found = TypeVar("Found")
Made = TypeVar("Made", bound=Expression)


class BlockReader:
    """Reads the fields and the state of blocks.

    `problems` are the diagnostics, each with the id of its block. `ids` maps the `id()` of each
    node to its block, `nodes` each block to its node, and `missing` each empty input to the value
    that replaces it.
    """

    def __init__(
        self, workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
    ) -> None:
        self.configurations = configurations
        self.variables = {variable.id: variable.name for variable in workspace.variables}
        self.problems: list[tuple[str, Diagnostic]] = []
        self.ids: dict[int, str] = {}
        self.nodes: dict[str, Expression] = {}
        self.missing: dict[tuple[str, str], Expression] = {}
        self.height = 0
        # Keep nodes alive, so that no other node gets the same `id()`.
        self.alive: list[Node] = []

    def report(
        self, block: Block, code: str, message: Phrase, severity: Severity = "error"
    ) -> None:
        if len(self.problems) < MAX_PROBLEMS:
            self.problems.append((block.id, Diagnostic(code, message, severity=severity)))

    def note(self, node: Node, block: Block) -> None:
        """Record the block of a node."""
        self.ids[id(node)] = block.id
        self.alive.append(node)

    def made(self, node: Made, block: Block) -> Made:
        """Record the block of a node, and of the nodes inside it that have no block yet."""
        for part in within(node):
            self.ids.setdefault(id(part), block.id)
        return node

    def choice(self, block: Block, field: str, choices: Mapping[str, Found]) -> Found:
        """The meaning of the option chosen in a field."""
        word = block.fields.get(field)
        if isinstance(word, str) and word in choices:
            return choices[word]
        self.report(block, "unknown-choice", Phrase("workspace-unknown-choice", field=field))
        return next(iter(choices.values()))

    def words(self, block: Block, field: str) -> str:
        """The text of a field."""
        value = block.fields.get(field)
        return writable(value) if isinstance(value, str) else ""

    def name(self, block: Block, text: object) -> str:
        """A name; if the text is not a valid name, report it and return the most similar name."""
        if isinstance(text, str) and is_name(text):
            return text
        nearest = as_name(text) if isinstance(text, str) else "_"
        shown = text if isinstance(text, str) else ""
        message = Phrase("workspace-bad-name", name=shown, nearest=nearest)
        self.report(block, "bad-name", message)
        return nearest

    def word(self, block: Block, text: object) -> str:
        """The name of a skill or an argument."""
        return text if isinstance(text, str) and is_word(text) else self.name(block, text)

    def variable(self, block: Block, field: str = "VAR") -> Name:
        """The variable chosen in a field of a block."""
        chosen = block.fields.get(field)
        name: FieldValue = None
        if isinstance(chosen, dict):
            name = self.variables.get(chosen.get("id", ""), chosen.get("name"))
        if name is None:
            self.report(block, "unknown-variable", Phrase("workspace-missing-variable"))
            name = "x"
        node = Name(self.name(block, name))
        self.note(node, block)
        return node


def is_disabled(block: Block) -> bool:
    """Whether the user has disabled a block."""
    return bool(block.disabledReasons) and MANUALLY_DISABLED in block.disabledReasons


def plugged(block: Block, name: str) -> Block | None:
    """The block in an input, else its shadow; None if it is empty or its block is disabled."""
    socket = block.inputs.get(name)
    if socket is None:
        return None
    inner = socket.block or socket.shadow
    return None if inner is None or is_disabled(inner) else inner


def extra(block: Block, name: str) -> object:
    """A value in the extra state of a block."""
    return block.extraState.get(name) if isinstance(block.extraState, dict) else None


def extra_list(block: Block, name: str) -> list[object]:
    state = extra(block, name)
    return state[:MAX_INPUTS] if isinstance(state, list) else []


def extra_count(block: Block, name: str) -> int:
    count = extra(block, name)
    if isinstance(count, bool) or not isinstance(count, int):
        return 0
    return min(max(count, 0), MAX_INPUTS)
