"""The call graphs of two runs side by side: one program on two robots, for example.

The program, its functions and the skills should be the same on both; only the lowest rows, which
are the robot's own, differ.
"""

from dataclasses import dataclass, replace
from functools import cached_property

from learnblock.why.calls import Callee, CallNode, Calls, Edge, Layer


@dataclass(frozen=True, slots=True)
class CallPair:
    """A function in both graphs.

    Args:
        called: which.
        first: its calls in the first run; None if it was not called there.
        second: those in the second run.
    """

    called: Callee
    first: CallNode | None
    second: CallNode | None

    @property
    def differs(self) -> bool:
        """Whether only one of the runs called it."""
        return self.first is None or self.second is None


@dataclass(frozen=True)
class CallsBeside:
    """Two call graphs, with the same name for the program.

    Args:
        first: that of the first run.
        second: that of the second run.
    """

    first: Calls
    second: Calls

    @cached_property
    def pairs(self) -> tuple[CallPair, ...]:
        """All functions, by row; those of both runs come first."""
        first, second = ({node.called: node for node in calls.nodes} for calls in self._graphs)
        pairs = [
            CallPair(called, first.get(called), second.get(called))
            for called in {**first, **second}
        ]
        return tuple(sorted(pairs, key=lambda pair: (pair.called.layer, pair.differs)))

    @property
    def differing(self) -> tuple[Layer, ...]:
        """The rows in which they differ."""
        return tuple(dict.fromkeys(pair.called.layer for pair in self.pairs if pair.differs))

    @property
    def merged(self) -> Calls:
        """Both graphs in one, which gives every function its place."""
        edges: dict[tuple[Callee, Callee], Edge] = {}
        for calls in self._graphs:
            for edge in calls.edges:
                edges.setdefault((edge.caller, edge.callee), edge)
        return Calls("", self.first.first, self.first.last, tuple(edges.values()))

    @property
    def _graphs(self) -> tuple[Calls, Calls]:
        return self.first, self.second


def beside(first: Calls, second: Calls) -> CallsBeside:
    """Put two call graphs side by side."""
    return CallsBeside(first, _renamed(second, first.program))


def _renamed(calls: Calls, program: Callee) -> Calls:
    """The same graph with another name of the program: the runs may have it under two names."""
    edges = (
        replace(edge, caller=program) if edge.caller.layer is Layer.PROGRAM else edge
        for edge in calls.edges
    )
    return replace(calls, edges=tuple(edges))
