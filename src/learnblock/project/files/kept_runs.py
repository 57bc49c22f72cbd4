"""The runs of a project that were kept: their logs, in a folder beside its history.

Each run is a file ``ID.why``; ``ID.json`` beside it is what the list shows of it, so that listing
reads no logs. A list that is missing or damaged is made again from the logs; only names are lost.
"""

import re
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct
from msgspec.structs import replace

from learnblock.errors import LearnBlockError
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream, stored
from learnblock.runtime.log.noting import TICK
from learnblock.storage.files import save

#: How many runs without a name are kept, and their total size in bytes.
MOST_UNNAMED, MOST_UNNAMED_BYTES = 20, 96 * 1024 * 1024
#: The same of those with a name, which stay until they are deleted.
MOST_NAMED, MOST_NAMED_BYTES = 100, 512 * 1024 * 1024
#: The largest file that is read, and the largest entry of a list.
LARGEST, LARGEST_ENTRY = 40 * 1024 * 1024, 20_000
ENDING = ".why"
#: The limit in characters of the name of a run.
LONGEST_RUN_NAME = 60

_ID = re.compile(r"[0-9]{13,15}-[0-9]{1,3}")
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]")


class KeptRun(Struct, frozen=True, omit_defaults=True):
    """A run of the project that was kept.

    Args:
        id: distinguishes it from the others.
        time: when it began, or was opened from a file, in seconds since 1970.
        size: its size in bytes.
        name: empty unless the user has named it.
        program: the name of the program, and of the robot among several.
        identity: a hash of the program, independent of the robot.
        robot: the robot's id.
        world: the name of its world; empty for a real robot.
        variant: the number of the world's variant.
        seconds: its length.
        ended: one word, as in `Ended`; empty if its log was cut off.
        reached: the goals that were reached.
        missed: the number of the others.
        foreign: whether it was opened from a file.
        damaged: whether nothing of it can be read.
        version: the version of the project that ran; empty if none was saved.
    """

    id: str
    time: float
    size: int = 0
    name: str = ""
    program: str = ""
    identity: str = ""
    robot: str = ""
    world: str = ""
    variant: int = 0
    seconds: float = 0.0
    ended: str = ""
    reached: tuple[str, ...] = ()
    missed: int = 0
    foreign: bool = False
    damaged: bool = False
    version: str = ""


_read_entry = msgspec.json.Decoder(KeptRun).decode


