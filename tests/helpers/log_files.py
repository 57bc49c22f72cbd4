"""Logs of runs as texts for the fuzzer, unpacked so that changes reach what reads them."""

from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream
from learnblock.server import messages
from learnblock.server.runs.looking import Looking
from learnblock.why.verification import verified
from logged_runs import logged_blocks

#: Between two blocks.
SEPARATOR = "\x1e"


def texts() -> tuple[str, ...]:
    """Short logs of two runs."""
    logs = (logged_blocks(name, "sim-ebo", seconds=2) for name in ("avoid.bt", "patrol.bt"))
    return tuple(SEPARATOR.join(map(_text, log)) for log in logs)


def read_log(text: str) -> None:
    """Read a log as from a file, and look back at it if it is sound."""
    blocks = (_block(part) for part in text.split(SEPARATOR) if part)
    log = verified(MAGIC + b"".join(map(bytes, blocks)))
    looking = Looking(log, ())
    looking.timeline()
    looking.past(messages.LookBack(1.0))
    looking.calls(0.0, None)


def _text(block: EventBlock) -> str:
    return f"{int(block.stream)}{block.data.decode('latin-1')}"


def _block(text: str) -> EventBlock:
    streams = EventStream.__members__.values()
    stream = (
        EventStream(int(text[0])) if text[0] in map(str, map(int, streams)) else EventStream.WORLD
    )
    return EventBlock.of(stream, 0, 0, text[1:].encode("latin-1", "replace"))
