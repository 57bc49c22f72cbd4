from itertools import islice

import pytest

from learnblock import language
from learnblock.blocks import builtin
from learnblock.language import check, parse
from learnblock.lessons.variations import variations
from places import ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.bt"))
SQUARE = """main:
    repeat 4:
        function.drive_distance(200)
        function.turn_90_right()
    end
    function.stop_bot()
end
"""


def first(source, most=60):
    return list(islice(variations(source), most))


@pytest.mark.sample(6)
@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_every_variation_of_an_example_is_another_program_without_errors(file):
    found = first(file.read_text())
    assert len({one.source for one in found}) == len(found) == 60
    for one in found:
        program = parse(one.source)
        assert language.format(program) == one.source
        assert not [one for one in check(program, builtin()) if one.severity == "error"]


def test_the_same_program_always_has_the_same_variations():
    assert first(SQUARE) == first(SQUARE)


@pytest.mark.parametrize(
    ("source", "instead"),
    [
        (SQUARE, "for turn_1 from 1 to 4:"),
        (SQUARE, "function.turn(90)"),
        (SQUARE, "function.set_move(0, 0)"),
        (SQUARE, "number_1 = 200"),
        (SQUARE, "def part_1():"),
        ("main:\n    function.sleep(4)\nend\n", "function.sleep(2)\n    function.sleep(2)"),
        (SQUARE, "while round_1 < 4:"),
        ("main:\n    function.turn(180)\nend\n", "function.turn(-180)"),
        ("main:\n    wait until x\nend\n", "while not x:"),
        ("main:\n    forever:\n        a()\n    end\nend\n", "while 1 == 1:"),
        ("x = 0\n\nmain:\n    x += 1\nend\n", "x = x + 1"),
        ("x = 0\n\nmain:\n    print(x)\nend\n", "my_x = 0"),
        ("main:\n    while x < 3:\n        a()\n    end\nend\n", "while 3 > x:"),
        ("main:\n    if x:\n        a()\n    else:\n        b()\n    end\nend\n", "if not x:"),
    ],
)
def test_a_variation_does_the_same_in_another_way(source, instead):
    assert any(instead in one.source for one in first(source, 40))


def test_a_variation_says_which_construct_it_no_longer_has():
    counted = next(one for one in first(SQUARE) if "for turn_1" in one.source)
    assert counted.without == {"repeat"}


def test_a_decision_made_forever_becomes_an_event_for_each_case():
    source = (
        "main:\n    a()\n    forever:\n        if x:\n            b()\n        elif y:\n"
        "            c()\n        else:\n            d()\n        end\n    end\nend\n"
    )
    events = (
        "when start:\n    a()\nend\n\nwhen case_11 = x:\n    b()\nend\n\n"
        "when case_21 = not x and y:\n    c()\nend\n\n"
        "when case_31 = not x and not y:\n    d()\nend\n"
    )
    assert events in {one.source for one in first(source)}
