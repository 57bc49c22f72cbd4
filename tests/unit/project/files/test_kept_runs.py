"""The runs of a project are kept: the last ones, and those with a name."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.project.files import kept_runs
from learnblock.project.files.kept_runs import KeptRuns
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program

BEGAN = 1_700_000_000.0


@pytest.fixture
def kept(tmp_path):
    return KeptRuns(tmp_path / "runs")


def log(**ending):
    text = "x = 1\n"
    made = RunLog(Program("square", text, text))
    made.happened(0.0, b'{"run":{"robot":"sim-ebo","world":"arena","seed":0}}\n')
    made.noted(0, 250, b"\x90")
    if ending:
        made.end(ending)
    return made.blocks


def test_the_list_tells_program_robot_world_length_and_goals(kept):
    goals = [{"name": "box", "state": "reached"}, {"name": "exit", "state": "open"}]
    kept.add(BEGAN, log(ended="finished", time=2.5, goals=goals))
    [run] = kept.runs()
    assert (run.time, run.program, run.robot, run.world) == (BEGAN, "square", "sim-ebo", "arena")
    assert (run.seconds, run.ended, run.reached, run.missed) == (2.5, "finished", ("box",), 1)
    assert kept.read(run.id).startswith(b"LearnBlock run log")


def test_a_log_that_was_cut_off_has_no_ending_but_a_length(kept):
    kept.add(BEGAN, log())
    [run] = kept.runs()
    assert (run.ended, run.seconds, run.damaged) == ("", 2.5, False)


def test_programs_of_one_moment_are_kept_beside_each_other(kept):
    ids = [kept.add(BEGAN, log()).id for _ in range(3)]
    assert [run.id for run in kept.runs()] == ids


def test_the_last_twenty_without_a_name_are_kept_and_all_with_one(kept):
    kept.add(BEGAN - 1, log(), name="my best")
    for number in range(23):
        kept.add(BEGAN + number, log())
    runs = kept.runs()
    assert len(runs) == 21
    assert [run.time for run in runs[:2]] == [BEGAN + 22, BEGAN + 21]
    assert runs[-1].name == "my best"
    assert len(list(kept.folder.iterdir())) == 42


def test_a_large_run_gives_up_the_older_ones_but_stays_itself(kept, monkeypatch):
    monkeypatch.setattr(kept_runs, "MOST_UNNAMED_BYTES", 100)
    for number in range(2):
        kept.add(BEGAN + number, log())
    assert [run.time for run in kept.runs()] == [BEGAN + 1]


def test_there_is_room_for_so_many_names_only(kept, monkeypatch):
    monkeypatch.setattr(kept_runs, "MOST_NAMED", 1)
    first, second = (kept.add(BEGAN + number, log()).id for number in range(2))
    kept.name(first, "one")
    with pytest.raises(LearnBlockError, match="at most 1 runs"):
        kept.name(second, "two")
    kept.name(first, "another name")


def test_a_name_is_one_line_and_can_be_taken_away(kept):
    id_ = kept.add(BEGAN, log()).id
    kept.name(id_, "  two\nlines  ")
    assert kept.find(id_).name == "two lines"
    kept.name(id_, "")
    assert kept.find(id_).name == ""


@pytest.mark.parametrize("id_", ["", "../runs/1700000000000-1", "1700000000000-1/..", "x" * 5000])
def test_an_id_that_is_none_leads_nowhere(kept, id_):
    kept.add(BEGAN, log())
    for use in (kept.find, kept.read, kept.delete):
        with pytest.raises(LearnBlockError, match="not kept any more"):
            use(id_)
    assert len(kept.runs()) == 1


@pytest.mark.parametrize("content", [b"", b"not a log", b"LearnBlock run log 1\nrubbish"])
def test_a_damaged_run_is_listed_as_such_and_can_be_deleted(kept, content):
    id_ = kept.add(BEGAN, log(ended="finished")).id
    (kept.folder / f"{id_}.why").write_bytes(content)
    [run] = kept.runs()
    assert (run.id, run.damaged) == (id_, True)
    kept.delete(id_)
    assert kept.runs() == ()
    assert list(kept.folder.iterdir()) == []


@pytest.mark.parametrize("content", [b"", b"{}", b"[" * 10_000, b'{"id":"x","time":"?"}'])
def test_a_damaged_entry_is_made_again_from_the_log(kept, content):
    id_ = kept.add(BEGAN, log(ended="finished")).id
    (kept.folder / f"{id_}.json").write_bytes(content)
    [run] = kept.runs()
    assert (run.id, run.ended, run.program) == (id_, "finished", "square")


def test_other_files_in_the_folder_are_left_alone(kept):
    kept.add(BEGAN, log())
    other = kept.folder / "notes.why"
    other.write_text("mine")
    assert len(kept.runs()) == 1
    assert other.read_text() == "mine"


def test_a_folder_that_is_only_read_keeps_nothing(tmp_path):
    with pytest.raises(LearnBlockError):
        KeptRuns(tmp_path, read_only=True).add(BEGAN, log())
    assert list(tmp_path.iterdir()) == []
