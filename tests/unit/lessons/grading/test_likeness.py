"""Programs that are the same, renamed or alike are found; others are not."""

from itertools import combinations

from learnblock import language
from learnblock.lessons.grading.likeness import MUCH, Print, alike, print_of

SQUARE = """
main:
    side = 200
    times = 0
    while times < 4:
        function.drive_distance(side)
        function.turn(90)
        times += 1
    end
    function.expressJoy()
    print("done")
end
"""
OTHER = """
main:
    forever:
        if function.obstacle_free():
            function.set_move(50, 0)
        else:
            function.turn_right(30)
            function.sleep(1)
        end
        function.look_for("x")
    end
end
""".replace('        function.look_for("x")\n', "")


def of(text):
    return print_of(language.parse(text, "x.bt"))


def kinds(*texts, given=None):
    found = alike([of(one) for one in texts], given and of(given))
    return [(one.first, one.second, one.kind) for one in found.pairs]


def share(first, second):
    return len(first.parts & second.parts) / len(first.parts | second.parts)


def test_comments_and_layout_make_no_difference():
    assert kinds(SQUARE, "# mine\n\n" + SQUARE) == [(0, 1, "same")]


def test_other_names_make_a_renamed_program():
    assert kinds(SQUARE, SQUARE.replace("times", "n").replace("side", "s")) == [(0, 1, "renamed")]


def test_another_number_is_no_renaming():
    found = kinds(SQUARE, SQUARE.replace("200", "300"))
    assert (0, 1, "same") not in found
    assert (0, 1, "renamed") not in found


def test_a_line_more_leaves_programs_alike():
    more = SQUARE.replace('    print("done")\n', '    print("done")\n    function.expressJoy()\n')
    assert kinds(SQUARE, more) == [(0, 1, "alike")]
    assert MUCH <= share(of(SQUARE), of(more)) < 1


def test_programs_of_other_ideas_are_not_alike():
    assert kinds(SQUARE, OTHER) == []


def test_what_everyone_was_given_counts_for_nothing():
    assert kinds(SQUARE, SQUARE, given=SQUARE) == []
    more = SQUARE.replace('    print("done")\n', '    print("done")\n    function.expressJoy()\n')
    assert kinds(SQUARE, more, given=more) == []


def test_renamed_python_is_found_too():
    python = "import math\n\ndef f(a):\n    b = a * math.pi\n    return b\n\nprint(f(2))\n"
    renamed = python.replace("f(", "area(").replace("a)", "r)").replace("= a", "= r")
    trees = [language.from_python(one, "x.py") for one in (python, renamed)]
    [found] = alike([print_of(one) for one in trees]).pairs
    assert found.kind in {"renamed", "alike"}


def variants(count):
    """Programs whose parts differ a little, or a lot."""
    for number in range(count):
        left_out = {number % 7 * 9, number % 11 * 5}
        own = range(100, 100 + number % 13)
        yield Print(f"{number}", f"{number}", frozenset({*range(60), *own} - left_out))


def test_the_pairs_are_those_that_are_found_by_comparing_two_by_two():
    prints = [*variants(90)]
    shares = {
        (one, other): round(share(prints[one], prints[other]), 3)
        for one, other in combinations(range(90), 2)
        if share(prints[one], prints[other]) >= MUCH
    }
    found = alike(prints, most=10_000)
    assert {(one.first, one.second): one.share for one in found.pairs} == shares
    assert found.total == len(shares)
    assert 100 < found.total < 4005


def test_of_many_pairs_the_most_alike_are_listed_and_the_others_counted():
    prints = [*variants(90)]
    every, few = alike(prints, most=10_000), alike(prints, most=3)
    assert few.pairs == every.pairs[:3]
    assert few.total == every.total
