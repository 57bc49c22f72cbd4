from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from clocks import Clock
from learnblock.errors import UnknownNameError
from learnblock.project.files.history import MOST_RUNS, MOST_VERSIONS, History, PastRun
from learnblock.project.files.project import Project

START = 1_700_000_000.0


@pytest.fixture
def clock():
    return Clock(START)


@pytest.fixture
def history(tmp_path, clock):
    return History("p", tmp_path / "p", clock)


def project(text):
    return Project("p", text)


def run(number):
    return PastRun(number, "sim-ebo", "line", "finished", 1.5, ("reached",), "ab", "v")


def test_a_version_is_read_as_it_was_saved(history):
    kept = history.keep(project("x = 1\ny = 2\n"), "run")
    assert history.read(kept) == project("x = 1\ny = 2\n")
    (version,) = history.versions()
    assert (version.id, version.reason, version.lines) == (kept, "run", 3)
    assert version.time == START


def test_versions_are_listed_newest_first(history, clock):
    for number in range(3):
        clock.time += 10
        history.keep(project(f"x = {number}"), "time")
    assert [history.read(one.id).blocktext for one in history.versions()] == [
        "x = 2", "x = 1", "x = 0"
    ]  # fmt: skip


def test_the_same_program_twice_is_one_version(history):
    assert history.keep(project("x"), "run") == history.keep(project("x"), "time")
    assert len(history.versions()) == 1


def test_versions_of_one_moment_stay_in_order(history, clock):
    history.keep(project("x = 1"), "run")
    clock.time -= 3600
    history.keep(project("x = 2"), "run")
    assert history.read(history.versions()[0].id).blocktext == "x = 2"


def test_old_versions_are_thinned_out_except_the_first_and_the_last(history, clock):
    for number in range(MOST_VERSIONS + 60):
        clock.time += 60
        history.keep(project(f"x = {number}"), "time")
    versions = history.versions()
    assert len(versions) == MOST_VERSIONS
    assert history.read(versions[-1].id).blocktext == "x = 0"
    assert history.read(versions[0].id).blocktext == f"x = {MOST_VERSIONS + 59}"

    gaps = [one.time - other.time for one, other in pairwise(versions)]
    assert max(gaps[:20]) < max(gaps[-20:])


def test_versions_of_conflicts_stay_longest(history, clock):
    for number in range(MOST_VERSIONS + 60):
        clock.time += 60
        history.keep(project(f"x = {number}"), "conflict" if number in (20, 21, 22) else "run")
    kept = [version.reason for version in history.versions()]
    assert (len(kept), kept.count("conflict")) == (MOST_VERSIONS, 3)


def test_a_version_that_is_not_kept_is_refused(history):
    with pytest.raises(UnknownNameError, match=r"There is no version '\.\./"):
        history.read("../../etc")


def test_a_project_without_history_has_none(history):
    assert (history.versions(), history.runs()) == ((), ())


def test_runs_are_listed_newest_first_up_to_a_limit(history):
    for number in range(MOST_RUNS + 3):
        history.add_run(run(number))
    runs = history.runs()
    assert len(runs) == MOST_RUNS
    assert runs[0] == run(MOST_RUNS + 2)


@given(st.binary(max_size=200))
def test_a_damaged_list_of_runs_does_not_prevent_a_run(tmp_path_factory, data):
    history = History("p", tmp_path_factory.mktemp("history"))
    (history.folder / "runs.json").write_bytes(data)
    assert history.runs() == ()
    history.add_run(run(1))
    assert history.runs() == (run(1),)


def test_other_files_in_its_folder_are_not_versions(history):
    history.keep(project("x"), "run")
    (history.folder / "notes.learnblock").write_text("mine")
    assert len(history.versions()) == 1
