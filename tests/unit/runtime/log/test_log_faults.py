"""Whatever happens to a log or in its program, the run goes on, and the file opens up to there."""

import random
import resource
import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import msgspec
import pytest

from learnblock.cli.console import ExitCode
from learnblock.errors import LearnBlockError
from learnblock.runtime.log import keeping
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream, stored
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.why import EventHistory, read
from learnblock.why.moments import Moments
from learnblock.why.questions import questions
from learnblock.why.recorded import Recorded
from logged_runs import logged_text

pytestmark = [pytest.mark.realtime, pytest.mark.certain]

DRIVING = (
    "values = [1]\nwhen near = function.is_front_obstacle(300):\n    function.turn(20)\n"
    "    append(values, len(values))\nend\n"
    "when drive = True:\n    function.move_straight(60)\n    function.sleep(0.2)\nend\n"
)
COMMAND = [sys.executable, "-m", "learnblock", "run"]


def look_at(log: Recorded) -> EventHistory:
    """Read a log as the page does."""
    history = EventHistory(log)
    moments = Moments(history)
    for part in range(5):
        moments.at(history.end * part / 4)
    questions(history)
    return history


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The file of a run."""
    folder = tmp_path_factory.mktemp("whole")
    path = folder / "program.bt"
    path.write_text(DRIVING)
    command = [*COMMAND, str(path), "--world", "arena", "--for", "6", "--why", folder / "a.why"]
    subprocess.run(command, check=True, capture_output=True)
    return (folder / "a.why").read_bytes()


@pytest.mark.slow
def test_a_killed_host_leaves_a_file_that_opens(tmp_path):
    path, log = tmp_path / "program.bt", tmp_path / "a.why"
    path.write_text(DRIVING)
    command = [*COMMAND, str(path), "--world", "arena", "--pace", "real", "--why", str(log)]
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    try:
        # Two blocks of what happened in the world: it drives.
        while not (log.exists() and len(_blocks(log, EventStream.WORLD)) >= 2):
            assert run.poll() is None
    finally:
        run.send_signal(signal.SIGKILL)
        run.wait()
    history = look_at(read(log))
    assert history.end > 0
    assert history.recorded.ending == {}


def _blocks(log: Path, stream: EventStream) -> list[EventBlock]:
    return [one for one in stored(log.read_bytes()[len(MAGIC) :]) if one.stream is stream]


def test_a_file_cut_off_anywhere_opens_up_to_there(whole, tmp_path):
    path = tmp_path / "a.why"
    header = len(MAGIC) + len(bytes(next(stored(whole[len(MAGIC) :]))))
    ends = []
    for size in range(header, len(whole), 10):
        path.write_bytes(whole[:size])
        ends.append(sum(map(len, read(path).batches)))
    assert ends == sorted(ends)
    look_at(read(path))


def test_a_file_with_flipped_bytes_opens_up_to_the_first_of_them(whole, tmp_path):
    path = tmp_path / "a.why"
    rng = random.Random(1)  # noqa: S311 - not a secret
    for _ in range(300):
        at = rng.randrange(len(whole))
        path.write_bytes(whole[:at] + bytes([whole[at] ^ rng.randrange(1, 256)]) + whole[at + 1 :])
        try:
            log = read(path)
        except LearnBlockError:
            # Its first block says what program it is of.
            assert at < 5000
        else:
            assert log.batches == read_events(whole)[: len(log.batches)]


def read_events(whole: bytes):
    return Recorded.of(stored(whole[len(MAGIC) :])).batches


def test_events_that_make_no_sense_are_refused_or_read(whole):
    rng = random.Random(2)  # noqa: S311 - not a secret
    blocks = [*stored(whole[len(MAGIC) :])]
    batches = read_events(whole)
    refused = 0
    for _ in range(200):
        events = [list(event) for event in rng.choice(batches)]
        for _ in range(rng.randint(1, 5)):
            event = rng.choice(events)
            event[rng.randrange(len(event))] = rng.choice((-1, 7, 99999, None, "x", [], True, 1.5))
        block = EventBlock.of(EventStream.PROGRAM, 0, 0, msgspec.msgpack.encode(events))
        try:
            look_at(Recorded.of([*blocks[:1], block]))
        except LearnBlockError:
            refused += 1
    assert refused


def test_a_log_that_unpacks_to_far_too_much_is_refused(whole, monkeypatch):
    monkeypatch.setattr("learnblock.why.recorded.MOST_UNPACKED", 10_000)
    with pytest.raises(LearnBlockError):
        Recorded.of(stored(whole[len(MAGIC) :]))


def _limit_files(size: int) -> None:
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


@pytest.mark.slow
def test_a_file_that_may_not_grow_does_not_end_the_run(tmp_path):
    path, log = tmp_path / "program.bt", tmp_path / "a.why"
    path.write_text(DRIVING)
    done = subprocess.run(
        [*COMMAND, str(path), "--world", "arena", "--for", "60", "--why", str(log)],
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=partial(_limit_files, 6000),
    )
    assert done.returncode == ExitCode.WELL, done.stderr
    assert "File too large" in done.stderr
    assert log.stat().st_size == 6000
    assert look_at(read(log)).end < 60


def test_a_full_disk_does_not_end_the_run(tmp_path):
    log = RunLog(Program("p.py", "x = 1\n", "x = 1\n"), Path("/dev/full"))
    log.happened(0, b'{"t":0,"line":1}\n')
    log.end({"ended": "finished"})
    assert log.failure == "No space left on device"
    assert Recorded.of(log.blocks).ending == {"ended": "finished"}


def run_python(folder: Path, body: str, **options):
    """Run raw Python in a program with a log; it must end well, and its log be read."""
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    logged = logged_text(folder, f"main:\n    python:\n{_indented(lines)}    end\nend\n", **options)
    assert logged.report.error is None, logged.report.error
    look_at(logged.recorded)
    return logged


def _indented(lines: str) -> str:
    return "".join(f"    {line}\n" for line in lines.splitlines())


def test_a_million_turns_of_a_loop_keep_the_log_small(tmp_path):
    body = "x = 0\nwhile x < 1_000_000:\n    x += 1\nrobot.sleep(1)\nprint(x)"
    logged = run_python(tmp_path, body)
    assert sum(map(len, logged.recorded.batches)) < 5000
    assert Moments(logged.history).at(0.5).shared["x"] == "1000000"


def test_a_list_of_a_million_items_keeps_the_log_small(tmp_path):
    body = "values = list(range(1_000_000))\nfor i in range(300):\n    values.append(i)\n"
    logged = run_python(tmp_path, body + "    robot.sleep(0.01)")
    assert len(msgspec.msgpack.encode(logged.recorded.batches)) < 200_000
    assert Moments(logged.history).at(2).shared["values"].endswith("19, ... 1000181 more]")


def test_lists_in_lists_keep_what_is_told_of_one_moment_small(tmp_path):
    body = "rows = [['a' * 100] * 100] * 100\nfor i in range(3000):\n    rows = [*rows]"
    logged = run_python(tmp_path, f"{body}\nrobot.sleep(1)")
    assert len(msgspec.msgpack.encode(logged.recorded.batches)) < 1_000_000


def test_recursion_to_its_limit_ends_as_the_program_wants(tmp_path):
    body = (
        "def deep(n):\n    try:\n        return deep(n + 1)\n    except RecursionError:\n"
        "        return n\nprint(deep(0) > 300)\nrobot.sleep(1)\n"
    )
    logged = run_python(tmp_path, body)
    assert [line["print"] for line in logged.recorded.lines if "print" in line] == ["True"]


def test_thousands_of_generated_names_keep_the_log_small(tmp_path):
    body = (
        "for i in range(5000):\n    exec(f'made{i} = {i}')\n    globals()[f'v{i}' * 50] = i\n"
        "globals()[5] = 1\nglobals()['\\ud800'] = 2\nrobot.sleep(12)\nlast = 1\nrobot.sleep(1)"
    )
    logged = run_python(tmp_path, body)
    assert len(msgspec.msgpack.encode(logged.recorded.batches)) < 1_000_000
    assert Moments(logged.history).at(12.5).shared["last"] == "1"


def test_as_many_lines_as_a_program_may_print_are_kept(tmp_path):
    body = "for i in range(50_000):\n    print(i % 10)\n"
    body += "    if i % 100 == 0:\n        robot.sleep(0.01)"
    logged = run_python(tmp_path, body)
    assert sum("print" in line for line in logged.recorded.lines) == 50_000


def test_texts_that_no_file_can_hold_are_kept_readably(tmp_path):
    body = (
        "text = '\\ud800'\nvalues = ['\\udc80', {'\\udfff': 1}]\nprint(text)\n"
        "class Odd:\n    def __bool__(self):\n        raise ValueError\n"
        "    def __eq__(self, other):\n        raise ValueError\n"
        "odd = Odd()\nrobot.sleep(1)"
    )
    logged = run_python(tmp_path, body)
    assert Moments(logged.history).at(0.5).shared["text"] == repr("\\ud800")


def test_gigabytes_of_values_keep_log_and_memory_small(tmp_path):
    body = "for i in range(100):\n    text = 'a' * 20_000_000\n    values = [text] * 1000\n"
    logged = run_python(tmp_path, body + "    robot.sleep(0.01)")
    assert len(msgspec.msgpack.encode(logged.recorded.batches)) < 1_000_000


def test_a_log_that_is_full_of_the_world_gives_that_up_too(monkeypatch, tmp_path):
    monkeypatch.setattr(keeping, "MOST_UNPACKED", 300_000)
    log = RunLog(Program("p.py", "x = 1\n", "x = 1\n"), tmp_path / "a.why")
    log.happened(0, b'{"run":{"robot":"sim-ebo"}}\n')
    for number in range(20_000):
        log.happened(number / 100, b'{"t":%f,"device":"Base","args":[%d]}\n' % (number, number))
    log.end({"ended": "finished"})
    kept = read(tmp_path / "a.why")
    assert kept.conditions == {"robot": "sim-ebo"}
    assert {"t": 0.0, "lost": True} in kept.lines
    assert len(kept.lines) < 10_000
    assert kept.lines[-1]["args"] == [19_999]
    assert log.complete_since > 0
