"""An error that a `try` around it handles is no mistake."""

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, from_python

ROBOT = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n"


def codes(statement, handler):
    text = f"{ROBOT}try:\n    {statement}\n{handler}:\n    print(0)\n"
    return [one.code for one in check(from_python(text), builtin(), python=text)]


CASES = [
    ('print(int("ten"))', "wrong-type", "ValueError"),
    ("print(1 / 0)", "wrong-type", "ZeroDivisionError"),
    ('print("a" + 1)', "wrong-type", "TypeError"),
    ("robot.turn()", "missing-argument", "TypeError"),
    ("print(count)", "unknown-name", "NameError"),
]


@pytest.mark.parametrize(("statement", "code", "error"), CASES)
def test_an_error_is_reported_unless_a_handler_names_it(statement, code, error):
    assert [] == codes(statement, f"except {error}")
    assert [] == codes(statement, f"except (KeyError, {error}) as problem")
    assert [code] == codes(statement, "except KeyError")
    assert [code] == codes(statement, "finally")


@pytest.mark.parametrize("handler", ["except", "except Exception", "except BaseException as all"])
@pytest.mark.parametrize(("statement", "code", "error"), CASES)
def test_a_handler_of_everything_hides_no_misspelled_name(statement, code, error, handler):
    is_slip = error in {"NameError", "TypeError"}
    assert ([code] if is_slip else []) == codes(statement, handler)


def test_an_error_in_a_handler_or_behind_it_is_reported():
    text = ROBOT + 'try:\n    n = 1\nexcept ValueError:\n    n = int("ten")\nn = int("ten")\n'
    assert [8, 9] == [one.line for one in check(from_python(text), builtin(), python=text)]