@dataclass(frozen=True)
class KeptRuns:
    """The kept runs of one project, in one folder.

    Args:
        folder: the folder, which may not exist yet.
        read_only: whether nothing may be written.
        now: returns the time in seconds since 1970.
    """

    folder: Path
    read_only: bool = False
    now: Callable[[], float] = time.time

    def runs(self) -> tuple[KeptRun, ...]:
        """List the runs, the newest first."""
        ids = (path.stem for path in self.folder.glob(f"*{ENDING}") if path.is_file())
        runs = map(self._entry, filter(_ID.fullmatch, ids))
        return tuple(sorted(runs, key=lambda run: _order(run.id), reverse=True))

    def find(self, id_: str) -> KeptRun:
        """The run with this id.

        Raises:
            LearnBlockError: there is none.
        """
        self._require(id_)
        return self._entry(id_)

    def read(self, id_: str) -> bytes:
        """The file of a run.

        Raises:
            LearnBlockError: there is none.
            OSError: it can't be read.
        """
        with self._require(id_).open("rb") as file:
            return file.read(LARGEST + 1)

    def add(
        self,
        began: float,
        blocks: Sequence[EventBlock],
        *,
        name: str = "",
        version: str = "",
        foreign: bool = False,
    ) -> KeptRun:
        """Keep a run, and give up old ones without a name if there are too many.

        Args:
            began: when it began, in seconds since 1970.
            blocks: its log.
            name: its name.
            version: the version of the project that ran.
            foreign: whether it comes from elsewhere.

        Raises:
            LearnBlockError: there is no room for another run with a name.
            OSError: it can't be saved.
        """
        self._require_writing()
        data = MAGIC + b"".join(map(bytes, blocks))
        id_ = self._free_id(began)
        entry = replace(
            _summary(id_, began, blocks), size=len(data), version=version, foreign=foreign
        )
        if name:
            self._require_room(len(data))
            entry = replace(entry, name=_plain(name))
        save(self._log(id_), data)
        save(self._about(id_), msgspec.json.encode(entry))
        self._thin_out()
        return entry

    def name(self, id_: str, name: str) -> None:
        """Name a run, or take its name away.

        Raises:
            LearnBlockError: there is no such run, or no room for another one with a name.
            OSError: the name can't be saved.
        """
        self._require_writing()
        run = self.find(id_)
        name = _plain(name)
        if name and not run.name:
            self._require_room(run.size)
        save(self._about(id_), msgspec.json.encode(replace(run, name=name)))
        self._thin_out()

    def delete(self, id_: str) -> None:
        """Delete a run, even a damaged one.

        Raises:
            LearnBlockError: there is no such run.
            OSError: it can't be deleted.
        """
        self._require_writing()
        self._require(id_).unlink()
        self._about(id_).unlink(missing_ok=True)

    def _require(self, id_: str) -> Path:
        path = self._log(id_)
        if not _ID.fullmatch(id_) or not path.is_file():
            raise LearnBlockError("kept-no-such")
        return path

    def _require_writing(self) -> None:
        if self.read_only:
            raise LearnBlockError("server-read-only")

    def _require_room(self, size: int) -> None:
        named_runs = [run for run in self.runs() if run.name]
        if (
            len(named_runs) >= MOST_NAMED
            or sum(run.size for run in named_runs) + size > MOST_NAMED_BYTES
        ):
            raise LearnBlockError("kept-no-room", most=MOST_NAMED, size=MOST_NAMED_BYTES // 2**20)

    def _entry(self, id_: str) -> KeptRun:
        """What the list shows of a run, from its entry, or from the run itself."""
        try:
            size = self._log(id_).stat().st_size
            with self._about(id_).open("rb") as file:
                entry = _read_entry(file.read(LARGEST_ENTRY))
        except (OSError, msgspec.MsgspecError, RecursionError):
            return self._found(id_, "")
        if entry.size == size:
            return replace(entry, id=id_)
        return self._found(id_, entry.name)

    def _found(self, id_: str, name: str) -> KeptRun:
        began = int(id_.partition("-")[0]) / 1000
        try:
            data = self.read(id_)
        except (OSError, LearnBlockError):
            return KeptRun(id_, began, name=name, damaged=True)
        blocks = tuple(stored(data[len(MAGIC) :])) if data.startswith(MAGIC) else ()
        return replace(_summary(id_, began, blocks), size=len(data), name=_plain(name))

    def _free_id(self, began: float) -> str:
        moment = int(began * 1000)
        # Several robots begin at one moment.
        names = (f"{moment:013}-{number}" for number in count(1))
        return next(name for name in names if not self._log(name).exists())

    def _thin_out(self) -> None:
        """Delete the oldest runs without a name; the newest one always stays."""
        unnamed = [run for run in self.runs() if not run.name]
        size = 0
        for number, run in enumerate(unnamed):
            size += run.size
            if number and (number >= MOST_UNNAMED or size > MOST_UNNAMED_BYTES):
                self._log(run.id).unlink(missing_ok=True)
                self._about(run.id).unlink(missing_ok=True)

    def _log(self, id_: str) -> Path:
        return self.folder / (id_ + ENDING)

    def _about(self, id_: str) -> Path:
        return self.folder / (id_ + ".json")


def _order(id_: str) -> tuple[int, int]:
    moment, _, number = id_.partition("-")
    return int(moment), -int(number)


def _plain(name: str) -> str:
    return _CONTROL.sub(" ", name).strip()[:LONGEST_RUN_NAME].strip()


def _summary(id_: str, began: float, blocks: Sequence[EventBlock]) -> KeptRun:
    """What the list shows of a run; only its first and last blocks are read."""
    from learnblock.why.recorded import Recorded  # noqa: PLC0415 - the server answers before

    few = [*_first(blocks, EventStream.HEADER), *_first(blocks, EventStream.WORLD)]
    ending = [block for block in blocks if block.stream is EventStream.ENDING]
    last = max((block.last for block in blocks), default=0) * TICK
    try:
        recorded = Recorded.of([*few, *ending[:1]])
        return _described(id_, began, round(last, 2), recorded)
    except (LearnBlockError, ValueError, TypeError, LookupError, AttributeError, RecursionError):
        return KeptRun(id_, began, damaged=True)


def _first(blocks: Sequence[EventBlock], stream: EventStream) -> Iterator[EventBlock]:
    with suppress(StopIteration):
        yield next(block for block in blocks if block.stream is stream)


def _described(id_: str, began: float, last: float, recorded: Any) -> KeptRun:
    run, ending = recorded.conditions, recorded.ending
    goals = ending.get("goals") or []
    reached = tuple(_text(goal["name"]) for goal in goals if goal["state"] == "reached")
    world = recorded.robot.get("world") or {}
    variant = world.get("variant", 0)
    return KeptRun(
        id_,
        began,
        program=_text(recorded.program.name),
        identity=recorded.program.identity,
        robot=_text(run.get("robot", "")),
        world=_text(run.get("world") or ""),
        variant=variant if isinstance(variant, int) and 0 <= variant <= 9999 else 0,
        seconds=float(ending.get("time", last)),
        ended=_text(ending.get("ended", "")),
        reached=reached[:20],
        missed=len(goals) - len(reached),
    )


def _text(value: object) -> str:
    """A short text, whatever a damaged log has there."""
    return _CONTROL.sub(" ", str(value))[:100]
