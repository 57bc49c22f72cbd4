"""The call graph as an SVG picture: a row for each layer, a line for each caller and callee."""

from collections import defaultdict
from functools import partial
from html import escape

from learnblock.why.calls import Callee, CallNode, Calls, Edge, Layer
from learnblock.why.calls_beside import CallsBeside

#: Sizes in pixels: of a box, of the space around it and of the text in it.
BOX, HEIGHT, SPACE, ROW, TEXT, SMALL = 172, 44, 18, 104, 12, 10
#: The number of passes that sort each row by its callers.
SWEEPS = 4
#: As in the paper's figure 8: from a small to a large share of the time.
COLOURS = ("#d9dce3", "#b9d3f5", "#8fb4ef", "#b39ae6", "#e88fd0")
_FULL = 0.5
#: The most characters of a name that fit into a box.
LONGEST = 20
#: The room for the names of two runs, and the edge of a function that only one of them has.
HEADING, APART = 34, "#c2410c"


def picture(calls: Calls, titles: dict[Layer, str]) -> str:
    """Draw a call graph.

    Args:
        calls: the graph.
        titles: the names of its rows.

    Returns:
        An SVG picture.
    """
    rows = _rows(calls)
    widest = max(len(row) for row in rows.values())
    width = widest * (BOX + SPACE) + SPACE + BOX
    places = _places(rows, width)
    height = len(rows) * ROW + SPACE
    names = "".join(
        f'<text x="{SPACE}" y="{_top(index) + HEIGHT / 2}">{escape(titles[layer])}</text>'
        for index, layer in enumerate(rows)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"'
        f' font-family="sans-serif" font-size="{TEXT}">'
        '<rect width="100%" height="100%" fill="#fff"/>'
        f'<g fill="#4a5473">{names}</g>{_graph(calls, places)}</svg>\n'
    )


def pictures_beside(both: CallsBeside, titles: dict[Layer, str], names: tuple[str, str]) -> str:
    """Draw two call graphs side by side, every function at the same place in both.

    A function that only one of them has gets a thick edge.

    Args:
        both: the graphs.
        titles: the names of their rows.
        names: the names of the runs.

    Returns:
        An SVG picture.
    """
    merged = both.merged
    rows = _rows(merged)
    width = max(map(len, rows.values())) * (BOX + SPACE) + SPACE + BOX
    places = _places(rows, width)
    height = len(rows) * ROW + SPACE + HEADING
    apart = frozenset(pair.called for pair in both.pairs if pair.differs)
    graphs = "".join(
        f'<g transform="translate({index * width},{HEADING})">'
        f'<text x="{width / 2:.0f}" y="{-SPACE / 2}" text-anchor="middle" font-size="15"'
        f' font-weight="bold">{escape(name)}</text>{_graph(graph, places, apart)}</g>'
        for index, (graph, name) in enumerate(zip((both.first, both.second), names, strict=True))
    )
    texts = "".join(
        f'<text x="{SPACE}" y="{_top(index) + HEADING + HEIGHT / 2}">{escape(titles[layer])}</text>'
        for index, layer in enumerate(rows)
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * width} {height}"'
        f' font-family="sans-serif" font-size="{TEXT}">'
        f'<rect width="100%" height="100%" fill="#fff"/><g fill="#4a5473">{texts}</g>'
        f"{graphs}</svg>\n"
    )


def _graph(
    calls: Calls,
    places: dict[Callee, tuple[float, float]],
    apart: frozenset[Callee] = frozenset(),
) -> str:
    lines = "".join(_line(edge, places) for edge in calls.edges)
    counts = "".join(_count(edge, places) for edge in calls.edges)
    boxes = "".join(
        _box(node, places[node.called], is_apart=node.called in apart) for node in calls.nodes
    )
    return (
        f'<g fill="none" stroke="#717d9b">{lines}</g>{boxes}'
        f'<g fill="#4a5473" font-size="{SMALL}" text-anchor="middle" stroke="#fff"'
        f' stroke-width="3" paint-order="stroke">{counts}</g>'
    )


