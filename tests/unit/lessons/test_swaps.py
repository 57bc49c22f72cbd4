import pytest

from learnblock import language
from learnblock.language import parse
from learnblock.lessons.swaps import swaps
from places import ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.bt"))


def changed(body):
    """The changed programs of a kind and the bodies that they have."""
    return {(kind, mutant.source) for kind, mutant in swaps(f"main:\n{body}end\n")}


def program(body):
    return f"main:\n{body}end\n"


@pytest.mark.sample(6)
@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_every_swap_is_another_program_that_can_be_read(file):
    source = language.format(parse(file.read_text()))
    found = [mutant.source for _, mutant in swaps(source)]
    assert len({source, *found}) == len(found) + 1
    for one in found:
        assert language.format(parse(one)) == one


@pytest.mark.parametrize(
    ("kind", "right", "wrong"),
    [
        (
            "shown",
            "    function.expressJoy()\n    x = 1\n    function.expressFear()\n",
            "    function.expressFear()\n    x = 1\n    function.expressJoy()\n",
        ),
        (
            "shown",
            '    print("a")\n    if x:\n        print("b")\n    end\n',
            '    print("b")\n    if x:\n        print("a")\n    end\n',
        ),
        ("direction", "    function.turn(90)\n", "    function.turn(-90)\n"),
        ("direction", "    function.turn_left(20)\n", "    function.turn_right(20)\n"),
        (
            "direction",
            "    if function.is_left_obstacle(9):\n        function.set_move(8, 20)\n    end\n",
            "    if function.is_right_obstacle(9):\n        function.set_move(8, -20)\n    end\n",
        ),
        (
            "order",
            "    a()\n    b()\n    c()\n",
            "    c()\n    b()\n    a()\n",
        ),
        (
            "half",
            "    if x:\n        a()\n    else:\n        b()\n    end\n",
            "    if x:\n        b()\n    else:\n        a()\n    end\n",
        ),
        ("half", "    wait until x\n", "    wait until not x\n"),
        (
            "limit",
            "    wait until function.is_front_obstacle(100)\n",
            "    wait until function.is_front_obstacle(400)\n",
        ),
        ("limit", "    repeat 4:\n        a()\n    end\n", "    repeat 5:\n        a()\n    end\n"),
        (
            "limit",
            "    while x < 3:\n        a()\n    end\n",
            "    while x > 3:\n        a()\n    end\n",
        ),
    ],
)
def test_two_parts_of_a_program_change_places(kind, right, wrong):
    assert (kind, program(wrong)) in changed(right)


def test_the_bodies_of_two_events_change_places():
    events = "when a = x:\n    b()\nend\n\nwhen c = y:\n    d()\nend\n"
    swapped = "when a = x:\n    d()\nend\n\nwhen c = y:\n    b()\nend\n"
    assert ("half", swapped) in {(kind, one.source) for kind, one in swaps(events)}
