"""Which save another program has edited."""

from learnblock.server.program.revisions import Revision
from learnblock.server.projects.project import Project
from learnblock.server.sessions.saves import MOST_SAVES, Saved, Saves


def saved(text, number=1):
    return Saved(Project("program", text), Revision(number, text, "", text))


def saves(*texts):
    first, *others = (saved(text, number) for number, text in enumerate(texts, 1))
    made = Saves(first)
    for one in others:
        made.add(one)
    return made


def edited(made, text):
    return made.edited("blocktext", text).revision.blocktext


def test_an_editor_that_read_the_file_before_the_last_save_has_edited_an_earlier_one():
    assert edited(saves("a", "a\nb", "a\nb\nc"), "a\nx") == "a"


def test_an_editor_that_read_the_last_save_has_edited_that():
    assert edited(saves("a", "a\nb"), "a\nb\nx") == "a\nb"


def test_of_two_saves_as_different_the_later_was_edited():
    assert edited(saves("a\nb", "a\nc"), "a") == "a\nc"


def test_who_goes_back_to_an_earlier_save_has_edited_the_last():
    assert edited(saves("a", "a\nb"), "a") == "a\nb"


def test_old_saves_are_forgotten():
    texts = ["\n".join(str(line) for line in range(number)) for number in range(MOST_SAVES + 5)]
    assert edited(saves(*texts), "x") == texts[5]