def _rows(calls: Calls) -> dict[Layer, list[Callee]]:
    """The functions by row, each near its callers, so that few lines cross."""
    rows: dict[Layer, list[Callee]] = defaultdict(list)
    for node in calls.nodes:
        rows[node.called.layer].append(node.called)
    for _ in range(SWEEPS):
        for row in rows.values():
            order = _order(rows)
            row.sort(key=partial(_middle, calls, order))
    return dict(sorted(rows.items()))


def _order(rows: dict[Layer, list[Callee]]) -> dict[Callee, float]:
    """How far to the right each function is in its row, from 0 to 1."""
    return {called: index / len(row) for row in rows.values() for index, called in enumerate(row)}


def _middle(calls: Calls, order: dict[Callee, float], called: Callee) -> float:
    """How far to the right the callers of a function are, on average."""
    above = [order[edge.caller] for edge in calls.edges if edge.callee == called]
    return sum(above) / len(above) if above else order[called]


def _places(rows: dict[Layer, list[Callee]], width: int) -> dict[Callee, tuple[float, float]]:
    """The upper middle of each box."""
    places: dict[Callee, tuple[float, float]] = {}
    for index, row in enumerate(rows.values()):
        step = (width - BOX) / len(row)
        for column, called in enumerate(row):
            places[called] = (BOX + (column + 0.5) * step, _top(index))
    return places


def _top(row: int) -> int:
    return SPACE + row * ROW


def _line(edge: Edge, places: dict[Callee, tuple[float, float]]) -> str:
    (x, y), (to_x, to_y) = places[edge.caller], places[edge.callee]
    y += HEIGHT
    if to_y < y:
        # A call of the same row or a higher one, such as of the function itself.
        return f'<path d="M{x:.0f} {y:.0f} q{BOX / 2} 24 {to_x - x:.0f} 0"/>'
    middle = (y + to_y) / 2
    return (
        f'<path stroke-width="{1 + 3 * edge.share:.1f}" d="M{x:.0f} {y:.0f} C{x:.0f} {middle:.0f}'
        f' {to_x:.0f} {middle:.0f} {to_x:.0f} {to_y:.0f}"/>'
    )


def _count(edge: Edge, places: dict[Callee, tuple[float, float]]) -> str:
    """How often, and for how much of the time: in the middle of the line."""
    (x, y), (to_x, to_y) = places[edge.caller], places[edge.callee]
    below = (to_y - y + HEIGHT) / 2 if to_y > y else HEIGHT + SPACE
    return (
        f'<text x="{(x + to_x) / 2:.0f}" y="{y + below + SMALL / 3:.0f}">'
        f"{edge.count}×, {edge.share:.0%}</text>"
    )


def _box(node: CallNode, place: tuple[float, float], *, is_apart: bool = False) -> str:
    x, y = place
    calls = f"{node.count}×, {node.seconds:g} s" if node.seconds else f"{node.count}×"
    edge = f'stroke="{APART}" stroke-width="4"' if is_apart else 'stroke="#4a5473"'
    return (
        f"<g><title>{escape(node.called.name)}: {calls}</title>"
        f'<rect x="{x - BOX / 2:.0f}" y="{y:.0f}" width="{BOX}" height="{HEIGHT}" rx="8"'
        f' fill="{colour(node.share)}" {edge}/>'
        f'<text text-anchor="middle" x="{x:.0f}" y="{y + 18:.0f}" font-weight="bold">'
        f"{escape(_short(node.called.name))}</text>"
        f'<text text-anchor="middle" x="{x:.0f}" y="{y + 35:.0f}">{calls}</text></g>'
    )


def colour(share: float) -> str:
    """The colour of a share of the time, from 0 to 1."""
    index = round(min(1.0, share / _FULL) * (len(COLOURS) - 1))
    return COLOURS[index]


def _short(name: str) -> str:
    return name if len(name) <= LONGEST else name[: LONGEST - 1] + "…"
