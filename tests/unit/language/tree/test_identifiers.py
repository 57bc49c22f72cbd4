"""Names in every script are the same in all notations."""

import re
import sys
import unicodedata

import pytest

from learnblock.blocks import builtin
from learnblock.language import (
    check,
    from_python,
    from_workspace,
    parse,
    to_python,
    to_workspace,
)
from learnblock.language import format as format_program
from learnblock.language.tree.identifiers import IDENTIFIER, normal

NAMES = {
    "Latin": "größe",
    "Latin, decomposed": unicodedata.normalize("NFD", "ñandú"),
    "Vietnamese": unicodedata.normalize("NFD", "tốc_độ"),
    "Catalan": "paral·lel",
    "Yoruba": "ọ̀nà",
    "Greek": "ταχύτητα",
    "Cyrillic": "скорость",
    "Armenian": "արագություն",
    "Georgian": "სიჩქარე",
    "Hebrew with vowels": "מְהִירוּת",
    "Arabic with vowels": "سُرْعَة",
    "Devanagari": "गति",
    "Bengali": "গতি",
    "Gurmukhi": "ਗਤੀ",
    "Gujarati": "ઝડપ_ગતિ",
    "Tamil": "வேகம்",
    "Telugu": "వేగం",
    "Kannada": "ವೇಗ",
    "Malayalam": "വേഗത",
    "Sinhala": "වේගය",
    "Thai": "ความเร็ว",
    "Lao": "ຄວາມໄວ",
    "Burmese": "မြန်နှုန်း",
    "Khmer": "ល្បឿន",
    "Tibetan": "མགྱོགས་"[:-1],
    "Amharic": "ፍጥነት",
    "Cherokee": "ᎠᏓᏅᏖᏗ",
    "Mongolian": "хурд_ᠬᠤᠷᠳᠤ",
    "Chinese": "速度",
    "Japanese": "スピード",
    "Korean": "속도",
    "Korean, decomposed": unicodedata.normalize("NFD", "속도"),
    "full width": "ｓｐｅｅｄ",
    "a ligature": "ﬁn",
}
PROGRAM = """\
{0} = 1
def {0}_f({0}_p):
    return {0}_p + {0}
end
when {0}_e = {0} > 2:
    {0} += {0}_f({0}_p=3)
    print(f"{{{0}}}", state_{0}_e)
end
"""


@pytest.mark.parametrize("name", NAMES.values(), ids=NAMES)
def test_a_name_of_any_script_goes_through_all_notations_and_back(name):
    assert name.isidentifier()
    program = parse(PROGRAM.format(name))
    assert [*program.functions] == [f"{normal(name)}_f"]
    assert parse(format_program(program)) == program
    assert not [one for one in check(program, builtin()) if one.severity == "error"]
    python = to_python(program).text
    assert from_python(python) == program
    assert to_python(from_python(python)).text == python
    assert from_workspace(to_workspace(program, builtin()).workspace, builtin()).program == program


def test_every_character_that_may_continue_a_name_is_read_as_part_of_it():
    word = re.compile(IDENTIFIER)
    every = map(chr, range(0x80, sys.maxunicode + 1))
    missed = [one for one in every if f"a{one}".isidentifier() and not word.fullmatch(f"a{one}")]
    # Later versions of Unicode have more marks.
    assert [one for one in missed if unicodedata.ucd_3_2_0.category(one) != "Cn"] == []


@pytest.mark.parametrize("text", ["x²", "1a", "a-b", "a b", "x\N{ZERO WIDTH SPACE}", "", "½"])
def test_what_python_takes_for_no_name_is_none_here(text):
    assert normal(text) is None
