"""More facts about a variable than the statement that set it."""

from learnblock.runtime.log.nodes import Kind
from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry


class VariableFacts:
    """Tells which variables only share a name, and which lines have not set one yet.

    Args:
        inquiry: the question, and its answer so far.
    """

    def __init__(self, inquiry: Inquiry) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._draft = inquiry.draft

    def others(self, name: str, event: int) -> None:
        """Tell which variables of functions only share their name with this one."""
        history = self._history
        frame = history.frames[event] if event >= 0 else None
        for number, node in enumerate(history.nodes):
            if node.kind is not Kind.ASSIGN or name not in node.writes:
                continue
            write = history.of_node.get(number, [-1])[-1]
            is_own = write >= 0 and self._slices.is_local(name, node.function)
            if is_own and history.frames[write] is not frame:
                function = history.nodes[node.function].name
                at = history.number(write)
                self._draft.say("why-own-name", at, write, name=name, function=function)
                self._draft.say("why-own-place", node.function, name=name, function=function)
                return

    def not_yet(self, number: int, event: int) -> None:
        """Tell which lines change what a statement uses, but had not run by an event."""
        history = self._history
        for name in history.nodes[number].reads:
            write = self._slices.last_write(name, event)
            for other, node in enumerate(history.nodes):
                is_writer = node.kind is Kind.ASSIGN and name in node.writes
                ran = history.last_of(history.of_node.get(other, []), event)
                is_same = node.function == history.nodes[number].function
                if write >= 0 and is_writer and is_same and ran < 0:
                    self._draft.say("why-not-yet", other, event, name=name)
