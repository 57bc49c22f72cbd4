"""Words to join a class with."""

import re

from learnblock.classroom.join_words import WORDS, is_join_word, new_join_word


def test_a_join_word_is_a_word_and_two_digits():
    for _ in range(50):
        assert re.fullmatch(r"[a-z]{3,10} [1-9]\d", new_join_word())


def test_there_are_thousands_of_join_words():
    assert len(set(WORDS)) * 90 > 3000


def test_case_spaces_and_accents_do_not_matter():
    for typed in ("volcan 47", "Volcán47", " VOLCAN  47 ", "volcan-47"):
        assert is_join_word(typed, "volcan 47")
    for typed in ("volcan 48", "volcan", "47", "", "volcan 470"):
        assert not is_join_word(typed, "volcan 47")
