"""Marks as tables for spreadsheets and for Moodle."""

import csv
import io

import pytest

from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.marking import Marking
from learnblock.classroom.marks import marks, marks_for_moodle
from learnblock.classroom.roster import Roster
from learnblock.server.messages import GivenProgram, GivenWork

PLACE = ("1-03-square", 4)


@pytest.fixture
def marking(tmp_path):
    roster, shelf = Roster(tmp_path, "7b"), HandInShelf(tmp_path, now=lambda: 0.0)
    for name, mark in (("Ana", "9,5"), ("Bo", ""), ("Юля", "=A1")):
        pupil, _ = roster.add(name)
        shelf.add(pupil.id, GivenWork(*PLACE, GivenProgram("main:\nend\n"), 3))
        shelf.say(pupil.id, *PLACE, note='Say "why"', mark=mark)
    roster.add("Eva")
    return Marking(roster, shelf, lambda: None)


def read(data):
    assert data.startswith(b"\xef\xbb\xbf")
    return list(csv.DictReader(io.StringIO(data.decode("utf-8-sig"))))


def test_every_pupil_has_a_row_and_no_cell_is_a_formula(marking):
    rows = read(marks(marking, *PLACE))
    assert [(row["pupil"], row["mark"], row["note"], row["tries"]) for row in rows] == [
        ("Ana", "9,5", 'Say "why"', "3"),
        ("Bo", "", 'Say "why"', "3"),
        ("Юля", "'=A1", 'Say "why"', "3"),
        ("Eva", "", "", ""),
    ]
    assert rows[-1]["state"] == "not begun"


def test_for_moodle_only_those_with_a_mark_have_a_row(marking):
    rows = read(marks_for_moodle(marking, *PLACE, "es"))
    assert [row["First name"] for row in rows] == ["Ana", "Юля"]
    [grade, feedback] = [*rows[0]][2:]
    assert feedback == f"{grade} feedback"
    assert rows[0][grade] == "9,5"
