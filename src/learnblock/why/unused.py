"""Values that a program computes and does not use: often it uses another one by mistake."""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from difflib import get_close_matches
from functools import cached_property
from typing import Any

from learnblock.i18n import Value
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind
from learnblock.why.history import EventHistory
from learnblock.why.sentences import Draft
from learnblock.why.slices import Slices
from learnblock.why.wording import value_phrase

#: How similar names have to be for one to be a typo of the other.
_ALIKE = 0.75
#: The number of runs of a call that are examined.
_SOME = 8
#: Kinds of nodes that do not use what they contain.
_NO_USE = frozenset({Kind.FUNCTION, *LOOPS})


class Unused:
    """Finds unused values in one run.

    Args:
        slices: of the run.
    """

    def __init__(self, slices: Slices) -> None:
        self._history: EventHistory = slices.history
        self._slices = slices

    def instead_of(self, write: int, name: str) -> Iterator[int]:
        """The last writes of variables that no line reads, perhaps by mistake for another one.

        A variable that only counts is fine: the page shows it.

        Args:
            write: of the other variable.
            name: the other variable.
        """
        value = self._history.value(write)
        for candidate in self._never_read:
            if self._may_be_meant(candidate, name, value):
                yield candidate

    def _may_be_meant(self, write: int, name: str, value: Any) -> bool:
        node, other = self._history.node(write), self._history.value(write)
        names = [variable.casefold() for variable in node.writes]
        is_alike = bool(get_close_matches(name.casefold(), names, 1, _ALIKE))
        is_same_kind = type(value) is type(other) and isinstance(value, bool | list)
        return is_alike or is_same_kind or name in node.reads

    @cached_property
    def _never_read(self) -> tuple[int, ...]:
        history = self._history
        return tuple(
            history.of_node[number][-1]
            for number, node in enumerate(history.nodes)
            if node.kind is Kind.ASSIGN
            and history.of_node.get(number)
            and not self._read.intersection(node.writes)
            and not self._counters.intersection(node.writes)
        )

    def _is_number(self, event: int) -> bool:
        op, _, *values = self._history.events[event]
        return bool(op == Op.WRITE and isinstance(values[0], int | float))

    @cached_property
    def _counters(self) -> frozenset[str]:
        """The variables with numbers that a line changes by their own value, and the robot."""
        history = self._history
        counters = {
            name
            for number, node in enumerate(history.nodes)
            for name in node.writes
            if node.kind is Kind.ASSIGN and name in self._slices.reads(number)
            if any(self._is_number(event) for event in history.of_node.get(number, ())[-1:])
        }
        return frozenset({*counters, "robot"})

    def own_of_functions(self, name: str, after: int) -> Iterator[int]:
        """The last writes, later than an event, of what a function has for itself alone.

        Only of functions that set it without ever reading it: a mistake for the other variable.
        """
        for number in self._own.get(name, ()):
            last = self._history.of_node.get(number, [-1])[-1]
            if last > after:
                yield last

    def results(self, name: str, after: int) -> Iterator[int]:
        """The unused results, later than an event, of the program's functions with a variable."""
        history = self._history
        for call in self._lost.get(name, ()):
            events = history.of_node.get(call, [])
            for result in events[bisect_right(events, after) :][:_SOME]:
                event = history.events[result]
                if event[0] == Op.RESULT and event[2] is not None and self._slices.called(result):
                    yield result
                    break

    def is_used(self, call: int) -> bool:
        """Whether the result of a call is used, for example stored in a variable."""
        return any(
            index < call <= node.last and node.kind not in _NO_USE
            for index, node in enumerate(self._history.nodes)
        )

    @cached_property
    def _own(self) -> dict[str, list[int]]:
        """By name: what sets a variable of a function that the function never reads."""
        setters: dict[str, list[int]] = defaultdict(list)
        for number, node in enumerate(self._history.nodes):
            for name in node.writes if node.kind is Kind.ASSIGN else ():
                is_own = self._slices.is_local(name, node.function)
                if is_own and not self._reads_in(node.function, name):
                    setters[name].append(number)
        return setters

    @cached_property
    def _lost(self) -> dict[str, list[int]]:
        """By name: the calls of the program's functions with a variable and an unused result."""
        calls: dict[str, list[int]] = defaultdict(list)
        for number, node in enumerate(self._history.nodes):
            if node.kind is Kind.CALL and not node.base and not self.is_used(number):
                for name in node.reads:
                    calls[name].append(number)
        return calls

    @cached_property
    def _read(self) -> frozenset[str]:
        """The variables that a line reads for more than changing them."""
        nodes = self._history.nodes
        read: set[str] = set()
        targets: frozenset[str] = frozenset()
        until = -1
        for number, node in enumerate(nodes):
            if node.kind is Kind.ASSIGN:
                targets, until = frozenset(node.writes), node.last
            read |= set(node.reads) - (targets if number <= until else frozenset())
        return frozenset(read)

    def _reads_in(self, function: int, name: str) -> bool:
        nodes = self._history.nodes
        return any(node.function == function and name in node.reads for node in nodes)


class NotUsed:
    """Tells which values a program computed and did not use.

    Args:
        unused: finds it.
        slices: of the run.
        draft: the answer.
    """

    def __init__(self, unused: Unused, slices: Slices, draft: Draft) -> None:
        self._unused = unused
        self._history: EventHistory = slices.history
        self._draft = draft

    def instead_of(self, write: int, name: str) -> Iterator[int]:
        """The last writes of variables that no line reads, perhaps by mistake for another one.

        Args:
            write: of the other variable.
            name: the other variable.
        """
        return self._unused.instead_of(write, name)

    def is_used(self, call: int) -> bool:
        """Whether the result of a call is used, for example stored in a variable."""
        return self._unused.is_used(call)

    def tell_never_read(self, write: int) -> None:
        """Tell that no line reads what was set."""
        node = self._history.node(write)
        self._say("why-never-read", write, name=node.writes[0])

    def tell_not_changed(self, name: str, since: int) -> None:
        """Tell what should have changed a variable since an event, and did not."""
        history = self._history
        for write in self._unused.own_of_functions(name, since):
            function = history.nodes[history.node(write).function].name
            self._say("why-own-name", write, name=name, function=function)
        for result in self._unused.results(name, since):
            value = value_phrase(history.value(result))
            self._say("why-result-lost", result, name=history.node(result).name, value=value)

    def _say(self, code: str, event: int, **values: Value) -> None:
        self._draft.say(code, self._history.number(event), event, **values)
