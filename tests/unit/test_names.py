"""Every name that people have is a name, and what nobody can see is none."""

import unicodedata

import pytest

from learnblock.names import (
    LONGEST,
    flaw_of_first_name,
    folded,
    hidden_character,
    length,
    normalized,
)

#: By script: names, and their lengths in characters as people see them.
NAMES = {
    "Latin": {
        "Ana": 3,
        "Ñusta": 5,
        "Zoë": 3,
        "Anne-Marie": 10,
        "O'Neill": 7,
        "O’Neill": 7,
        "Ana M.": 6,
    },
    "Latin, Catalan": {"Gal·la": 6},
    "Latin, Tongan": {"'Ana": 4, "ʻOfa": 4},
    "Latin, Vietnamese": {"Nguyễn": 6},
    "Latin, Turkish": {"İpek": 4, "Işıl": 4},
    "Latin, Yoruba": {"Ọláyẹ̀mí": 7},
    "Greek": {"Ἀλέξανδρος": 10},
    "Cyrillic": {"Юлия": 4, "Дар'я": 5},
    "Armenian": {"Արամ": 4},
    "Georgian": {"ნინო": 4},
    "Hebrew": {"דָּוִד": 3, "ג׳ורג׳": 6},
    "Arabic": {"مُحَمَّد": 4, "فاطمة": 5},
    "Arabic, Persian": {"مه\u200cلقا": 5},
    "Syriac": {"ܝܘܚܢܢ": 5},
    "Thaana": {"އަހްމަދު": 4},
    "Devanagari": {"नेहा": 2, "श्रेया": 3},
    "Bengali": {"প্রিয়া": 3},
    "Gurmukhi": {"ਸਿਮਰਨ": 4},
    "Gujarati": {"નેહા": 2},
    "Tamil": {"தமிழ்": 3},
    "Telugu": {"శ్రీను": 3},
    "Kannada": {"ಸೌಮ್ಯ": 3},
    "Malayalam": {"ലക്ഷ്മി": 4},
    "Sinhala": {"ශ්\u200dරී": 2},
    "Thai": {"ณัฐ": 2, "กิ่ง": 2},
    "Lao": {"ນິດ": 2},
    "Tibetan": {"བསྟན་འཛིན": 7},
    "Burmese": {"ဇော်": 1, "မြို့": 1},
    "Khmer": {"សុភា": 2},
    "Ethiopic": {"ሰላም": 3},
    "Cherokee": {"ᏣᎳᎩ": 3},
    "Hangul": {"지우": 2},
    "Kana": {"さくら": 3, "マイケル・ジャクソン": 10},
    "Han": {"李": 1, "葛\U000e0100城": 2},
    "Mongolian": {"ᠪᠣᠯᠣᠷ": 5},
    "N'Ko": {"ߡߎ߬ߛߊ": 4},
    "Adlam": {"𞤀𞤥𞤢": 3},
}
CASES = [
    pytest.param(name, seen, id=f"{script}-{name}")
    for script, names in NAMES.items()
    for name, seen in names.items()
]


@pytest.mark.parametrize(("name", "seen"), CASES)
def test_a_name_of_any_script_is_a_name(name, seen):
    for form in ("NFC", "NFD"):
        written = normalized(unicodedata.normalize(form, name))
        assert flaw_of_first_name(written) is None
        assert length(written) == seen


@pytest.mark.parametrize(("name", "_"), CASES)
def test_a_name_is_the_same_however_it_is_composed(name, _):
    assert folded(unicodedata.normalize("NFD", name)) == folded(unicodedata.normalize("NFC", name))
    assert folded(folded(name)) == folded(name) != ""


@pytest.mark.parametrize(
    "name",
    [
        "Leo",
        "LEO",
        "Lèo",
        "Lëo",
        "Lēò",
        " leo ",
        "Ｌeo",
        "𝐋eo",
        "Ⓛeo",
        "L\u0308e\u0301o",
        "Le\u200do",
    ],
)
def test_spellings_of_one_name_are_the_same(name):
    assert folded(name) == "leo"


@pytest.mark.parametrize(
    "hidden",
    ["\x00", "\x1b", "\x7f", "\x9b", "\u00ad", "\u034f", "\u061c", "\u115f", "\u200b", "\u200e",
     "\u200f", "\u202a", "\u202e", "\u2066", "\u2069", "\u2060", "\u2028", "\u3164", "\ufeff",
     "\uffa0", "\ufff9", "\ue000", "\U000e0041", "\ud800"],
)  # fmt: skip
def test_what_nobody_sees_is_named(hidden):
    name = f"A{hidden}na"
    assert hidden_character(name) == hidden
    assert flaw_of_first_name(name).hidden == f"U+{ord(hidden):04X}"


@pytest.mark.parametrize("name", ["\u200dAna", "Ana\u200c", "A \u200dna", "A\u200d\u200dna"])
def test_a_joiner_that_joins_nothing_is_hidden(name):
    assert hidden_character(name)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "1",
        "2 Ana",
        ".",
        "-",
        "_",
        "''Ana",
        "'",
        "Ana-",
        "../x",
        "a/b",
        "a\\b",
        "<b>",
        "a:b",
        "A*",
        "😀",
        "a😀",
        "\u0301",
        "́Ana",
    ],
)
def test_other_texts_are_no_names(text):
    assert flaw_of_first_name(text) is not None


def test_the_length_is_that_of_characters_as_seen():
    assert flaw_of_first_name("ने" * LONGEST) is None
    assert flaw_of_first_name("न" * (LONGEST + 1)) is not None
    assert flaw_of_first_name("a" * (LONGEST + 1)) is not None


def test_a_letter_carries_few_signs():
    assert flaw_of_first_name("a" + "\u0325" * 7) is not None
