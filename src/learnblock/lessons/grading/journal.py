"""The journal in the folder of a grading: what is finished survives every kind of end."""

import os
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec
from filelock import FileLock, Timeout

from learnblock.errors import LearnBlockError
from learnblock.storage.files import save

NAME = "journal.jsonl"
_LOCK = ".grading.lock"
#: The longest line that is read back, in bytes.
LONGEST = 4_000_000


class _Line(msgspec.Struct, frozen=True, array_like=True):
    key: str
    result: msgspec.Raw


_decode = msgspec.json.Decoder(_Line).decode


class Journal:
    """Results by the keys of their pieces, appended to a file one line each.

    Only the places of the lines are in memory. A line that was cut off, as by a crash, is left out
    and written again.

    Args:
        path: the file.
    """

    def __init__(self, path: Path) -> None:
        self._places: dict[bytes, tuple[int, int]] = {}
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o644)
        self._end = self._read()

    def __contains__(self, key: str) -> bool:
        return bytes.fromhex(key) in self._places

    def __len__(self) -> int:
        return len(self._places)

    def add(self, key: str, result: bytes) -> None:
        """Append a result: all of its line or, if this process ends now, nothing that counts."""
        if key in self:
            return
        line = _line(key, result)
        written = 0
        while written < len(line):
            written += os.write(self._file, line[written:])
        self._places[bytes.fromhex(key)] = self._end, len(line)
        self._end += len(line)

    def result(self, key: str) -> bytes | None:
        """The result of a piece; None if it is not finished."""
        place = self._places.get(bytes.fromhex(key))
        if place is None:
            return None
        start, length = place
        return bytes(_decode(os.pread(self._file, length, start)).result)

    def close(self) -> None:
        """Close the file."""
        os.close(self._file)

    def _read(self) -> int:
        """Find the finished lines; return where the file ends."""
        start = 0
        with os.fdopen(os.dup(self._file), "rb") as file:
            file.seek(0)
            while line := file.readline(LONGEST):
                if not line.endswith(b"\n"):
                    break
                self._keep(line, start)
                start += len(line)
        os.ftruncate(self._file, start)
        return start

    def _keep(self, line: bytes, start: int) -> None:
        try:
            key = bytes.fromhex(_decode(line).key)
        except (msgspec.MsgspecError, ValueError):
            return
        self._places[key] = start, len(line)


def kept_only(folder: Path, keys: Collection[str]) -> None:
    """Delete all results of a folder but those of some pieces.

    Raises:
        LearnBlockError: another grading uses the folder.
        OSError: it can't be written.
    """
    with opened_journal(folder) as journal:
        kept = {key: result for key in keys if (result := journal.result(key)) is not None}
        if len(kept) == len(journal):
            return
        lines = (_line(key, result) for key, result in kept.items())
        save(folder / NAME, b"".join(lines))


def _line(key: str, result: bytes) -> bytes:
    return msgspec.json.encode(_Line(key, msgspec.Raw(result))) + b"\n"


@contextmanager
def opened_journal(folder: Path) -> Iterator[Journal]:
    """The journal of a folder, which no other grading uses at the same time.

    Raises:
        LearnBlockError: another one does.
    """
    folder.mkdir(parents=True, exist_ok=True)
    lock = FileLock(folder / _LOCK)
    try:
        lock.acquire(timeout=0)
    except Timeout as error:
        raise LearnBlockError("grade-folder-in-use", folder=str(folder)) from error
    with lock:
        journal = Journal(folder / NAME)
        try:
            yield journal
        finally:
            journal.close()
