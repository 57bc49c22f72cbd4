"""Every number in a block shows its unit."""

import re

import pytest

from learnblock.blocks.palette import palette
from learnblock.blocks.schema.loading import builtin
from learnblock.blocks.translation import units

UNIT = re.compile(rf"\s*({'|'.join(map(re.escape, [*units(), 'of 7', 'de 7']))})(?!\w)")
#: Counts, codes, and parts of a scale of the robot's own.
WITHOUT = {
    ("RGBled", "blue"),
    ("RGBled", "green"),
    ("RGBled", "red"),
    ("is_illuminated", "threshold"),
    ("is_this_code_IR", "code"),
    ("change_lives", "lives"),
    ("change_score", "points"),
    ("led", "intensity"),
    ("matrix_number", "number"),
    ("matrix_text", "column"),
    ("select_audio", "folder"),
    ("select_audio", "song"),
    ("send_code_IR", "code"),
    ("set_lives", "lives"),
    ("set_score", "score"),
    ("show_number", "value"),
}
NUMBERS = [
    (block.languages[language], parameter.name)
    for block in builtin().values()
    for parameter in block.parameters
    if parameter.is_number and (block.name, parameter.name) not in WITHOUT
    for language in ("EN", "ES")
]


@pytest.mark.parametrize(("sentence", "parameter"), NUMBERS)
def test_a_number_is_followed_by_its_unit(sentence, parameter):
    _, _, after = sentence.partition(f"{{{parameter}}}")
    assert UNIT.match(after)


@pytest.mark.parametrize(
    ("block", "parameter"),
    [
        (block.name, parameter.name)
        for block in builtin().values()
        for parameter in block.parameters
        if parameter.type == "choice" or parameter.choices
    ],
)
def test_a_menu_has_words_in_both_languages_for_what_is_no_word(block, parameter):
    found = next(one for one in builtin()[block].parameters if one.name == parameter)
    codes = [one for one in found.choices if re.search(r"_|[a-z][A-Z]", one)]
    assert [
        one for one in codes if not {"EN", "ES"} <= found.choice_names.get(one, {}).keys()
    ] == []


def test_the_page_has_the_words_for_a_unit_after_a_one():
    assert (
        palette(builtin(), "en")["units"].items()
        >= {
            "seconds": "second",
            "segundos": "segundo",
            "times": "time",
            "veces": "vez",
        }.items()
    )
