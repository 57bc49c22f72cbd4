"""The command `calls`: what called what in a run."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.cli.console import EXISTING_FILE, json_option, print_json, say, text, usage_error

if TYPE_CHECKING:
    from learnblock.why.calls import Callee, CallNode, Calls, Edge, Layer
    from learnblock.why.calls_beside import CallsBeside

#: The width of the names in the table.
_WIDTH = 44
#: The width of a run's column, if there are two.
_COLUMN = 28
MOST_LOGS = 2


@click.command("calls")
@click.argument(
    "logs",
    type=EXISTING_FILE,
    metavar="LOG [OTHER]",
    nargs=-1,
    required=True,
)
@click.option(
    "--from", "first", type=click.FloatRange(min=0), default=0.0, help="From this time on, in s."
)
@click.option("--to", "last", type=click.FloatRange(min=0), help="Up to this time, in s.")
@click.option(
    "--svg",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Draw the graph into this file.",
)
@json_option
def calls_command(
    logs: tuple[Path, ...],
    first: float,
    last: float | None,
    svg: Path | None,
    as_json: bool,  # noqa: FBT001
) -> None:
    """Show what called what in a run, and for how long.

    The log is written by learnblock run --why. Times are the robot's. Two logs are shown side by
    side, for example of one program on two robots: an asterisk marks what only one of them called.

    \b
    learnblock run examples/square.bt --why square.why
    learnblock calls square.why --svg square.svg
    learnblock run examples/square.bt --robot sim-ev3 --why ev3.why
    learnblock calls square.why ev3.why
    """  # noqa: D301 - click wants the character itself
    from learnblock import why  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.why.calls import calls  # noqa: PLC0415

    if last is not None and last < first:
        raise usage_error("calls-span", first=first, last=last)
    if len(logs) > MOST_LOGS:
        raise usage_error("calls-too-many", most=MOST_LOGS)
    graph, *others = (calls(why.EventHistory(why.read(log)), first, last) for log in logs)
    if others:
        _show_beside(graph, others[0], (logs[0].name, logs[1].name), svg, as_json=as_json)
        return
    if svg:
        svg.write_text(_picture(graph), "utf-8")
    if as_json:
        print_json(graph)
    else:
        _print(graph)


def _show_beside(
    first: "Calls", second: "Calls", files: tuple[str, str], svg: Path | None, *, as_json: bool
) -> None:
    from learnblock.why.calls_beside import beside  # noqa: PLC0415 - as above
    from learnblock.why.graph_picture import pictures_beside  # noqa: PLC0415

    both = beside(first, second)
    names = (f"{files[0]} ({first.robot})", f"{files[1]} ({second.robot})")
    if svg:
        svg.write_text(pictures_beside(both, _titles(), names), "utf-8")
    if as_json:
        print_json({"first": first, "second": second, "pairs": both.pairs})
    else:
        _print_beside(both, names)


def _print_beside(both: "CallsBeside", names: tuple[str, str]) -> None:
    titles = _titles()
    click.echo(f"{'':{_WIDTH}} {_column(names[0])} {_column(names[1])}".rstrip())
    previous = None
    for pair in both.pairs:
        layer = pair.called.layer
        if layer is not previous and layer.value:
            click.echo(titles[layer])
        previous = layer
        name = f"{'*' if pair.differs else ' '} {pair.called.name}"
        counts = f"{_count(pair.first)} {_count(pair.second)}".rstrip()
        click.echo(f"{name:{_WIDTH}} {counts}")
    layers = ", ".join(titles[layer] for layer in both.differing)
    if layers:
        say("calls-differ", layers=layers)
    else:
        say("calls-alike")


def _column(text: str) -> str:
    return f"{text[-_COLUMN:]:>{_COLUMN}}"


def _count(node: "CallNode | None") -> str:
    return _column("–" if node is None else f"{node.count}x {node.seconds:8.2f} s")


def _picture(graph: "Calls") -> str:
    from learnblock.why.graph_picture import picture  # noqa: PLC0415 - `--help` needs none of it

    return picture(graph, _titles())


def _titles() -> "dict[Layer, str]":
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.why.calls import Layer  # noqa: PLC0415

    titles = {
        Layer.PROGRAM: Phrase("calls-layer-program"),
        Layer.FUNCTIONS: Phrase("calls-layer-functions"),
        Layer.SKILLS: Phrase("calls-layer-skills"),
        Layer.CLIENT: Phrase("calls-layer-client"),
        Layer.DEVICES: Phrase("calls-layer-devices"),
        Layer.DRIVER: Phrase("calls-layer-driver"),
    }
    return {layer: text(title) for layer, title in titles.items()}


def _print(graph: "Calls") -> None:
    if not graph.edges:
        say("calls-none")
        return
    whole = graph.nodes[0]
    click.echo(_row(0, whole.called.name, whole))
    _print_callees(graph, whole.called, (whole.called,))


def _print_callees(graph: "Calls", caller: "Callee", above: tuple["Callee", ...]) -> None:
    edges: list[Edge] = [edge for edge in graph.edges if edge.caller == caller]
    # A run does not count by the whole way: below what several call are the calls of all of them.
    is_shared = any(_callers(graph, called) > 1 for called in above)
    for edge in edges:
        row = _row(len(above), edge.callee.name, edge)
        click.echo(f"{row}  {_shared()}" if is_shared else row)
        if edge.callee not in above:
            _print_callees(graph, edge.callee, (*above, edge.callee))


def _callers(graph: "Calls", called: "Callee") -> int:
    return len({edge.caller for edge in graph.edges if edge.callee == called} - {called})


def _shared() -> str:
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it

    return text(Phrase("calls-shared"))


def _row(depth: int, name: str, calls: "CallNode | Edge") -> str:
    label = "  " * depth + name
    return f"{label:{_WIDTH}} {calls.count:>8}x {calls.seconds:>9.2f} s {calls.share:>6.0%}"
