"""The pupils of a class, as its file keeps them."""

import json
import stat
import unicodedata

import pytest

from learnblock.classroom.roster import FILE, MOST_PUPILS, Roster, checked_name, names_of
from learnblock.errors import LearnBlockError


@pytest.fixture
def roster(tmp_path):
    return Roster(tmp_path, "7b")


def code_of(action):
    with pytest.raises(LearnBlockError) as refused:
        action()
    return refused.value.phrase.code


def test_a_new_pupil_is_recognised_by_name_and_pictures(roster):
    pupil, pictures = roster.add(" Ana ")
    assert pupil.name == "Ana"
    assert roster.recognise("ana", pictures) == pupil
    assert roster.recognise("Ana", pictures[::-1]) is None
    assert roster.recognise("Leo", pictures) is None


def test_accents_and_case_do_not_matter(roster):
    pupil, pictures = roster.add("José Ángel")
    assert roster.recognise("jose  angel", pictures) == pupil


def test_two_pupils_with_one_name_have_different_pictures(roster):
    first, pictures = roster.add("Ana")
    second, others = roster.add("Ana")
    assert pictures != others
    assert roster.recognise("Ana", pictures) == first
    assert roster.recognise("Ana", others) == second


def test_a_class_is_the_same_when_it_is_opened_again(roster, tmp_path):
    pupil, pictures = roster.add("Ana")
    again = Roster(tmp_path, "other title")
    assert (again.title, again.word, again.key, again.secret) == (
        "7b", roster.word, roster.key, roster.secret
    )  # fmt: skip
    assert again.recognise("Ana", pictures) == pupil


def test_the_file_is_private_and_has_no_pictures(roster, tmp_path):
    roster.add("Ana")
    assert stat.S_IMODE((tmp_path / FILE).stat().st_mode) == 0o600
    assert "apple" not in (tmp_path / FILE).read_text()


def test_new_pictures_replace_the_old_ones(roster):
    pupil, pictures = roster.add("Ana")
    renewed = roster.renew_pin(pupil)
    assert roster.recognise("Ana", pictures) is None
    found = roster.recognise("Ana", renewed)
    assert (found.id, found.badges) == (pupil.id, 1)


def test_a_deleted_pupil_leaves_nothing(roster):
    pupil, pictures = roster.add("Ana")
    other, _ = roster.add("Leo")
    folder = roster.folder_of(pupil)
    (folder / "projects").mkdir(parents=True)
    (folder / "projects" / "a.learnblock").write_text("{}")
    roster.remove(pupil)
    assert not folder.exists()
    assert roster.pupils == (other,)
    assert roster.recognise("Ana", pictures) is None


def test_nobody_new_joins_a_closed_class(roster):
    roster.let_join(open=False)
    assert code_of(lambda: roster.add("Ana")) == "class-closed"
    roster.let_join(open=True)
    roster.add("Ana")


def test_a_class_has_a_limit(roster, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.roster.MOST_PUPILS", 2)
    roster.add("Ana")
    roster.add("Leo")
    assert code_of(lambda: roster.add("Mia")) == "class-full"
    assert MOST_PUPILS >= 30


def test_the_join_word_can_be_changed(roster, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.roster.new_join_word", lambda: "koala 99")
    roster.renew_word()
    assert roster.word == "koala 99"


@pytest.mark.parametrize(
    "name", ["Ana", "Ana M.", "O'Neill", "李", "Jo 2", "नेहा", "ณัฐ", "مُحَمَّد", "Gal·la"]
)
def test_first_names_of_all_kinds_are_names(name):
    """`test_names.py` has more scripts."""
    assert checked_name(name) == unicodedata.normalize("NFC", name)


@pytest.mark.parametrize("name", ["", "  ", "1", "../x", "a/b", "a" * 40, "<b>", ".", "_"])
def test_other_texts_are_no_names(name):
    assert code_of(lambda: checked_name(name)) == "class-no-name"


@pytest.mark.parametrize("name", ["a\x00b", "a\u202eb", "\u200fAna"])
def test_a_name_with_a_hidden_character_is_refused(name):
    assert code_of(lambda: checked_name(name)) == "class-hidden-character"


def test_the_teacher_is_asked_when_more_join_than_expected(roster, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.roster.MORE", 1)
    roster._change(expected=2)
    roster.add("Ana")
    roster.add("Leo")
    assert code_of(lambda: roster.add("Mia")) == "class-asks-teacher"
    roster.expect_more()
    roster.add("Mia")
    assert code_of(lambda: roster.add("Zoe")) == "class-asks-teacher"


def test_few_pupils_have_one_name_however_it_is_spelled(roster):
    for name in ("Zoe", "Zoë", "ZOE", "zoé"):
        roster.add(name)
    assert code_of(lambda: roster.add("Zòe")) == "class-name-taken"
    roster.add("Zoe M.")


def test_a_damaged_file_is_reported_with_its_path(tmp_path):
    (tmp_path / FILE).write_text("{")
    with pytest.raises(LearnBlockError) as refused:
        Roster(tmp_path, "7b")
    assert refused.value.phrase.code == "class-damaged"
    assert str(tmp_path / FILE) in str(refused.value)


def test_a_file_of_a_newer_version_is_left_alone(roster, tmp_path):
    content = json.loads((tmp_path / FILE).read_text())
    (tmp_path / FILE).write_text(json.dumps({**content, "version": 99}))
    assert code_of(lambda: Roster(tmp_path, "7b")) == "class-newer"


@pytest.mark.parametrize("wrong", ["../../etc", "a" * 10 + "/", "", "A" * 10])
def test_an_id_that_could_leave_the_folder_is_refused(roster, tmp_path, wrong):
    roster.add("Ana")
    content = json.loads((tmp_path / FILE).read_text())
    content["pupils"][0]["id"] = wrong
    (tmp_path / FILE).write_text(json.dumps(content))
    assert code_of(lambda: Roster(tmp_path, "7b")) == "class-damaged"


def test_a_number_never_gives_two_pupils_the_same_name(roster):
    for name in ("Ana", "Ana 2", "Ana", "Leo"):
        roster.add(name)
    assert list(names_of(roster.pupils).values()) == ["Ana 1", "Ana 2", "Ana 3", "Leo"]
