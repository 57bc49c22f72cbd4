"""Find items that a list does not have, where its length is certain before the run."""

from collections import Counter
from collections.abc import Iterable, Mapping

from learnblock.i18n import Phrase
from learnblock.language.check.findings import Findings, constant
from learnblock.language.tree.nodes import (
    Assign,
    Call,
    Compare,
    Def,
    Expression,
    ForEach,
    ForRange,
    Index,
    Item,
    List,
    Name,
    Perform,
)
from learnblock.language.tree.traversal import all_expressions, expressions, set_by, targets, within

#: The functions that leave a list as it is.
_READING = frozenset(
    (
        *("len", "print", "str", "sum", "min", "max", "mean", "median", "mode", "stdev"),
        *("choice", "sorted", "join", "count", "index", "copy", "sublist", "list"),
    )
)


def check_lists(findings: Findings) -> None:
    """Report items past the end of a list that has the same length in the whole program."""
    for item in findings.everything:
        if isinstance(item, ForRange):
            _counting(findings, item)
    # Most lists grow, so most programs need not be searched for what changes a list.
    if lengths := _written(findings):
        _items(findings, lengths)


def _written(findings: Findings) -> dict[str, int]:
    """The lists that are written in full, once, with their lengths."""
    lengths: dict[str, int] = {}
    again = set(findings.raw_names)
    for item in findings.everything:
        match item:
            case Perform(call=Call(name=name, arguments=arguments)) if name not in _READING:
                again.update(_names(arguments))
            case Assign(target=Name(name=name), value=List(items=items)) if name not in lengths:
                lengths[name] = len(items)
            case Assign() | ForEach():
                again.update(set_by(item))
            case Def(parameters=parameters):
                again.update(parameters)
    return {name: length for name, length in lengths.items() if name not in again}


def _items(findings: Findings, lengths: Mapping[str, int]) -> None:
    changed: set[str] = set()
    items: list[Index] = []
    for item in findings.everything:
        for expression in expressions(item):
            changed |= _changed(expression, item, items)
    certain = {name: length for name, length in lengths.items() if name not in changed}
    for index in items:
        _item(findings, index, certain)


def _changed(expression: Expression, item: Item, items: list[Index]) -> set[str]:
    """The names whose lists an expression may change; its indexes are added to `items`."""
    mentions: Counter[str] = Counter()
    if isinstance(item, Assign | ForEach) and any(
        expression is part for part in (*targets(item), _values(item))
    ):
        mentions.subtract(_names((expression,)))
    for node in within(expression):
        match node:
            case Name(name=name):
                mentions[name] += 1
            case Index(value=value):
                items.append(node)
                mentions.subtract(_names((value,)))
            case Compare(operands=operands):
                mentions.subtract(_names(operands))
            case Call(name=name, arguments=arguments) if name in _READING:
                mentions.subtract(_names(arguments))
    return {name for name, count in mentions.items() if count > 0}


def _values(item: Assign | ForEach) -> Expression:
    return item.values if isinstance(item, ForEach) else item.target


def _names(nodes: Iterable[Expression]) -> list[str]:
    return [node.name for node in nodes if isinstance(node, Name)]


def _item(findings: Findings, node: Index, lengths: Mapping[str, int]) -> None:
    place = constant(node.index)
    length = _length(node.value, lengths)
    if place is None or isinstance(place, str) or length is None or -length <= place < length:
        return
    values = findings.spelled(node.value)
    if length:
        message = Phrase(
            "check-past-end", values=values, index=f"{place:g}", length=length, last=str(length - 1)
        )
    else:
        code = findings.worded("check-empty-list-item", "check-empty-list-item-python")
        message = Phrase(code, values=values, index=f"{place:g}")
    findings.report("past-end", message, node.index.span, "warning")


def _length(values: Expression, lengths: Mapping[str, int]) -> int | None:
    return lengths.get(values.name) if isinstance(values, Name) else None


def _counting(findings: Findings, item: ForRange) -> None:
    """Report ``for i from ... to len(values)`` with ``values[i]`` inside."""
    match item.stop:
        case Call(name="len", arguments=(Name(name=values),)) if item.step is None:
            pass
        case _:
            return
    for statement in item.body:
        for node in all_expressions(statement):
            match node:
                case Index(value=Name(name=indexed), index=Name(name=index)) if (
                    indexed == values and index == item.target.name
                ):
                    code = findings.worded("check-loop-past-end", "check-loop-past-end-python")
                    line = str(item.span.line)
                    message = Phrase(code, values=values, index=index, line=line)
                    findings.report("past-end", message, node.index.span, "warning")
                    return
