"""A log is kept up to a limit, and its file can be read up to where it was written."""

import errno

import msgspec
import pytest

from learnblock.runtime.log import keeping
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream, stored
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.why.recorded import Recorded, read

PROGRAM = Program("p.py", "x = 1\n", "x = 1\n")
EVENTS = msgspec.msgpack.encode([[Op.AT, 0], [Op.WRITE, 0, 1, 0]])


def filled(path=None, batches=3):
    log = RunLog(PROGRAM, path)
    for number in range(batches):
        log.noted(number * 100, number * 100 + 99, EVENTS)
        log.stepped(number, b'{"t":%d,"line":1}\n' % number)
        log.happened(number, b'{"t":%d,"pose":[0,0,0]}\n' % number)
    return log


def test_what_is_kept_is_what_is_stored(tmp_path):
    log = filled(tmp_path / "a.why")
    log.end({"ended": "finished"})
    stored_log, kept = read(tmp_path / "a.why"), Recorded.of(log.blocks)
    assert stored_log == kept
    assert len(kept.batches) == 3
    assert [line["t"] for line in kept.lines] == [0, 0, 1, 1, 2, 2]
    assert kept.ending == {"ended": "finished"}
    assert kept.program.python == PROGRAM.python


def test_a_file_that_is_cut_off_is_read_up_to_there(tmp_path):
    path = tmp_path / "a.why"
    filled(path).end({"ended": "finished"})
    whole = path.read_bytes()
    read_blocks = [
        len([*stored(whole[len(MAGIC) : end])]) for end in range(len(MAGIC), len(whole) + 1)
    ]
    assert read_blocks == sorted(read_blocks)
    assert read_blocks[0] == 0
    assert read_blocks[-1] == len([*stored(whole[len(MAGIC) :])])


def test_a_damaged_block_ends_what_is_read(tmp_path):
    path = tmp_path / "a.why"
    filled(path).end({})
    data = bytearray(path.read_bytes())
    data[-3] ^= 0xFF
    path.write_bytes(data)
    assert read(path).ending == {}


def test_a_full_log_gives_up_its_oldest_detail_and_nothing_else(monkeypatch, tmp_path):
    monkeypatch.setattr(keeping, "MOST_BYTES", 20_000)
    log = filled(tmp_path / "a.why", batches=0)
    for number in range(2000):
        log.noted(number, number, EVENTS)
        log.happened(number / 100, b'{"t":%d,"pose":[0,0,0]}\n' % number)
    log.end({"ended": "finished"})
    kept = Recorded.of(log.blocks)
    assert 0 < len(kept.batches) < 2000
    assert log.complete_since > 0
    assert len(kept.lines) == 2000
    assert read(tmp_path / "a.why") == kept
    assert (tmp_path / "a.why").stat().st_size < 2 * 20_000


def test_a_full_disk_does_not_stop_the_run(tmp_path, monkeypatch):
    log = filled(tmp_path / "a.why")

    def refuse(self, data):
        raise OSError(errno.ENOSPC, "No space left on device")

    log._file.close()
    monkeypatch.setattr(
        log, "_file", type("Full", (), {"write": refuse, "close": lambda _: None})()
    )
    log.noted(300, 300, EVENTS)
    log.end({"ended": "finished"})
    assert log.failure == "No space left on device"
    assert Recorded.of(log.blocks).ending == {"ended": "finished"}


def test_a_block_that_unpacks_to_too_much_is_refused(monkeypatch):
    monkeypatch.setattr("learnblock.runtime.log.blocks.LARGEST", 1000)
    with pytest.raises(ValueError, match="too large"):
        assert EventBlock.of(EventStream.WORLD, 0, 0, b"x" * 2000).data
