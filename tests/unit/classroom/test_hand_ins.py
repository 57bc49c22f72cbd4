"""What is handed in is kept with the teacher's notes and marks, and handed back as they were."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import json

from learnblock.classroom import hand_ins
from learnblock.classroom.hand_ins import (
    CheckedWork,
    CheckSummary,
    HandInFile,
    HandInShelf,
    NotedLine,
)
from learnblock.errors import LearnBlockError
from learnblock.server.messages import GivenProgram, GivenWork

ANA, LESSON = "a" * 10, "1-03-square"
LINE = NotedLine(2, "repeat 3:")
CHECKED = CheckedWork(runs=4, done=1, checks=(CheckSummary("Four corners", 1),))


def work(text="main:\nend\n", lesson=LESSON, step=4, tries=5):
    return GivenWork(lesson, step, GivenProgram(text), tries)


@pytest.fixture
def shelf(tmp_path):
    times = iter(range(1, 1000))
    return HandInShelf(tmp_path, now=lambda: float(next(times)))


def state(shelf):
    return shelf.of_pupil(ANA)[LESSON, 4].state


def test_a_hand_in_is_checked_then_marked_then_handed_back(shelf):
    shelf.add(ANA, work())
    assert state(shelf) == "to check"
    shelf.keep_checked(ANA, work(), CHECKED)
    assert state(shelf) == "to mark"
    shelf.say(ANA, LESSON, 4, note="Count the corners.", mark="8")
    assert state(shelf) == "marked"
    shelf.hand_back(ANA, LESSON, 4)
    assert state(shelf) == "handed back"
    [back] = shelf.read(ANA, LESSON, 4).back
    assert (back.note, back.mark, back.checked) == ("Count the corners.", "8", CHECKED)


def test_a_mark_that_is_said_again_is_not_to_be_handed_back_again(shelf):
    shelf.add(ANA, work())
    for mark, after in (("8", "handed back"), ("9", "marked")):
        shelf.say(ANA, LESSON, 4, note="Nearly.", mark="8")
        shelf.hand_back(ANA, LESSON, 4)
        shelf.say(ANA, LESSON, 4, note="Nearly.", mark=mark)
        assert state(shelf) == after


def test_a_pupil_improves_what_is_back_and_hands_it_in_again(shelf):
    shelf.add(ANA, work())
    shelf.say(ANA, LESSON, 4, note="Nearly.", mark="7")
    shelf.hand_back(ANA, LESSON, 4)
    shelf.improve(ANA, LESSON, 4)
    assert state(shelf) == "improving"
    shelf.add(ANA, work("main:\n    pass\nend\n"))
    file = shelf.read(ANA, LESSON, 4)
    assert (file.state, file.times, file.note, file.mark) == ("to check", 2, "", "")
    assert file.back[-1].mark == "7"


def test_the_same_program_handed_in_again_stays_checked(shelf):
    shelf.add(ANA, work())
    shelf.keep_checked(ANA, work(), CHECKED)
    assert shelf.add(ANA, work()).checked == CHECKED
    assert shelf.add(ANA, work("main:\n    pass\nend\n")).checked is None


def test_a_check_of_a_program_that_was_replaced_meanwhile_says_nothing(shelf):
    shelf.add(ANA, work("main:\n    pass\nend\n"))
    shelf.keep_checked(ANA, work(), CHECKED)
    assert state(shelf) == "to check"


def test_a_note_waits_although_the_pupil_hands_in_again(shelf):
    shelf.add(ANA, work())
    shelf.say(ANA, LESSON, 4, note="Good start", mark="")
    assert shelf.add(ANA, work("main:\n    pass\nend\n")).note == "Good start"


def test_the_line_of_a_note_is_handed_back_with_it(shelf):
    shelf.add(ANA, work())
    shelf.say(ANA, LESSON, 4, note="How often?", mark="", line=LINE)
    again = shelf.add(ANA, work("main:\n    pass\nend\n"))
    assert again.line == LINE
    shelf.hand_back(ANA, LESSON, 4)
    assert shelf.read(ANA, LESSON, 4).back[-1].line == LINE
    assert shelf.add(ANA, work()).line is None


def test_without_a_note_no_line_is_handed_back(shelf):
    shelf.add(ANA, work())
    shelf.say(ANA, LESSON, 4, note="", mark="8", line=LINE)
    shelf.hand_back(ANA, LESSON, 4)
    assert shelf.read(ANA, LESSON, 4).back[-1].line is None


def test_another_process_finds_what_was_kept(shelf, tmp_path):
    shelf.add(ANA, work())
    shelf.say(ANA, LESSON, 4, note="", mark="A+")
    again = HandInShelf(tmp_path)
    assert again.read(ANA, LESSON, 4) == shelf.read(ANA, LESSON, 4)
    assert again.of_pupil(ANA) == shelf.of_pupil(ANA)


def test_a_damaged_file_counts_as_none(shelf):
    shelf.add(ANA, work())
    for damage in (b"", b"{", b'{"work":1}', b"[" * 100_000, b"\xff" * 10):
        shelf.path_of(ANA, LESSON, 4).write_bytes(damage)
        assert shelf.read(ANA, LESSON, 4) is None
        assert HandInShelf(shelf.folder.parent).of_pupil(ANA) == {}


def test_nothing_can_be_marked_improved_or_handed_back_that_was_not_handed_in(shelf):
    for act in (
        lambda: shelf.say(ANA, LESSON, 4, note="", mark="1"),
        lambda: shelf.improve(ANA, LESSON, 4),
        lambda: shelf.hand_back(ANA, LESSON, 4),
    ):
        with pytest.raises(LearnBlockError, match="has not handed in"):
            act()


def test_a_program_that_could_not_be_read_again_is_refused(shelf):
    with pytest.raises(ValueError, match="length"):
        shelf.add(ANA, work("x" * 1_000_000))
    assert shelf.of_pupil(ANA) == {}


def test_a_pupil_can_not_fill_the_disk_with_steps_that_there_are_not(shelf, monkeypatch):
    monkeypatch.setattr(hand_ins, "MOST_HAND_INS", 3)
    for number in range(3):
        shelf.add(ANA, work(lesson=f"lesson {number}"))
    with pytest.raises(LearnBlockError, match="can't be handed in"):
        shelf.add(ANA, work(lesson="one more"))
    assert shelf.add(ANA, work(lesson="lesson 1")).times == 2


def test_what_a_removed_pupil_has_handed_in_is_gone_and_nothing_comes_after(shelf):
    shelf.add(ANA, work())
    shelf.remove(ANA)
    assert not shelf.folder_of(ANA).exists()
    with pytest.raises(LearnBlockError, match="no longer in the class"):
        shelf.add(ANA, work())
    assert shelf.of_pupil(ANA) == {}


@pytest.mark.parametrize(
    ("done", "runs", "stars"), [(0, 4, 0), (1, 4, 1), (2, 4, 1), (3, 4, 2), (4, 4, 3), (1, 1, 3)]
)
def test_three_stars_are_all_starts_two_more_than_half_one_some(done, runs, stars):
    assert CheckedWork(runs=runs, done=done).stars == stars


TEXTS = st.text(st.characters(codec="utf-8"), max_size=20)
FILES = st.builds(
    HandInFile,
    work=st.builds(
        GivenWork, st.just(LESSON), st.integers(1, 30), st.builds(GivenProgram, TEXTS), st.just(3)
    ),
    note=TEXTS,
    mark=TEXTS,
    at=st.floats(0, 1e10),
    waits=st.booleans(),
)


@given(FILES)
def test_what_is_written_is_read_again(file):
    assert json.decode(json.encode(file), type=HandInFile) == file
