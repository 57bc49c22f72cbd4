"""The names of skills in a user's Python."""

import ast

from learnblock.extensions.skill_names import places, replaced

SOURCE = '''\
def waltz(robot, waltzes=1):
    """A waltz."""
    robot.say_Text("waltz")
    robot.\\
        waltz(2); waltz(robot)
'''


def test_a_skill_is_renamed_where_it_is_defined_and_called():
    found = places(ast.parse(SOURCE), SOURCE, {"waltz"})
    assert replaced(SOURCE, found, {"waltz": "ball"}) == SOURCE.replace(
        "def waltz", "def ball"
    ).replace("waltz(2); waltz(robot)", "ball(2); ball(robot)")


def test_a_name_in_another_form_of_unicode_is_not_plain():
    source = "é = 1; def_ = 2\ndef ﬁre(robot): robot.fire()\n"
    found = sorted(places(ast.parse(source), source, {"fire"}))
    assert [place.is_plain for place in found] == [False, True]
